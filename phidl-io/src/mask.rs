//! Building a mask: one device into a folder of files.
//!
//! | file | what it is |
//! |---|---|
//! | `NAME.gds` | the mask, hierarchy kept |
//! | `NAME.svg` | a picture of it |
//! | `metadata.json` | every cell: generator, parameters, info, ports, instances; and the summary |
//! | `devices.csv` | where each device is on the mask, with its parameters |
//!
//! The same device and options give the same bytes, whenever and on however many threads.

use std::path::{Path, PathBuf};

use phidl_core::scene::Device;

use crate::atomic;
use crate::error::{IoError, Result};
use crate::gds::{self, GdsOptions, GdsReport};
use crate::json;
use crate::placements;
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

/// A step of a mask build, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The GDSII file.
    Gds,
    /// The picture.
    Svg,
    /// The metadata.
    Metadata,
    /// The table of devices.
    Devices,
}

impl std::fmt::Display for Step {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Gds => "writing GDSII",
            Self::Svg => "drawing SVG",
            Self::Metadata => "writing metadata",
            Self::Devices => "listing devices",
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

/// Writes a device into a folder, which is made if it does not exist. Each file is whole or does not exist. Symbolic links
/// in the folder that lead out of it are refused.
///
/// `started` is called with every step when it begins.
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
    let names = [format!("{name}.gds"), format!("{name}.svg"), "metadata.json".to_owned(), "devices.csv".to_owned()];
    let [gds_name, svg_name, metadata_name, devices_name] = names.each_ref();

    started(Step::Gds);
    let gds = gds::write_in(device, folder, gds_name, &options.gds)?;
    let summary = Summary::of_file(device, &options.gds, folder.join(gds_name))?;
    started(Step::Svg);
    atomic::write_in(folder, svg_name, svg::to_string(device, &options.svg)?.as_bytes())?;
    started(Step::Metadata);
    let mut metadata = json::metadata(device, &options.gds)?;
    metadata["summary"] = summary.to_json();
    atomic::write_in(folder, metadata_name, json::to_text(&metadata).as_bytes())?;
    started(Step::Devices);
    atomic::write_in(folder, devices_name, placements::csv(device, &options.gds)?.as_bytes())?;

    Ok(MaskReport { files: names.map(|name| folder.join(name)).to_vec(), gds, summary })
}
