//! Integration tests of the shape library.

mod domain;
mod golden;
mod hashes;
mod placement;
mod quick_start;
mod registry;
