//! Devices as SVG pictures: [`write()`], [`to_string`]; small ones with their ports, for documentation: [`figure()`].
//!
//! - **One group per layer**, ascending, colored from a [`LayerSet`] or PHIDL's palette; the opacity is the group's, so that
//!   overlaps within a layer do not get darker. Labels come last, as text.
//! - **Holes.** All outlines of a cell on a layer are one path with the fill rule `nonzero`, each turned to run
//!   counter-clockwise. So overlapping polygons stay filled (with `evenodd` they would cut holes into each other), and the
//!   hole of a keyholed outline, which is run around both ways, stays open.
//! - **The hierarchy stays.** Each cell is written once for each layer it is drawn on, and placed with `<use>`. Arrays are
//!   doubled up: a row of 1000 is ten definitions, not a thousand elements.
//!
//! PHIDL flattens, and has neither opacity nor a view box; that makes a large chip a picture of gigabytes.

mod array;
mod document;
mod figure;
mod looks;
pub(crate) use looks::palette;
mod number;

use std::path::Path;

use phidl_core::layer::LayerSet;
use phidl_core::scene::Device;

use crate::atomic;
use crate::error::{IoError, Result};

pub use figure::{FigureOptions, ScaleBar, figure};

/// How a picture is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SvgOptions {
    /// Colors and opacities. Layers that are not in the set, or have no color, take one from the palette.
    pub layers: LayerSet,
    /// Pixels per micrometer, for programs that show the picture in its own size.
    pub scale: f64,
    /// Height of the letters of labels (µm); a fiftieth of the picture's longer side unless given.
    pub label_height: Option<f64>,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self { layers: LayerSet::new(), scale: 1.0, label_height: None }
    }
}

impl SvgOptions {
    fn check(&self) -> Result<()> {
        positive("scale", self.scale)?;
        self.label_height.map_or(Ok(()), |height| positive("label_height", height))
    }
}

/// Refuses what cannot be a length.
fn positive(option: &'static str, v: f64) -> Result<()> {
    match v > 0.0 && v.is_finite() {
        true => Ok(()),
        false => Err(IoError::option(option, v, "be greater than 0 and finite")),
    }
}

/// Draws a device as an SVG picture. The same device gives the same text, on every machine with the same sine.
///
/// ```
/// # use phidl_core::prelude::*;
/// use phidl_io::svg::{self, SvgOptions};
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
/// let picture = svg::to_string(&d.build()?, &SvgOptions::default())?;
/// assert!(picture.contains(r#"<path d="M0 0L4 0 4 2 0 2Z"/>"#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Option`].
pub fn to_string(device: &Device, options: &SvgOptions) -> Result<String> {
    options.check()?;
    Ok(document::draw(device, options))
}

/// Draws a device as an SVG picture into a file. The path is taken as it is.
///
/// # Errors
/// [`IoError::Option`], [`IoError::File`].
pub fn write(device: &Device, path: impl AsRef<Path>, options: &SvgOptions) -> Result<()> {
    atomic::write(path, to_string(device, options)?.as_bytes()).map(|_| ())
}
