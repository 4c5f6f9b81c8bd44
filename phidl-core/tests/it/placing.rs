//! The placement methods of an open cell: keys, aliases, lists and `..`.

use phidl_core::prelude::*;

/// A rectangle from the origin, with ports at its ends.
fn bar(width: f64, height: f64) -> Device {
    let mut d = Device::builder("bar");
    d.add_polygon([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)], 1).unwrap();
    d.add_port("1", ((0.0, height / 2.0), height, 180)).unwrap();
    d.add_port("2", ((width, height / 2.0), height, 0)).unwrap();
    d.build().unwrap()
}

fn empty() -> Device {
    Device::builder("empty").build().unwrap()
}

#[test]
fn one_statement_reads_one_element_and_moves_another() -> Result<()> {
    let mut d = Device::builder("cell");
    let [a, b, c] = d.add([bar(4.0, 2.0), bar(6.0, 2.0), bar(1.0, 1.0)]);
    d.set_xmin(a, d.xmax(b) + 5.0);
    d.set_ymin(c, d.ymax(..) + 10.0);
    d.set_x(c, d.x(a));
    d.move_to(b, d[b].port("1")?, (0, 0));
    d.rotate_about(b, 90, d[b].port("1")?);
    assert_eq!((d.xmin(a), d.center(c)), (11.0, Point::new(13.0, 12.5)));
    assert_eq!(d.bbox_of(b)?, Some(Rect::new((-1, 0), (1, 6))));
    d.connect(b, "1", (a, "2"))?.connect_overlapping(c, "1", (b, "2"), 0.5)?;
    assert_eq!((d.xmin(b), d.xmin(c)), (15.0, 20.5));
    Ok(())
}

#[test]
fn every_method_does_what_the_method_of_the_reference_does() -> Result<()> {
    type Pair = (fn(&mut DeviceBuilder, ReferenceKey), fn(&mut Reference));
    let pairs: [Pair; 18] = [
        (|d, k| _ = d.move_by(k, (1, 2)), |r| _ = r.move_by((1, 2))),
        (|d, k| _ = d.move_to(k, (1, 2), (5, 7)), |r| _ = r.move_to((1, 2), (5, 7))),
        (|d, k| _ = d.movex(k, 3), |r| _ = r.movex(3)),
        (|d, k| _ = d.movey(k, 3), |r| _ = r.movey(3)),
        (|d, k| _ = d.movex_to(k, (1, 2), (5, 7)), |r| _ = r.move_by((4, 0))),
        (|d, k| _ = d.movey_to(k, (1, 2), (5, 7)), |r| _ = r.move_by((0, 5))),
        (|d, k| _ = d.rotate(k, 30), |r| _ = r.rotate(30)),
        (|d, k| _ = d.rotate_about(k, 30, (1, 1)), |r| _ = r.rotate_about(30, (1, 1))),
        (|d, k| _ = d.mirror(k, (0, 0), (1, 1)), |r| _ = r.mirror((0, 0), (1, 1))),
        (|d, k| _ = d.scale(k, 2), |r| _ = r.scale(2)),
        (|d, k| _ = d.set_center(k, (7, 8)), |r| _ = r.set_center((7, 8))),
        (|d, k| _ = d.set_x(k, 7), |r| _ = r.set_x(7)),
        (|d, k| _ = d.set_y(k, 7), |r| _ = r.set_y(7)),
        (|d, k| _ = d.set_xmin(k, 7), |r| _ = r.set_xmin(7)),
        (|d, k| _ = d.set_xmax(k, 7), |r| _ = r.set_xmax(7)),
        (|d, k| _ = d.set_ymin(k, 7), |r| _ = r.set_ymin(7)),
        (|d, k| _ = d.set_ymax(k, 7), |r| _ = r.set_ymax(7)),
        (|d, k| _ = d.align(k, Edge::X), |r| _ = r),
    ];
    for (of_cell, of_reference) in pairs {
        let mut reference = bar(4.0, 2.0).place().moved_by((3, 1));
        let mut d = Device::builder("cell");
        let key = d.add(reference.clone());
        of_cell(&mut d, key);
        of_reference(&mut reference);
        assert_eq!(d[key], reference);
        let box_of_all = d.bbox_of(..)?;
        let due = (reference.center(), reference.size(), reference.xsize(), reference.ysize());
        assert_eq!((d.center(key), d.size(key), d.xsize(key), d.ysize(key)), due);
        let due =
            [reference.x(), reference.y(), reference.xmin(), reference.xmax(), reference.ymin(), reference.ymax()];
        assert_eq!([d.x(key), d.y(key), d.xmin(key), d.xmax(key), d.ymin(key), d.ymax(key)], due);
        assert_eq!((d.bbox_of(key)?, box_of_all), (reference.bbox(), reference.bbox()));
    }
    Ok(())
}

