//! Snap rounding in one strip: through which grid points does each edge go?
//!
//! See [`super`] for the idea. The exact test whether an edge passes the half-open square of a grid point is cheap:
//! with `d` twice the area between the edge and the point, the line of an edge `(dx, dy)` passes the inside of the
//! square if `2 |d| < |dx| + |dy|`, and touches its one included corner if `dy < 0` and `2 d = |dx| + |dy|`.

use super::{
    bands::Bands,
    edge::{Edge, Scene},
    plan::StripPlan,
};
use crate::point::{GridPoint, cross};

/// Crossings closer than this to a border between grid squares are rounded in integers.
const FLOAT_MARGIN: f64 = 1e-4;

/// Offsets up to this size keep an absolute error far below [`FLOAT_MARGIN`] in an `f64`.
const FLOAT_RANGE: f64 = (1u64 << 32) as f64;

/// A grid point through which an edge is bent.
#[derive(Debug, Clone, Copy)]
struct Bend {
    /// The place of the edge among those that the strip sees.
    edge: u32,
    at: GridPoint,
}

/// What one strip found.
pub(super) struct Snapped {
    pub(super) bends: Bends,
    /// The edges that reach into later strips, by their places among those that the strip sees.
    pub(super) leaving: Vec<u32>,
    /// Drawn contours that touch or cross themselves.
    pub(super) touching: Vec<u32>,
}

/// Finds the bends of all edges inside one strip.
pub(super) fn snap_strip(scene: &Scene, plan: &StripPlan, strip: usize) -> Snapped {
    let seen = plan.seen(strip);
    let mut reader = scene.reader();
    let edges: Vec<Edge> = seen.iter().map(|&number| reader.edge(number)).collect();
    let columns = plan.columns(strip);
    let mut snapper =
        Snapper { scene, seen, edges: &edges, columns, bends: Vec::new(), crossings: Vec::new(), touching: Vec::new() };
    let bands = Bands::new(&edges, columns);
    bands.for_each_pair(|a, b| snapper.meet(a, b));
    let crossings = std::mem::take(&mut snapper.crossings);
    bands.for_each_point(&crossings, |edge, point| snapper.pass(edge, point));
    snapper.finish()
}

struct Snapper<'a> {
    scene: &'a Scene,
    seen: &'a [u32],
    edges: &'a [Edge],
    columns: (i64, i64),
    bends: Vec<Bend>,
    /// Hot squares that are not vertices.
    crossings: Vec<GridPoint>,
    touching: Vec<u32>,
}

impl Snapper<'_> {
    /// Two edges whose boxes overlap: where do they meet, and which ends lie in squares that the other passes?
    fn meet(&mut self, a: u32, b: u32) {
        let (e, f) = (self.edges[a as usize], self.edges[b as usize]);
        let (f_l, f_r) = (e.cross(f.l), e.cross(f.r));
        let reach_e = reach(&e);
        if (f_l > reach_e && f_r > reach_e) || (f_l < -reach_e && f_r < -reach_e) {
            // No square of `e` is near, but a vertex of `e` may still be near `f`.
            return self.pass_ends(b, &f, &e);
        }
        let (e_l, e_r) = (f.cross(e.l), f.cross(e.r));
        self.pass_vertex(a, &e, f.l, f_l);
        self.pass_vertex(a, &e, f.r, f_r);
        self.pass_vertex(b, &f, e.l, e_l);
        self.pass_vertex(b, &f, e.r, e_r);
        let is_crossing = opposite(f_l, f_r) && opposite(e_l, e_r);
        if is_crossing {
            self.cross(a, b, crossing(&e, &f));
        }
        let touches = is_crossing
            || (f_l == 0 && in_box(&e, f.l))
            || (f_r == 0 && in_box(&e, f.r))
            || (e_l == 0 && in_box(&f, e.l))
            || (e_r == 0 && in_box(&f, e.r));
        if touches {
            self.note_self_touch(a, b);
        }
    }

    fn pass_ends(&mut self, edge: u32, e: &Edge, other: &Edge) {
        for p in [other.l, other.r] {
            if in_box(e, p) {
                self.pass_vertex(edge, e, p, e.cross(p));
            }
        }
    }

    /// A bend of `edge` at `p` if it passes the square of `p`; `d` is `edge.cross(p)`.
    #[inline]
    fn pass_vertex(&mut self, edge: u32, e: &Edge, p: GridPoint, d: i128) {
        // Few points are as near as this, so the box is looked at last.
        if passes(e, d) && in_box(e, p) {
            self.bend(edge, e, p);
        }
    }

    fn pass(&mut self, edge: u32, p: GridPoint) {
        let e = self.edges[edge as usize];
        self.pass_vertex(edge, &e, p, e.cross(p));
    }

    fn cross(&mut self, a: u32, b: u32, p: GridPoint) {
        if p.x < self.columns.0 || p.x > self.columns.1 {
            return;
        }
        let (e, f) = (self.edges[a as usize], self.edges[b as usize]);
        let is_vertex = [e.l, e.r, f.l, f.r].contains(&p);
        if !is_vertex {
            self.crossings.push(p);
        }
        self.bend(a, &e, p);
        self.bend(b, &f, p);
    }

    fn bend(&mut self, edge: u32, e: &Edge, at: GridPoint) {
        if at != e.l && at != e.r && at.x >= self.columns.0 && at.x <= self.columns.1 {
            self.bends.push(Bend { edge, at });
        }
    }

    /// Neighbors along a contour share a vertex, all other edges of a drawn contour should not meet.
    fn note_self_touch(&mut self, a: u32, b: u32) {
        let (a, b) = (self.seen[a as usize], self.seen[b as usize]);
        let contour = self.scene.contour_of(a);
        // Whether edges are neighbors is asked over repeated points, so not again of a contour that is known to touch itself.
        if contour == self.scene.contour_of(b)
            && self.touching.last() != Some(&contour)
            && self.scene.is_drawn(contour)
            && !self.scene.are_neighbors(a.min(b), a.max(b))
        {
            self.touching.push(contour);
        }
    }

    fn finish(mut self) -> Snapped {
        self.touching.sort_unstable();
        self.touching.dedup();
        let leaving =
            (0u32..).zip(self.edges).filter(|(_, e)| e.r.x > self.columns.1).map(|(place, _)| place).collect();
        Snapped { bends: Bends::new(self.edges, &self.bends), leaving, touching: self.touching }
    }
}

