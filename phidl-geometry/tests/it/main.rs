//! Integration tests of the shape library.

mod extremes;
mod golden;
mod placement;
mod registry;
