//! The examples run.

#[path = "../../examples/first_chip.rs"]
mod first_chip;

#[test]
fn the_first_chip_is_drawn_and_written() {
    first_chip::main().expect("files in the folder for temporary files");
}
