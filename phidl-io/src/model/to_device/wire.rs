//! The outline of a path.
//!
//! Devices have polygons and no paths, so a path becomes the outline that KLayout draws: both edges half the width from the
//! centerline. The outer side of a turn of up to 90° is a miter; at sharper turns both edges run on by half the width and
//! their ends are joined. The inner side is where the two edges meet. Round ends are regular polygons within a tenth of a grid
//! step of the circle before rounding, with at most 512 chords: 50 bytes of a file must not ask for megabytes.
//!
//! Every corner is a point of the centerline plus a rounded offset, so equal paths have equal outlines wherever they are,
//! and an outline is on the grid. Where the inner edges do not meet on their segments, or the path runs over itself, one
//! outline would leave slivers outside of the wire: the wire is united from its segments then ([`overlap`](super::overlap)).

use phidl_core::geom::Point;
use phidl_core::num::grid::whole;
use phidl_core::num::{angle, count};

use super::overlap;
use crate::model::{Path, PathEnd};

/// A point in grid steps. Outlines of paths may reach beyond 32 bits.
pub(crate) type Step = [i64; 2];

/// The largest distance of a chord from a round end (grid steps).
const TOLERANCE: f64 = 0.1;

/// The most chords of a half circle.
const MOST_CHORDS: usize = 512;

/// Turns up to this cosine (90°) are mitered.
const MITERED: f64 = -1e-12;

/// The outlines of a path: one, or several where it overlaps itself; none if it covers nothing.
pub(crate) fn outlines(path: &Path) -> Vec<Vec<Step>> {
    let Some(wire) = Wire::new(path) else { return dot(path) };
    if let Some(outline) = wire.outline().filter(|outline| overlap::is_simple(outline, &wire)) {
        return vec![outline];
    }
    overlap::united(&wire)
}

/// A path of at least one segment.
pub(super) struct Wire {
    points: Vec<Point>,
    /// The direction of each segment.
    directions: Vec<Point>,
    half: f64,
    start: PathEnd,
    end: PathEnd,
}

/// The outline of a path whose points are all the same: a disc or a rectangle about it.
fn dot(path: &Path) -> Vec<Vec<Step>> {
    let half = path.width as f64 / 2.0;
    let Some(center) = path.points.first().filter(|_| path.width > 0).map(|corner| point(*corner)) else {
        return Vec::new();
    };
    let along = Point::new(1.0, 0.0);
    let start = cap(center, along * -1.0, half, path.start);
    let end = cap(center, along, half, path.end);
    let outline = [start, end].concat();
    let [mut left, mut right] = [i64::MAX, i64::MIN];
    outline.iter().for_each(|[x, _]| (left, right) = (left.min(*x), right.max(*x)));
    if left < right { vec![outline] } else { Vec::new() }
}

fn point([x, y]: [i32; 2]) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

impl Wire {
    fn new(path: &Path) -> Option<Self> {
        let mut points: Vec<Point> = path.points.iter().map(|corner| point(*corner)).collect();
        points.dedup();
        if points.len() < 2 || path.width <= 0 {
            return None;
        }
        let directions = points.windows(2).map(|pair| unit(pair[1] - pair[0])).collect();
        let half = path.width as f64 / 2.0;
        Some(Self { points, directions, half, start: path.start, end: path.end })
    }

    /// One outline along both edges: left and right corner of the start, right edge, end, left edge. `None` if the inner
    /// edges of a turn do not meet on their segments.
    fn outline(&self) -> Option<Vec<Step>> {
        if !self.inner_edges_meet() {
            return None;
        }
        let mut outline = self.start_cap();
        for joint in 1..self.directions.len() {
            outline.extend(self.joint(joint, -1.0));
        }
        outline.extend(self.end_cap());
        for joint in (1..self.directions.len()).rev() {
            let mut corners = self.joint(joint, 1.0);
            corners.reverse();
            outline.extend(corners);
        }
        Some(outline)
    }

    /// Whether each segment is long enough for the inner miters at its ends.
    fn inner_edges_meet(&self) -> bool {
        let last = self.directions.len() - 1;
        let reach = |joint: usize| {
            let (before, after) = (self.directions[joint - 1], self.directions[joint]);
            // tan(turn / 2)
            self.half * before.cross(after).abs() / (1.0 + before.dot(after)).max(1e-300)
        };
        (0..=last).all(|segment| {
            let length = (self.points[segment + 1] - self.points[segment]).norm();
            let start = if segment == 0 { -extension(self.start, self.half).min(0.0) } else { reach(segment) };
            let end = if segment == last { -extension(self.end, self.half).min(0.0) } else { reach(segment + 1) };
            start + end <= length
        })
    }

