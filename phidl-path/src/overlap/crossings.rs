//! Where the outline of a band crosses itself.
//!
//! Steps of the path are the leaves of a tree of boxes, and two steps are compared only where their boxes meet: about
//! n log n for n steps, whatever the shape. Comparisons are exact, on points rounded to a picometer.
//!
//! A touch is no crossing. To tell them apart, the outline is drawn a little narrower and shorter: edges that touch from
//! outside then separate, and edges that lie on one another inside the band cross the faces. (Comparing winding numbers on
//! both sides of each edge would do without this, and would need all crossings first.)

use phidl_core::geom::Point;

use crate::Side;
use crate::band::Band;

/// How much narrower and shorter the outline is (µm).
const INSET: f64 = 4e-6;
/// How much narrower it is at least, as a part of an edge's distance: edges that end in a point run backwards by less.
const PART: f64 = 1.5e-4;
/// Points are rounded to this (µm), or to a larger power of two far away from the origin.
const GRID: f64 = 1e-6;
/// More crossings than this are not needed.
const MOST: usize = 4096;

/// The pairs of steps (from a sample to the next one) at which the outline crosses itself.
pub(super) fn of_band(band: &Band<'_>) -> Vec<(usize, usize)> {
    let [right, left] = [Side::Right, Side::Left].map(|side| inset_edge(band, side));
    let scale = right.iter().chain(&left).flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max);
    let grid = GRID.max(scale * 2_f64.powi(-60));
    let [right, left] = [right, left].map(|edge| edge.into_iter().map(|p| Node::of(p, grid)).collect::<Vec<_>>());
    let steps: Vec<Step> = (0..right.len() - 1).map(|i| Step::of(&right, &left, i)).collect();
    let tree = Tree::over(&steps);
    let mut found = Vec::new();
    tree.pairs(|a, b| {
        let crosses = if a == b { steps[a].crosses_itself() } else { steps[a].crosses(&steps[b]) };
        if crosses && found.len() < MOST {
            found.push((a, b));
        }
    });
    found
}

/// An edge that is drawn narrower by the inset, and shorter at both faces.
fn inset_edge(band: &Band<'_>, side: Side) -> Vec<Point> {
    let last = band.normals.len() - 1;
    let (points, vectors) = (&band.normals.points, &band.normals.vectors);
    let at = |i: usize| {
        let (own, other) = (band.distance(side, i), band.distance(side.opposite(), i));
        let inset = INSET.max(PART * own.abs().max(other.abs())).min(band.width(i) / 4.0);
        points[i] + vectors[i] * (own - side.sign() * inset)
    };
    let mut edge: Vec<Point> = (0..=last).map(at).collect();
    // Different insets, so that the two faces of a ring do not fall together.
    let (start, end) = (points[1] - points[0], points[last - 1] - points[last]);
    for (index, along, inset) in [(0, start, INSET), (last, end, 2.0 * INSET)] {
        let length = along.norm();
        if length > 0.0 {
            edge[index] += along / length * inset.min(length / 4.0);
        }
    }
    edge
}

/// A rounded point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Node {
    x: i64,
    y: i64,
}

impl Node {
    #[expect(clippy::cast_possible_truncation, reason = "the grid is chosen so that 60 bits suffice")]
    fn of(p: Point, grid: f64) -> Self {
        Self { x: (p.x / grid).round() as i64, y: (p.y / grid).round() as i64 }
    }

    /// On which side of the line from `a` to `b` the point lies: positive on the left.
    fn side_of(self, a: Self, b: Self) -> i128 {
        let difference = |to: i64, from: i64| i128::from(to) - i128::from(from);
        difference(b.x, a.x) * difference(self.y, a.y) - difference(b.y, a.y) * difference(self.x, a.x)
    }
}

/// The edges of an outline along one step of the path, in the direction of the outline: right, left, and the faces.
#[derive(Debug)]
struct Step {
    edges: Vec<[Node; 2]>,
    bounds: Bounds,
}

impl Step {
    fn of(right: &[Node], left: &[Node], i: usize) -> Self {
        let mut edges = vec![[right[i], right[i + 1]], [left[i + 1], left[i]]];
        if i == 0 {
            edges.push([left[0], right[0]]);
        }
        if i + 2 == right.len() {
            edges.push([right[i + 1], left[i + 1]]);
        }
        let bounds = Bounds::around(edges.iter().flatten());
        Self { edges, bounds }
    }

    fn crosses_itself(&self) -> bool {
        self.edges.iter().enumerate().any(|(i, a)| self.edges[i + 1..].iter().any(|b| crosses(*a, *b)))
    }

    fn crosses(&self, other: &Self) -> bool {
        self.edges.iter().any(|a| other.edges.iter().any(|b| crosses(*a, *b)))
    }
}

/// Whether two edges of an outline cross, or lie on one another in the same direction: the area between is covered twice
/// then, or the outline goes around it the wrong way.
fn crosses([a, b]: [Node; 2], [c, d]: [Node; 2]) -> bool {
    let (c_side, d_side) = (c.side_of(a, b), d.side_of(a, b));
    if c_side == 0 && d_side == 0 {
        return run_together([a, b], [c, d]);
    }
    if a == c || a == d || b == c || b == d {
        return false;
    }
    let (a_side, b_side) = (a.side_of(c, d), b.side_of(c, d));
    (c_side > 0) != (d_side > 0) && (a_side > 0) != (b_side > 0)
}

