//! Helpers of unit tests.

use phidl_core::geom::signed_area;
use phidl_core::prelude::*;
use testkit::golden::merged_area;

/// Whether no outline crosses itself: one that does covers more than it encloses once.
pub(crate) fn outlines_are_simple(device: &Device) -> bool {
    device.flat_polygons().all(|polygon| {
        let points: Vec<Point> = polygon.points().collect();
        let enclosed = signed_area(&points).abs();
        let length: f64 = points.windows(2).map(|p| p[0].distance(p[1])).sum();
        // The covered area is found on a grid of 1e-6 µm.
        (merged_area(&[points]) - enclosed).abs() <= 1e-6 * length
    })
}

#[test]
fn a_bow_tie_is_not_simple() {
    let outline = |points: [(i32, i32); 4]| {
        let mut d = Device::builder("outline");
        d.add_polygon(points, 0).unwrap();
        d.build().unwrap()
    };
    assert!(!outlines_are_simple(&outline([(0, 0), (2, 2), (2, 0), (0, 2)])));
    assert!(outlines_are_simple(&outline([(0, 0), (2, 0), (2, 2), (0, 2)])));
}
