//! Integration tests: laws of the set operations, the promise about strips and threads, an independent oracle.

mod check;
mod laws;
mod oracle;
mod shapes;

#[path = "../../benches/support/mod.rs"]
mod support;
