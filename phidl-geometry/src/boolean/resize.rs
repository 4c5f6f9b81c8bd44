//! [`offset`](fn@offset), [`outline`] and [`invert`].

use phidl_boolean::{Margin, OpenPorts};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::{Divisions, Elements, JoinName};
use crate::basic::cross;

/// Grows shapes by a distance, or shrinks them by a negative one.
///
/// # Ports
/// None.
///
/// # Errors
/// A coordinate that is off the grid, which reaches ±2⁴⁰ steps of `precision`, with the cell it is in.
/// `distance` beyond the grid.
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
    /// What is grown.
    elements: Elements,
    /// How far; negative shrinks.
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
    /// Parts that the plane is divided into; the result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// What is put at corners.
    #[default(JoinName::Miter)]
    join: JoinName,
    /// Of miters, the farthest tip in distances (at least 2); of arcs, the points of a full turn.
    #[default(2.0)]
    tolerance: f64,
    /// The most points of a polygon; fewer than 5 mean no limit.
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
    /// What is framed.
    elements: Elements,
    /// Width of the frame; negative draws it inside.
    #[default(1.0)]
    #[param(unit = "um")]
    distance: f64,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Parts that the plane is divided into; the result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// What is put at corners.
    #[default(JoinName::Miter)]
    join: JoinName,
    /// Of miters, the farthest tip in distances (at least 2); of arcs, the points of a full turn.
    #[default(2.0)]
    tolerance: f64,
    /// Merge overlapping shapes first; otherwise each is shrunk on its own.
    #[default(true)]
    join_first: bool,
    /// The most points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Whether the frame is open at ports: false, true, or how much wider than the port (µm).
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

/// Draws what shapes leave free in the box around all of them.
///
/// # Ports
/// None.
///
/// # Errors
/// A coordinate that is off the grid, which reaches ±2⁴⁰ steps of `precision`, with the cell it is in. `num_divisions` of 0.
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
    /// What is left out.
    elements: Elements,
    /// How far the box reaches beyond the shapes, in all directions or in x and in y.
    #[default(10.0)]
    #[param(unit = "um")]
    border: Margin,
    /// Grid step.
    #[default(1e-4)]
    #[param(unit = "um", above = 0.0)]
    precision: f64,
    /// Parts that the plane is divided into; the result does not depend on it.
    #[default([1, 1])]
    num_divisions: Divisions,
    /// The most points of a polygon; fewer than 5 mean no limit.
    #[default(4000)]
    max_points: usize,
    /// Where the result is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    Ok(phidl_boolean::invert(&elements, border, layer, &num_divisions.options(precision, max_points))?)
}
