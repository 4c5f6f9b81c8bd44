//! Integration tests: laws of the set operations, the promise about strips and threads, an independent oracle.

mod check;
mod fracture;
mod laws;
mod offset;
mod oracle;
mod run;
mod shapes;

#[path = "../../benches/support/mod.rs"]
mod support;
