//! The example, as `examples/around_a_chip.rs` has it.

#[path = "../../examples/around_a_chip.rs"]
mod around_a_chip;

#[test]
fn the_example_runs_to_its_end() {
    around_a_chip::main().unwrap();
}
