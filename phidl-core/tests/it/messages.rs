//! All error sentences of this crate, one line for each variant and each kind of use. Read them as a person would.

use expect_test::expect;
use phidl_core::num::grid::Grid;
use phidl_core::param::Check;
use phidl_core::prelude::*;

fn pad() -> Device {
    let mut d = Device::builder("pad");
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.add_port("in", ((0, 0), 1, 0)).unwrap();
    d.build().unwrap()
}

fn empty() -> Device {
    Device::builder("empty").build().unwrap()
}

/// The error with which building a cell ends.
fn deferred(edit: impl FnOnce(&mut DeviceBuilder)) -> String {
    let mut d = Device::builder("chip");
    edit(&mut d);
    d.build().unwrap_err().to_string()
}

/// The error of one call on an open cell.
fn immediate(call: impl FnOnce(&mut DeviceBuilder) -> Error) -> String {
    call(&mut Device::builder("chip")).to_string()
}

fn placement_errors() -> Vec<String> {
    let nan = f64::NAN;
    vec![
        deferred(|d| _ = d.add(pad().place().moved_by((nan, 2.0)))),
        deferred(|d| _ = d.add(pad().place().rotated(f64::INFINITY))),
        deferred(|d| _ = d.add(pad().place().mirrored((1, 1), (1, 1)))),
        deferred(|d| _ = d.add(pad().place().scaled(-2))),
        deferred(|d| _ = d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], 1).rotated(nan))),
        deferred(|d| _ = d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], 1).simplify(-1).clone())),
        deferred(|d| _ = d.add(Label::new("name", (0, 0), 1).rotated(nan))),
        deferred(|d| _ = d.add((pad().place() + pad().place()).rotated(nan))),
        deferred(|d| _ = d.add((pad().place() + empty().place()).align(Edge::X).clone())),
        deferred(|d| _ = d.rotate(.., nan)),
        deferred(|d| _ = d.set_xmin(.., 3)),
        deferred(|d| {
            let keys = d.add([pad(), empty()]);
            d.align(keys, Edge::X);
        }),
        deferred(|d| {
            let keys = d.add([pad(), pad()]);
            d.distribute(keys, Direction::X, nan);
        }),
        deferred(|d| {
            let [a, b] = d.add([pad(), empty()]);
            d.set_xmin(a, d.xmax(b));
        }),
        deferred(|d| _ = d.add(pad().place().moved_by((1e308, 0)).moved_by((1e308, 0)))),
        deferred(|d| _ = d.add(Label::new("name", (f64::INFINITY, 0.0), 1))),
        deferred(|d| _ = d.add(pad().array(0, 3, (1, 1)))),
        deferred(|d| {
            d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
            d.scale(.., 1e308).scale(.., 1e308);
        }),
    ]
}

fn cell_errors() -> Vec<String> {
    let mut other = Device::builder("other");
    let foreign = other.add(pad());
    vec![
        deferred(|d| _ = d.info("length", f64::NAN)),
        deferred(|d| _ = d.rename("")),
        deferred(|d| _ = [d.add_as("left", pad()), d.add_as("left", pad())]),
        deferred(|d| {
            d["left"] = pad().place();
            d["lfet"].movex(3);
        }),
        immediate(|d| d.add_polygon([(0, 0), (1, 0)], 1).unwrap_err()),
        immediate(|d| d.add_polygon([(0, 0)], 1).unwrap_err()),
        immediate(|d| d.add_polygon([(0.0, 0.0), (1.0, f64::NAN), (0.0, 1.0)], 1).unwrap_err()),
        immediate(|d| d.add_port("in", ((0, 0), -1, 0)).unwrap_err()),
        immediate(|d| d.add_port("in", ((0.0, f64::NAN), 1, 0)).unwrap_err()),
        immediate(|d| d.add_port("in", Port::new((0, 0), 1, 0).rotated(f64::NAN)).unwrap_err()),
        immediate(|d| d.add_port("in", pad().port("in").unwrap()).unwrap().add_port("in", ((0, 0), 1, 0)).unwrap_err()),
        immediate(|d| d.port("in").unwrap_err()),
        immediate(|d| d.add_port("in", ((0, 0), 1, 0)).unwrap().port("inn").unwrap_err()),
        immediate(|d| d.get("left").unwrap_err()),
        immediate(|d| d.reference(foreign).unwrap_err()),
        immediate(|d| {
            let key = d.add(pad());
            d.remove(key).unwrap().remove(key).unwrap_err()
        }),
        immediate(|d| d.simplify(-1.0).unwrap_err()),
        pad().array(2, 2, (5, 5)).port("in").unwrap_err().to_string(),
        pad().array(2, 2, (5, 5)).port_at("in", 2, 0).unwrap_err().to_string(),
        pad().place().connect_overlapping("in", Port::new((0, 0), 1, 0), f64::NAN).unwrap_err().to_string(),
        pad().hash_geometry(0.0).unwrap_err().to_string(),
        pad().array(2, 2, (5, 5)).to_device().unwrap().flattened_within(2).unwrap_err().to_string(),
        pad().array(4_000_000_000, 4_000_000_000, (1, 1)).to_device().unwrap().flattened().unwrap_err().to_string(),
        pad()
            .place()
            .moved_by((3e6, 0))
            .to_device()
            .unwrap()
            .check_extent(&Grid::new(1e-3).unwrap())
            .unwrap_err()
            .to_string(),
    ]
}

