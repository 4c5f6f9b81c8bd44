//! Integration tests of the scene graph.

mod bounds;
mod editing;
mod errors;
mod laws;
mod placing;
mod reference_facts;
