//! Integration tests of the shape library.

mod arrange;
mod bounds;
mod deplof;
mod docs;
mod domain;
mod extremes;
mod fill;
#[cfg(feature = "fonts")]
mod fonts;
mod golden;
mod hashes;
mod hashes_basic;
mod islands;
mod marks_and_tests;
mod measured;
mod messages;
mod outline;
mod packer;
mod placement;
mod quick_start;
mod random;
mod registry;
mod select;
mod text;
mod wires_and_pads;
