//! Exact, parallel booleans and offsets on an integer grid.
//!
//! | To do | use |
//! | --- | --- |
//! | round micrometers to the grid | [`Grid::snap`], the only place where coordinates are rounded |
//! | combine two layers of shapes | [`boolean`] |
//! | merge one layer | [`Region::merged`] |
//! | grow or shrink | [`offset()`], [`Region::offset`] |
//! | work on with a result | [`Region`]: `&a \| &b`, `&a & &b`, `&a - &b`, `&a ^ &b`, area, box, point tests |
//! | write it to a file | [`Region::without_holes`], [`Region::fractured`] |
//! | watch, stop, choose threads | [`RunOptions`], [`Watch`] |
//!
//! # What is promised
//!
//! - Results depend on the shapes alone. Threads and strips change how long it takes, not one point of the outcome.
//! - No edge moves by more than half a grid step in x or y, however crowded the place. Edges that need not bend keep
//!   their points exactly, so upright shapes are combined without any error. (Combining a *result* again may bend an
//!   edge that has come within half a step of a vertex; nothing moves on upright shapes.)
//! - Any input is taken: crossing itself, repeated points, spikes, seams, no area at all. What is refused is refused
//!   with a [`BooleanError`] that names the value and the rule.
//! - Near-linear cost: a place is only compared with what is near it. The exception is a result that is itself larger:
//!   `n` long lines across `n` others have `n²` crossings.
//!
//! The engine's module docs explain why a divided plane gives the undivided result.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod contours;
mod engine;
mod error;
mod fracture;
mod grid;
mod offset;
mod op;
mod options;
mod point;
mod progress;
mod region;

pub use contours::Contours;
pub use error::BooleanError;
pub use grid::Grid;
pub use offset::{Join, OffsetOptions, offset};
pub use op::Operation;
pub use options::RunOptions;
pub use point::{GridPoint, MAX_COORDINATE, signed_area2};
pub use progress::{Progress, Watch};
pub use region::{Polygon, Region};

/// Runs a set operation on two layers of shapes.
///
/// Each operand is the union of its shapes, whatever their direction; a shape that crosses itself covers all its
/// lobes. An empty operand is the empty set.
///
/// # Errors
/// [`BooleanError::OutOfRange`] for a coordinate beyond ±[`MAX_COORDINATE`], [`BooleanError::Option`] for a bad
/// option, [`BooleanError::TooLarge`] for more than 2³¹ edges, [`BooleanError::Cancelled`] if a [`Watch`] says so.
///
/// # Examples
/// ```
/// use phidl_boolean::{Grid, Operation, RunOptions, boolean};
/// let grid = Grid::new(1e-3)?;
/// let square = |x: f64| [(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 2.0), (x, 2.0)];
/// let (a, b) = (grid.snap([square(0.0)])?, grid.snap([square(1.0)])?);
/// let both = boolean(&a, &b, Operation::And, &RunOptions::default())?;
/// assert_eq!(both.area(), 1000.0 * 2000.0);
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
pub fn boolean(a: &Contours, b: &Contours, operation: Operation, options: &RunOptions) -> Result<Region, BooleanError> {
    let rule = engine::Rule { operation, fill: op::Fill::NonZero };
    engine::resolve([engine::Operand::Drawn(a), engine::Operand::Drawn(b)], rule, options)
}
