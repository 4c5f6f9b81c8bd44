//! Integration tests of the scene graph.
#![expect(missing_docs, reason = "tests explain themselves by their names")]

mod editing;
mod errors;
mod laws;
mod reference_facts;
