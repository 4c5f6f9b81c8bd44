//! Write, then read: the same drawing.

use phidl_core::prelude::*;
use phidl_core::scene::TextStyle;
use phidl_io::gds::{self, Date, GdsOptions, ReadOptions};
use proptest::{prop_assert, proptest};

use crate::hierarchy::hierarchies;

fn back(device: &Device) -> Device {
    let bytes = gds::to_bytes(device, &GdsOptions::default()).unwrap();
    let import = gds::read_bytes(&bytes, &ReadOptions::default()).unwrap();
    assert_eq!(import.problems, []);
    import.device
}

/// Angles and magnifications lose their last digit in the format's real numbers now and then.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * a.abs().max(1.0)
}

fn assert_same_transform(a: &Transform, b: &Transform) {
    assert!(a.origin == b.origin && a.x_reflection == b.x_reflection, "{a:?} {b:?}");
    assert!(close(a.rotation, b.rotation) && close(a.magnification, b.magnification), "{a:?} {b:?}");
}

/// Cell by cell, element by element.
fn assert_same_cells(a: &Device, b: &Device) {
    assert_eq!(a.name(), b.name());
    let polygons = |d: &Device| {
        let list = d
            .polygons()
            .map(|p| (p.points.to_vec(), p.layer, p.properties().map(|(k, v)| (k, v.to_owned())).collect()));
        list.collect::<Vec<(Vec<Point>, Layer, Vec<(u16, String)>)>>()
    };
    assert_eq!(polygons(a), polygons(b));
    assert_eq!(a.labels().len(), b.labels().len());
    for (a, b) in a.labels().iter().zip(b.labels()) {
        assert_eq!((&a.text, a.layer, a.anchor, &a.properties), (&b.text, b.layer, b.anchor, &b.properties));
        assert_same_transform(a.transform(), b.transform());
    }
    assert_eq!(a.references().len(), b.references().len());
    for (a, b) in a.references().iter().zip(b.references()) {
        assert_eq!(a.properties, b.properties);
        assert_same_transform(a.transform(), b.transform());
        assert_eq!(a.count(), b.count());
        for ((a, b), _) in a.elements().zip(b.elements()).zip(0..30) {
            assert!(a.origin.distance(b.origin) < 1e-9, "{a:?} {b:?}");
        }
        assert_same_cells(a.device(), b.device());
    }
}

proptest! {
    #[test]
    fn what_is_written_on_the_grid_is_read_as_it_was(device in hierarchies()) {
        let read = back(&device);
        assert_same_cells(&device, &read);
        // Once more: the file of a file is the file.
        let options = GdsOptions::default();
        let (first, second) = (gds::to_bytes(&device, &options).unwrap(), gds::to_bytes(&read, &options).unwrap());
        prop_assert!(first == second);
    }
}

fn square(size: f64) -> Device {
    let mut d = Device::builder("square");
    d.add_polygon([(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)], 1).unwrap();
    d.build().unwrap()
}

#[test]
fn rounding_goes_away_from_zero_and_leaves_mirrored_layouts_mirrored() {
    let mut d = Device::builder("halves");
    d.add_polygon([(0.0005, 0.0015), (1.0005, 0.0), (-0.0005, -2.0005)], 1).unwrap();
    let read = back(&d.build().unwrap());
    let points = read.polygons().next().unwrap().points.to_vec();
    assert_eq!(points, [(0.001, 0.002), (1.001, 0.0), (-0.001, -2.001)].map(Point::from));
}

#[test]
fn elements_of_an_array_off_the_grid_stand_where_rounding_puts_them() {
    let mut d = Device::builder("field");
    d.add(square(0.1).array(1000, 3, (1.0 / 3.0, 2.0)));
    d.add(square(0.1).array(7, 7, (1.5, 1.5)).rotated(30.0));
    let field = d.build().unwrap();
    let positions = |device: &Device| {
        #[expect(clippy::cast_possible_truncation, reason = "a few hundred micrometers")]
        let nm = |p: Point| ((p.x * 1000.0).round() as i64, (p.y * 1000.0).round() as i64);
        let elements = device.references().iter().flat_map(|r| r.elements().map(|e| nm(e.origin)).collect::<Vec<_>>());
        let mut positions: Vec<(i64, i64)> = elements.collect();
        positions.sort_unstable();
        positions
    };
    assert!(positions(&field) == positions(&back(&field)));
}

