//! Integration tests: laws of the set operations, the promise about strips and threads, an independent oracle.

mod check;
mod fracture;
mod fuzzed;
mod hierarchy;
mod laws;
mod messages;
mod offset;
mod oracle;
mod replay;
mod run;
mod shapes;
mod stages;

#[path = "../../benches/support/mod.rs"]
mod support;