#[test]
fn two_dots_are_the_whole_cell_with_ports_and_labels() -> Result<()> {
    let mut d = bar(4.0, 2.0).edit();
    let label = d.add_label("name", (1, 1), 2)?;
    let inner = d.add(bar(4.0, 2.0).place().moved_by((0, 10)));
    d.rotate(.., 90).move_by(.., (100, 0));
    assert_eq!(d.port("2")?.midpoint(), Point::new(99.0, 4.0));
    assert_eq!((d.label(label)?.position(), d.xmax(inner)), (Point::new(99.0, 1.0), 90.0));
    assert_eq!(d.size(..), Size::new(12.0, 4.0));
    Ok(())
}

#[test]
fn lists_tuples_and_nested_lists_are_targets() -> Result<()> {
    let mut d = Device::builder("cell");
    let pads = [d.add(bar(4.0, 4.0)), d.add(bar(4.0, 4.0).place().moved_by((50, 3)))];
    let names = [d.add_label("a", (1, 1), 2)?, d.add_label("b", (51, 4), 2)?];
    let dot = d.add_polygon([(0, 0), (1, 0), (0, 1)], [1, 2])?;
    d.align(pads, Edge::YMin);
    assert_eq!((d.ymin(pads[0]), d.ymin(pads[1])), (0.0, 0.0));
    // A pad and its name are one member.
    d.distribute([(pads[0], names[0]), (pads[1], names[1])], Direction::X, 2);
    assert_eq!((d.xmin(pads[1]), d.label(names[1])?.position().x), (6.0, 7.0));
    d.move_by((pads, dot), (10, 0));
    assert_eq!((d.xmin(pads[0]), d.xmin(dot), d.xmin(vec![pads[0], pads[1]])), (10.0, 10.0, 10.0));
    d.remove((pads[0], names, dot))?;
    assert_eq!((d.references().len(), d.labels().len(), d.polygons().len()), (1, 0, 0));
    Ok(())
}

#[test]
fn aliases_are_given_by_assignment_and_name_all_kinds_of_elements() -> Result<()> {
    let mut d = Device::builder("cell");
    d["left"] = bar(4.0, 2.0).place();
    d["right"] = bar(4.0, 2.0).place().moved_by((10, 0));
    let dot = d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?;
    d.alias("dot", dot)?;
    d.set_xmin("dot", d.xmax("right")).connect("right", "1", ("left", "2"))?;
    assert_eq!((d.xmin("dot"), d["right"].xmin()), (14.0, 4.0));
    d["right"] = bar(1.0, 1.0).place();
    assert_eq!(d.references().len(), 2, "an assignment to an existing alias replaces the reference");
    assert!(matches!(d.alias("left", dot), Err(Error::Duplicate { .. })));
    d.remove("dot")?;
    assert!(d.polygons().len() == 0 && d.bbox_of("dot").is_err());
    let d = d.build()?;
    assert_eq!(d.aliases().map(|(name, _)| name).collect::<Vec<_>>(), ["left", "right"]);
    Ok(())
}

