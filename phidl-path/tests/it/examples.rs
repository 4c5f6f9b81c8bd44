//! The examples run, and the tutorial's steps draw what they should.

#[path = "../../examples/bends.rs"]
mod bends;
#[path = "../../examples/waveguides.rs"]
mod waveguides;

#[test]
fn examples_run() {
    waveguides::main().unwrap();
    bends::main().unwrap();
}
