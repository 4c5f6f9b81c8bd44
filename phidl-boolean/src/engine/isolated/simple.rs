//! Simple polygons: contours that snap rounding leaves as they are.
//!
//! No edge of a simple polygon crosses, touches, or comes into the pixel of a vertex of an edge that is not its neighbor.
//! For a convex contour, the vertices next to an edge are the nearest to it, so a test of those is enough. Other contours
//! are tested pair by pair if they are small.

use crate::{
    engine::{
        predicates::{crosses_pixel, have_opposite_signs, in_box},
        segment::Segment,
    },
    point::{GridPoint, cross, side},
};

/// Contours with more corners than this are only tested if they are convex.
const MOST_PAIRWISE: usize = 40;

/// Replaces `corners` by those of a simple polygon, counter-clockwise from its leftmost (then lowest) point. Returns false
/// if the contour is not simple, has no area, or is too large to test.
pub(super) fn simple_polygon(contour: &[GridPoint], corners: &mut Vec<GridPoint>) -> bool {
    corners.clear();
    if let Some((low, high)) = axis_parallel_rectangle(contour) {
        corners.extend([low, GridPoint::new(high.x, low.y), high, GridPoint::new(low.x, high.y)]);
        return true;
    }
    if !find_real_corners(contour, corners) {
        return false;
    }
    let first = (0..corners.len()).min_by_key(|&corner| corners[corner]).unwrap_or(0);
    corners.rotate_left(first);
    // The turn at the leftmost point is the direction of the contour.
    if side(corners[corners.len() - 1], corners[0], corners[1]).is_lt() {
        corners[1..].reverse();
    }
    (is_convex(corners) && is_wide(corners)) || is_simple_by_pairs(corners)
}

/// The lower left and the upper right corner of a contour that is an axis-parallel rectangle, as most shapes of layouts are.
fn axis_parallel_rectangle(contour: &[GridPoint]) -> Option<(GridPoint, GridPoint)> {
    let &[a, b, c, d] = contour else { return None };
    let begins_along_x = a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x;
    let begins_along_y = a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y;
    let encloses_something = a.x != c.x && a.y != c.y;
    let corner = |pick: fn(i64, i64) -> i64| GridPoint::new(pick(a.x, c.x), pick(a.y, c.y));
    ((begins_along_x || begins_along_y) && encloses_something).then(|| (corner(i64::min), corner(i64::max)))
}

/// Finds the points of a contour but repeated ones and those on straight edges; false if it doubles back or has no area.
fn find_real_corners(contour: &[GridPoint], corners: &mut Vec<GridPoint>) -> bool {
    if !contour.iter().all(|&point| push(corners, point)) {
        return false;
    }
    // Where the contour closes, from both sides.
    while corners.len() > 2 && corners.last() == corners.first() {
        corners.pop();
    }
    while let [first, .., a, b] = corners[..] {
        match straightness(a, b, first) {
            Straightness::Corner => break,
            Straightness::Straight => corners.pop(),
            Straightness::Back => return false,
        };
    }
    while let [a, b, .., last] = corners[..] {
        match straightness(last, a, b) {
            Straightness::Corner => break,
            Straightness::Straight => corners.remove(0),
            Straightness::Back => return false,
        };
    }
    corners.len() >= 3
}

/// Adds a point; false if the contour doubles back.
fn push(corners: &mut Vec<GridPoint>, point: GridPoint) -> bool {
    if corners.last() == Some(&point) {
        return true;
    }
    if let [.., a, b] = corners[..] {
        match straightness(a, b, point) {
            Straightness::Corner => {}
            Straightness::Straight => drop(corners.pop()),
            Straightness::Back => return false,
        }
    }
    corners.push(point);
    true
}

enum Straightness {
    Corner,
    Straight,
    Back,
}

fn straightness(a: GridPoint, b: GridPoint, c: GridPoint) -> Straightness {
    if cross(a, b, c) != 0 {
        return Straightness::Corner;
    }
    let along = i128::from(b.x - a.x) * i128::from(c.x - b.x) + i128::from(b.y - a.y) * i128::from(c.y - b.y);
    if along > 0 { Straightness::Straight } else { Straightness::Back }
}

