//! The grammar of the command line, with its help.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Builds masks, and lists and draws devices.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", disable_help_subcommand = true)]
pub(crate) struct Flags {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What there is to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Builds masks of this repository: GDSII, SVG, metadata and a summary of each.
    Mask(MaskFlags),
    /// Lists the registered devices with their docs, parameters and defaults.
    Devices(DevicesFlags),
    /// Draws one device, or with --batch many.
    Device(DeviceFlags),
}

/// Flags of `mask`.
#[derive(Debug, Args)]
pub(crate) struct MaskFlags {
    /// Which masks; without a name, all of them.
    pub(crate) names: Vec<String>,
    /// The folder that gets a folder for each mask.
    #[arg(long, value_name = "DIR", default_value = "target/mask")]
    pub(crate) out: PathBuf,
}

/// Flags of `devices`.
#[derive(Debug, Args)]
pub(crate) struct DevicesFlags {
    /// Only devices whose name contains this.
    pub(crate) filter: Option<String>,
}

/// Flags of `device`.
#[derive(Debug, Args)]
pub(crate) struct DeviceFlags {
    /// The registered name.
    #[arg(required_unless_present = "batch")]
    pub(crate) name: Option<String>,
    /// Parameters as JSON; those that are left out have their defaults.
    #[arg(long, value_name = "JSON", default_value = "{}", conflicts_with = "batch")]
    pub(crate) params: String,
    /// The file to write; its ending says what: .gds, .svg or .json.
    #[arg(long, value_name = "FILE", required_unless_present = "batch", conflicts_with = "batch")]
    pub(crate) out: Option<PathBuf>,
    /// A JSON list of {"id", "device", "params"}, each drawn to ID.json.
    #[arg(long, value_name = "FILE", requires = "out_dir", conflicts_with = "name")]
    pub(crate) batch: Option<PathBuf>,
    /// The folder for the results of --batch.
    #[arg(long, value_name = "DIR", requires = "batch")]
    pub(crate) out_dir: Option<PathBuf>,
}
