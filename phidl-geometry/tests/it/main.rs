//! Integration tests of the shape library.

mod arrange;
mod fill;
mod golden;
mod packer;
mod placement;
mod registry;
mod select;