#[test]
fn large_outlines_are_cut_and_keep_their_area() {
    let mut d = Device::builder("ring");
    let circle = |radius: f64, turn: f64| {
        (0..=20_000).map(move |i| Point::polar(radius, turn * 360.0 * f64::from(i) / 20_000.0))
    };
    d.add_polygon(circle(100.0, 1.0).chain(circle(80.0, -1.0)).collect::<Vec<_>>(), 1).unwrap();
    let ring = d.build().unwrap();
    let read = back(&ring);
    assert!(read.polygons().all(|p| p.points.len() <= 4094));
    let area = |d: &Device| d.polygons().map(|p| p.area()).sum::<f64>();
    // 1800 π; each of 40,000 corners moves by less than a nanometer along an edge of 31 nm.
    assert!((area(&read) - area(&ring)).abs() < 0.7, "{} {}", area(&read), area(&ring));
    assert!((area(&ring) - 3600.0 * PI).abs() < 0.01);
}

#[test]
fn the_same_source_gives_the_same_bytes_and_the_date_is_the_one_that_was_set() {
    let device = square(1.0);
    let options = GdsOptions { date: Date::new(2031, 2, 3), ..GdsOptions::default() };
    let bytes = gds::to_bytes(&device, &options).unwrap();
    assert_eq!(bytes, gds::to_bytes(&square(1.0), &options).unwrap());
    // BGNLIB: year, month, day … twice.
    let date = [7, 239, 0, 2, 0, 3, 0, 0, 0, 0, 0, 0];
    assert_eq!(bytes[10..34], [date, date].concat());
}

#[test]
fn lengths_are_micrometers_whatever_the_units_of_the_file() {
    let device = square(12.0);
    for (user_unit, grid) in [(1000.0, 1e-3), (1e-3, 5e-3), (1.0, 0.25)] {
        let options = GdsOptions { user_unit, grid, ..GdsOptions::default() };
        let import = gds::read_bytes(&gds::to_bytes(&device, &options).unwrap(), &ReadOptions::default()).unwrap();
        assert_eq!(import.device.bbox(), device.bbox());
        assert!((import.user_unit / user_unit - 1.0).abs() < 1e-12 && (import.grid / grid - 1.0).abs() < 1e-12);
    }
}

/// An independent reader finds what was written, and reads what an independent writer wrote.
mod independent {
    use ::gds21::{GdsElement, GdsLibrary, GdsPoint, GdsPresentation, GdsStruct, GdsStructRef, GdsTextElem};

    use super::*;

