//! A command line for a program with generators of its own: `devices`, `device` and `gallery`.
//!
//! A program that links generators calls [`main`]; every registered generator can then be listed and drawn by name:
//!
//! ```no_run
//! # #[cfg(any())]
//! use my_devices as _; // the crate with the generators, unless the program names it anyway
//!
//! fn main() -> std::process::ExitCode {
//!     phidl_io::cli::main()
//! }
//! ```
//!
//! ```text
//! cargo run -- devices ring
//! cargo run -- device ring --params '{"radius": 20}' --out ring.gds
//! cargo run -- gallery --out gallery
//! ```
//!
//! A program with further commands takes [`Command`] into its own clap parser and calls [`run`]. What the commands do
//! is in [`devices`], [`device`] and [`gallery`], for programs with another front.
#![expect(clippy::print_stderr, reason = "commands print for the person who runs them")]

pub mod device;
pub mod devices;
mod error;
mod flags;
pub mod gallery;
mod text;

use std::io::{self, Write as _};
use std::process::ExitCode;

use clap::Parser as _;

pub use error::CliError;
pub use flags::{Command, DeviceFlags, DevicesFlags, GalleryFlags};
pub use text::first_paragraph;

/// Reads the arguments of the program, runs the command, and reports an error in one line.
#[must_use]
pub fn main() -> ExitCode {
    match run(&flags::Flags::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Runs one command.
///
/// # Errors
/// [`CliError`], as a sentence for the person who runs the command.
pub fn run(command: &Command) -> Result<(), CliError> {
    match command {
        Command::Devices(flags) => print(&devices::list(flags.filter.as_deref().unwrap_or_default(), flags.json)?),
        Command::Device(flags) => print(&device::run(flags, |_| {})?),
        Command::Gallery(flags) => print(&gallery::write(&flags.out, |_| true, |_| {})?),
    }
}

/// Not `println!`, which panics when the reader of a pipe (head, less) has read enough.
fn print(text: &str) -> Result<(), CliError> {
    writeln!(io::stdout().lock(), "{text}").map_err(CliError::Print)
}
