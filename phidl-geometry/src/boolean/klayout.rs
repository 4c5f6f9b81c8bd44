//! [`kl_boolean`], [`kl_offset`], [`kl_outline`] and [`kl_invert`]: the same engine under KLayout's options.
//!
//! `merge_after` must be true. PHIDL's `merge_after=False` leaves the parts of the tiles of a tiled run, with seams and
//! overlaps. Results of this engine have no parts: an operation ends with outlines drawn once around the covered area, for
//! every `tile_size`. The input of an `or` is no substitute for parts: it is not rounded, and its shapes may cross themselves.

use phidl_boolean::klayout::KLayoutOptions;
use phidl_boolean::{Margin, OpenPorts};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::{DeviceList, NumCpu};
use crate::basic::{circle, cross, rectangle};

/// Default tile size (µm).
const TILE: Size = Size { width: 1000.0, height: 1000.0 };

fn options(precision: f64, tile_size: Option<Size>, num_cpu: NumCpu) -> KLayoutOptions<'static> {
    let tile_size = tile_size.map(|tile| (tile.width, tile.height));
    KLayoutOptions { precision, tile_size, num_cpu: num_cpu.0, monitor: None }
}

fn check_merged(check: Check<'_>, merge_after: bool) -> Result<()> {
    check.that("merge_after", merge_after, merge_after, "be true, because results are always merged")
}

/// Runs a set operation; see [`boolean`](fn@super::boolean).
///
/// # Ports
/// None.
///
/// # Errors
/// Those of [`boolean`](fn@super::boolean).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let (disc, square) = (pg::circle(10, 2.5, 0)?, pg::rectangle((12, 12), 1)?);
/// let rest = pg::KlBooleanParams::new(&disc, &square, "A-B").layer(2).build()?;
/// assert_eq!(rest.drawing_hash(), pg::BooleanParams::new(&disc, &square, "not").layer(2).build()?.drawing_hash());
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `kl_boolean`.
#[device(picture = "docs/kl_boolean.svg", example = KlBooleanParams::new(circle(10, 2.5, 0)?, rectangle((12, 12), 1)?, "not"))]
pub fn kl_boolean(
    /// First operand.
    #[param(name = "A")]
    a: DeviceList,
    /// Second operand.
    #[param(name = "B")]
    b: DeviceList,
    /// The operation: `and`, `or` (`A+B`), `not` (`A-B`), `B-A`, `xor`.
    operation: String,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Approximate size of the parts given to threads; none lets the engine choose. The result does not depend on it.
    #[default(Some(TILE))]
    #[param(unit = "um")]
    tile_size: Option<Size>,
    /// Must be true: results are always merged.
    #[default(true)]
    merge_after: bool,
    /// Number of threads; the result does not depend on it.
    #[default(NumCpu::ALL)]
    num_cpu: NumCpu,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check_merged(check, merge_after)?;
    Ok(phidl_boolean::klayout::kl_boolean(&a, &b, operation.as_str(), layer, &options(precision, tile_size, num_cpu))?)
}

/// Grows or shrinks shapes; see [`offset`](fn@super::offset).
///
/// # Ports
/// None.
///
/// # Errors
/// Those of [`offset`](fn@super::offset).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::rectangle((10, 10), 1)?;
/// let grown = pg::KlOffsetParams::new(&pad).distance(2).build()?;
/// let cut = pg::KlOffsetParams::new(&pad).distance(2).miter_mode(0).build()?;
/// assert_eq!(grown.area(), 14.0 * 14.0);
/// assert_eq!(cut.area(), 14.0 * 14.0 - 4.0 * 2.0); // half of a 2 × 2 square less at each corner
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `kl_offset`.
#[device(picture = "docs/kl_offset.svg", example = KlOffsetParams::new(cross(10, 3, 0)?).distance(1))]
pub fn kl_offset(
    /// The devices.
    elements: DeviceList,
    /// Distance, rounded to whole grid steps; negative goes inside.
    #[default(0.1)]
    #[param(unit = "um")]
    distance: f64,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Cut of corners: 0 cuts all, 1 keeps 135° and blunter, 2 keeps right angles, up to 5.
    #[default(2)]
    miter_mode: usize,
    /// Approximate size of the parts given to threads; none lets the engine choose. The result does not depend on it.
    #[default(Some(TILE))]
    #[param(unit = "um")]
    tile_size: Option<Size>,
    /// Must be true: results are always merged.
    #[default(true)]
    merge_after: bool,
    /// Number of threads; the result does not depend on it.
    #[default(NumCpu::ALL)]
    num_cpu: NumCpu,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check_merged(check, merge_after)?;
    let options = options(precision, tile_size, num_cpu);
    Ok(phidl_boolean::klayout::kl_offset(&elements, distance, miter_mode, layer, &options)?)
}

