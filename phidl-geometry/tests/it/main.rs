//! Integration tests of the shape library.

mod golden;
mod hashes_basic;
mod marks_and_tests;
mod outline;
mod placement;
mod registry;
mod wires_and_pads;
