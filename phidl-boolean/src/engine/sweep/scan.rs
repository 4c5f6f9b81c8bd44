//! [`Scan`]: one sweep over segments that meet only at their ends.
//!
//! Snap rounding has found all crossings before, so the sweep computes no points. The status structure holds the
//! segments over the current event point from bottom to top, and the sweep adds up their winding deltas. The winding
//! numbers below all segments are zero, so a strip needs no start values from its neighbors.

use std::{cmp::Ordering, ops::Range};

use super::status::{Slot, Status};
use crate::{
    engine::{
        input::Rule,
        radix::by_x,
        segment::{Segment, drop_last_cancelled, push_merged},
    },
    point::{GridPoint, side},
};

/// Identifies a boundary edge: its number in the strip, or [`SPANNING`] with the number of a spanning segment.
pub(in crate::engine) type BoundaryId = u32;

/// Marks the [`BoundaryId`] of a spanning segment that begins in another strip.
pub(in crate::engine) const SPANNING: BoundaryId = 1 << 31;

/// The boundary edges of one strip and how they are linked.
#[derive(Debug, Default)]
pub(in crate::engine) struct BoundaryEdges {
    /// The start of each boundary edge of this strip, which has the covered side on its left. Edges are numbered by
    /// their left end, from left to right and upward.
    pub(in crate::engine) from: Vec<GridPoint>,
    /// Pairs of boundary edges: the second follows the first.
    pub(in crate::engine) follows: Vec<(BoundaryId, BoundaryId)>,
    /// Boundary edges at the leftmost point of a possible hole, and the boundary edge right below that point.
    pub(in crate::engine) below: Vec<(BoundaryId, BoundaryId)>,
    /// Boundary edges of this strip that span a seam: number of the spanning segment, number of the edge.
    pub(in crate::engine) spanning: Vec<(u32, BoundaryId)>,
    /// What surrounds each query point, in the order of the points.
    pub(in crate::engine) surroundings: Vec<Surroundings>,
}

/// What surrounds a point that is on no segment.
#[derive(Debug, Clone, Copy)]
pub(in crate::engine) struct Surroundings {
    pub(in crate::engine) winding: [i32; 2],
    /// The boundary edge right below.
    pub(in crate::engine) below: Option<BoundaryId>,
}

/// Which side of a segment is covered, if exactly one is.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Boundary {
    None,
    CoveredAbove,
    CoveredBelow,
}

/// What the sweep knows about a segment after its left end.
#[derive(Clone, Copy)]
struct SegmentState {
    above: [i32; 2],
    boundary: Boundary,
    id: BoundaryId,
}

/// A sweep over sorted segments up to the grid column `last`.
pub(super) struct Scan<'a> {
    rule: Rule,
    segments: &'a [Segment],
    last: i64,
    states: Vec<SegmentState>,
    status: Status,
    /// The boundary edges around the event point, counter-clockwise from straight down; true for those that start there.
    around: Vec<(BoundaryId, bool)>,
    /// Those of them with their right end at the event point, from bottom to top.
    arriving: Vec<(BoundaryId, bool)>,
    edges: BoundaryEdges,
}

impl<'a> Scan<'a> {
    pub(super) fn new(rule: Rule, segments: &'a [Segment], last: i64) -> Self {
        let unknown = SegmentState { above: [0, 0], boundary: Boundary::None, id: 0 };
        Self {
            rule,
            segments,
            last,
            states: vec![unknown; segments.len()],
            status: Status::new(segments.len()),
            around: Vec::new(),
            arriving: Vec::new(),
            edges: BoundaryEdges::default(),
        }
    }

    /// Inserts the spanning segments `segments[own..]`, from bottom to top, by their numbers.
    pub(super) fn enter(&mut self, own: usize, numbers: &[u32]) {
        let mut winding = [0, 0];
        for (segment, number) in (own..self.segments.len()).zip(numbers) {
            winding = self.classify(segment, winding);
            self.states[segment].id = SPANNING | number;
            self.status.insert(self.status.top(), index(segment)..index(segment + 1));
        }
    }

