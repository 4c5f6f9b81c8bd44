//! Integration tests of the shape library.

mod golden;
mod hashes;
mod placement;
mod quick_start;
mod registry;
