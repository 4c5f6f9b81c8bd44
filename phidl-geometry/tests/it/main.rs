//! Integration tests of the shape library.

mod deplof;
mod domain;
mod extremes;
mod golden;
mod hashes;
mod hashes_basic;
mod marks_and_tests;
mod outline;
mod placement;
mod quick_start;
mod registry;
mod text;
mod wires_and_pads;
