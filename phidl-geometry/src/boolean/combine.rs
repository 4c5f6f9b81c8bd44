//! [`boolean`](fn@boolean), [`union`] and [`xor_diff`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::{DeviceList, Divisions};
use crate::basic::{circle, rectangle};

/// Runs a set operation on two operands: `and`, `or`, `not` (`A-B`), `B-A` or `xor`.
///
/// Each operand is the union of its shapes on all layers. Holes of the result are cut open.
///
/// # Ports
/// None.
///
/// # Errors
/// An unknown operation, a coordinate off the grid.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let (disc, bar) = (pg::circle(5, 2.5, 0)?, pg::rectangle((12, 3), 0)?);
/// let rest = pg::boolean(&disc, &bar, "not", 1e-4, [1, 1], 4000, 1)?;
/// assert_eq!(rest.polygons().count(), 1);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `boolean`.
#[device(picture = "docs/boolean.svg", example = BooleanParams::new(circle(10, 2.5, 0)?, rectangle((12, 12), 1)?, "not"))]
pub fn boolean(
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
    /// Number of parts of the plane in x and y. The result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// Largest number of points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let options = num_divisions.options(precision, max_points);
    Ok(phidl_boolean::boolean(&a, &b, operation.as_str(), layer, &options)?)
}

/// Merges what overlaps or touches, all layers together or each on its own.
///
/// # Ports
/// None.
///
/// # Errors
/// A coordinate beyond the grid of ±2⁴⁰ steps of `precision`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let merged = pg::union([pg::cross(10, 3, 1)?, pg::circle(4, 2.5, 2)?], false, 1e-4, true, 4000, 7)?;
/// assert_eq!((merged.polygons().count(), merged.layers()), (1, vec![Layer::new(7, 0)]));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `union`.
#[device(picture = "docs/union.svg", example = UnionParams::new([circle(10, 2.5, 0)?, rectangle((12, 12), 1)?]))]
pub fn union(
    /// The devices to merge.
    #[param(name = "D")]
    d: DeviceList,
    /// Merge each layer separately and keep it; `layer` is then not used.
    #[default(false)]
    by_layer: bool,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Must be true: a union has only one order. PHIDL ignores the value.
    #[default(true)]
    join_first: bool,
    /// Largest number of points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check.that("join_first", join_first, join_first, "be true, because a union joins all shapes at once")?;
    let options = Divisions(1, 1).options(precision, max_points);
    Ok(if by_layer { phidl_boolean::union_by_layer(&d, &options)? } else { phidl_boolean::union(&d, layer, &options)? })
}

/// Draws what differs between two devices, layer by layer.
///
/// # Ports
/// None.
///
/// # Errors
/// A coordinate beyond the grid of ±2⁴⁰ steps of `precision`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let (old, new) = (pg::rectangle((10, 2), 1)?, pg::rectangle((10.5, 2.0), 1)?);
/// assert_eq!(pg::xor_diff(&old, &new, 1e-4)?.bbox(), Some(Rect::new((10, 0), (10.5, 2.0))));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `xor_diff`.
#[device(picture = "docs/xor_diff.svg", example = XorDiffParams::new(circle(10, 2.5, 0)?, rectangle((12, 12), 1)?))]
pub fn xor_diff(
    /// One drawing.
    #[param(name = "A")]
    a: DeviceList,
    /// The other one.
    #[param(name = "B")]
    b: DeviceList,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
) -> Result<Device> {
    let options = phidl_boolean::Options { precision, ..phidl_boolean::Options::default() };
    Ok(phidl_boolean::xor_diff(&a, &b, &options)?)
}
