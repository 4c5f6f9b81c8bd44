//! Building a mask: one device into a folder of files.
//!
//! | file | what it is |
//! |---|---|
//! | `NAME.gds` | the mask, hierarchy kept |
//! | `NAME.svg` | a picture of it |
//! | `metadata.json` | every cell: generator, parameters, info, ports, instances; and the summary |
//!
//! The same device and options give the same bytes, whenever and on however many threads.

use std::path::{Path, PathBuf};

use phidl_core::scene::Device;

use crate::atomic;
use crate::error::{IoError, Result};
use crate::gds::{self, GdsOptions, GdsReport};
use crate::json;
use crate::summary::Summary;
use crate::svg::{self, SvgOptions};

/// What a mask is called and how it is written.
#[derive(Debug, Clone, Default)]
pub struct MaskOptions {
    /// How the GDSII file is written.
    pub gds: GdsOptions,
    /// How the picture is drawn.
    pub svg: SvgOptions,
}

/// One thing that building a mask does, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The GDSII file.
    Gds,
    /// The picture.
    Svg,
    /// The metadata.
    Metadata,
}

impl std::fmt::Display for Step {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Gds => "writing GDSII",
            Self::Svg => "drawing SVG",
            Self::Metadata => "writing metadata",
        })
    }
}

/// What was built.
#[derive(Debug, Clone)]
pub struct MaskReport {
    /// The files, in the order in which they were written.
    pub files: Vec<PathBuf>,
    /// What the writer of the GDSII file did.
    pub gds: GdsReport,
    /// What the mask holds.
    pub summary: Summary,
}

/// Writes a device into a folder, which is made if it is not there. Each file is whole or not there at all.
///
/// `started` hears of every step when it begins.
///
/// # Errors
/// What the writers say; files that were finished before stay.
pub fn build(
    name: &str,
    device: &Device,
    folder: &Path,
    options: &MaskOptions,
    mut started: impl FnMut(Step),
) -> Result<MaskReport> {
    std::fs::create_dir_all(folder).map_err(|error| IoError::file(folder, "make the folder", error))?;
    let [gds_file, svg_file] = ["gds", "svg"].map(|ending| folder.join(format!("{name}.{ending}")));
    let metadata_file = folder.join("metadata.json");

    started(Step::Gds);
    let gds = gds::write(device, &gds_file, &options.gds)?;
    let summary = Summary::of_file(device, &options.gds, &gds_file)?;
    started(Step::Svg);
    svg::write(device, &svg_file, &options.svg)?;
    started(Step::Metadata);
    let mut metadata = json::metadata(device, &options.gds)?;
    metadata["summary"] = summary.to_json();
    atomic::write(&metadata_file, json::to_text(&metadata).as_bytes())?;

    Ok(MaskReport { files: vec![gds_file, svg_file, metadata_file], gds, summary })
}
