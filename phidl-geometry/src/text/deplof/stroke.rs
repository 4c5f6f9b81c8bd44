//! From center lines to outlines: how the strokes of [`super`] get their width.
//!
//! A stroke glyph is a set of *trees* of center lines. An outline is found by walking once around a tree, half a stroke
//! to the left of it: every edge is passed twice, every branch turned into, every end turned round. A tree has no
//! circle, so its outline encloses no counter, and the width of a stroke is right by construction.
//!
//! Drawing outlines point by point was the alternative; a table of outlines says nothing about widths or islands.
//! Uniting rectangles was another; it needs a boolean engine to draw a letter.

use phidl_core::geom::Point;

use super::{NOTCH, STROKE};

/// Corners of center lines, in units.
pub(super) type Line = [(i16, i16)];

/// Half the width of a stroke.
const HALF: f64 = STROKE / 2.0;
/// Angles closer than this (degrees) to a straight line or a right angle count as such.
const SAME: f64 = 1e-9;

/// The outline of a tree of center lines, clockwise, on whole units.
///
/// A line may begin or end on another line: that is a branch.
pub(super) fn outline(lines: &[&Line]) -> Vec<Point> {
    let tree = Tree::new(lines);
    let start = (0, tree.next[0][0]);
    let mut points = Vec::new();
    let (mut from, mut to) = start;
    loop {
        let next = tree.turn(from, to);
        corner(tree.nodes[from], tree.nodes[to], tree.nodes[next], &mut points);
        (from, to) = (to, next);
        if (from, to) == start {
            return without_straight(points.into_iter().map(|p| Point::new(p.x.round(), p.y.round())).collect());
        }
    }
}

/// The outline without points that are no corners: where a stroke ends flush with the side of another one.
fn without_straight(mut points: Vec<Point>) -> Vec<Point> {
    points.dedup();
    if points.first() == points.last() {
        points.pop();
    }
    let at = |i: usize| points[i % points.len()];
    let is_corner = |i: &usize| (at(*i) - at(i + points.len() - 1)).cross(at(i + 1) - at(*i)) != 0.0;
    (0..points.len()).filter(is_corner).map(at).collect()
}

/// Center lines as nodes and what each is joined to.
struct Tree {
    nodes: Vec<Point>,
    next: Vec<Vec<usize>>,
}

impl Tree {
    fn new(lines: &[&Line]) -> Self {
        let mut tree = Self { nodes: Vec::new(), next: Vec::new() };
        for point in lines.iter().copied().flatten() {
            tree.node(Point::from(*point));
        }
        for pair in lines.iter().flat_map(|line| line.windows(2)) {
            tree.join(Point::from(pair[0]), Point::from(pair[1]));
        }
        tree
    }

    fn node(&mut self, point: Point) -> usize {
        if let Some(known) = self.nodes.iter().position(|p| *p == point) {
            return known;
        }
        self.nodes.push(point);
        self.next.push(Vec::new());
        self.nodes.len() - 1
    }

    /// Joins two points through all nodes between them.
    fn join(&mut self, a: Point, b: Point) {
        let between = |p: &Point| (*p - a).cross(b - a) == 0.0 && (*p - a).dot(*p - b) <= 0.0;
        let mut stops: Vec<usize> = (0..self.nodes.len()).filter(|i| between(&self.nodes[*i])).collect();
        stops.sort_by(|i, j| a.distance(self.nodes[*i]).total_cmp(&a.distance(self.nodes[*j])));
        for pair in stops.windows(2) {
            self.next[pair[0]].push(pair[1]);
            self.next[pair[1]].push(pair[0]);
        }
    }

    /// Where the walk goes on after it came `from` one node `to` another: the first edge clockwise from the one it came
    /// by, which is that one itself at an end.
    fn turn(&self, from: usize, to: usize) -> usize {
        let sector = |next: &usize| sector(self.nodes[from] - self.nodes[to], self.nodes[*next] - self.nodes[to]);
        let first = self.next[to].iter().copied().min_by(|a, b| sector(a).total_cmp(&sector(b)));
        first.expect("invariant: a node was come to by an edge")
    }
}

/// Clockwise angle from one direction to another, in `(0, 360]` degrees.
fn sector(from: Point, to: Point) -> f64 {
    let angle = to.cross(from).atan2(to.dot(from)).to_degrees();
    if angle > SAME { angle } else { angle + 360.0 }
}

