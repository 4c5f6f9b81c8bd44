//! Laws over the whole parameter domain of every shape, as the registry states it.

use phidl_core::geom::signed_area;
use phidl_core::prelude::*;
use proptest::prelude::*;
use testkit::golden::merged_area;

use crate::random::{for_every_drawing, shapes};

/// Random parameter sets for each shape.
const CASES: u32 = 32;
/// Largest distance of a port from the nearest edge (µm).
const PORT_TOLERANCE: f64 = 1e-6;

#[test]
fn what_is_drawn_can_be_measured() {
    for entry in shapes() {
        for_every_drawing(entry, CASES, |_, device| {
            let finite = device.flat_polygons().flat_map(|p| p.points().collect::<Vec<_>>()).all(Point::is_finite);
            prop_assert!(finite && device.ports().all(|port| port.width() >= 0.0));
            prop_assert!(device.area() >= 0.0 && device.hash_geometry(1e-4).is_ok());
            Ok(())
        });
    }
}

#[test]
fn ports_lie_on_the_edge_of_what_is_drawn() {
    for entry in shapes() {
        for_every_drawing(entry, CASES, |_, device| {
            let outlines: Vec<Vec<Point>> = device.flat_polygons().map(|p| p.points().collect()).collect();
            for port in device.ports().filter(|_| !outlines.is_empty()) {
                let size = device.bbox().map_or(1.0, |b| 1.0 + b.max.norm().max(b.min.norm()));
                let nearest = outlines.iter().map(|o| distance(o, port.midpoint())).fold(f64::MAX, f64::min);
                prop_assert!(nearest <= PORT_TOLERANCE * size, "{port} is {nearest} µm away");
            }
            Ok(())
        });
    }
}

/// `polygon_ports` draws the outline that it is given, whatever that is.
#[test]
fn no_outline_crosses_itself() {
    for entry in shapes().filter(|entry| entry.name != "polygon_ports") {
        for_every_drawing(entry, CASES, |_, device| {
            for polygon in device.flat_polygons() {
                let points: Vec<Point> = polygon.points().collect();
                let (drawn, covered) = (signed_area(&points).abs(), merged_area(std::slice::from_ref(&points)));
                // The second engine rounds to 1e-6 µm; an outline may lose half a step along its length.
                let length: f64 = points.windows(2).map(|edge| edge[0].distance(edge[1])).sum();
                prop_assert!((drawn - covered).abs() <= 1e-9 * (1.0 + drawn) + 4e-6 * length, "{drawn} {covered}");
            }
            Ok(())
        });
    }
}

/// Distance of a point from an outline.
fn distance(outline: &[Point], p: Point) -> f64 {
    let edge = |i: usize| {
        let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
        let along = b - a;
        let part = if along == Point::ORIGIN { 0.0 } else { ((p - a).dot(along) / along.dot(along)).clamp(0.0, 1.0) };
        p.distance(a + along * part)
    };
    (0..outline.len()).map(edge).fold(f64::MAX, f64::min)
}
