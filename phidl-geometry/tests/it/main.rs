//! Integration tests of the shape library.
#![expect(missing_docs, reason = "tests explain themselves by their names")]

mod golden;
mod placement;
mod registry;