    /// Handles every end of a segment of the strip as an event, from left to right and upward, and answers the query
    /// `points` (ascending) on the way. `segments[..own]` begin in the strip.
    pub(super) fn run(&mut self, own: usize, points: impl Iterator<Item = GridPoint>) {
        let mut points = points.peekable();
        let segments = self.segments;
        let ends = ends_in_order(segments, self.last);
        let (mut next_segment, mut next_end) = (0, 0);
        let end_at = |next: usize| ends.get(next).map(|&segment| segments[segment as usize].r);
        loop {
            let begin = segments[..own].get(next_segment).map(|segment| segment.l);
            let end = end_at(next_end);
            let at = match (begin, end) {
                (Some(begin), Some(end)) => begin.min(end),
                (Some(only), None) | (None, Some(only)) => only,
                (None, None) => break,
            };
            while let Some(point) = points.next_if(|&point| point < at) {
                self.locate(point);
            }
            let first = next_segment;
            while next_segment < own && segments[next_segment].l == at {
                next_segment += 1;
            }
            let ending = if end == Some(at) { Some(ends[next_end]) } else { None };
            while end_at(next_end) == Some(at) {
                next_end += 1;
            }
            self.handle_event(at, first..next_segment, ending);
        }
        points.for_each(|point| self.locate(point));
    }

    /// The boundary edges found; [`BoundaryEdges::spanning`] holds indices of segments instead of numbers.
    pub(super) fn into_edges(self) -> BoundaryEdges {
        self.edges
    }

    /// Which side of each segment is covered.
    pub(super) fn boundaries(&self) -> impl Iterator<Item = Boundary> {
        self.states.iter().map(|state| state.boundary)
    }

    /// Answers a query point that is on no segment.
    fn locate(&mut self, point: GridPoint) {
        let segments = self.segments;
        let slot = self.status.search(|segment| segments[segment as usize].cross(point) > 0);
        let winding = self.winding_below(slot);
        self.edges.surroundings.push(Surroundings { winding, below: self.boundary_below(slot) });
    }

    fn winding_below(&self, slot: Slot) -> [i32; 2] {
        self.status.below(slot).map_or([0, 0], |under| self.states[under as usize].above)
    }

    /// The first boundary edge below a slot.
    fn boundary_below(&self, slot: Slot) -> Option<BoundaryId> {
        let mut below = self.status.all_below(slot).map(|segment| self.states[segment as usize]);
        below.find(|state| state.boundary != Boundary::None).map(|state| state.id)
    }

    /// Replaces the segments that end at a point, of which one may be given, by those that begin there, from bottom to
    /// top.
    fn handle_event(&mut self, at: GridPoint, beginning: Range<usize>, ending: Option<u32>) {
        let slot = self.remove_ending(at, ending);
        let mut winding = self.winding_below(slot);
        self.around.clear();
        for segment in beginning.clone() {
            winding = self.classify(segment, winding);
            self.number(segment);
            let SegmentState { boundary, id, .. } = self.states[segment];
            if boundary != Boundary::None {
                self.around.push((id, boundary == Boundary::CoveredAbove));
            }
        }
        if self.arriving.is_empty() {
            self.note_hole(slot);
        }
        self.around.extend(self.arriving.iter().rev());
        self.link();
        self.status.insert(slot, index(beginning.start)..index(beginning.end));
    }