/// Whether a counter-clockwise contour only turns left, and once around.
fn is_convex(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    let at = |i: usize| corners[i % n];
    let turns_left = (0..n).all(|i| side(at(i), at(i + 1), at(i + 2)).is_gt());
    let runs_right = |i: usize| at(i) < at(i + 1);
    turns_left && (0..n).filter(|&i| runs_right(i) != runs_right(i + 1)).count() == 2
}

/// Whether no edge of a convex contour comes into the pixel of a vertex that is not its own.
fn is_wide(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    (0..n).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % n]);
        let reach = i128::from((b.x - a.x).abs() + (b.y - a.y).abs());
        let is_far = |p: GridPoint| 2 * cross(a, b, p) > reach;
        is_far(corners[(i + 2) % n]) && is_far(corners[(i + n - 1) % n])
    })
}

fn is_simple_by_pairs(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    if n > MOST_PAIRWISE {
        return false;
    }
    let edge = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % n]);
        Segment { l: a.min(b), r: a.max(b), delta: [0, 0] }
    };
    let edges: Vec<Segment> = (0..n).map(edge).collect();
    let is_new = |j: usize| !corners[..j].contains(&corners[j]);
    (1..n).all(|j| is_new(j) && (0..j).all(|i| is_clear_of(&edges[i], &edges[j])))
}

/// Whether two edges of one contour do not interact; neighbors share an end.
fn is_clear_of(e: &Segment, f: &Segment) -> bool {
    let touches_end = |e: &Segment, p: GridPoint| p != e.l && p != e.r && in_box(e, p) && crosses_pixel(e, e.cross(p));
    let crosses = have_opposite_signs(e.cross(f.l), e.cross(f.r)) && have_opposite_signs(f.cross(e.l), f.cross(e.r));
    let separate = e.l.x > f.r.x || f.l.x > e.r.x;
    separate || !(crosses || touches_end(e, f.l) || touches_end(e, f.r) || touches_end(f, e.l) || touches_end(f, e.r))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn simple(points: &[(i64, i64)]) -> Option<Vec<(i64, i64)>> {
        let points: Vec<GridPoint> = points.iter().copied().map(GridPoint::from).collect();
        let mut corners = Vec::new();
        simple_polygon(&points, &mut corners).then(|| corners.iter().map(|p| (p.x, p.y)).collect())
    }

    #[test]
    fn contours_are_cleaned_oriented_and_begin_at_their_leftmost_point() {
        let square = vec![(0, 0), (10, 0), (10, 10), (0, 10)];
        assert_eq!(simple(&[(10, 10), (10, 5), (10, 0), (5, 0), (0, 0), (0, 0), (0, 10), (10, 10)]), Some(square));
        assert_eq!(simple(&[(10, 5), (10, 0), (0, 0), (0, 5)]), Some(vec![(0, 0), (10, 0), (10, 5), (0, 5)]));
        let arrow = [(0, 0), (20, 10), (0, 20), (8, 10)];
        assert_eq!(simple(&arrow), Some(arrow.to_vec()));
        let mut clockwise = arrow;
        clockwise.reverse();
        assert_eq!(simple(&clockwise), Some(arrow.to_vec()));
    }

    #[test]
    fn contours_that_cross_touch_or_double_back_are_not_simple() {
        assert_eq!(simple(&[(0, 0), (10, 10), (10, 0), (0, 8)]), None, "a figure-eight");
        assert_eq!(simple(&[(0, 0), (10, 0), (10, 10), (5, 0), (0, 10)]), None, "a corner on an edge");
        assert_eq!(simple(&[(0, 0), (10, 0), (10, 10), (15, 15), (10, 10), (0, 10)]), None, "a spike");
        assert_eq!(simple(&[(0, 0), (1000, 1), (500, 1)]), None, "thinner than a step");
        assert_eq!(simple(&[(0, 0), (10, 5), (20, 0), (20, 10), (10, 5), (0, 10)]), None, "a corner on a corner");
        assert_eq!(simple(&[(0, 0), (5, 5), (9, 9)]), None, "no area");
        assert_eq!(simple(&[(0, 0), (5, 0), (5, 0), (0, 0)]), None, "a rectangle of no height");
        let pentagram = [(0, 20), (60, 20), (10, 60), (30, 0), (50, 60)];
        assert_eq!(simple(&pentagram), None, "it turns left everywhere, but twice around");
    }
}
