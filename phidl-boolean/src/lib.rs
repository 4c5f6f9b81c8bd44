//! Exact, parallel booleans and offsets on an integer grid.
//!
//! | To do | use |
//! | --- | --- |
//! | combine, merge, compare | [`boolean`], [`union`], [`union_by_layer`], [`xor_diff`] |
//! | measure | [`merged_area`], [`merged_areas`] |
//! | grow, shrink, frame, invert | [`offset()`], [`outline`], [`invert`] |
//! | choose the operands | any type that is [`Shapes`]: devices, references, polygons, outlines, lists |
//! | choose the grid, the threads, progress and cancellation | [`Options`], [`RunOptions`], [`ProgressMonitor`] |
//! | keep cells that are placed often | [`Hierarchy::Keep`] in the [`Options`] |
//! | process a result further | [`Region`]: `&a \| &b`, `&a & &b`, `&a - &b`, `&a ^ &b`, area, box, point tests, [`Region::to_device`] |
//! | work on integer coordinates | [`grid`] |
//! | port a script with PHIDL's `kl_` functions | [`klayout`] |
//!
//! # Invariants
//!
//! - Results depend on the shapes alone. Threads and strips change the run time, but no point of the result.
//! - No edge moves by more than half a grid step in x or y, in any crowd. Edges that need no snapping keep their points
//!   exactly, so axis-parallel shapes are combined without any error. (Combining a *result* again may snap an edge to a
//!   vertex within half a step; axis-parallel shapes never move.)
//! - Any input is accepted: self-crossing shapes, repeated points, spikes, seams, no area. Invalid values are refused with
//!   a [`BooleanError`] that names the value and the rule.
//! - The cost is near-linear: a segment is only compared with what is near it. The exception is a larger result: `n` long
//!   lines across `n` others have `n²` crossings.
//!
#![doc = include_str!("../docs/stages.md")]
#![doc = include_str!("../docs/stages.svg")]
//!
//! # Time and number of strips
//!
//!
#![doc = include_str!("../docs/divisions.svg")]
//!
//! This crate divides into strips, KLayout's tiling processor into tiles whose seams it merges afterwards; both have two
//! threads. The measurement is described in `benches/README.md` of the repository.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod contours;
mod device;
mod engine;
mod error;
mod fracture;
mod geo;
pub mod grid;
mod jobs;
mod offset;
mod op;
mod options;
mod point;
mod progress;
mod region;
mod region_ops;

pub use device::{
    Hierarchy, IntoOperation, Margin, OpenPorts, Options, Shapes, boolean, invert, klayout, merged_area, merged_areas,
    offset, outline, union, union_by_layer, xor_diff,
};
pub use error::BooleanError;
pub use offset::{Join, OffsetOptions};
pub use op::Operation;
pub use options::{RunOptions, StripCount};
pub use progress::{Progress, ProgressMonitor};
pub use region::Region;

/// The stages of the engine, for the picture in its docs.
#[doc(hidden)]
pub mod stages {
    pub use crate::engine::stages::{Stages, record};
}
