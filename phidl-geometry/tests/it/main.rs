//! Integration tests of the shape library.

mod golden;
mod hashes;
mod placement;
mod registry;