    fn start_cap(&self) -> Vec<Step> {
        cap(self.points[0], self.directions[0] * -1.0, self.half, self.start)
    }

    fn end_cap(&self) -> Vec<Step> {
        let last = self.directions.len() - 1;
        cap(self.points[last + 1], self.directions[last], self.half, self.end)
    }

    /// The corners of one edge at the joint before a segment: of the left edge for `side` 1, of the right edge for −1.
    fn joint(&self, joint: usize, side: f64) -> Vec<Step> {
        let (before, after) = (self.directions[joint - 1], self.directions[joint]);
        let (at, half) = (self.points[joint], self.half);
        let (a, b) = (left(before) * (half * side), left(after) * (half * side));
        let cos = before.dot(after);
        let is_inner = before.cross(after) * side > 0.0;
        if is_inner || cos >= MITERED {
            // The bisector of the two normals, as long as both edges need to reach it.
            return vec![offset(at, (a + b) / (1.0 + cos))];
        }
        vec![offset(at, a + before * half), offset(at, b - after * half)]
    }

    /// Polygons that cover the wire together: each segment, the outer side of each turn, the ends.
    pub(super) fn pieces(&self) -> Vec<Vec<Step>> {
        let mut pieces = Vec::with_capacity(2 * self.points.len() + 2);
        for (segment, along) in self.directions.iter().enumerate() {
            let (from, to, across) = (self.points[segment], self.points[segment + 1], left(*along) * self.half);
            pieces.push(vec![
                offset(from, across),
                offset(from, across * -1.0),
                offset(to, across * -1.0),
                offset(to, across),
            ]);
        }
        for joint in 1..self.directions.len() {
            let (before, after) = (self.directions[joint - 1], self.directions[joint]);
            let side = if before.cross(after) > 0.0 { -1.0 } else { 1.0 };
            let across = |along: Point| left(along) * (self.half * side);
            let at = self.points[joint];
            let mut wedge = vec![offset(at, Point::ORIGIN), offset(at, across(before))];
            wedge.extend(self.joint(joint, side));
            wedge.push(offset(at, across(after)));
            pieces.push(wedge);
        }
        let base = |at: Point, along: Point| [1.0, -1.0].map(|side| offset(at, left(along) * (self.half * side)));
        let last = self.directions.len() - 1;
        let caps = [
            (self.start_cap(), base(self.points[0], self.directions[0] * -1.0)),
            (self.end_cap(), base(self.points[last + 1], self.directions[last])),
        ];
        for (mut cap, base) in caps {
            cap.extend(base);
            pieces.push(cap);
        }
        pieces
    }

    /// The angle by which the wire turns in all (degrees), left and right alike.
    pub(super) fn total_turn(&self) -> f64 {
        self.directions.windows(2).map(|pair| angle_between(pair[0], pair[1])).sum()
    }
}

fn angle_between(a: Point, b: Point) -> f64 {
    a.cross(b).atan2(a.dot(b)).to_degrees().abs()
}

/// How far a straight end reaches beyond its point.
fn extension(end: PathEnd, half: f64) -> f64 {
    match end {
        PathEnd::Flush | PathEnd::Round => 0.0,
        PathEnd::Square => half,
        PathEnd::Extended(by) => by as f64,
    }
}

/// The corners across an end, from right to left as seen outward.
fn cap(at: Point, outward: Point, half: f64, end: PathEnd) -> Vec<Step> {
    let right = left(outward) * -half;
    if end != PathEnd::Round {
        let tip = outward * extension(end, half);
        return vec![offset(at, tip + right), offset(at, tip - right)];
    }
    let chords = count::for_tolerance(half, 180.0, TOLERANCE).min(MOST_CHORDS);
    let from = right.direction();
    (0..=chords).map(|i| offset(at, Point::polar(half, from + 180.0 * i as f64 / chords as f64))).collect()
}

/// A point plus a rounded offset.
fn offset(at: Point, by: Point) -> Step {
    #[expect(clippy::cast_possible_truncation, reason = "whole numbers of at most 34 bits")]
    let step = [(at.x + whole(by.x)) as i64, (at.y + whole(by.y)) as i64];
    step
}

fn unit(v: Point) -> Point {
    match angle::quarter_turns(v.direction()) {
        // Exact along the axes, where most paths run.
        Some(_) => Point::polar(1.0, v.direction()),
        None => v / v.norm(),
    }
}

/// A quarter turn to the left.
fn left(v: Point) -> Point {
    Point::new(-v.y, v.x)
}

#[cfg(test)]
mod tests {
    use phidl_core::layer::Layer;
    use phidl_core::scene::Properties;

    use super::*;

