//! What holds for every registered shape.

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_core::runtime::{Record, registry};
use phidl_geometry as _;

fn named(record: Record) -> BTreeMap<String, Value> {
    record.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

#[test]
fn every_shape_of_the_library_is_registered_and_draws_its_example() {
    let names: Vec<&str> = registry::all().filter(|e| e.module.starts_with("phidl_geometry")).map(|e| e.name).collect();
    let expected = [
        "arc",
        "bbox",
        "circle",
        "compass",
        "cross",
        "ellipse",
        "flagpole",
        "grating",
        "hecken_taper",
        "meander_taper",
        "optimal_90deg",
        "optimal_hairpin",
        "optimal_step",
        "racetrack_gradual",
        "ramp",
        "rectangle",
        "ring",
        "snspd",
        "snspd_candelabra",
        "snspd_expanded",
        "straight",
        "taper",
        "turn",
        "ytron_round",
    ];
    assert_eq!(names, expected);
    for entry in registry::all() {
        let device = entry
            .example()
            .and_then(|record| entry.build(&named(record)))
            .unwrap_or_else(|error| panic!("{}: {}", entry.name, error.in_full()));
        assert!(!device.is_empty(), "{}", entry.name);
    }
}
