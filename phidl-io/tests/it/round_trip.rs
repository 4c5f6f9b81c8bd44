//! Write, then read: the same drawing.

use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsDate, GdsOptions, ReadOptions};
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
    let places = |device: &Device| {
        #[expect(clippy::cast_possible_truncation, reason = "a few hundred micrometers")]
        let nm = |p: Point| ((p.x * 1000.0).round() as i64, (p.y * 1000.0).round() as i64);
        let elements = device.references().iter().flat_map(|r| r.elements().map(|e| nm(e.origin)).collect::<Vec<_>>());
        let mut places: Vec<(i64, i64)> = elements.collect();
        places.sort_unstable();
        places
    };
    assert!(places(&field) == places(&back(&field)));
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
    let options = GdsOptions { date: GdsDate::new(2031, 2, 3), ..GdsOptions::default() };
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
