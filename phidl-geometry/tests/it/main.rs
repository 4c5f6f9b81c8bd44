//! Integration tests of the shape library.

mod deplof;
mod golden;
mod placement;
mod registry;
mod text;
