//! The operations with results that keep hierarchy: what is placed often and meets nothing else is done once.
//!
//! The functions have the names and parameters of those at the top of the crate, and cover the same places. Those draw
//! everything into one cell; these draw a cell for whatever repeats, and place it where it is needed, in arrays where
//! places are regular. Everything else is drawn flat. A million placements of a cell cost little more than one.
//!
//! ```
//! use phidl_boolean::{Growth, Options, hierarchy};
//! use phidl_core::prelude::*;
//! let mut d = Device::builder("via");
//! d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], 1)?;
//! let vias = d.build()?.array(1000, 1000, (5, 5));
//! let grown = hierarchy::offset(&vias, 0.5, &Growth::default(), 1, &Options::default())?;
//! assert_eq!(grown.bbox(), Some(Rect::new((-0.5, -0.5), (4997.5, 4997.5))));
//! assert_eq!((grown.polygons().count(), grown.references().len()), (0, 1));
//! # Ok::<(), Error>(())
//! ```
//!
//! # What is promised
//!
//! - Flattened and on the grid, the result is the flat result: the same polygons, not only the same places. (Their order
//!   differs. Two conditions of the flat result concern the whole of it and do not count here: its range, and that all of
//!   it is narrower than the distance it shrinks by.)
//! - References of the result are shifts by whole grid steps, never turned: a turned placement is a case of its own, of
//!   which there are at most eight on the grid.
//! - The same input gives the same cells, in the same order.
//!
//! # What repeats
//!
//! Placements of both operands are opened from the top down. At each level, those whose boxes come near each other (the
//! distance of an offset with its joins counted) are seen together, and so is an outline that runs through a box or lies
//! around it. Such a group repeats if another one has the same cells at the same distances, mirrored, turned and magnified
//! alike, and elsewhere by whole grid steps. Arrays side by side with the same pitch are one group. A group that stands
//! alone, or next to an outline, is opened: its largest members give way to what they hold.
//!
//! Placements off the grid are told apart by the part of a step that they are off, so equal parts repeat. A corner *at* a
//! half step rounds away from zero; so cells with such corners repeat on one side of zero only, and are drawn flat where
//! they stand across it. ([`rounding`](self) decides this by the corners, so nothing else is lost.)
//!
//! `invert` is not here: the box around everything is near everything.
//!
//! Rejected: an option of the flat functions (half of what takes [`Options`] could not follow it); quarter turns of one
//! result (edges bend through half-open squares, which are not the same turned); comparing the placed corners of all
//! placements (as much work as a flat result in the case that matters).

mod cluster;
mod context;
mod item;
mod lattice;
mod rounding;
mod solve;
mod work;

use phidl_core::geom::Transform;
use phidl_core::layer::{Layer, Layers};
use phidl_core::scene::{Device, DeviceBuilder};

use super::{IntoOperation, OpenPorts, Options, Shapes, boolean::named, offset::Frame, operand::Operand};
use crate::{error::BooleanError, offset::Growth, op::Operation, point::GridPoint};
use item::{Pile, open_cell};
use solve::Solver;
use work::Work;

/// Runs a set operation and keeps what repeats in cells of its own. See [`boolean`](super::boolean()).
///
/// # Errors
/// As for [`boolean`](super::boolean()).
///
/// # Examples
/// ```
/// use phidl_boolean::{Options, hierarchy};
/// use phidl_core::prelude::*;
/// let pads = |size: f64| -> Result<Reference> {
///     let mut d = Device::builder("pad");
///     d.add_polygon(Rect::new((-size, -size), (size, size)), 1)?;
///     Ok(d.build()?.array(50, 50, (20, 20)))
/// };
/// let frames = hierarchy::boolean(&pads(5.0)?, &pads(2.0)?, "not", 3, &Options::default())?;
/// assert_eq!(frames.references().len(), 1);
/// assert_eq!(frames.flat_polygons().count(), 2500);
/// # Ok::<(), Error>(())
/// ```
pub fn boolean(
    a: &(impl Shapes + ?Sized),
    b: &(impl Shapes + ?Sized),
    operation: impl IntoOperation,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    named("boolean", || {
        let work = Work::Combine(operation.into_operation()?);
        let operands = [Operand::new("A", a)?, Operand::new("B", b)?];
        finished("boolean", |cell| draw(cell, "boolean", work, &operands, &layer.into(), options))
    })
}

