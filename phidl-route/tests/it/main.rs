//! Integration tests of the routes.

mod example;
mod golden;
mod hashes;
mod laws;
mod registry;
