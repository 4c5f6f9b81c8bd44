//! Rounding the corners of an outline.

use std::f64::consts::TAU;

use phidl_core::num::count;
use phidl_core::prelude::*;

/// Points that a full turn of a rounded corner would get.
const POINTS_PER_TURN: f64 = 128.0;
/// How much of each adjacent edge a rounding may take at the most; a little less than half, so that two rounded corners
/// never meet in one point.
const MOST_OF_AN_EDGE: f64 = 0.49;
/// A corner that turns by less than this (radians) is straight and stays one point.
const STRAIGHT: f64 = 1e-6;

/// The outline with its corners rounded, each by its own radius (µm; 0 keeps the corner).
///
/// A rounding is an arc that touches both edges of the corner. Where a radius asks for more than 49 % of an adjacent
/// edge, it is the largest that does not. The result begins with the last corner, as the specification has it.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry::connect::filleted;
/// let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
/// let rounded = filleted(&square, |_| 1.0);
/// assert_eq!(rounded.len(), 4 * 32);
/// ```
#[must_use]
pub fn filleted(outline: &[Point], radius: impl Fn(usize) -> f64) -> Vec<Point> {
    let corners: Vec<usize> = (0..outline.len()).filter(|i| outline[*i] != outline[before(*i, outline)]).collect();
    let mut rounded = Vec::new();
    for turn in 0..corners.len() {
        let at = |offset: usize| corners[(turn + corners.len() - 2 + offset) % corners.len()];
        let (previous, corner, next) = (outline[at(0)], outline[at(1)], outline[at(2)]);
        round_corner(previous, corner, next, radius(at(1)), &mut rounded);
    }
    rounded
}

fn before(i: usize, outline: &[Point]) -> usize {
    if i == 0 { outline.len() - 1 } else { i - 1 }
}

fn round_corner(previous: Point, corner: Point, next: Point, radius: f64, rounded: &mut Vec<Point>) {
    let (incoming, outgoing) = (corner - previous, next - corner);
    let turn = incoming.cross(outgoing).atan2(incoming.dot(outgoing));
    let half_tangent = (turn.abs() / 2.0).tan();
    let longest = MOST_OF_AN_EDGE * incoming.norm().min(outgoing.norm());
    let radius = radius.min(longest / half_tangent);
    if turn.abs() <= STRAIGHT || radius <= 0.0 {
        rounded.push(corner);
        return;
    }
    let points = count::up(POINTS_PER_TURN * turn.abs() / TAU).max(2);
    let start = corner - incoming * (radius * half_tangent / incoming.norm());
    // The center lies to the side that the outline turns to.
    let to_center = Point::new(-incoming.y, incoming.x) * (radius * turn.signum() / incoming.norm());
    let center = start + to_center;
    for step in count::linspace(0.0, turn, points) {
        let (sin, cos) = step.sin_cos();
        let spoke = -to_center;
        rounded.push(center + Point::new(spoke.x * cos - spoke.y * sin, spoke.x * sin + spoke.y * cos));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::signed_area;

    #[test]
    fn a_rounded_square_loses_the_area_outside_its_arcs() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        for outline in [square, [square[3], square[2], square[1], square[0]]] {
            let area = signed_area(&filleted(&outline, |_| 2.0)).abs();
            // Four corners lose (4 - π) r² in all; 31 chords of a quarter circle lose a little more.
            assert!((area - (100.0 - (4.0 - PI) * 4.0)).abs() < 0.01, "{area}");
        }
    }

    #[test]
    fn one_inner_corner_is_rounded_within_half_an_edge() {
        let l = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 3), (0, 3)].map(Point::from);
        let rounded = filleted(&l, |i| if i == 3 { 5.0 } else { 0.0 });
        assert_eq!(rounded.len(), 5 + 32);
        let bend: Vec<&Point> = rounded.iter().filter(|p| p.distance(Point::new(2.49, 2.49)) < 0.4901).collect();
        assert_eq!(bend.len(), 32, "an arc of radius 0.49 about (2.49, 2.49)");
    }

    #[test]
    fn repeated_points_count_once() {
        let square = [(0, 0), (10, 0), (10, 10), (10, 10), (0, 10), (0, 0)].map(Point::from);
        assert_eq!(filleted(&square, |_| 0.0).len(), 4);
    }
}
