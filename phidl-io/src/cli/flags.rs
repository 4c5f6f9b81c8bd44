//! The grammar of the command line, with its help.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Lists and draws the devices of this program.
#[derive(Debug, Parser)]
#[command(disable_help_subcommand = true)]
pub(super) struct Flags {
    /// The command.
    #[command(subcommand)]
    pub(super) command: Command,
}

/// The commands of every program with generators.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Lists the registered devices with their docs, parameters and defaults.
    Devices(DevicesFlags),
    /// Draws one device, or with --batch many.
    Device(DeviceFlags),
    /// Draws the example of every device: one figure each, and a page with the calls.
    Gallery(GalleryFlags),
}

/// Flags of `devices`.
#[derive(Debug, Args)]
pub struct DevicesFlags {
    /// Only devices whose name contains this.
    pub filter: Option<String>,
    /// As JSON, for other programs.
    #[arg(long)]
    pub json: bool,
}

/// Flags of `device`.
#[derive(Debug, Args)]
pub struct DeviceFlags {
    /// The registered name.
    #[arg(required_unless_present = "batch")]
    pub name: Option<String>,
    /// Parameters as JSON; those that are left out have their defaults.
    #[arg(long, value_name = "JSON", default_value = "{}", conflicts_with = "batch")]
    pub params: String,
    /// The file to write; its ending selects the format: .gds, .svg or .json.
    #[arg(long, value_name = "FILE", required_unless_present = "batch", conflicts_with = "batch")]
    pub out: Option<PathBuf>,
    /// A .svg file is a small figure with ports and a scale, as in documentation.
    #[arg(long, conflicts_with = "batch")]
    pub figure: bool,
    /// A JSON list of {"id", "device", "params"}, each drawn to ID.json.
    #[arg(long, value_name = "FILE", requires = "out_dir", conflicts_with = "name")]
    pub batch: Option<PathBuf>,
    /// The folder for the results of --batch.
    #[arg(long, value_name = "DIR", requires = "batch")]
    pub out_dir: Option<PathBuf>,
}

/// Flags of `gallery`.
#[derive(Debug, Args)]
pub struct GalleryFlags {
    /// The folder that is written to.
    #[arg(long, value_name = "DIR", default_value = "target/gallery")]
    pub out: PathBuf,
}
