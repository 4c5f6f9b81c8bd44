//! Integration tests of the shape library.

mod golden;
mod placement;
mod registry;
