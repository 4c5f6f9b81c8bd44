//! `cargo xtask`: masks of this repository, the devices that are linked into it, booleans on files, other tools.
//!
//! This file only dispatches; the work is in the libraries, where it can be tested.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "commands talk to whoever typed them")]

mod bench;
mod boolean;
mod compare;
mod demo;
mod device;
mod devices;
mod figure;
mod flags;
mod gallery;
mod golden;
mod interop;
mod layer_file;
mod mask;
mod offset;
mod progress;
mod python;
mod stages;
mod summary;

use std::io;
use std::process::ExitCode;

use clap::Parser;
use flags::{Command, Flags};
use phidl_geometry as _;
use phidl_route as _;

fn main() -> ExitCode {
    let result = match Flags::parse().command {
        Command::Mask(flags) => mask::run(&flags),
        Command::Devices(flags) => devices::run(&flags),
        Command::Device(flags) => device::run(&flags),
        Command::Gallery(flags) => gallery::run(&flags),
        Command::Boolean(flags) => boolean::run(&flags),
        Command::Offset(flags) => offset::run(&flags),
        Command::Bench(flags) => bench::run(&flags),
        Command::Compare(flags) => compare::run(&flags),
        Command::Figure(flags) => figure::run(&flags),
        Command::Interop(flags) => interop::run(&flags),
        Command::Golden(flags) => golden::run(&flags),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Whether the one who reads what we print has gone: no fault of ours or theirs.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe)
}

/// An error of the libraries with the whole way from the outermost cell to the rule.
#[expect(clippy::needless_pass_by_value, reason = "it stands in map_err")]
fn report(error: phidl_core::Error) -> anyhow::Error {
    anyhow::anyhow!(error.report())
}
