//! The properties of every region, checked by slow and obvious methods.

use phidl_boolean::{
    Operation, Region,
    grid::{Contours, GridPoint, signed_area2},
};

fn cross(a: GridPoint, b: GridPoint, c: GridPoint) -> i128 {
    i128::from(b.x - a.x) * i128::from(c.y - a.y) - i128::from(b.y - a.y) * i128::from(c.x - a.x)
}

fn edges(contours: &Contours) -> Vec<(GridPoint, GridPoint)> {
    let closed = |c: &[GridPoint]| c.iter().copied().zip(c.iter().copied().cycle().skip(1)).collect::<Vec<_>>();
    contours.iter().flat_map(closed).collect()
}

/// True if `p` lies on the edge but is not one of its ends.
fn is_inside_edge((a, b): (GridPoint, GridPoint), p: GridPoint) -> bool {
    let dot = i128::from(p.x - a.x) * i128::from(p.x - b.x) + i128::from(p.y - a.y) * i128::from(p.y - b.y);
    cross(a, b, p) == 0 && dot < 0
}

/// Panics unless outlines have real corners, the right direction, no crossings and nothing in common but points.
pub(crate) fn assert_clean(region: &Region) {
    for polygon in region.polygons() {
        assert!(signed_area2(polygon.outer()) > 0, "an outer outline runs clockwise");
        assert!(polygon.holes().all(|hole| signed_area2(hole) < 0), "a hole runs counter-clockwise");
        assert!(
            polygon.holes().all(|hole| hole.iter().all(|&p| is_in_outline(polygon.outer(), p))),
            "a hole is outside"
        );
    }
    for contour in region.contours().iter() {
        assert_eq!(contour.iter().min(), contour.first(), "an outline does not begin at its leftmost point");
        for i in 0..contour.len() {
            let (a, b, c) = (contour[i], contour[(i + 1) % contour.len()], contour[(i + 2) % contour.len()]);
            assert_ne!(cross(a, b, c), 0, "{b:?} is no corner");
        }
    }
    let edges = edges(region.contours());
    for (i, &e) in edges.iter().enumerate() {
        for &f in &edges[..i] {
            let properly = |p: (GridPoint, GridPoint), q: (GridPoint, GridPoint)| {
                cross(p.0, p.1, q.0).signum() * cross(p.0, p.1, q.1).signum() < 0
            };
            assert!(!(properly(e, f) && properly(f, e)), "{e:?} crosses {f:?}");
            assert!(e != f && e != (f.1, f.0), "{e:?} occurs twice");
            let overlap = [f.0, f.1].into_iter().any(|p| is_inside_edge(e, p))
                && cross(e.0, e.1, f.0) == 0
                && cross(e.0, e.1, f.1) == 0;
            assert!(!overlap, "{e:?} lies on {f:?}");
        }
    }
}

fn is_in_outline(outline: &[GridPoint], p: GridPoint) -> bool {
    let one: Contours = [outline.to_vec()].into_iter().collect();
    winding(&one, p) != 0 || edges(&one).into_iter().any(|e| e.0 == p || is_inside_edge(e, p))
}

/// Winding number of contours around a point that is on none of them.
fn winding(contours: &Contours, p: GridPoint) -> i32 {
    edges(contours)
        .into_iter()
        .map(|(a, b)| {
            let left = cross(a, b, p);
            if a.y <= p.y && b.y > p.y && left > 0 {
                1
            } else if a.y > p.y && b.y <= p.y && left < 0 {
                -1
            } else {
                0
            }
        })
        .sum()
}

fn covers(shapes: &Contours, p: GridPoint) -> bool {
    shapes.iter().any(|shape| winding(&[shape.to_vec()].into_iter().collect(), p) != 0)
}

/// True if `p` is farther than `steps` from the edge.
fn is_clear_of((a, b): (GridPoint, GridPoint), p: GridPoint, steps: f64) -> bool {
    let (abx, aby) = ((b.x - a.x) as f64, (b.y - a.y) as f64);
    let (apx, apy) = ((p.x - a.x) as f64, (p.y - a.y) as f64);
    let length2 = abx * abx + aby * aby;
    let t = if length2 == 0.0 { 0.0 } else { ((apx * abx + apy * aby) / length2).clamp(0.0, 1.0) };
    (apx - t * abx).hypot(apy - t * aby) > steps
}

/// Edges move by at most half a step in x and y, so a point farther than that keeps its side.
const CLEAR: f64 = 0.75;

/// Panics unless every probe that is not at an edge of the shapes is covered exactly if set theory says so.
pub(crate) fn assert_covers(region: &Region, a: &Contours, b: &Contours, operation: Operation, probes: &[GridPoint]) {
    let all: Vec<_> = edges(a).into_iter().chain(edges(b)).collect();
    for &p in probes.iter().filter(|&&p| all.iter().all(|&e| is_clear_of(e, p, CLEAR))) {
        assert_eq!(region.contains(p), operation.keeps(covers(a, p), covers(b, p)), "{operation:?} at {p:?}");
    }
}

/// Panics unless both regions cover the same probes, as far as those are not at an edge.
pub(crate) fn assert_same_cover(region: &Region, same: &Region, probes: &[GridPoint]) {
    let edges = edges(same.contours());
    for &p in probes.iter().filter(|&&p| edges.iter().all(|&e| is_clear_of(e, p, CLEAR))) {
        assert_eq!(region.contains(p), same.contains(p), "at {p:?}");
    }
}
