//! Snap rounding in one strip: which hot pixels does each segment cross?
//!
//! [`super::super`] explains the idea, [`predicates`](crate::engine::predicates) the exact test.

use super::{
    candidates::CandidateSearch,
    chains::{SnapVertex, StripChains},
};
use crate::{
    engine::{
        budget::Budget,
        predicates::{crosses_pixel, have_opposite_signs, in_box, reach},
        segment::Segment,
        segment_set::SegmentSet,
        strips::StripPlan,
    },
    point::{GridPoint, cross},
};

/// Crossings closer than this to a border between pixels are rounded in integers.
const FLOAT_MARGIN: f64 = 1e-4;

/// Offsets up to this size keep an absolute error far below [`FLOAT_MARGIN`] in an `f64`.
const FLOAT_RANGE: f64 = (1u64 << 32) as f64;

/// Finds the snap chains of all segments inside one strip.
pub(in crate::engine) fn snap_strip(set: &SegmentSet, plan: &StripPlan, strip: usize, budget: &Budget) -> StripChains {
    let numbers = plan.touching(strip);
    let mut reader = set.reader();
    let segments: Vec<Segment> = numbers.iter().map(|&number| reader.segment(number)).collect();
    let columns = plan.columns(strip);
    let mut snapper = Snapper {
        set,
        numbers,
        segments: &segments,
        columns,
        budget,
        vertices: Vec::new(),
        crossings: Vec::new(),
        self_intersecting: Vec::new(),
    };
    let search = CandidateSearch::new(&segments, columns);
    search.for_each_pair(|a, b| snapper.intersect(a, b), || budget.is_over());
    let crossings = if budget.is_over() { Vec::new() } else { std::mem::take(&mut snapper.crossings) };
    search.for_each_point(&crossings, |segment, point| snapper.snap_to_crossing(segment, point));
    StripChains::new(&segments, &snapper.vertices, columns.1, snapper.self_intersecting)
}

/// Snap vertices that are counted at once.
const VERTICES_PER_COUNT: usize = 4096;

struct Snapper<'a> {
    set: &'a SegmentSet,
    /// Numbers of the segments of the strip.
    numbers: &'a [u32],
    segments: &'a [Segment],
    columns: (i64, i64),
    budget: &'a Budget<'a>,
    vertices: Vec<SnapVertex>,
    /// Hot pixels without an input vertex.
    crossings: Vec<GridPoint>,
    /// Shapes that touch or cross themselves.
    self_intersecting: Vec<u32>,
}

impl Snapper<'_> {
    /// Two segments whose boxes overlap: where do they cross, and which ends are in pixels that the other one crosses?
    fn intersect(&mut self, a: u32, b: u32) {
        let (e, f) = (self.segments[a as usize], self.segments[b as usize]);
        let (f_l, f_r) = (e.cross(f.l), e.cross(f.r));
        let reach_e = reach(&e);
        if (f_l > reach_e && f_r > reach_e) || (f_l < -reach_e && f_r < -reach_e) {
            // `e` crosses no pixel of `f`, but `f` may still cross the pixel of a vertex of `e`.
            return self.snap_to_ends(b, &f, &e);
        }
        let (e_l, e_r) = (f.cross(e.l), f.cross(e.r));
        self.snap_to_vertex(a, &e, f.l, f_l);
        self.snap_to_vertex(a, &e, f.r, f_r);
        self.snap_to_vertex(b, &f, e.l, e_l);
        self.snap_to_vertex(b, &f, e.r, e_r);
        let is_crossing = have_opposite_signs(f_l, f_r) && have_opposite_signs(e_l, e_r);
        if is_crossing {
            self.add_crossing(a, b, crossing(&e, &f));
        }
        let touches = is_crossing
            || (f_l == 0 && in_box(&e, f.l))
            || (f_r == 0 && in_box(&e, f.r))
            || (e_l == 0 && in_box(&f, e.l))
            || (e_r == 0 && in_box(&f, e.r));
        if touches {
            self.note_self_intersection(a, b);
        }
    }

    fn snap_to_ends(&mut self, segment: u32, e: &Segment, other: &Segment) {
        for p in [other.l, other.r] {
            if in_box(e, p) {
                self.snap_to_vertex(segment, e, p, e.cross(p));
            }
        }
    }

    /// Adds a snap vertex at `p` if the segment crosses the pixel of `p`; `d` is `e.cross(p)`.
    #[inline]
    fn snap_to_vertex(&mut self, segment: u32, e: &Segment, p: GridPoint, d: i128) {
        // Few points are this close, so the box is tested last.
        if crosses_pixel(e, d) && in_box(e, p) {
            self.add_vertex(segment, e, p);
        }
    }

    fn snap_to_crossing(&mut self, segment: u32, p: GridPoint) {
        let e = self.segments[segment as usize];
        self.snap_to_vertex(segment, &e, p, e.cross(p));
    }

    fn add_crossing(&mut self, a: u32, b: u32, p: GridPoint) {
        if p.x < self.columns.0 || p.x > self.columns.1 {
            return;
        }
        let (e, f) = (self.segments[a as usize], self.segments[b as usize]);
        let is_vertex = [e.l, e.r, f.l, f.r].contains(&p);
        if !is_vertex {
            self.crossings.push(p);
        }
        self.add_vertex(a, &e, p);
        self.add_vertex(b, &f, p);
    }

    fn add_vertex(&mut self, segment: u32, e: &Segment, at: GridPoint) {
        if at != e.l && at != e.r && at.x >= self.columns.0 && at.x <= self.columns.1 {
            self.vertices.push(SnapVertex { segment, at });
            if self.vertices.len().is_multiple_of(VERTICES_PER_COUNT) {
                self.budget.add_vertices(VERTICES_PER_COUNT);
            }
        }
    }

    /// Neighbors along a contour share a vertex; other segments of a shape that meet make it self-intersecting.
    fn note_self_intersection(&mut self, a: u32, b: u32) {
        let (a, b) = (self.numbers[a as usize], self.numbers[b as usize]);
        let contour = self.set.contour_of(a);
        // The test for neighbors walks over repeated points, so it comes last.
        if contour == self.set.contour_of(b)
            && self.self_intersecting.last() != Some(&contour)
            && self.set.is_shape(contour)
            && !self.set.are_neighbors(a.min(b), a.max(b))
        {
            self.self_intersecting.push(contour);
        }
    }
}

/// The grid point whose pixel contains the crossing of two segments that properly cross.
fn crossing(e: &Segment, f: &Segment) -> GridPoint {
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
