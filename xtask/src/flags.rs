//! The grammar of the command line, with its help.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use phidl_io::cli::{DeviceFlags, DevicesFlags};

use crate::layer_file::LayerFile;

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
    /// Draws the example of every device: one figure each, a sheet with all of them, a page with the calls.
    Gallery(GalleryFlags),
    /// Combines two layers of GDSII files.
    Boolean(BooleanFlags),
    /// Grows or shrinks a layer of a GDSII file.
    Offset(OffsetFlags),
    // The commands below measure phidl beside other tools, or compare with them; they need Python.
    /// Times shapes, paths, routes, cells and files beside PHIDL and gdstk.
    Bench(BenchFlags),
    /// Times booleans and offsets beside KLayout, gdstk and PHIDL on the same files.
    Compare(CompareFlags),
    /// Opens the masks in KLayout, gdstk and gdspy, and checks booleans and offsets of random shapes against KLayout.
    Interop(InteropFlags),
    /// Has PHIDL draw further reference results with random parameters, for the tests to run on.
    Golden(GoldenFlags),
    /// Counts what is in a layout file: cells, layers, problems.
    Inspect(InspectFlags),
    /// Makes another file of a layout file: other format, one cell, some layers, flat, on another grid.
    Convert(ConvertFlags),
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

/// Flags of `gallery`.
#[derive(Debug, Args)]
pub(crate) struct GalleryFlags {
    /// The folder that is written to.
    #[arg(long, value_name = "DIR", default_value = "target/gallery")]
    pub(crate) out: PathBuf,
    /// Write nothing, and fail if a figure of the documentation is not what is drawn now.
    #[arg(long)]
    pub(crate) check: bool,
    /// Write the figures of the documentation, too.
    #[arg(long, conflicts_with = "check")]
    pub(crate) bless: bool,
}

/// Flags of `boolean`.
#[derive(Debug, Args)]
pub(crate) struct BooleanFlags {
    /// The first operand, FILE:LAYER/DATATYPE.
    #[arg(value_name = "A")]
    pub(crate) a: LayerFile,
    /// The second operand.
    #[arg(value_name = "B")]
    pub(crate) b: LayerFile,
    /// What to do: or, and, not (A-B), B-A, xor.
    #[arg(long, value_name = "OPERATION", allow_hyphen_values = true)]
    pub(crate) op: String,
    /// Where the result is written: a file of its own, with one cell.
    #[arg(long, value_name = "FILE:LAYER/DATATYPE")]
    pub(crate) out: LayerFile,
    /// The cell of the second file; without it, that of --cell.
    #[arg(long, value_name = "NAME")]
    pub(crate) cell_b: Option<String>,
    #[command(flatten)]
    pub(crate) run: RunFlags,
}

/// Flags of `offset`.
#[derive(Debug, Args)]
pub(crate) struct OffsetFlags {
    /// What is grown, FILE:LAYER/DATATYPE.
    #[arg(value_name = "INPUT")]
    pub(crate) input: LayerFile,
    /// How far (µm); negative shrinks.
    #[arg(long, value_name = "UM", allow_hyphen_values = true)]
    pub(crate) distance: f64,
    /// Where the result is written: a file of its own, with one cell.
    #[arg(long, value_name = "FILE:LAYER/DATATYPE")]
    pub(crate) out: LayerFile,
    /// What is put at corners.
    #[arg(long, value_enum, default_value = "miter")]
    pub(crate) join: JoinFlag,
    /// How far a miter may reach, in distances.
    #[arg(long, value_name = "N", default_value_t = 2.0, allow_negative_numbers = true)]
    pub(crate) miter_limit: f64,
    /// Points of a full turn of round joins.
    #[arg(long, value_name = "N", default_value_t = 64.0, allow_negative_numbers = true)]
    pub(crate) points_per_turn: f64,
    #[command(flatten)]
    pub(crate) run: RunFlags,
}

/// What `boolean` and `offset` have in common.
#[derive(Debug, Args)]
pub(crate) struct RunFlags {
    /// The cell to read; without a name, the only one at the top of the file.
    #[arg(long, value_name = "NAME")]
    pub(crate) cell: Option<String>,
    /// Number of threads; one for each core if not given.
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,
    /// Parts that the plane is divided into; the result does not depend on it.
    #[arg(long, value_name = "N")]
    pub(crate) divisions: Option<usize>,
    /// The grid step of the work and of the result (µm).
    #[arg(long, value_name = "UM", default_value_t = 1e-4, allow_negative_numbers = true)]
    pub(crate) precision: f64,
}

/// What is put at corners.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum JoinFlag {
    Miter,
    Bevel,
    Round,
}

/// Flags of `bench`.
#[derive(Debug, Args)]
pub(crate) struct BenchFlags {
    /// Which sections; without a name, all of them.
    #[arg(value_enum)]
    pub(crate) sections: Vec<BenchSection>,
    /// Only shapes whose name contains this.
    #[arg(long, value_name = "TEXT")]
    pub(crate) filter: Option<String>,
    /// The folder for files and the virtual environment.
    #[arg(long, value_name = "DIR", default_value = "target/compare")]
    pub(crate) out: PathBuf,
}

/// What is timed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BenchSection {
    Shapes,
    Text,
    Paths,
    Routes,
    Cells,
    Files,
}

impl BenchSection {
    /// All of them, in the order of the report.
    pub(crate) const ALL: [Self; 6] = [Self::Shapes, Self::Text, Self::Paths, Self::Routes, Self::Cells, Self::Files];
}