    fn path(points: &[[i32; 2]], width: i64, end: PathEnd) -> Path {
        let (layer, properties) = (Layer::new(1, 0), Properties::new());
        Path { layer, points: points.to_vec(), width, fixed_width: false, start: end, end, properties, offset: 0 }
    }

    fn area(outlines: &[Vec<Step>]) -> f64 {
        let area2 = |outline: &Vec<Step>| -> i64 {
            let edges = outline.iter().zip(outline.iter().cycle().skip(1));
            edges.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
        };
        outlines.iter().map(|outline| (area2(outline) as f64 / 2.0).abs()).sum()
    }

    /// The corners that PHIDL draws.
    #[test]
    fn a_path_with_a_right_angle_has_a_miter_on_both_sides() {
        let outline = outlines(&path(&[[0, 0], [10_000, 0], [10_000, 5000]], 500, PathEnd::Flush));
        let expected = [[0, 250], [0, -250], [10_250, -250], [10_250, 5000], [9750, 5000], [9750, 250]];
        assert_eq!(outline, [expected.to_vec()]);
    }

    #[test]
    fn ends_are_flush_square_extended_or_round() {
        let line = [[0, 0], [10_000, 0]];
        assert_eq!(area(&outlines(&path(&line, 500, PathEnd::Flush))), 5_000_000.0);
        assert_eq!(area(&outlines(&path(&line, 500, PathEnd::Square))), 5_250_000.0);
        assert_eq!(area(&outlines(&path(&line, 500, PathEnd::Extended(-1000)))), 4_000_000.0);
        let circle = std::f64::consts::PI * 250.0 * 250.0;
        let round = area(&outlines(&path(&line, 500, PathEnd::Round)));
        assert!((round - 5_000_000.0 - circle).abs() < 400.0, "{round}");
        let ends = Path { end: PathEnd::Extended(3000), ..path(&line, 2000, PathEnd::Square) };
        assert_eq!(outlines(&ends), [[[-1000, 1000], [-1000, -1000], [13_000, -1000], [13_000, 1000]]]);
    }

    #[test]
    fn an_odd_width_is_the_same_on_all_legs() {
        let outline = outlines(&path(&[[0, 0], [1000, 0], [1000, 1000]], 101, PathEnd::Flush));
        assert_eq!(outline, [[[0, 51], [0, -51], [1051, -51], [1051, 1000], [949, 1000], [949, 51]]]);
    }

    /// Areas of KLayout 0.30.12, merged.
    #[test]
    fn sharp_turns_have_the_area_that_klayout_draws() {
        let cases: [(&[[i32; 2]], f64); 6] = [
            (&[[0, 0], [1000, 0], [0, 100]], 155_637.0),
            (&[[0, 0], [1000, 0], [300, 700]], 196_250.0),
            (&[[0, 0], [1000, 0], [0, 0]], 105_000.0),
            (&[[0, 0], [1000, 0], [200, 0]], 105_000.0),
            (&[[0, 0], [1000, 0], [1000, 50], [0, 50]], 157_500.0),
            (&[[0, 0], [1000, 1000], [1000, 0], [0, 1000]], 366_700.0),
        ];
        for (points, expected) in cases {
            let drawn = area(&outlines(&path(points, 100, PathEnd::Flush)));
            // Both round corners to the grid: by half a step along an outline of less than 10,000 steps.
            assert!((drawn - expected).abs() < 2000.0, "{points:?}: {drawn} instead of {expected}");
        }
    }

    #[test]
    fn a_path_of_one_point_is_a_disc_or_a_square() {
        for points in [&[[500, 500]][..], &[[500, 500], [500, 500]]] {
            assert_eq!(area(&outlines(&path(points, 100, PathEnd::Square))), 10_000.0);
            let disc = area(&outlines(&path(points, 100, PathEnd::Round)));
            assert!((disc - std::f64::consts::PI * 2500.0).abs() < 80.0, "{disc}");
            assert_eq!(area(&outlines(&path(points, 100, PathEnd::Flush))), 0.0);
        }
    }

    #[test]
    fn paths_without_width_or_points_cover_nothing() {
        assert!(outlines(&path(&[[0, 0], [1000, 0]], 0, PathEnd::Round)).is_empty());
        assert!(outlines(&path(&[], 1000, PathEnd::Square)).is_empty());
    }

    #[test]
    fn round_ends_have_a_bounded_number_of_corners() {
        let large = path(&[[0, 0], [1000, 0]], 2_147_483_646, PathEnd::Round);
        assert!(outlines(&large).iter().map(Vec::len).sum::<usize>() <= 2 * (MOST_CHORDS + 1) + 8);
    }
}
