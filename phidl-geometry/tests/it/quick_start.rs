//! The first tutorial, `examples/quick_start.rs`.

#[path = "../../examples/quick_start.rs"]
mod example;

#[test]
fn the_quick_start_runs_to_its_end() {
    example::main().unwrap();
}
