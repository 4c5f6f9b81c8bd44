//! Reference results: reading them, and comparing a device with one.
//!
//! A case says what was drawn and what came out. The tests read every `*.json` of the project's own copy, or of the
//! folder that the environment variable `PHIDL_GOLDEN` names, and take the cases of their kind from all of them.

mod cases;
mod check;
mod compare;
mod difference;
mod differences;
mod facts;
#[cfg(test)]
mod page;
mod parameters;
mod path_facts;
mod refusal;
mod region;

pub use cases::{Case, Kind, load};
pub use check::{assert_all, assert_differences_are_needed};
pub use compare::{compare_device, compare_reference};
pub use difference::{Difference, Instead, Refusal};
pub use differences::differences;
pub use refusal::assert_refused;
pub use region::{agree_on_grid, merged_area, xor_area};
