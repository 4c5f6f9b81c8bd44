//! Reference results: reading them, and comparing a device with one.
//!
//! A case says what was drawn and what came out. The tests read every `*.json` of the project's own copy, or of the
//! folder that the environment variable `PHIDL_GOLDEN` names, and take the cases of their kind from all of them.

mod cases;
mod compare;
mod condition;
mod differences;
mod facts;
#[cfg(test)]
mod page;
mod region;

pub use cases::{Case, Kind, load};
pub use compare::{assert_all, assert_differences_are_needed, compare_device, compare_reference};
pub use differences::{Difference, Instead, Names, differences};
pub use region::{agree_on_grid, merged_area, xor_area};
