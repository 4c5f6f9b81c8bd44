//! What holds for every registered shape.

use phidl_core::runtime::registry;
use phidl_geometry as _;

#[test]
fn every_shape_of_the_library_is_registered_and_draws_its_example() {
    let names: Vec<&str> =
        registry::all().filter(|entry| entry.module.starts_with("phidl_geometry")).map(|entry| entry.name).collect();
    let expected = [
        "arc",
        "bbox",
        "boolean",
        "circle",
        "compass",
        "cross",
        "ellipse",
        "flagpole",
        "invert",
        "kl_boolean",
        "kl_invert",
        "kl_offset",
        "kl_outline",
        "offset",
        "outline",
        "rectangle",
        "ring",
        "straight",
        "taper",
        "union",
        "xor_diff",
    ];
    assert_eq!(names, expected);
    for entry in registry::all() {
        let example = entry.example().unwrap_or_else(|error| panic!("{}: {}", entry.name, error.in_full()));
        let params = example.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        let device = entry.build(&params).unwrap_or_else(|error| panic!("{}: {}", entry.name, error.in_full()));
        assert!(!device.is_empty(), "{}", entry.name);
    }
}
