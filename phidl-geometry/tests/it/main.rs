//! Integration tests of the shape library.

mod arrange;
mod bounds;
mod deplof;
mod docs;
mod domain;
mod extremes;
mod fill;
mod golden;
mod hashes;
mod hashes_basic;
mod marks_and_tests;
mod outline;
mod packer;
mod placement;
mod quick_start;
mod registry;
mod select;
mod text;
mod wires_and_pads;
