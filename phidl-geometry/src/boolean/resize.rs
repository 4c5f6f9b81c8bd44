//! [`offset`](fn@offset), [`outline`] and [`invert`].

use phidl_boolean::{Margin, OpenPorts};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::{DeviceList, Divisions, JoinName};
use crate::basic::cross;

/// Grows shapes by a distance, or shrinks them by a negative one.
///
/// # Ports
/// None.
///
/// # Errors
/// A coordinate or `distance` beyond the grid of ±2⁴⁰ steps of `precision`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let grown = pg::OffsetParams::new(pg::rectangle((10, 2), 1)?).distance(0.5).build()?;
/// assert_eq!(grown.bbox(), Some(Rect::new((-0.5, -0.5), (10.5, 2.5))));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `offset`.
#[device(picture = "docs/offset.svg", example = OffsetParams::new(cross(10, 3, 0)?).distance(1))]
pub fn offset(
    /// The devices to grow.
    elements: DeviceList,
    /// Distance; negative shrinks.
    #[default(0.1)]
    #[param(unit = "um")]
    distance: f64,
    /// Merge overlapping shapes first; otherwise each is shrunk on its own.
    #[default(true)]
    join_first: bool,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Number of parts of the plane in x and y. The result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// Shape of the corners.
    #[default(JoinName::Miter)]
    join: JoinName,
    /// For miters, the largest distance of a tip from its corner, in distances (at least 2); for arcs, the points of a full turn.
    #[default(2.0)]
    tolerance: f64,
    /// Largest number of points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let growth = join.growth(tolerance, distance, precision, join_first);
    let options = num_divisions.options(precision, max_points);
    Ok(phidl_boolean::offset(&elements, distance, &growth, layer, &options)?)
}

/// Draws a frame around shapes, or inside them with a negative distance.
///
/// # Ports
/// Those of a single element, if ports are open.
///
/// # Errors
/// Those of [`offset`](fn@offset).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let wire = pg::straight((1, 10), 1)?;
/// let trench = pg::OutlineParams::new(&wire).distance(2).open_ports(true).layer(5).build()?;
/// assert_eq!((trench.polygons().count(), trench.ports().len()), (2, 2));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `outline`.
#[device(picture = "docs/outline.svg", example = OutlineParams::new(cross(10, 3, 0)?))]
pub fn outline(
    /// The devices to frame.
    elements: DeviceList,
    /// Width of the frame; negative draws it inside.
    #[default(1.0)]
    #[param(unit = "um")]
    distance: f64,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Number of parts of the plane in x and y. The result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// Shape of the corners.
    #[default(JoinName::Miter)]
    join: JoinName,
    /// For miters, the largest distance of a tip from its corner, in distances (at least 2); for arcs, the points of a full turn.
    #[default(2.0)]
    tolerance: f64,
    /// Merge overlapping shapes first; otherwise each is shrunk on its own.
    #[default(true)]
    join_first: bool,
    /// Largest number of points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Openings of the frame at ports: false, true, or an opening wider than the port by this length (µm).
    #[default(false)]
    open_ports: OpenPorts,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let growth = join.growth(tolerance, distance, precision, join_first);
    let options = num_divisions.options(precision, max_points);
    Ok(phidl_boolean::outline(&elements, distance, &growth, open_ports, layer, &options)?)
}

/// Draws the complement of shapes inside a box around all of them.
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
/// let mold = pg::invert(pg::rectangle((10, 10), 1)?, 2, 1e-4, [1, 1], 4000, 1)?;
/// assert_eq!(mold.polygons().map(|p| p.area()).sum::<f64>(), 96.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own engine, compatible with PHIDL's `invert`.
#[device(picture = "docs/invert.svg", example = InvertParams::new(cross(10, 3, 0)?))]
pub fn invert(
    /// The devices to leave out.
    elements: DeviceList,
    /// Margin of the box around the shapes, in all directions or in x and in y.
    #[default(10.0)]
    #[param(unit = "um")]
    border: Margin,
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
    Ok(phidl_boolean::invert(&elements, border, layer, &num_divisions.options(precision, max_points))?)
}
