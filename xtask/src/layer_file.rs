//! One layer of a file, as the command line names it (`chip.gds:1/0`).

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context, anyhow, ensure};
use phidl_boolean::grid::{self, Contours};
use phidl_boolean::{Options, Region};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::scene::Device;
use phidl_io::gds::{self, GdsOptions, ReadOptions};

/// The most points of an outline that a file can hold.
const MOST_POINTS: usize = 8190;

/// A layer of a GDSII file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LayerFile {
    path: PathBuf,
    layer: Layer,
}

impl FromStr for LayerFile {
    type Err = anyhow::Error;

    /// Reads `FILE:LAYER` or `FILE:LAYER/DATATYPE`.
    fn from_str(text: &str) -> anyhow::Result<Self> {
        let (path, layer) = text.rsplit_once(':').with_context(|| format!("{text:?} is not FILE:LAYER/DATATYPE"))?;
        ensure!(!path.is_empty(), "{text:?} names no file");
        let (number, datatype) = layer.split_once('/').unwrap_or((layer, "0"));
        let parsed = |text: &str| text.parse().with_context(|| format!("{text:?} is no layer number"));
        Ok(Self { path: path.into(), layer: Layer::new(parsed(number)?, parsed(datatype)?) })
    }
}

impl std::fmt::Display for LayerFile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}", self.path.display(), self.layer)
    }
}

impl LayerFile {
    /// The cell of the file that the layer is read from: a named one, or the only one at the top.
    pub(crate) fn read(&self, cell: Option<&str>) -> anyhow::Result<Device> {
        let import = gds::read(&self.path, &ReadOptions { cellname: cell.map(Into::into), ..ReadOptions::default() });
        let import = import.map_err(|error| anyhow!(error.report()))?;
        for problem in &import.problems {
            println!("{}: {problem}", self.path.display());
        }
        Ok(import.device)
    }

    /// Refuses to write over a file that is read: all its other layers and cells would be gone.
    pub(crate) fn ensure_is_none_of(&self, inputs: &[&Self]) -> anyhow::Result<()> {
        let same = |a: &Path, b: &Path| matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b);
        let is_input = inputs.iter().any(|input| same(&input.path, &self.path));
        ensure!(
            !is_input,
            "{}: --out must be another file than what is read, which it would replace",
            self.path.display()
        );
        Ok(())
    }

    /// What is drawn on the layer, on a grid.
    pub(crate) fn contours(&self, device: &Device, grid: &Grid) -> anyhow::Result<Contours> {
        let contours = grid::snap_device(grid, device, Some(self.layer.into()))?;
        ensure!(!contours.is_empty(), "{self}: nothing is drawn on this layer");
        Ok(contours)
    }

    /// A device that draws a region on the layer.
    pub(crate) fn drawn(&self, region: &Region, precision: f64) -> anyhow::Result<Device> {
        let name = self.path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("result");
        let options = Options { precision, max_points: Some(MOST_POINTS), ..Options::default() };
        Ok(region.to_device(name, self.layer, &options)?)
    }

    /// Writes a device to the file, on the grid that it was worked out on.
    pub(crate) fn write(&self, device: &Device, precision: f64) -> anyhow::Result<()> {
        write(device, &self.path, precision)
    }
}

/// Writes a device to a file with this grid (µm).
pub(crate) fn write(device: &Device, path: &Path, precision: f64) -> anyhow::Result<()> {
    let options = GdsOptions { grid: precision, allow_empty: true, ..GdsOptions::default() };
    gds::write(device, path, &options).map(drop).map_err(|error| anyhow!(error.report()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_of_files_are_read_from_the_end_of_the_text() {
        let read = |text: &str| text.parse::<LayerFile>().unwrap();
        assert_eq!(read("a.gds:7"), LayerFile { path: "a.gds".into(), layer: Layer::new(7, 0) });
        assert_eq!(read("C:\\b.gds:1/2"), LayerFile { path: "C:\\b.gds".into(), layer: Layer::new(1, 2) });
        for bad in ["a.gds", ":1/0", "a.gds:x", "a.gds:1/70000", "a.gds:1/"] {
            assert!(bad.parse::<LayerFile>().is_err(), "{bad}");
        }
    }
}
