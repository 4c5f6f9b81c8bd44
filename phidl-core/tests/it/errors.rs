//! Bad input: each kind is refused with an error that names the cell, the value and the rule; nothing panics.

use phidl_core::prelude::*;

fn triangle() -> Device {
    let mut d = Device::builder("triangle");
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.add_port("a", ((0, 0), 1, 0)).unwrap();
    d.build().unwrap()
}

fn empty() -> Device {
    Device::builder("empty").build().unwrap()
}

/// The error that building a cell ends with.
fn refusal(edit: impl FnOnce(&mut DeviceBuilder)) -> String {
    let mut d = Device::builder("cell");
    edit(&mut d);
    d.build().unwrap_err().to_string()
}

#[test]
fn outlines_need_three_finite_points() {
    let mut d = Device::builder("cell");
    for outline in [vec![], vec![(0.0, 0.0)], vec![(0.0, 0.0), (1.0, 0.0)]] {
        let count = outline.len();
        assert_eq!(
            d.add_polygon(outline, 1).unwrap_err(),
            Error::TooFewPoints { device: "cell".into(), points: count }
        );
    }
    let error = d.add_polygon([(0.0, 0.0), (1.0, f64::NAN), (0.0, 1.0)], 1).unwrap_err();
    assert_eq!(error.to_string(), "cell: point 1 of an outline is (1, NaN), but it must be finite");
    assert!(d.add_polygon([(0.0, 0.0), (f64::INFINITY, 0.0), (0.0, 1.0)], 1).is_err());
    assert!(d.build().unwrap().is_empty(), "a refused outline must leave nothing behind");
}

#[test]
fn the_first_bad_placement_comes_back_at_the_end() {
    assert_eq!(
        refusal(|d| {
            let key = d.add(triangle());
            d[key].move_by((f64::NAN, 0.0)).rotate(f64::INFINITY).set_center((3, 4));
        }),
        "cell: the argument of move_by for the reference to \"triangle\" is NaN (as is every edge of an empty element), \
         but it must be finite"
    );
    assert_eq!(
        refusal(|d| {
            d.add(triangle().place().mirrored((1, 1), (1, 1)));
        }),
        "cell: the line of mirror for the reference to \"triangle\" needs two different points, but both are (1, 1)"
    );
    assert_eq!(
        refusal(|d| {
            d.add(triangle().place().scaled(-2));
        }),
        "cell: the factor of scale for the reference to \"triangle\" is -2, but it must be greater than 0"
    );
    assert_eq!(
        refusal(|d| {
            d.set_xmin(.., 3);
        }),
        "cell: set_xmin needs a bounding box, but the cell is empty"
    );
    assert!(refusal(|d| _ = d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], 1).rotated(f64::NAN))).contains("NaN"));
    assert!(refusal(|d| _ = d.add(Label::new("x", (f64::NAN, 0.0), 1))).contains("label \"x\""));
}

#[test]
fn tolerances_that_are_none_are_refused_and_outlines_keep_three_points() {
    let thin = Polygon::new([(0.0, 0.0), (1.0, 0.001), (2.0, 0.0)], 1);
    for tolerance in [-1.0, f64::NAN] {
        let mut polygon = thin.clone();
        polygon.simplify(tolerance);
        assert!(refusal(|d| _ = d.add(polygon)).contains("the tolerance of simplify for the polygon"));
        let mut d = Device::builder("cell");
        d.add(thin.clone());
        assert!(d.simplify(tolerance).is_err());
    }
    let mut polygon = thin.clone();
    assert_eq!(polygon.simplify(1).points, thin.points);
}

#[test]
fn a_placement_that_overflows_is_refused() {
    let error = refusal(|d| {
        d.add(triangle().place().moved_by((1e308, 0)).moved_by((1e308, 0)));
    });
    assert!(error.contains("must be finite"), "{error}");
    let error = refusal(|d| {
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        d.scale(.., 1e308).scale(.., 1e308);
    });
    assert!(error.contains("must be finite"), "{error}");
}

