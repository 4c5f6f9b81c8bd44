//! Tests of the crate from outside: reference results, laws, messages, examples.

mod examples;
mod golden;
mod hashes;
mod laws;
mod messages;
mod registry;
