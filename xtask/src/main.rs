//! `cargo xtask`: masks of this repository, the devices that are linked into it, booleans on files, other tools.
//!
//! This file only dispatches; the work is in the libraries, where it can be tested.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "commands print for the person who runs them")]

mod bench;
mod boolean;
mod compare;
mod convert;
mod demo;
mod flags;
mod gallery;
mod golden;
mod inspect;
mod interop;
mod interop_files;
mod layer_file;
mod mask;
mod offset;
mod progress;
mod python;
mod stages;

use std::io;
use std::process::ExitCode;

use clap::Parser;
use flags::{Command, Flags};
use phidl_geometry as _;
use phidl_io::cli::{self, CliError};
use phidl_route as _;
use progress::Progress;

/// The exit code of `--strict`: a problem or a loss.
const STRICT: u8 = 3;

fn main() -> ExitCode {
    match run(Flags::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) if error.is::<inspect::Strict>() => {
            eprintln!("error: {error:#}");
            ExitCode::from(STRICT)
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> anyhow::Result<()> {
    match command {
        Command::Mask(flags) => mask::run(&flags),
        Command::Devices(flags) => Ok(cli::run(&cli::Command::Devices(flags))?),
        Command::Device(flags) => device(&flags),
        Command::Gallery(flags) => gallery::run(&flags),
        Command::Boolean(flags) => boolean::run(&flags),
        Command::Offset(flags) => offset::run(&flags),
        Command::Bench(flags) => bench::run(&flags),
        Command::Compare(flags) => compare::run(&flags),
        Command::Interop(flags) => interop::run(&flags),
        Command::Golden(flags) => golden::run(&flags),
        Command::Inspect(flags) => inspect::run(&flags),
        Command::Convert(flags) => convert::run(&flags),
    }
}

fn device(flags: &cli::DeviceFlags) -> anyhow::Result<()> {
    let progress = Progress::new();
    let done = cli::device::run(flags, |step| progress.step(step))?;
    drop(progress);
    println!("{done}");
    Ok(())
}

/// Whether the reader of a pipe has closed it, which is no failure.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let printed = error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe);
    printed || error.downcast_ref::<CliError>().is_some_and(CliError::is_broken_pipe)
}

/// An error of the libraries with its chain from the outermost cell to the rule.
#[expect(clippy::needless_pass_by_value, reason = "it is passed to map_err")]
fn report(error: phidl_core::Error) -> anyhow::Error {
    anyhow::anyhow!(error.report())
}
