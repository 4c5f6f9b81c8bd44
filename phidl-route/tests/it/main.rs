//! Integration tests of the routes.

mod examples;
mod golden;
mod hashes;
mod laws;
mod registry;
