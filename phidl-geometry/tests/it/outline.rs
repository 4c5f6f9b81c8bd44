//! Questions that tests ask about outlines and the ports on them.

use phidl_core::prelude::*;

/// How far from an edge a point still lies on it (µm).
const ON_EDGE: f64 = 1e-6;

/// Whether no edge of the outline crosses another one. Edges without length do not count.
pub(crate) fn is_simple(outline: &[Point]) -> bool {
    let mut corners = outline.to_vec();
    corners.dedup();
    if corners.first() == corners.last() {
        corners.pop();
    }
    let n = corners.len();
    let edge = |i: usize| (corners[i], corners[(i + 1) % n]);
    (0..n).all(|i| (i + 2..n).filter(|j| (j + 1) % n != i).all(|j| !cross(edge(i), edge(j))))
}

/// Whether two edges have a point in common that is no end of either.
fn cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Whether both ends of a port lie on one edge of something drawn.
pub(crate) fn is_on_an_edge(device: &Device, port: &Port) -> bool {
    let (left, right) = port.endpoints();
    let middle = (left + right) / 2.0;
    device.flat_polygons().any(|polygon| {
        let outline: Vec<Point> = polygon.points().collect();
        let edges = (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]));
        edges.into_iter().any(|edge| [left, middle, right].into_iter().all(|p| distance(p, edge) < ON_EDGE))
    })
}

fn distance(p: Point, (a, b): (Point, Point)) -> f64 {
    let along = b - a;
    let t = if along.norm() > 0.0 { ((p - a).dot(along) / along.dot(along)).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * t)
}

/// The boxes of everything drawn on a layer.
pub(crate) fn boxes(device: &Device, layer: u16) -> Vec<Rect> {
    let polygons = device.flat_polygons().filter(|polygon| polygon.layer == Some(layer.into()));
    polygons.filter_map(|polygon| Rect::around(polygon.points())).collect()
}

#[test]
fn a_bow_tie_crosses_itself_and_an_l_does_not() {
    let bow_tie = [(0, 0), (2, 2), (2, 0), (0, 2)].map(Point::from);
    let l = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), (0, 0)].map(Point::from);
    assert!(!is_simple(&bow_tie) && is_simple(&l));
}