    #[test]
    fn finds_every_element_with_all_it_has() {
        let mut d = Device::builder("dot");
        d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], (40_000, 3)).with_property(7, "odd"));
        let dot = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(Label::new("here", (1, 2), (5, 6)).anchored(Anchor::SouthWest));
        d.add(dot.place().rotated(90).moved_by((3, 4)));
        d.add(dot.array(2, 3, (10, 20)));
        let bytes = gds::to_bytes(&d.build().unwrap(), &GdsOptions::default()).unwrap();

        let library = GdsLibrary::from_bytes(&bytes).unwrap();
        let names: Vec<&str> = library.structs.iter().map(|cell| cell.name.as_str()).collect();
        assert_eq!(names, ["dot", "top"]);
        let [GdsElement::GdsBoundary(b)] = &library.structs[0].elems[..] else { panic!("one boundary") };
        assert_eq!((b.layer, b.datatype, b.xy.len()), (-25_536, 3, 4));
        assert_eq!((b.properties[0].attr, b.properties[0].value.as_str()), (7, "odd"));
        let [GdsElement::GdsTextElem(t), GdsElement::GdsStructRef(s), GdsElement::GdsArrayRef(a)] =
            &library.structs[1].elems[..]
        else {
            panic!("a text, a reference, an array")
        };
        assert_eq!((t.string.as_str(), t.xy.x, t.texttype), ("here", 1000, 6));
        assert_eq!(t.presentation.as_ref().unwrap().1, 8);
        assert_eq!((s.xy.y, s.strans.as_ref().unwrap().angle), (4000, Some(90.0)));
        assert_eq!((a.cols, a.rows, a.xy[1].x, a.xy[2].y), (2, 3, 20_000, 60_000));
        assert_eq!(library.units.db_unit(), 1e-9);
    }

    #[test]
    fn finds_every_element_of_a_file_of_several_portions() {
        let mut d = Device::builder("many");
        for i in 0..20_000 {
            let at = Point::from((i % 200, i / 200));
            d.add_polygon([at, at + Point::new(0.5, 0.0), at + Point::new(0.0, 0.5)], 1).unwrap();
        }
        let bytes = gds::to_bytes(&d.build().unwrap(), &GdsOptions::default()).unwrap();
        assert!(bytes.len() > 1 << 20);
        let [cell] = &GdsLibrary::from_bytes(&bytes).unwrap().structs[..] else { panic!("one cell") };
        assert_eq!(cell.elems.len(), 20_000);
    }

    #[test]
    fn writes_what_is_read() {
        let mut library = GdsLibrary::new("other");
        let mut top = GdsStruct::new("top");
        let text = GdsTextElem {
            string: "pad".into(),
            layer: 3,
            xy: GdsPoint::new(1000, -2000),
            presentation: Some(GdsPresentation(0, 0b10_0110)),
            ..GdsTextElem::default()
        };
        let reference = GdsStructRef { name: "dot".into(), xy: GdsPoint::new(5, 6), ..GdsStructRef::default() };
        top.elems = vec![text.into(), reference.into()];
        library.structs = vec![GdsStruct::new("dot"), top];
        let mut bytes = Vec::new();
        library.write(&mut bytes).unwrap();

        let read = gds::read_bytes(&bytes, &ReadOptions::default()).unwrap();
        assert_eq!((read.library_name.as_str(), read.device.name()), ("other", "top"));
        let label = &read.device.labels()[0];
        assert_eq!((label.position(), label.anchor, label.style().font), (Point::new(1.0, -2.0), Anchor::East, 2));
        assert_eq!(read.device.references()[0].transform().origin, Point::new(0.005, 0.006));
    }
}

/// What files have that devices do not draw stays from file to file.
#[test]
fn attributes_of_texts_stay() {
    let style = |font, path_type, width, anchor_unstated, magnification_stated| TextStyle {
        font,
        path_type,
        width,
        anchor_unstated,
        magnification_stated,
    };
    let mut d = Device::builder("texts");
    let styles = [
        style(0, None, None, false, false),
        style(3, Some(1), Some(0.25), false, true),
        style(0, Some(-1), Some(-0.5), true, false),
    ];
    for style in styles {
        d.add(Label::new("5 µm\tΩ\n2", (1, 2), 3).anchored(Anchor::NorthWest).with_style(style));
    }
    let texts = d.build().unwrap();
    let read = back(&texts);
    assert_eq!(read.labels(), texts.labels());
    assert_eq!(read, texts);
}

#[test]
fn cells_that_are_drawn_alike_keep_their_names() {
    let transistor = |name: &str| {
        let mut d = Device::builder(name);
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        d.build().unwrap()
    };
    let mut d = Device::builder("inverter");
    d.add(transistor("nmos w=1 l=0.06"));
    d.add(transistor("pmos w=1 l=0.06"));
    let read = back(&d.build().unwrap());
    let names: Vec<&str> = read.references().iter().map(|r| r.device().name()).collect();
    assert_eq!(names, ["nmos w=1 l=0.06", "pmos w=1 l=0.06"]);
}

#[test]
fn several_top_cells_are_one_file() {
    let dot = square(1.0);
    let holder = |name: &str| {
        let mut d = Device::builder(name);
        d.add(&dot);
        d.build().unwrap()
    };
    let tops = vec![holder("a"), holder("b")];
    let bytes = gds::to_bytes(&tops, &GdsOptions::default()).unwrap();
    let layout = gds::decode_layout(&bytes).unwrap();
    let names: Vec<&str> = layout.cells.iter().map(|cell| layout.names.name(cell.name)).collect();
    assert_eq!((names, layout.tops()), (vec!["square", "a", "b"], vec![1, 2]));
}

#[test]
fn coordinates_reach_from_the_first_to_the_last_of_32_bits() {
    let (low, high) = (-2_147_483.648, 2_147_483.647);
    let mut d = Device::builder("far");
    d.add_polygon([(low, low), (high, low), (high, high)], 1).unwrap();
    let far = d.build().unwrap();
    assert_eq!(back(&far), far);
}
