//! Integration tests of the scene graph.

mod bounds;
mod editing;
mod errors;
mod laws;
mod reference_facts;
