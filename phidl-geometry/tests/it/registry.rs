//! What holds for every registered shape.

use phidl_core::{cache, registry};
use phidl_geometry as _;

#[test]
fn every_shape_of_the_library_is_registered_and_draws_its_example() {
    let names: Vec<&str> =
        registry::all().filter(|entry| entry.module.starts_with("phidl_geometry")).map(|entry| entry.name).collect();
    let expected = [
        "C",
        "L",
        "arc",
        "basic_die",
        "bbox",
        "boolean",
        "circle",
        "compass",
        "compass_multi",
        "connector",
        "copy",
        "copy_layer",
        "cross",
        "deepcopy",
        "ellipse",
        "extract",
        "fill_rectangle",
        "flagpole",
        "flatten",
        "geometry_to_ports",
        "grating",
        "grid",
        "gridsweep",
        "hecken_taper",
        "invert",
        "kl_boolean",
        "kl_invert",
        "kl_offset",
        "kl_outline",
        "litho_calipers",
        "litho_ruler",
        "litho_star",
        "litho_steps",
        "meander_taper",
        "offset",
        "optimal_90deg",
        "optimal_hairpin",
        "optimal_step",
        "outline",
        "packer",
        "polygon_ports",
        "ports_to_geometry",
        "preview_layerset",
        "racetrack_gradual",
        "ramp",
        "rectangle",
        "ring",
        "snspd",
        "snspd_candelabra",
        "snspd_expanded",
        "straight",
        "taper",
        "tee",
        "test_comb",
        "test_ic",
        "test_res",
        "test_via",
        "text",
        "turn",
        "union",
        "xor_diff",
        "ytron_round",
    ];
    assert_eq!(names, expected);
    for entry in registry::all() {
        let example = entry.example().unwrap_or_else(|error| panic!("{}: {}", entry.name, error.report()));
        let device =
            entry.build(&example.by_name()).unwrap_or_else(|error| panic!("{}: {}", entry.name, error.report()));
        assert!(!device.is_empty() || device.ports().len() > 0, "{}", entry.name);
    }
}

#[test]
fn a_bypass_of_the_cache_draws_an_equal_cell_each_time() {
    let entry = registry::find("ring").unwrap();
    let draw = || cache::bypass(|| entry.build(&[("radius".to_owned(), 3.25.into())].into())).unwrap();
    let (first, second) = (draw(), draw());
    assert!(!first.same_cell(&second) && first == second);
    let cached = phidl_geometry::ring(3.25, 0.5, 2.5, 0).unwrap();
    assert!(cached == first && !cached.same_cell(&first) && !cached.same_cell(&second));
}
