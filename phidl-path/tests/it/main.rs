//! Tests of the crate from outside: reference results, laws, examples.

mod examples;
mod golden;
mod hashes;
mod laws;
mod messages;
mod simplified;
