//! What holds for every registered route.

use phidl_core::runtime::registry;
use phidl_route as _;

#[test]
fn every_route_is_registered_and_draws_its_example() {
    let routes: Vec<_> = registry::all().filter(|entry| entry.module.starts_with("phidl_route")).collect();
    let names: Vec<&str> = routes.iter().map(|entry| entry.name).collect();
    let expected = [
        "delay_line",
        "route_basic",
        "route_manhattan",
        "route_manhattan_auto",
        "route_quad",
        "route_serpentine",
        "route_sharp",
        "route_smooth",
        "route_xy",
    ];
    assert_eq!(names, expected);
    for entry in routes {
        let example = entry.example().unwrap_or_else(|error| panic!("{}: {}", entry.name, error.report()));
        let device =
            entry.build(&example.by_name()).unwrap_or_else(|error| panic!("{}: {}", entry.name, error.report()));
        assert!(!device.is_empty(), "{}", entry.name);
        for key in ["length", "bends", "smallest_radius"] {
            assert!(device.info().contains_key(key), "{} says nothing of its {key}", entry.name);
        }
    }
}
