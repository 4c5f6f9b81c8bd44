//! The examples run.

#[path = "../../examples/first_chip.rs"]
mod first_chip;
#[path = "../../examples/geo_bridge.rs"]
mod geo_bridge;

#[test]
fn the_first_chip_is_drawn_and_written() {
    first_chip::main().expect("files in the folder for temporary files");
}

#[test]
fn algorithms_of_geo_run_on_a_layer() {
    geo_bridge::main().expect("polygons that are valid on both sides");
}
