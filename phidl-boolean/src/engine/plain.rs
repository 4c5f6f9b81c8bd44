//! Is a contour plain: would snapping leave it as it is?
//!
//! That is so if no edge of it crosses, touches or passes the square of a vertex (see [`super::snap`]) of an edge that
//! is not its neighbor. For a convex outline, the vertices next to an edge are the nearest to it, so a look at those is
//! enough; other outlines are looked at pair by pair if they are small.

use super::{
    edge::Edge,
    snap::{in_box, opposite, passes},
};
use crate::point::{GridPoint, cross, side};

/// Outlines with more corners than this are only looked at if they are convex.
const MOST_PAIRWISE: usize = 40;

/// Finds the corners of a plain contour, counter-clockwise from its leftmost (then lowest) point; false if it is not
/// plain, encloses nothing, or is too much work to look at. What was in `corners` before is lost.
pub(super) fn plain_outline(contour: &[GridPoint], corners: &mut Vec<GridPoint>) -> bool {
    corners.clear();
    if let Some((low, high)) = upright_rectangle(contour) {
        corners.extend([low, GridPoint::new(high.x, low.y), high, GridPoint::new(low.x, high.y)]);
        return true;
    }
    if !find_real_corners(contour, corners) {
        return false;
    }
    let first = (0..corners.len()).min_by_key(|&corner| corners[corner]).unwrap_or(0);
    corners.rotate_left(first);
    // At the leftmost point, an outline turns the way it runs.
    if side(corners[corners.len() - 1], corners[0], corners[1]).is_lt() {
        corners[1..].reverse();
    }
    (is_convex(corners) && is_wide(corners)) || is_plain_by_pairs(corners)
}

/// The lower left and the upper right corner of a contour that is an upright rectangle, as most shapes of layouts are.
fn upright_rectangle(contour: &[GridPoint]) -> Option<(GridPoint, GridPoint)> {
    let &[a, b, c, d] = contour else { return None };
    let begins_along_x = a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x;
    let begins_along_y = a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y;
    let encloses_something = a.x != c.x && a.y != c.y;
    let corner = |pick: fn(i64, i64) -> i64| GridPoint::new(pick(a.x, c.x), pick(a.y, c.y));
    ((begins_along_x || begins_along_y) && encloses_something).then(|| (corner(i64::min), corner(i64::max)))
}

/// Finds the points of a contour without repeated ones and those on straight edges; false if it doubles back or has no
/// area.
fn find_real_corners(contour: &[GridPoint], corners: &mut Vec<GridPoint>) -> bool {
    if !contour.iter().all(|&point| push(corners, point)) {
        return false;
    }
    // The seam between end and beginning, from both sides.
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

/// Whether a counter-clockwise outline only turns left, and once around.
fn is_convex(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    let at = |i: usize| corners[i % n];
    let turns_left = (0..n).all(|i| side(at(i), at(i + 1), at(i + 2)).is_gt());
    let runs_right = |i: usize| at(i) < at(i + 1);
    turns_left && (0..n).filter(|&i| runs_right(i) != runs_right(i + 1)).count() == 2
}

/// Whether no edge of a convex outline passes the square of a vertex that is not its own.
fn is_wide(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    (0..n).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % n]);
        let reach = i128::from((b.x - a.x).abs() + (b.y - a.y).abs());
        let is_far = |p: GridPoint| 2 * cross(a, b, p) > reach;
        is_far(corners[(i + 2) % n]) && is_far(corners[(i + n - 1) % n])
    })
}

fn is_plain_by_pairs(corners: &[GridPoint]) -> bool {
    let n = corners.len();
    if n > MOST_PAIRWISE {
        return false;
    }
    let edge = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % n]);
        Edge { l: a.min(b), r: a.max(b), delta: [0, 0] }
    };
    let edges: Vec<Edge> = (0..n).map(edge).collect();
    let is_new = |j: usize| !corners[..j].contains(&corners[j]);
    (1..n).all(|j| is_new(j) && (0..j).all(|i| is_clear_of(&edges[i], &edges[j])))
}

/// Whether two edges of one outline leave each other alone; neighbors share an end.
fn is_clear_of(e: &Edge, f: &Edge) -> bool {
    let passes_end = |e: &Edge, p: GridPoint| p != e.l && p != e.r && in_box(e, p) && passes(e, e.cross(p));
    let crosses = opposite(e.cross(f.l), e.cross(f.r)) && opposite(f.cross(e.l), f.cross(e.r));
    let apart = e.l.x > f.r.x || f.l.x > e.r.x;
    apart || !(crosses || passes_end(e, f.l) || passes_end(e, f.r) || passes_end(f, e.l) || passes_end(f, e.r))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(points: &[(i64, i64)]) -> Option<Vec<(i64, i64)>> {
        let points: Vec<GridPoint> = points.iter().copied().map(GridPoint::from).collect();
        let mut corners = Vec::new();
        plain_outline(&points, &mut corners).then(|| corners.iter().map(|p| (p.x, p.y)).collect())
    }

    #[test]
    fn outlines_are_cleaned_turned_and_begun_at_their_leftmost_point() {
        let square = vec![(0, 0), (10, 0), (10, 10), (0, 10)];
        assert_eq!(plain(&[(10, 10), (10, 5), (10, 0), (5, 0), (0, 0), (0, 0), (0, 10), (10, 10)]), Some(square));
        assert_eq!(plain(&[(10, 5), (10, 0), (0, 0), (0, 5)]), Some(vec![(0, 0), (10, 0), (10, 5), (0, 5)]));
        let arrow = [(0, 0), (20, 10), (0, 20), (8, 10)];
        assert_eq!(plain(&arrow), Some(arrow.to_vec()));
        let mut clockwise = arrow;
        clockwise.reverse();
        assert_eq!(plain(&clockwise), Some(arrow.to_vec()));
    }

    #[test]
    fn what_crosses_touches_or_doubles_back_is_not_plain() {
        assert_eq!(plain(&[(0, 0), (10, 10), (10, 0), (0, 8)]), None, "a figure-eight");
        assert_eq!(plain(&[(0, 0), (10, 0), (10, 10), (5, 0), (0, 10)]), None, "a corner on an edge");
        assert_eq!(plain(&[(0, 0), (10, 0), (10, 10), (15, 15), (10, 10), (0, 10)]), None, "a spike");
        assert_eq!(plain(&[(0, 0), (1000, 1), (500, 1)]), None, "thinner than a step");
        assert_eq!(plain(&[(0, 0), (10, 5), (20, 0), (20, 10), (10, 5), (0, 10)]), None, "a corner on a corner");
        assert_eq!(plain(&[(0, 0), (5, 5), (9, 9)]), None, "no area");
        assert_eq!(plain(&[(0, 0), (5, 0), (5, 0), (0, 0)]), None, "an upright rectangle of no height");
        let pentagram = [(0, 20), (60, 20), (10, 60), (30, 0), (50, 60)];
        assert_eq!(plain(&pentagram), None, "it turns left everywhere, but twice around");
    }
}
