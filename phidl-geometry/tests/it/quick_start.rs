//! The first tutorial, as `examples/quick_start.rs` has it.

#[path = "../../examples/quick_start.rs"]
mod example;

#[test]
fn the_quick_start_runs_to_its_end() {
    example::main().unwrap();
}