#[test]
fn arranging_an_empty_member_is_refused() {
    let mut d = Device::builder("cell");
    let keys = [d.add(triangle()), d.add(empty())];
    d.group(keys).align(Edge::XMin);
    let error = d.build().unwrap_err();
    assert_eq!(error.to_string(), "cell: align needs a bounding box, but the reference to \"empty\" is empty");
    let refused = refusal(|d| {
        let mut group = triangle().place() + empty().place();
        group.align(Edge::XMin);
        d.add(group);
    });
    let due = "cell: align needs a bounding box, but member 1 of the group, counted from 0, is empty";
    assert_eq!(refused, due);
    let mut d = Device::builder("cell");
    let key = d.add(triangle());
    d.group([key]).distribute(Direction::X, f64::NAN);
    assert!(d.build().is_err());
}

#[test]
fn names_are_unique_and_unknown_ones_list_the_known() {
    let mut d = Device::builder("cell");
    d.add_port("a", ((0, 0), 1, 0)).unwrap();
    assert_eq!(d.add_port("a", ((5, 5), 1, 0)).unwrap_err().to_string(), "cell: port \"a\" already exists");
    assert_eq!(d.port("b").unwrap_err().to_string(), "cell: there is no port \"b\"; known are a");
    assert!(d.rename_port("b", "c").is_err() && d.remove_port("b").is_err());
    d.add_as("left", triangle());
    assert_eq!(d.get("right").unwrap_err().to_string(), "cell: there is no alias \"right\"; known are left");
    let meant = d.get("lef").unwrap_err().to_string();
    assert_eq!(meant, "cell: there is no alias \"lef\"; known are left; did you mean \"left\"?");
    d.add_as("left", triangle());
    assert_eq!(d.build().unwrap_err().to_string(), "cell: alias \"left\" already exists");
    assert!(matches!(Device::builder("").build(), Err(Error::Invalid { .. })));
}

#[test]
fn deferred_errors_come_out_of_build_and_check_only() {
    let mut d = Device::builder("cell");
    d.info("length", f64::INFINITY).move_by(.., (f64::NAN, 0.0));
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.add_port("a", ((0, 0), 1, 0)).unwrap();
    d.add_label("a", (0, 0), 1).unwrap();
    assert!(d.recorded().is_empty(), "a refused value is not recorded");
    let due = "cell: info \"length\" is inf, but it must be finite";
    assert_eq!(d.check().unwrap_err().to_string(), due);
    assert_eq!(d.build().unwrap_err().to_string(), due);
}

#[test]
fn fallible_calls_that_fail_change_nothing() {
    let mut d = Device::builder("cell");
    assert!(d.add_polygon([(0.0, 0.0), (1.0, f64::NAN), (0.0, 1.0)], [1, 2]).is_err());
    assert!(d.add_label("x", (f64::NAN, 0.0), 1).is_err());
    assert!(d.add_port("p", ((0.0, f64::NAN), 1, 0)).is_err());
    let ports = [Port::new((0, 0), 1, 0).named("p"), Port::new((0, 0), -1, 0).named("q")];
    assert!(d.add_ports(ports).is_err());
    assert_eq!((d.polygons().len(), d.labels().len(), d.ports().len()), (0, 0, 0));
    assert!(d.build().unwrap().is_empty());
}

#[test]
fn the_key_of_a_refused_polygon_finds_nothing() {
    let mut d = Device::builder("cell");
    let first = d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    let refused = d.add(Polygon::new([(0, 0), (1, 0)], 1));
    assert!(matches!(d.remove(refused), Err(Error::Removed { .. })));
    assert!(d.polygon(refused).is_err() && d.polygon(first).is_ok());
    assert!(matches!(d.build(), Err(Error::TooFewPoints { points: 2, .. })));
}

#[test]
fn an_edge_of_an_empty_element_is_refused_by_every_setter() {
    let empty = empty();
    let mut d = Device::builder("cell");
    let key = d.add(triangle());
    d[key].set_xmin(empty.xmax() + 5.0);
    let error = d.build().unwrap_err().to_string();
    assert!(error.contains("set_xmin") && error.contains("every edge of an empty element"), "{error}");
}