/// Merges everything that is drawn, on all layers, and keeps what repeats in cells of its own. See
/// [`union`](super::union()).
///
/// # Errors
/// As for [`boolean`](super::boolean()).
pub fn union(
    shapes: &(impl Shapes + ?Sized),
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    named("union", || {
        let operands = [Operand::new("shapes", shapes)?, Operand::new("nothing", &())?];
        let work = Work::Combine(Operation::Or);
        finished("union", |cell| draw(cell, "union", work, &operands, &layer.into(), options))
    })
}

/// Merges what is drawn on each layer on its own, and keeps what repeats in cells of its own. See
/// [`union_by_layer`](super::union_by_layer()).
///
/// # Errors
/// As for [`boolean`](super::boolean()).
pub fn union_by_layer(shapes: &(impl Shapes + ?Sized), options: &Options) -> Result<Device, BooleanError> {
    named("union", || {
        by_layer("union", Operation::Or, [Operand::new("shapes", shapes)?, Operand::new("nothing", &())?], options)
    })
}

/// What differs between two operands, layer by layer, and keeps what repeats in cells of its own. See
/// [`xor_diff`](super::xor_diff()).
///
/// # Errors
/// As for [`boolean`](super::boolean()).
pub fn xor_diff(
    a: &(impl Shapes + ?Sized),
    b: &(impl Shapes + ?Sized),
    options: &Options,
) -> Result<Device, BooleanError> {
    named("xor_diff", || by_layer("xor_diff", Operation::Xor, [Operand::new("A", a)?, Operand::new("B", b)?], options))
}

/// Grows or shrinks shapes and keeps what repeats in cells of its own. See [`offset`](super::offset()).
///
/// # Errors
/// As for [`offset`](super::offset()).
pub fn offset(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    growth: &Growth,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    named("offset", || {
        let work = Work::Offset(options.grid()?.scaled(distance.into()), *growth);
        let operands = [Operand::new("shapes", shapes)?, Operand::new("nothing", &())?];
        finished("offset", |cell| draw(cell, "offset", work, &operands, &layer.into(), options))
    })
}

/// Frames shapes and keeps what repeats in cells of its own. See [`outline`](super::outline()).
///
/// # Errors
/// As for [`outline`](super::outline()).
pub fn outline(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    growth: &Growth,
    open_ports: OpenPorts,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let distance = distance.into();
    named("outline", || {
        let frame = Frame { distance, growth: *growth, open_ports };
        let shapes = Operand::new("shapes", shapes)?;
        let ports = frame.ports_to_hand_on(&shapes);
        let openings = Operand::new("openings", &frame.openings(&shapes, options.precision))?;
        let operands = [shapes, openings];
        finished("outline", |cell| {
            draw(cell, "outline", Work::Frame(frame), &operands, &layer.into(), options)?;
            Ok(cell.add_ports(ports).map(drop)?)
        })
    })
}

/// A cell that is drawn by a function.
fn finished(
    name: &str,
    draw: impl FnOnce(&mut DeviceBuilder) -> Result<(), BooleanError>,
) -> Result<Device, BooleanError> {
    let mut cell = Device::builder(name);
    draw(&mut cell)?;
    Ok(cell.build()?)
}

fn by_layer(
    name: &str,
    operation: Operation,
    operands: [Operand; 2],
    options: &Options,
) -> Result<Device, BooleanError> {
    let mut layers: Vec<Layer> = operands.iter().flat_map(Operand::layers).collect();
    layers.sort_unstable();
    layers.dedup();
    finished(name, |cell| {
        for layer in layers {
            let [a, b] = &operands;
            let on_layer = [a.on_layer(layer)?, b.on_layer(layer)?];
            draw(cell, name, Work::Combine(operation), &on_layer, &layer.into(), options)?;
        }
        Ok(())
    })
}

/// Draws what some work makes of two operands.
fn draw(
    cell: &mut DeviceBuilder,
    name: &str,
    work: Work,
    operands: &[Operand; 2],
    layers: &Layers,
    options: &Options,
) -> Result<(), BooleanError> {
    let grid = options.grid()?;
    work.check(options)?;
    let (mut items, mut pile) = (Vec::new(), Pile::default());
    for (side, operand) in operands.iter().enumerate() {
        open_cell(operand.cell(), side, &Transform::IDENTITY, &grid, &mut items, &mut pile)?;
    }
    options.run.on_threads(|| {
        // The threads are there already; pieces of the work must not start their own.
        let mut inner = *options;
        inner.run.threads = None;
        Solver::new(work, name, layers, grid, &inner).draw(cell, items, pile, GridPoint::default())
    })
}