/// Flags of `compare`.
#[derive(Debug, Args)]
pub(crate) struct CompareFlags {
    /// Only lines whose name contains this, such as `n = 10,000: or`.
    pub(crate) filter: Option<String>,
    /// Number of threads, for everyone who can use more than one.
    #[arg(long, value_name = "N", default_value_t = 2)]
    pub(crate) threads: usize,
    /// Everything smaller, to see that it works.
    #[arg(long)]
    pub(crate) quick: bool,
    /// Scenes of many kinds in three sizes, instead of those of the published table.
    #[arg(long)]
    pub(crate) suite: bool,
    /// The folder for scenes and the virtual environment.
    #[arg(long, value_name = "DIR", default_value = "target/compare")]
    pub(crate) out: PathBuf,
}

/// Flags of `interop`.
#[derive(Debug, Args)]
pub(crate) struct InteropFlags {
    /// Number of random scenes.
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub(crate) scenes: u64,
    /// Shapes of each kind in a scene.
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub(crate) shapes: usize,
    /// Scenes of many kinds in three sizes, instead of those of the published table.
    #[arg(long)]
    pub(crate) suite: bool,
    /// The folder for scenes and the virtual environment.
    #[arg(long, value_name = "DIR", default_value = "target/compare")]
    pub(crate) out: PathBuf,
}

/// Flags of `golden`.
#[derive(Debug, Args)]
pub(crate) struct GoldenFlags {
    /// What the random parameters are drawn from; the same seed gives the same cases.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Cases of each shape; some more of paths, routes and placement.
    #[arg(long, value_name = "N", default_value_t = 12)]
    pub(crate) count: usize,
    /// Draws the cases of this folder once more instead.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["seed", "count"])]
    pub(crate) redraw: Option<PathBuf>,
    /// The folder that gets the results; run the tests with PHIDL_GOLDEN set to it.
    #[arg(long, value_name = "DIR", default_value = "target/golden")]
    pub(crate) out: PathBuf,
    /// The folder for the virtual environments.
    #[arg(long, value_name = "DIR", default_value = "target/compare")]
    pub(crate) peers: PathBuf,
}

/// Flags of `inspect`.
#[derive(Debug, Args)]
pub(crate) struct InspectFlags {
    /// A GDSII or OASIS file, also compressed with gzip; the format is that of its content.
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Only this cell and what is below it.
    #[arg(long, value_name = "NAME")]
    pub(crate) cell: Option<String>,
    /// As JSON, for other programs.
    #[arg(long)]
    pub(crate) json: bool,
    /// Leave out merged areas, which cost a boolean operation.
    #[arg(long)]
    pub(crate) no_merged: bool,
    /// All problems, not the first 20.
    #[arg(long)]
    pub(crate) problems: bool,
    /// Exit with 3 if there is any problem.
    #[arg(long)]
    pub(crate) strict: bool,
}

/// Flags of `convert`.
#[derive(Debug, Args)]
pub(crate) struct ConvertFlags {
    /// A GDSII or OASIS file, also compressed with gzip; the format is that of its content.
    #[arg(value_name = "IN")]
    pub(crate) input: PathBuf,
    /// The result; its ending says what: .gds, .oas, both also with .gz, .svg, .json, .lyp.
    #[arg(value_name = "OUT")]
    pub(crate) output: PathBuf,
    /// Only this cell and what is below it.
    #[arg(long, value_name = "NAME")]
    pub(crate) cell: Option<String>,
    /// One cell without references.
    #[arg(long)]
    pub(crate) flatten: bool,
    /// Only these layers: 1/0,2/0; 3 for all datatypes; 1/0=10/0 for another number.
    #[arg(long, value_name = "LIST")]
    pub(crate) layers: Option<String>,
    /// The grid of the result (µm); that of the file if not given.
    #[arg(long, value_name = "UM")]
    pub(crate) grid: Option<f64>,
    /// The user unit of the result (µm); that of the file if not given.
    #[arg(long, value_name = "UM")]
    pub(crate) user_unit: Option<f64>,
    /// The name of the top cell in the result.
    #[arg(long, value_name = "NAME")]
    pub(crate) top: Option<String>,
    /// Layer properties of KLayout: names of layers for OASIS, looks for SVG.
    #[arg(long, value_name = "FILE")]
    pub(crate) lyp: Option<PathBuf>,
    /// How hard OASIS and gzip files are compressed, from 1 (quick) to 9 (short).
    #[arg(long, value_name = "N", default_value_t = 6)]
    pub(crate) level: u32,
    /// Cells of OASIS files are not compressed.
    #[arg(long)]
    pub(crate) no_compress: bool,
    /// The checksum of OASIS files.
    #[arg(long, value_enum, default_value = "crc32")]
    pub(crate) checksum: ChecksumFlag,
    /// What rectangles become in OASIS files.
    #[arg(long, value_enum, default_value = "rectangles")]
    pub(crate) shapes: ShapesFlag,
    /// Equal shapes of OASIS files do not share a record.
    #[arg(long)]
    pub(crate) no_merge_repeats: bool,
    /// Exit with 3 and write nothing if anything is lost.
    #[arg(long)]
    pub(crate) strict: bool,
}

/// The checksum of OASIS files.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum ChecksumFlag {
    Crc32,
    Sum,
    None,
}

/// What rectangles become in OASIS files.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum ShapesFlag {
    Rectangles,
    Polygons,
}
