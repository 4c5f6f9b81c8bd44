//! Reference results: reading them, and comparing a device with one.
//!
//! A case says what was drawn and what came out. The tests read every `*.json` of the project's own copy, or of the
//! folder that the environment variable `PHIDL_GOLDEN` names, and take the cases of their kind from all of them.

mod cases;
mod compare;
mod differences;
mod region;

pub use cases::{Case, Kind, load};
pub use compare::{assert_all, compare_device, compare_reference};
pub use differences::{Difference, differences};
pub use region::{agree_on_grid, merged_area, xor_area};
