//! Test helpers that several crates of phidl share; never published.
//!
//! Use it from `tests/` and benches only: inside the unit tests of phidl-core, this crate would bring a second copy of
//! phidl-core along.

pub mod domain;
pub mod golden;
pub mod laws;
pub mod loads;
pub mod scenes;
pub mod strategies;