#[test]
fn ports_that_cannot_be_are_refused_wherever_they_come_from() {
    let mut d = Device::builder("cell");
    assert!(d.add_port("a", ((0, 0), -1, 0)).is_err());
    assert!(d.add_port("a", ((f64::NAN, 0.0), 1, 0)).is_err());
    let mut r = triangle().place();
    assert!(r.connect("a", &Port::new((f64::NAN, 0.0), 1, 0)).is_err());
    assert!(r.connect("b", &Port::new((0, 0), 1, 0)).is_err());
    assert!(r.connect_overlapping("a", &Port::new((0, 0), 1, 0), f64::NAN).is_err());
    assert!(triangle().array(2, 2, (5, 5)).port("a").is_err());
    assert!(triangle().array(2, 2, (5, 5)).port_at("a", 2, 0).is_err());
    assert_eq!(triangle().array(2, 2, (5, 5)).port_at("a", 1, 1).unwrap().midpoint(), Point::new(5.0, 5.0));
}

#[test]
fn an_empty_device_has_no_box_and_stays_usable() {
    assert_eq!(empty().bbox(), None);
    assert!(empty().xmin().is_nan());
    assert_eq!(empty().place().moved_by((5, 5)).bbox(), None);
    let mut d = Device::builder("cell");
    d.add(empty().place().moved_by((5, 5)).rotated(30));
    d.add(empty().array(3, 3, (1, 1)));
    d.add(triangle());
    let d = d.build().unwrap();
    assert_eq!(d.bbox(), triangle().bbox());
    assert_eq!(d.area(), 0.5);
    assert_eq!(d.flattened().unwrap().polygons().len(), 1);
}

#[test]
fn arrays_without_elements_are_refused() {
    for (columns, rows) in [(0, 3), (3, 0)] {
        let error = refusal(|d| {
            d.add(triangle().array(columns, rows, (1, 1)));
        });
        assert!(error.contains("at least one"), "{error}");
    }
}

#[test]
fn keys_of_other_cells_are_refused_wherever_they_are_used() {
    let mut other = Device::builder("other");
    let foreign = other.add(triangle());
    let polygon = other.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    let label = other.add_label("x", (0, 0), 1).unwrap();
    // Numbers agree: the same elements in the same order.
    let mut d = Device::builder("cell");
    d.add(triangle());
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.add_label("x", (0, 0), 1).unwrap();
    let is_foreign = |error: Error| matches!(error, Error::ForeignKey { .. });
    assert_eq!(
        d.reference(foreign).unwrap_err().to_string(),
        "cell: this key of a reference belongs to another open cell, \"other\""
    );
    assert!(is_foreign(d.reference_mut(foreign).unwrap_err()) && is_foreign(d.absorb(foreign).unwrap_err()));
    assert!(is_foreign(d.remove(foreign).unwrap_err()) && is_foreign(d.remove(polygon).unwrap_err()));
    assert!(is_foreign(d.remove(label).unwrap_err()) && is_foreign(d.label(label).unwrap_err()));
    assert!(d.polygon(polygon).is_err_and(is_foreign));
    assert!(is_foreign(d.set_properties(polygon, Properties::new()).unwrap_err()));
    for edit in [
        |d: &mut DeviceBuilder, key| _ = d.select(key).move_by((1, 0)),
        |d: &mut DeviceBuilder, key| _ = d.group([key]).rotate(90),
    ] {
        let mut copy = d.clone();
        edit(&mut copy, foreign);
        assert_eq!(copy.references().next().unwrap().transform(), &Transform::IDENTITY);
        assert!(is_foreign(copy.build().unwrap_err()));
    }
    assert_eq!((d.references().len(), d.polygons().len(), d.labels().len()), (1, 1, 1));
}

#[test]
#[should_panic(expected = "belongs to another open cell, \"other\"")]
fn indexing_with_the_key_of_another_cell_panics() {
    let foreign = Device::builder("other").add(triangle());
    let mut d = Device::builder("cell");
    d.add(triangle());
    let _ = &d[foreign];
}
