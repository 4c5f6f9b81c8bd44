//! PATH elements to outlines.
//!
//! Cells hold outlines and no paths, so a path gets the outline that readers draw: both edges half the width from the
//! centerline, mitered at turns up to 90°; at sharper turns each edge runs on by half the width and the two ends are
//! joined. Round ends are regular polygons that stay within half a grid step of the circle.

use phidl_core::geom::Point;
use phidl_core::num::{angle, count};

/// A path as the file has it; lengths in µm.
pub(super) struct Centerline {
    pub(super) points: Vec<Point>,
    pub(super) width: f64,
    pub(super) begin: End,
    pub(super) end: End,
}

/// How a path ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    /// A half circle, approximated within a tolerance (µm).
    Round {
        /// Largest distance of a chord from the circle.
        tolerance: f64,
    },
    /// Straight, this much beyond the last point.
    Extended(f64),
}

impl Centerline {
    /// The outline; `None` if the path has no width or no length, and covers nothing.
    ///
    /// It begins at the left and right edge of the first point, as seen along the path, goes along the right edge to the
    /// end, and comes back along the left edge.
    pub(super) fn outline(mut self) -> Option<Vec<Point>> {
        self.points.dedup();
        if self.points.len() < 2 || self.width == 0.0 {
            return None;
        }
        let half = self.width / 2.0;
        let (first, last) = (self.points.first_chunk::<2>()?, self.points.last_chunk::<2>()?);
        let begin = end_points(first[0], first[1] - first[0], -half, self.begin);
        let end = end_points(last[1], last[1] - last[0], half, self.end);
        let mut outline = begin;
        outline.extend(self.edge(-half));
        outline.extend(end);
        let mut back: Vec<Point> = self.edge(half).collect();
        back.reverse();
        outline.extend(back);
        Some(outline)
    }

    /// The inner corners of the edge at a distance to the left of the centerline.
    fn edge(&self, left: f64) -> impl Iterator<Item = Point> + '_ {
        self.points.windows(3).flat_map(move |p| corner(p[1], unit(p[1] - p[0]), unit(p[2] - p[1]), left))
    }
}

/// The points across an end. `side` is half the width: negative for the beginning, which goes from left to right,
/// positive for the end, which goes from right to left.
fn end_points(at: Point, along: Point, side: f64, end: End) -> Vec<Point> {
    let along = unit(along);
    let outward = along * side.signum();
    // From here a half turn counter-clockwise about the end point leads to the other edge.
    let start = normal(along) * -side;
    match end {
        End::Extended(by) => {
            let tip = at + outward * by;
            vec![tip + start, tip - start]
        }
        End::Round { tolerance } => {
            let radius = side.abs();
            let chords = count::for_tolerance(radius, 180.0, tolerance);
            let from = start.direction();
            let turns = (0..=chords).map(|i| from + 180.0 * i as f64 / chords as f64);
            turns.map(|turn| at + Point::polar(radius, turn)).collect()
        }
    }
}

/// One corner of an edge: a miter, or two points where the turn is sharp.
fn corner(at: Point, before: Point, after: Point, left: f64) -> Vec<Point> {
    let (a, b) = (at + normal(before) * left, at + normal(after) * left);
    let cos = before.dot(after);
    if cos >= -1e-12 {
        // The bisector of the two normals, as long as it takes to reach both edges.
        return vec![at + (normal(before) + normal(after)) * (left / (1.0 + cos))];
    }
    let on = left.abs();
    vec![a + before * on, b - after * on]
}

fn unit(v: Point) -> Point {
    match angle::quarter_turns(v.direction()) {
        // Exact along the axes, where most paths run.
        Some(_) => Point::polar(1.0, v.direction()),
        None => v / v.norm(),
    }
}

/// A quarter turn to the left.
fn normal(v: Point) -> Point {
    Point::new(-v.y, v.x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::signed_area;

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|p| Point::from(*p)).collect()
    }

    fn path(list: &[(f64, f64)], end: End) -> Vec<Point> {
        Centerline { points: points(list), width: 0.5, begin: end, end }.outline().unwrap()
    }

    /// Measured with the reference library (`spec/geometry-basic.md` §4.6).
    #[test]
    fn a_bent_path_has_the_outline_of_the_reference() {
        let outline = path(&[(0., 0.), (10., 0.), (10., 5.)], End::Extended(0.0));
        let expected = [(0., 0.25), (0., -0.25), (10.25, -0.25), (10.25, 5.), (9.75, 5.), (9.75, 0.25)];
        assert_eq!(outline, points(&expected));
    }

    #[test]
    fn ends_are_flush_extended_or_round() {
        let line = [(0., 0.), (10., 0.)];
        let area = |end| signed_area(&path(&line, end));
        assert_eq!(area(End::Extended(0.0)), 5.0);
        assert_eq!(area(End::Extended(0.25)), 5.25);
        let circle = std::f64::consts::PI * 0.25 * 0.25;
        let round = area(End::Round { tolerance: 1e-6 });
        assert!((round - 5.0 - circle).abs() < 1e-5, "{round}");
        let ends = Centerline { points: points(&line), width: 2.0, begin: End::Extended(1.0), end: End::Extended(3.0) };
        assert_eq!(ends.outline().unwrap(), points(&[(-1., 1.), (-1., -1.), (13., -1.), (13., 1.)]));
    }

    #[test]
    fn sharp_turns_end_half_a_width_beyond_their_corner() {
        let outline = path(&[(0., 0.), (10., 0.), (0., 1.)], End::Extended(0.0));
        let furthest = outline.iter().map(|p| p.x).fold(f64::MIN, f64::max);
        assert!((10.25..10.3).contains(&furthest), "{furthest}");
        let back = path(&[(0., 0.), (10., 0.), (0., 0.)], End::Extended(0.0));
        assert!(back.iter().all(|p| p.is_finite() && p.x <= 10.25));
    }

    #[test]
    fn paths_without_width_or_length_cover_nothing() {
        let outline = |list: &[(f64, f64)], width| {
            let end = End::Extended(0.0);
            Centerline { points: points(list), width, begin: end, end }.outline()
        };
        assert_eq!(outline(&[(0., 0.), (1., 0.)], 0.0), None);
        assert_eq!(outline(&[(1., 1.), (1., 1.)], 1.0), None);
        assert_eq!(outline(&[], 1.0), None);
    }
}