#[test]
fn a_misspelled_alias_is_an_error_of_build() {
    let mut d = Device::builder("cell");
    d["left"] = bar(4.0, 2.0).place();
    d["lfet"].movex(3);
    let due = "cell: there is no alias \"lfet\"; known are left; did you mean \"left\"?";
    assert_eq!(d.get("lfet").unwrap_err().to_string(), due);
    assert_eq!(d.check().unwrap_err().to_string(), due);
    assert_eq!(d.build().unwrap_err().to_string(), due);
}

#[test]
fn an_edge_of_an_empty_reference_is_reported_with_both_names() {
    let mut d = Device::builder("cell");
    let (a, b) = (d.add(bar(4.0, 2.0)), d.add(empty()));
    d.set_xmin(a, d.xmax(b) + 5.0);
    assert_eq!(
        d.build().unwrap_err().to_string(),
        "cell: the argument of set_xmin for the reference to \"bar\" is NaN, but it must be finite; the reference to \
         \"empty\" is empty, so its edges are NaN"
    );
}

#[test]
fn what_a_method_refuses_is_an_error_of_build() {
    let mut other = Device::builder("other");
    let foreign = other.add(bar(4.0, 2.0));
    let refused: [fn(&mut DeviceBuilder, ReferenceKey, ReferenceKey); 4] = [
        |d, own, _| _ = d.move_by(own, (f64::NAN, 0.0)),
        |d, _, foreign| _ = d.rotate(foreign, 90),
        |d, own, foreign| _ = d.align([own, foreign], Edge::X),
        |d, _, _| _ = d.set_x("nothing", 3),
    ];
    for edit in refused {
        let mut d = Device::builder("cell");
        let own = d.add(bar(4.0, 2.0));
        edit(&mut d, own, foreign);
        assert_eq!(d[own].transform(), &Transform::IDENTITY);
        assert!(d.build().is_err());
    }
    let mut d = Device::builder("cell");
    assert!(matches!(d.connect(foreign, "1", ((0, 0), "x").1), Err(Error::Unknown { .. })));
    assert!(matches!(d.connect(foreign, "1", Port::new((0, 0), 1, 0)), Err(Error::ForeignKey { .. })));
}

#[test]
#[should_panic(expected = "belongs to another open cell")]
fn reading_with_the_key_of_another_cell_panics() {
    let foreign = Device::builder("other").add(bar(4.0, 2.0));
    let _ = Device::builder("cell").xmax(foreign);
}

#[test]
fn a_group_in_a_group_is_one_member() {
    let square = |x: i32, y: i32| Polygon::new([(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)], 1);
    let mut group = square(0, 0) + (square(5, 3) + square(9, 6));
    assert_eq!(group.len(), 2);
    group.align(Edge::YMin);
    let Element::Group(inner) = &group[1] else { panic!("the second member is a group") };
    assert_eq!((inner[0].ymin(), inner[1].ymin()), (0.0, 3.0), "moved together");
    assert_eq!((square(0, 0) + square(3, 0) + square(6, 0)).len(), 3);
    let mut d = Device::builder("cell");
    assert_eq!(d.add(group).len(), 3);
}

#[test]
fn a_port_rotates_about_its_midpoint_and_a_label_about_the_origin() {
    let port = Port::new((3, 4), 2, 30).rotated(180);
    assert_eq!((port.midpoint(), port.orientation()), (Point::new(3.0, 4.0), 210.0));
    assert_eq!(Port::new((3, 4), 2, 30).rotated_about(180, (0, 0)).midpoint(), Point::new(-3.0, -4.0));
    assert_eq!(Label::new("x", (1, 0), 1).rotated(90).position(), Point::new(0.0, 1.0));
}

#[test]
fn several_polygons_are_added_or_none() -> Result<()> {
    let mut d = Device::builder("cell");
    let triangles = (0..3).map(|i| [(i, 0), (i + 1, 0), (i, 1)]);
    let keys = d.add_polygons(triangles, [1, 2])?;
    assert_eq!((keys.len(), d.polygons().len(), d.xmin(keys[2])), (3, 6, 2.0));
    let bad = [vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], vec![(0.0, 0.0)]];
    assert!(d.add_polygons(bad, 1).is_err());
    assert_eq!(d.polygons().len(), 6);
    Ok(())
}
