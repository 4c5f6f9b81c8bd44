//! Integration tests of the scene graph.

mod bounds;
mod editing;
mod errors;
mod laws;
mod messages;
mod placing;
mod queries;
mod reference_facts;
