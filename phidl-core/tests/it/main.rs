//! Integration tests of the scene graph.

mod editing;
mod errors;
mod laws;
mod reference_facts;