/// What the walk draws at a node.
fn corner(from: Point, at: Point, to: Point, points: &mut Vec<Point>) {
    let (incoming, outgoing) = (Side::left_of(from, at), Side::left_of(at, to));
    let angle = sector(from - at, to - at);
    if (angle - 180.0).abs() < SAME {
        return;
    }
    if angle > 360.0 - SAME {
        let cut = end_cut(at, incoming.along);
        points.extend([incoming.meet(&cut), outgoing.meet(&cut)]);
    } else if angle > 270.0 + SAME {
        let cut = tip_cut(at, incoming.along - outgoing.along);
        points.extend([incoming.meet(&cut), outgoing.meet(&cut)]);
    } else if angle < 90.0 - SAME {
        let depth = NOTCH / (2.0 * (angle / 2.0).to_radians().sin());
        let tip = incoming.meet(&outgoing);
        points.extend([tip - incoming.along * depth, tip + outgoing.along * depth]);
    } else {
        points.push(incoming.meet(&outgoing));
    }
}

/// A straight line: a point and a unit direction.
struct Side {
    through: Point,
    along: Point,
}

impl Side {
    fn left_of(from: Point, to: Point) -> Self {
        let along = (to - from) / (to - from).norm();
        Self { through: to + Point::new(-along.y, along.x) * HALF, along }
    }

    /// Where it meets another line that is not parallel to it.
    fn meet(&self, other: &Self) -> Point {
        self.through + self.along * ((other.through - self.through).cross(other.along) / self.along.cross(other.along))
    }
}

/// The line that ends a stroke: across upright, level and diagonal ones; level or upright through the end of a slanted
/// one, whichever cuts it shorter.
fn end_cut(end: Point, along: Point) -> Side {
    let (x, y) = (along.x.abs(), along.y.abs());
    let across = Point::new(-along.y, along.x);
    let slanted = x > SAME && y > SAME && (x - y).abs() > SAME;
    let along = match slanted {
        false => across,
        true if y > x => Point::new(1.0, 0.0),
        true => Point::new(0.0, 1.0),
    };
    Side { through: end, along }
}

/// The line that blunts an acute corner: level or upright, half a stroke outside the node.
fn tip_cut(node: Point, outward: Point) -> Side {
    if outward.x.abs() > outward.y.abs() {
        Side { through: node + Point::new(HALF * outward.x.signum(), 0.0), along: Point::new(0.0, 1.0) }
    } else {
        Side { through: node + Point::new(0.0, HALF * outward.y.signum()), along: Point::new(1.0, 0.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(outline: &[Point]) -> Vec<(f64, f64)> {
        outline.iter().map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn a_stroke_is_a_bar_as_wide_as_the_pen() {
        let bar = outline(&[&[(100, 0), (100, 1000)]]);
        assert_eq!(corners(&bar), [(0.0, 1000.0), (200.0, 1000.0), (200.0, 0.0), (0.0, 0.0)]);
    }

    #[test]
    fn a_branch_adds_a_bar_and_leaves_no_seam() {
        let t = outline(&[&[(0, 900), (600, 900)], &[(300, 900), (300, 0)]]);
        assert_eq!(t.len(), 8);
        assert_eq!(-phidl_core::geom::signed_area(&t), 600.0 * 200.0 + 800.0 * 200.0);
    }

    #[test]
    fn a_stroke_that_ends_in_the_side_of_another_makes_no_corner_there() {
        let l = outline(&[&[(100, 500), (100, 0)], &[(100, 100), (500, 100)]]);
        let expected = [(0.0, 500.0), (200.0, 500.0), (200.0, 200.0), (500.0, 200.0), (500.0, 0.0), (0.0, 0.0)];
        assert!(expected.iter().all(|corner| corners(&l).contains(corner)) && l.len() == 6, "{l:?}");
    }

    #[test]
    fn slanted_strokes_keep_their_width_and_end_level() {
        let slash = outline(&[&[(0, 0), (300, 1200)]]);
        assert!(slash.iter().all(|p| p.y == 0.0 || p.y == 1200.0));
        let (length, area) = (300_f64.hypot(1200.0), -phidl_core::geom::signed_area(&slash));
        assert!((area / length - STROKE).abs() < 1.0, "{area}");
    }

    #[test]
    fn acute_corners_are_cut_outside_and_filled_inside() {
        let v = outline(&[&[(0, 1000), (200, 0), (400, 1000)]]);
        assert_eq!(v.iter().map(|p| p.y).fold(f64::INFINITY, f64::min), -HALF);
        let notch: Vec<&Point> = v.iter().filter(|p| p.y > 0.0 && p.y < 1000.0).collect();
        assert_eq!((notch.len(), notch[0].distance(*notch[1])), (2, NOTCH));
    }
}