/// Whether two edges on one line share a stretch and have the same direction.
fn run_together([a, b]: [Node; 2], [c, d]: [Node; 2]) -> bool {
    let along = |from: Node, to: Node| (i128::from(to.x) - i128::from(from.x), i128::from(to.y) - i128::from(from.y));
    let dot = |p: (i128, i128), q: (i128, i128)| p.0 * q.0 + p.1 * q.1;
    let (own, other) = (along(a, b), along(c, d));
    let whole = dot(own, own);
    let (from, to) = (dot(along(a, c), own), dot(along(a, d), own));
    dot(own, other) > 0 && from.max(0) < to.min(whole)
}

/// A box of rounded points.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    min: Node,
    max: Node,
}

impl Bounds {
    fn around<'n>(nodes: impl Iterator<Item = &'n Node>) -> Self {
        let none = Self { min: Node { x: i64::MAX, y: i64::MAX }, max: Node { x: i64::MIN, y: i64::MIN } };
        nodes.fold(none, |bounds, node| bounds.joined(Self { min: *node, max: *node }))
    }

    fn joined(self, other: Self) -> Self {
        Self {
            min: Node { x: self.min.x.min(other.min.x), y: self.min.y.min(other.min.y) },
            max: Node { x: self.max.x.max(other.max.x), y: self.max.y.max(other.max.y) },
        }
    }

    fn meets(self, other: Self) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }
}

/// Boxes around runs of steps: level by level, each box around two of the level below.
struct Tree {
    levels: Vec<Vec<Bounds>>,
}

impl Tree {
    fn over(steps: &[Step]) -> Self {
        let mut levels = vec![steps.iter().map(|step| step.bounds).collect::<Vec<_>>()];
        while levels[levels.len() - 1].len() > 1 {
            let below = &levels[levels.len() - 1];
            let joined = below.chunks(2).map(|pair| pair.iter().copied().reduce(Bounds::joined));
            levels.push(joined.flatten().collect());
        }
        Self { levels }
    }

    /// All pairs of steps, each with the later one second, whose boxes meet; a step and itself included.
    fn pairs(&self, mut found: impl FnMut(usize, usize)) {
        let mut stack = vec![(self.levels.len() - 1, 0, 0)];
        while let Some((level, a, b)) = stack.pop() {
            let boxes = &self.levels[level];
            if !boxes[a].meets(boxes[b]) {
                continue;
            }
            let Some(below) = level.checked_sub(1) else {
                found(a, b);
                continue;
            };
            let children = |node: usize| (2 * node..2 * node + 2).filter(|child| *child < self.levels[below].len());
            for own in children(a) {
                stack.extend(children(b).filter(|other| own <= *other).map(|other| (below, own, other)));
            }
        }
    }
}

/// The distance of two straight segments (µm), and the fractions of both at which they are that close.
pub(super) fn segment_distance(a: [Point; 2], b: [Point; 2]) -> (f64, [f64; 2]) {
    let side = |[from, to]: [Point; 2], p: Point| (to - from).cross(p - from);
    let ([a0, a1], [b0, b1]) = ([side(b, a[0]), side(b, a[1])], [side(a, b[0]), side(a, b[1])]);
    if a0 * a1 < 0.0 && b0 * b1 < 0.0 {
        return (0.0, [a0 / (a0 - a1), b0 / (b0 - b1)]);
    }
    let nearest = |p: Point, [from, to]: [Point; 2]| {
        let along = to - from;
        let square = along.dot(along);
        let part = if square > 0.0 { ((p - from).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (p.distance(from + along * part), part)
    };
    let from_a =
        a.into_iter().zip([0.0, 1.0]).map(|(p, end)| (nearest(p, b), end)).map(|((d, at), end)| (d, [end, at]));
    let from_b =
        b.into_iter().zip([0.0, 1.0]).map(|(p, end)| (nearest(p, a), end)).map(|((d, at), end)| (d, [at, end]));
    from_a.chain(from_b).fold((f64::INFINITY, [0.0; 2]), |best, own| if own.0 < best.0 { own } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_cross_at_inner_points_and_lie_on_one_another_in_one_direction() {
        let node = |(x, y): (i64, i64)| Node { x, y };
        let cross = |a: [(i64, i64); 2], b: [(i64, i64); 2]| crosses(a.map(node), b.map(node));
        assert!(cross([(0, 0), (4, 4)], [(0, 4), (4, 0)]));
        assert!(!cross([(0, 0), (4, 4)], [(0, 4), (1, 3)]) && !cross([(0, 0), (4, 0)], [(4, 0), (9, 9)]));
        assert!(cross([(0, 0), (4, 0)], [(3, 0), (9, 0)]), "the same direction");
        assert!(!cross([(0, 0), (4, 0)], [(9, 0), (3, 0)]), "opposite directions only touch");
        assert!(!cross([(0, 0), (4, 0)], [(4, 0), (9, 0)]), "one after the other");
    }

    #[test]
    fn segments_have_the_distance_of_their_nearest_points() {
        let distance =
            |a: [(f64, f64); 2], b: [(f64, f64); 2]| segment_distance(a.map(Point::from), b.map(Point::from));
        assert_eq!(distance([(0., 0.), (4., 0.)], [(1., -1.), (1., 1.)]), (0.0, [0.25, 0.5]));
        assert_eq!(distance([(0., 0.), (4., 0.)], [(7., 4.), (9., 9.)]), (5.0, [1.0, 0.0]));
        assert_eq!(distance([(0., 0.), (4., 0.)], [(1., 3.), (2., 4.)]), (3.0, [0.25, 0.0]));
    }
}