/// Draws a frame around or inside shapes; see [`outline`](fn@super::outline).
///
/// # Ports
/// Those of a single element, if ports are open.
///
/// # Errors
/// Those of [`outline`](fn@super::outline).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let frame = pg::KlOutlineParams::new(pg::rectangle((10, 10), 1)?).distance(2).build()?;
/// assert_eq!(frame.area(), 14.0 * 14.0 - 10.0 * 10.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `kl_outline`.
#[device(picture = "docs/kl_outline.svg", example = KlOutlineParams::new(cross(10, 3, 0)?).distance(1))]
pub fn kl_outline(
    /// The devices.
    elements: DeviceList,
    /// Distance, rounded to whole grid steps; negative goes inside.
    #[default(0.1)]
    #[param(unit = "um")]
    distance: f64,
    /// Openings of the frame at ports: false, true, or an opening wider than the port by this length (µm).
    #[default(false)]
    open_ports: OpenPorts,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Cut of corners: 0 cuts all, 1 keeps 135° and blunter, 2 keeps right angles, up to 5.
    #[default(2)]
    miter_mode: usize,
    /// Approximate size of the parts given to threads; none lets the engine choose. The result does not depend on it.
    #[default(Some(TILE))]
    #[param(unit = "um")]
    tile_size: Option<Size>,
    /// Must be true: results are always merged.
    #[default(true)]
    merge_after: bool,
    /// Number of threads; the result does not depend on it.
    #[default(NumCpu::ALL)]
    num_cpu: NumCpu,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check_merged(check, merge_after)?;
    let options = options(precision, tile_size, num_cpu);
    Ok(phidl_boolean::klayout::kl_outline(&elements, distance, open_ports, miter_mode, layer, &options)?)
}

/// Draws the complement of shapes inside a box around all of them; see [`invert`](fn@super::invert).
///
/// # Ports
/// None.
///
/// # Errors
/// Those of [`invert`](fn@super::invert).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let mold = pg::KlInvertParams::new(pg::rectangle((10, 10), 1)?).border((2, 5)).build()?;
/// assert_eq!(mold.area(), 14.0 * 20.0 - 10.0 * 10.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `kl_invert`.
#[device(picture = "docs/kl_invert.svg", example = KlInvertParams::new(cross(10, 3, 0)?))]
pub fn kl_invert(
    /// The devices.
    elements: DeviceList,
    /// Margin of the box around the shapes, in all directions or in x and in y.
    #[default((10, 10))]
    #[param(unit = "um")]
    border: Margin,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Approximate size of the parts given to threads; none lets the engine choose. The result does not depend on it.
    #[default(Some(TILE))]
    #[param(unit = "um")]
    tile_size: Option<Size>,
    /// Must be true: results are always merged.
    #[default(true)]
    merge_after: bool,
    /// Number of threads; the result does not depend on it.
    #[default(NumCpu::ALL)]
    num_cpu: NumCpu,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check_merged(check, merge_after)?;
    Ok(phidl_boolean::klayout::kl_invert(&elements, border, layer, &options(precision, tile_size, num_cpu))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_leave_no_parts_and_unmerged_results_are_refused() {
        let (a, b) = (circle(10, 2.5, 0).unwrap(), rectangle((12, 12), 1).unwrap());
        for tile_size in [None, Some(Size::new(1.0, 1.0)), Some(TILE)] {
            let params = KlBooleanParams::new(a.clone(), b.clone(), "or").tile_size(tile_size);
            assert_eq!(params.clone().build().unwrap().polygons().count(), 1, "{tile_size:?}");
            let error = params.merge_after(false).build().unwrap_err().to_string();
            assert!(error.contains("merge_after is false, but it must be true"), "{error}");
        }
    }
}
