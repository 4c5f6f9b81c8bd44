//! Snap rounding in one strip: through which grid points does each edge go?
//!
//! See [`super`] for the idea. The exact test whether an edge passes the half-open square of a grid point is cheap:
//! with `d` twice the area between the edge and the point, the line of an edge `(dx, dy)` passes the inside of the
//! square if `2 |d| < |dx| + |dy|`, and touches its one included corner if `dy < 0` and `2 d = |dx| + |dy|`.

use std::cmp::Ordering;

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
pub(super) struct Bend {
    pub(super) edge: u32,
    pub(super) at: GridPoint,
}

/// What one strip found.
#[derive(Default)]
pub(super) struct Snapped {
    /// The edges that lie wholly in this strip, bent and cut into straight pieces.
    pub(super) pieces: Vec<Edge>,
    /// Bends of the edges that reach into other strips, by edge and then along it.
    pub(super) bends: Vec<Bend>,
    /// Like `pieces`, but of the contours that are filled apart; with the number of the contour.
    pub(super) apart: Vec<(u32, Edge)>,
    /// Drawn contours that touch or cross themselves.
    touching: Vec<u32>,
}

/// All self-touching contours, ascending.
pub(super) fn self_touching(strips: &mut [Snapped]) -> Vec<u32> {
    let mut all: Vec<u32> = strips.iter_mut().flat_map(|strip| std::mem::take(&mut strip.touching)).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Finds the bends of all edges inside one strip. The pieces of the contours `apart` (ascending) are kept apart.
pub(super) fn snap_strip(scene: &Scene, plan: &StripPlan, strip: usize, apart: &[u32]) -> Snapped {
    let seen = plan.seen(strip);
    let edges: Vec<Edge> = seen.iter().map(|&number| scene.edges[number as usize]).collect();
    let columns = plan.columns(strip);
    let mut snapper =
        Snapper { scene, seen, edges: &edges, columns, bends: Vec::new(), crossings: Vec::new(), touching: Vec::new() };
    let bands = Bands::new(&edges, columns);
    bands.for_each_pair(|a, b| snapper.meet(a, b));
    let crossings = std::mem::take(&mut snapper.crossings);
    bands.for_each_point(&crossings, |edge, point| snapper.pass(edge, point));
    snapper.finish(apart)
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
        let (low, high) = (a.min(b) as usize, a.max(b) as usize);
        let contours = &self.scene.contour_of;
        let contour = contours[low];
        if contour != contours[high] || high - low == 1 || !self.scene.is_drawn(contour) {
            return;
        }
        let is_first = low == 0 || contours[low - 1] != contour;
        let is_last = contours.get(high + 1) != Some(&contour);
        if !(is_first && is_last) {
            self.touching.push(contour);
        }
    }

    fn finish(self, apart: &[u32]) -> Snapped {
        let mut snapped = Snapped { touching: self.touching, ..Snapped::default() };
        snapped.touching.sort_unstable();
        snapped.touching.dedup();
        snapped.pieces.reserve(self.edges.len() + self.bends.len());
        let mut along = Along::new(self.edges.len(), self.bends);
        for (index, e) in self.edges.iter().enumerate() {
            let bends = along.sorted(index, e);
            let is_whole = e.l.x >= self.columns.0 && e.r.x <= self.columns.1;
            let contour = self.scene.contour_of[self.seen[index] as usize];
            if !is_whole {
                snapped.bends.extend(bends.iter().map(|bend| Bend { edge: self.seen[index], at: bend.at }));
            } else if apart.binary_search(&contour).is_ok() {
                snapped.apart.extend(pieces(e, bends).map(|piece| (contour, piece)));
            } else {
                snapped.pieces.extend(pieces(e, bends));
            }
        }
        snapped
    }
}

/// An edge cut at its bends, which are in order and may repeat.
pub(super) fn pieces(e: &Edge, bends: &[Bend]) -> impl Iterator<Item = Edge> {
    let (mut from, delta) = (e.l, e.delta);
    bends.iter().map(|bend| bend.at).chain([e.r]).filter_map(move |to| {
        let start = std::mem::replace(&mut from, to);
        match start.cmp(&to) {
            Ordering::Less => Some(Edge { l: start, r: to, delta }),
            // A falling edge that is bent within one grid column has a vertical piece, and those run upward.
            Ordering::Greater => Some(Edge { l: to, r: start, delta: delta.map(|d| -d) }),
            Ordering::Equal => None,
        }
    })
}

/// Bends grouped by edge.
struct Along {
    bends: Vec<Bend>,
    starts: Vec<u32>,
}

impl Along {
    fn new(edges: usize, bends: Vec<Bend>) -> Self {
        let mut starts = vec![0; edges + 1];
        for bend in &bends {
            starts[bend.edge as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut grouped = vec![Bend { edge: 0, at: GridPoint::default() }; bends.len()];
        for bend in bends {
            starts[bend.edge as usize] -= 1;
            grouped[starts[bend.edge as usize] as usize] = bend;
        }
        debug_assert_eq!(starts[edges] as usize, grouped.len());
        Self { bends: grouped, starts }
    }

    /// The bends of one edge in the order in which it passes them.
    fn sorted(&mut self, edge: usize, e: &Edge) -> &[Bend] {
        let range = self.starts[edge] as usize..self.starts[edge + 1] as usize;
        let bends = &mut self.bends[range];
        if e.r.y >= e.l.y {
            bends.sort_unstable_by_key(|bend| (bend.at.x, bend.at.y));
        } else {
            bends.sort_unstable_by_key(|bend| (bend.at.x, -bend.at.y));
        }
        bends
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
