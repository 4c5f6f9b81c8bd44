//! Exact, parallel booleans and offsets on an integer grid.
//!
//! | To do | use |
//! | --- | --- |
//! | combine, merge, compare | [`boolean`], [`union`], [`union_by_layer`], [`xor_diff`] |
//! | measure | [`merged_area`], [`merged_areas`] |
//! | grow, shrink, frame, invert | [`offset()`], [`outline`], [`invert`] |
//! | port a script that used KLayout's engine | [`kl_boolean`], [`kl_offset`], [`kl_outline`], [`kl_invert`] |
//! | say what the operands are | anything that is [`Shapes`]: devices, references, polygons, outlines, lists |
//! | choose the grid, threads, watch and stop | [`Options`], [`RunOptions`], [`Watch`] |
//! | keep cells that are placed often | [`hierarchy`]: the same functions, with references in the result |
//! | work on with a result | [`Region`]: `&a \| &b`, `&a & &b`, `&a - &b`, `&a ^ &b`, area, box, point tests, [`Region::to_device`] |
//! | stay on the integer grid | [`grid`] |
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
//! The engine's module docs explain why a divided plane gives the undivided result. How the time depends on the division:
//!
#![doc = include_str!("../docs/divisions.svg")]
//!
//! Ours is divided into strips and KLayout's tiling processor into tiles, whose seams it merges afterwards; both have two
//! threads. `cargo xtask figure` measures and draws it.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod contours;
mod device;
mod engine;
mod error;
mod fracture;
pub mod grid;
mod jobs;
mod offset;
mod op;
mod options;
mod point;
mod progress;
mod region;

pub use device::{
    Border, IntoOperation, KlOptions, OpenPorts, Options, Shapes, boolean, hierarchy, invert, kl_boolean, kl_invert,
    kl_offset, kl_outline, merged_area, merged_areas, offset, outline, union, union_by_layer, xor_diff,
};
pub use error::BooleanError;
pub use offset::{Growth, Join};
pub use op::Operation;
pub use options::{Division, RunOptions};
pub use progress::{Progress, Watch};
pub use region::Region;
