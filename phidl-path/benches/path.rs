//! Extrusions and bends, in numbers.
fn main() {}