fn other_errors() -> Vec<String> {
    let mut set = LayerSet::new();
    set.add(NamedLayer::new("gold", 1)).unwrap();
    let rule = Check::new("ring").unit("um").greater("width", -1, 0).unwrap_err();
    vec![
        set.get("gld").unwrap_err().to_string(),
        set.add(NamedLayer::new("gold", 2)).unwrap_err().to_string(),
        set.add(NamedLayer::new("glass", 2).alpha(1.5)).unwrap_err().to_string(),
        Color::from_fractions(2.0, 0.0, 0.0).unwrap_err().to_string(),
        "golden".parse::<Color>().unwrap_err().to_string(),
        Layer::try_from(70_000_i32).unwrap_err().to_string(),
        Grid::new(0.0).unwrap_err().to_string(),
        Grid::new(1e-3).unwrap().steps(3e6).unwrap_err().to_string(),
        Error::custom("die", "the wafer has no room for it").to_string(),
        Error::CyclicDependency { chain: vec!["a".into(), "b".into(), "a".into()] }.to_string(),
        format!("{:?}", rule.within("ring_filter").within("chip")),
    ]
}

#[test]
fn every_sentence_of_placing_reads_well() {
    expect![[r#"
        chip: the argument of move_by for the reference to "pad" is (NaN, 2) (as is every edge of an empty element), but it must be finite
        chip: the argument of rotate for the reference to "pad" is inf, but it must be finite
        chip: the line of mirror for the reference to "pad" needs two different points, but both are (1, 1)
        chip: the factor of scale for the reference to "pad" is -2, but it must be greater than 0
        chip: the argument of rotate for the polygon is NaN (as is every edge of an empty element), but it must be finite
        chip: the tolerance of simplify for the polygon is -1 µm, but it must be finite and at least 0 µm
        chip: the argument of rotate for the label "name" is NaN (as is every edge of an empty element), but it must be finite
        chip: the argument of rotate for the group is NaN (as is every edge of an empty element), but it must be finite
        chip: align needs a bounding box, but member 1 of the group, counted from 0, is empty
        chip: the argument of rotate for the cell is NaN (as is every edge of an empty element), but it must be finite
        chip: set_xmin needs a bounding box, but the cell is empty
        chip: align needs a bounding box, but the reference to "empty" is empty
        chip: the argument of distribute for the selection is NaN (as is every edge of an empty element), but it must be finite
        chip: the argument of set_xmin for the reference to "pad" is NaN, but it must be finite; the reference to "empty" is empty, so its edges are NaN
        chip: the placement of the reference to "pad" is magnified by 1, rotated by 0° and moved to (inf, 0), but it must be finite
        chip: the placement of the label "name" is magnified by 1, rotated by 0° and moved to (inf, 0), but it must be finite
        chip: the array reference to "pad" has 0 columns and 3 rows, but it needs at least one of each
        chip: a corner of a moved polygon is (inf, 0), but it must be finite"#]].assert_eq(&placement_errors().join("\n"));
}

#[test]
fn every_sentence_of_cells_reads_well() {
    expect![[r#"
        chip: info "length" is NaN, but it must be finite
        device: the name of a cell needs at least one character
        chip: alias "left" already exists
        chip: there is no alias "lfet"; known are left; did you mean "left"?
        chip: an outline has 2 points, but it needs at least 3
        chip: an outline has 1 point, but it needs at least 3
        chip: point 1 of an outline is (1, NaN), but it must be finite
        chip: the width of the port "in" is -1 µm, but it must be at least 0 µm
        chip: the midpoint of the port "in" is (0, NaN), but it must be finite
        chip: the argument of rotate for the port "in" is NaN (as is every edge of an empty element), but it must be finite
        chip: port "in" already exists
        chip: there is no port "in"; there are none
        chip: there is no port "inn"; known are in
        chip: there is no alias "left"; there are none
        chip: this key of a reference belongs to another open cell, "other"
        chip: the reference of this key is not in the cell any more
        chip: the tolerance of simplify is -1 µm, but it must be at least 0 µm
        pad: every element of the array has a port "in"; port_at takes one by column and row
        pad: the array has no element in column 2, row 0: its size is 2 x 2, counted from 0
        pad: the overlap of connect is NaN, but it must be finite
        pad: the precision of hash_geometry is 0 µm, but it must be finite and greater than 0 µm
        pad: the hierarchy has 4 polygons, but the limit is 2
        pad: the hierarchy has 16000000000000000000 polygons, but the limit is 268435456
        pad: the reference to "pad" reaches the point (3000000, 0): coordinate 3000000 µm is outside the grid, which reaches ±2147483.647 µm in steps of 0.001 µm"#]].assert_eq(&cell_errors().join("\n"));
}

#[test]
fn every_other_sentence_reads_well() {
    expect![[r#"
        layer set: there is no layer "gld"; known are gold; did you mean "gold"?
        layer set: layer "gold" already exists
        layer set: the alpha of the layer "glass" is 1.5, but it must be from 0 to 1
        layer: the color is (2, 0, 0), but it must have channels from 0 to 1
        layer: the color is golden, but it must be #rrggbb or a CSS color name
        layer: the number is 70000, but it must be from 0 to 65535
        grid step is 0 µm, but it must be greater than 0 µm and finite
        coordinate 3000000 µm is outside the grid, which reaches ±2147483.647 µm in steps of 0.001 µm
        die: the wafer has no room for it
        a generator needs its own cell: a → b → a
        in chip: in ring_filter: ring: width is -1 um, but it must be greater than 0 um"#]]
    .assert_eq(&other_errors().join("\n"));
}
