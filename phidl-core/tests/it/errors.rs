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
        "cell: move_by of reference to \"triangle\" is (NaN, 0), but it must be finite"
    );
    assert_eq!(
        refusal(|d| {
            d.add(triangle().place().mirrored((1, 1), (1, 1)));
        }),
        "cell: the line to mirror reference to \"triangle\" at is (1, 1) to (1, 1), but it must have two different points"
    );
    assert_eq!(
        refusal(|d| {
            d.add(triangle().place().scaled(-2));
        }),
        "cell: scale of reference to \"triangle\" is -2, but it must be greater than 0"
    );
    assert_eq!(
        refusal(|d| {
            d.set_xmin(3);
        }),
        "cell: set_xmin needs something drawn, but the cell is empty"
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
        assert!(refusal(|d| _ = d.add(polygon)).contains("tolerance to simplify a polygon"));
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
        d.scale(1e308).scale(1e308);
    });
    assert!(error.contains("must be finite"), "{error}");
}

#[test]
fn arranging_an_empty_member_is_refused() {
    let mut d = Device::builder("cell");
    let keys = [d.add(triangle()), d.add(empty())];
    d.group(keys).align(Edge::XMin);
    let error = d.build().unwrap_err();
    assert_eq!(error.to_string(), "cell: align needs something drawn, but the cell is empty");
    let mut d = Device::builder("cell");
    let key = d.add(triangle());
    d.group([key]).distribute(Direction::X, f64::NAN);
    assert!(d.build().is_err());
}

#[test]
fn names_are_unique_and_unknown_ones_list_the_known() {
    let mut d = Device::builder("cell");
    d.add_port("a", ((0, 0), 1, 0)).unwrap();
    assert_eq!(d.add_port("a", ((5, 5), 1, 0)).unwrap_err().to_string(), "cell: port \"a\" exists already");
    assert_eq!(d.port("b").unwrap_err().to_string(), "cell: there is no port \"b\"; known are a");
    assert!(d.rename_port("b", "c").is_err() && d.remove_port("b").is_err());
    d.add_as("left", triangle());
    assert_eq!(d.get("right").unwrap_err().to_string(), "cell: there is no alias \"right\"; known are left");
    d.add_as("left", triangle());
    assert_eq!(d.build().unwrap_err().to_string(), "cell: alias \"left\" exists already");
    assert!(matches!(Device::builder("").build(), Err(Error::Refused { .. })));
}

#[test]
fn what_was_kept_comes_back_at_the_next_fallible_call() {
    let mut d = Device::builder("cell");
    d.move_by((f64::NAN, 0.0));
    assert!(d.add_port("a", ((0, 0), 1, 0)).is_err());
    d.info("length", f64::INFINITY);
    let error = d.build().unwrap_err();
    assert_eq!(error.to_string(), "cell: info \"length\" is inf, but it must be finite");
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
    assert_eq!(d.flattened().polygons().len(), 1);
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
fn keys_of_other_cells_find_nothing() {
    let mut other = Device::builder("other");
    other.add(triangle());
    let foreign = other.add(triangle());
    let mut d = Device::builder("cell");
    d.add(triangle());
    assert!(d.reference(foreign).is_err() && d.remove(foreign).is_err() && d.absorb(foreign).is_err());
    d.select(foreign).move_by((1, 0));
    assert!(d.build().is_err());
}