/// The bends of all edges that a strip sees, in the order in which each edge passes them; some repeat.
pub(super) struct Bends {
    points: Vec<GridPoint>,
    /// Edge `e` of the strip has `points[starts[e]..starts[e + 1]]`.
    starts: Vec<u32>,
}

impl Bends {
    fn new(edges: &[Edge], bends: &[Bend]) -> Self {
        let mut starts = vec![0; edges.len() + 1];
        for bend in bends {
            starts[bend.edge as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut points = vec![GridPoint::default(); bends.len()];
        for bend in bends {
            starts[bend.edge as usize] -= 1;
            points[starts[bend.edge as usize] as usize] = bend.at;
        }
        for (e, range) in edges.iter().zip(starts.windows(2)) {
            put_along(e, &mut points[range[0] as usize..range[1] as usize]);
        }
        Self { points, starts }
    }

    /// The bends of an edge, by its place among those that the strip sees.
    #[inline]
    pub(super) fn of(&self, edge: usize) -> &[GridPoint] {
        &self.points[self.starts[edge] as usize..self.starts[edge + 1] as usize]
    }
}

fn put_along(e: &Edge, bends: &mut [GridPoint]) {
    if e.r.y >= e.l.y {
        bends.sort_unstable();
    } else {
        bends.sort_unstable_by_key(|at| (at.x, -at.y));
    }
}

#[inline]
pub(super) fn in_box(e: &Edge, p: GridPoint) -> bool {
    p.x >= e.l.x && p.x <= e.r.x && p.y >= e.l.y.min(e.r.y) && p.y <= e.l.y.max(e.r.y)
}

#[inline]
fn reach(e: &Edge) -> i128 {
    i128::from((e.r.x - e.l.x) + (e.r.y - e.l.y).abs())
}

/// Whether the edge passes the half-open square of a point in its box; `d` is `e.cross(point)`.
#[inline]
pub(super) fn passes(e: &Edge, d: i128) -> bool {
    let (twice, reach) = (2 * d, reach(e));
    twice.abs() < reach || (twice == reach && e.r.y < e.l.y)
}

#[inline]
pub(super) fn opposite(a: i128, b: i128) -> bool {
    (a > 0 && b < 0) || (a < 0 && b > 0)
}

/// The grid point whose half-open square holds the crossing of two edges that properly cross.
fn crossing(e: &Edge, f: &Edge) -> GridPoint {
    let (f_dx, f_dy) = (f.r.x - f.l.x, f.r.y - f.l.y);
    let (dx, dy) = (e.r.x - e.l.x, e.r.y - e.l.y);
    let mut part = cross(f.l, f.r, e.l);
    let mut whole = i128::from(dy) * i128::from(f_dx) - i128::from(dx) * i128::from(f_dy);
    part = -part;
    if whole < 0 {
        (part, whole) = (-part, -whole);
    }
    GridPoint::new(e.l.x + scale(dx, part, whole), e.l.y + scale(dy, part, whole))
}

/// `length · part / whole` to the nearest integer, halves up; `whole` is positive.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "the fast path checks its range and margin; the exact quotient is at most `length`"
)]
fn scale(length: i64, part: i128, whole: i128) -> i64 {
    let estimate = length as f64 * (part as f64 / whole as f64) + 0.5;
    let floor = estimate.floor();
    let fraction = estimate - floor;
    if estimate.abs() < FLOAT_RANGE && fraction > FLOAT_MARGIN && fraction < 1.0 - FLOAT_MARGIN {
        return floor as i64;
    }
    let exact = (2 * part * i128::from(length) + whole).div_euclid(2 * whole);
    exact as i64
}