    /// Removes the segments that end at a point, notes the boundary edges among them, and returns their slot.
    fn remove_ending(&mut self, at: GridPoint, ending: Option<u32>) -> Slot {
        let (segments, states, arriving) = (self.segments, &self.states, &mut self.arriving);
        arriving.clear();
        let Some(ending) = ending else {
            return self.status.search(|segment| segments[segment as usize].cross(at) > 0);
        };
        let mut lowest = self.status.slot_of(ending);
        while self.status.below(lowest).is_some_and(|segment| segments[segment as usize].r == at) {
            lowest = self.status.step_down(lowest);
        }
        self.status.remove_while(lowest, |segment| {
            let ends = segments[segment as usize].r == at;
            let SegmentState { boundary, id, .. } = states[segment as usize];
            if ends && boundary != Boundary::None {
                arriving.push((id, boundary == Boundary::CoveredBelow));
            }
            ends
        })
    }

    /// Links the boundary edges of each covered wedge: from the edge that arrives to the edge that leaves. So parts that
    /// touch in a point stay separate, and a ring never crosses itself.
    fn link(&mut self) {
        for (position, &(id, leaves)) in self.around.iter().enumerate() {
            if leaves {
                let (arriving, _) = self.around[(position + 1) % self.around.len()];
                self.edges.follows.push((arriving, id));
            }
        }
    }

    /// Notes the boundary edge right below the event point if a hole may begin there.
    fn note_hole(&mut self, slot: Slot) {
        let Some(&(id, false)) = self.around.first() else { return };
        if let Some(below) = self.boundary_below(slot) {
            self.edges.below.push((id, below));
        }
    }

    /// Finds the covered side of a segment from the winding numbers below it; returns those above it.
    fn classify(&mut self, segment: usize, below: [i32; 2]) -> [i32; 2] {
        let delta = self.segments[segment].delta;
        let above = [below[0] + delta[0], below[1] + delta[1]];
        let boundary = match (self.rule.covers(below), self.rule.covers(above)) {
            (false, true) => Boundary::CoveredAbove,
            (true, false) => Boundary::CoveredBelow,
            _ => Boundary::None,
        };
        self.states[segment].above = above;
        self.states[segment].boundary = boundary;
        above
    }

    /// Numbers a segment that begins in this strip, if it is a boundary edge.
    fn number(&mut self, segment: usize) {
        let e = &self.segments[segment];
        let from = match self.states[segment].boundary {
            Boundary::None => return,
            Boundary::CoveredAbove => e.l,
            Boundary::CoveredBelow => e.r,
        };
        let id = index(self.edges.from.len());
        self.edges.from.push(from);
        self.states[segment].id = id;
        if e.r.x > self.last {
            self.edges.spanning.push((index(segment), id));
        }
    }
}

/// The stored form of the index of a segment.
#[expect(clippy::cast_possible_truncation, reason = "the number of segments is checked when they are gathered")]
fn index(segment: usize) -> u32 {
    segment as u32
}

/// The segments in the order of a sweep, coincident ones merged.
pub(super) fn in_order(segments: &[Segment]) -> Vec<Segment> {
    let segment = |number: u32| &segments[number as usize];
    let order = by_x((0u32..).zip(segments).map(|(number, e)| (number, e.l.x)), |a, b| {
        left_then_upward(segment(a), segment(b))
    });
    let mut sorted = Vec::with_capacity(segments.len());
    order.into_iter().for_each(|number| push_merged(&mut sorted, *segment(number)));
    drop_last_cancelled(&mut sorted);
    sorted
}

/// Indices of the segments that end up to some grid column, in the order of their right ends.
fn ends_in_order(segments: &[Segment], last: i64) -> Vec<u32> {
    let right = |number: u32| segments[number as usize].r;
    let ending = (0u32..).zip(segments).map(|(number, e)| (number, e.r.x)).filter(|&(_, x)| x <= last);
    by_x(ending, |a, b| (right(a), a).cmp(&(right(b), b)))
}

/// Order of the left ends, and from bottom to top around a common one.
fn left_then_upward(a: &Segment, b: &Segment) -> Ordering {
    a.l.cmp(&b.l).then_with(|| side(a.l, b.r, a.r))
}
