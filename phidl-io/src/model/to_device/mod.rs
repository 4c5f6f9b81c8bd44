//! The layout model into devices: what both readers share.
//!
//! | Module | What it does |
//! |---|---|
//! | `order` | finds the cells below a top cell, children first; refuses cycles |
//! | `build` | makes a device of each cell |
//! | `wire`, `overlap` | the outline of a path; paths that overlap themselves |

mod build;
mod order;
mod overlap;
mod wire;

pub(crate) use build::devices;
pub(crate) use order::choose;
#[cfg(feature = "oasis")]
pub(crate) use wire::outlines;
