//! [`SnapChains`]: the second stage, every segment as the chain of grid points that snap rounding makes of it.
//!
//! Straight segments of a chain are computed where they are needed: a strip computes those inside it when it is swept.
//! Only segments that span a seam need what several strips know.

use std::cmp::Ordering;

use crate::{
    engine::{segment::Segment, segment_set::SegmentSet, strips::StripPlan},
    point::GridPoint,
};

/// A grid point in the interior of the chain of a segment.
#[derive(Debug, Clone, Copy)]
pub(super) struct SnapVertex {
    /// The index of the segment in its strip.
    pub(super) segment: u32,
    pub(super) at: GridPoint,
}

/// The chains inside one strip.
pub(in crate::engine) struct StripChains {
    vertices: ChainVertices,
    /// The segments that reach into later strips, by index in the strip.
    leaving: Vec<u32>,
    /// Shapes that touch or cross themselves.
    self_intersecting: Vec<u32>,
}

impl StripChains {
    /// The chains of the segments of a strip that ends with the column `last`; `self_intersecting` may repeat contours.
    pub(super) fn new(
        segments: &[Segment],
        vertices: &[SnapVertex],
        last: i64,
        mut self_intersecting: Vec<u32>,
    ) -> Self {
        self_intersecting.sort_unstable();
        self_intersecting.dedup();
        let leaving = (0u32..).zip(segments).filter(|(_, e)| e.r.x > last).map(|(index, _)| index).collect();
        Self { vertices: ChainVertices::new(segments, vertices), leaving, self_intersecting }
    }
}

/// The snap vertices of a strip by segment, in the direction of each segment; some repeat.
struct ChainVertices {
    points: Vec<GridPoint>,
    /// Segment `s` of the strip has `points[starts[s]..starts[s + 1]]`.
    starts: Vec<u32>,
}

impl ChainVertices {
    fn new(segments: &[Segment], vertices: &[SnapVertex]) -> Self {
        let mut starts = vec![0; segments.len() + 1];
        for vertex in vertices {
            starts[vertex.segment as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut points = vec![GridPoint::default(); vertices.len()];
        for vertex in vertices {
            starts[vertex.segment as usize] -= 1;
            points[starts[vertex.segment as usize] as usize] = vertex.at;
        }
        for (segment, range) in segments.iter().zip(starts.windows(2)) {
            sort_along(segment, &mut points[range[0] as usize..range[1] as usize]);
        }
        Self { points, starts }
    }

    /// The snap vertices of a segment, by its index in the strip.
    #[inline]
    fn of(&self, segment: usize) -> &[GridPoint] {
        &self.points[self.starts[segment] as usize..self.starts[segment + 1] as usize]
    }
}

fn sort_along(segment: &Segment, points: &mut [GridPoint]) {
    if segment.r.y >= segment.l.y {
        points.sort_unstable();
    } else {
        points.sort_unstable_by_key(|at| (at.x, -at.y));
    }
}

/// Which contours a query is about.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::engine) enum Kind {
    /// Contours that take part in the sweep as they are.
    Ordinary,
    /// Shapes that touch or cross themselves, which are filled first.
    SelfIntersecting,
}

/// The chains of all segments.
pub(in crate::engine) struct SnapChains<'a> {
    pub(in crate::engine) segments: &'a SegmentSet,
    pub(in crate::engine) plan: &'a StripPlan,
    strips: Vec<StripChains>,
    /// Contours of [`Kind::SelfIntersecting`], ascending.
    self_intersecting: Vec<u32>,
}

impl<'a> SnapChains<'a> {
    /// Joins what all strips have found.
    pub(in crate::engine) fn new(segments: &'a SegmentSet, plan: &'a StripPlan, strips: Vec<StripChains>) -> Self {
        let mut self_intersecting: Vec<u32> =
            strips.iter().flat_map(|strip| &strip.self_intersecting).copied().collect();
        self_intersecting.sort_unstable();
        self_intersecting.dedup();
        Self { segments, plan, strips, self_intersecting }
    }

    /// True if some contour is of [`Kind::SelfIntersecting`].
    pub(in crate::engine) fn has_self_intersecting(&self) -> bool {
        !self.self_intersecting.is_empty()
    }

    fn is_of(&self, kind: Kind, contour: u32) -> bool {
        (kind == Kind::SelfIntersecting) == self.self_intersecting.binary_search(&contour).is_ok()
    }

    /// The chain segments of some contours that stay in a strip, with their contours.
    pub(in crate::engine) fn within(&self, strip: usize, kind: Kind, mut take: impl FnMut(u32, Segment)) {
        let (first, last) = self.plan.columns(strip);
        let mut reader = self.segments.reader();
        for (index, &number) in self.plan.touching(strip).iter().enumerate() {
            let e = reader.segment(number);
            if !self.is_of(kind, reader.contour()) {
                continue;
            }
            let mut from = if e.l.x >= first { Some(e.l) } else { None };
            let end = if e.r.x <= last { Some(e.r) } else { None };
            for to in self.strips[strip].vertices.of(index).iter().copied().chain(end) {
                if let Some(part) = from.replace(to).and_then(|from| part_of_chain(from, to, e.delta)) {
                    take(reader.contour(), part);
                }
            }
        }
    }

    /// The chain segments of some contours that begin in a strip and end in a later one, with their contours.
    pub(in crate::engine) fn leaving(&self, strip: usize, kind: Kind, mut take: impl FnMut(u32, Segment)) {
        let (first, _) = self.plan.columns(strip);
        let mut reader = self.segments.reader();
        let touching = self.plan.touching(strip);
        let chains = &self.strips[strip];
        for (index, number) in chains.leaving.iter().map(|&index| (index as usize, touching[index as usize])) {
            let e = reader.segment(number);
            if !self.is_of(kind, reader.contour()) {
                continue;
            }
            let begin = if e.l.x >= first { Some(e.l) } else { None };
            if let Some(l) = chains.vertices.of(index).last().copied().or(begin) {
                let r = self.next_point(number, &e, strip + 1);
                take(reader.contour(), Segment { l, r, delta: e.delta });
            }
        }
    }

    /// The first point of the chain of a segment from a strip on.
    fn next_point(&self, number: u32, e: &Segment, strip: usize) -> GridPoint {
        let vertex = (strip..self.plan.strip_of(e.r.x) + 1).find_map(|strip| {
            let index = self.plan.touching(strip).partition_point(|&other| other < number);
            self.strips[strip].vertices.of(index).first().copied()
        });
        vertex.unwrap_or(e.r)
    }
}

/// The segment of a chain from one point to a later one; `None` if the points are equal.
fn part_of_chain(from: GridPoint, to: GridPoint, delta: [i32; 2]) -> Option<Segment> {
    match from.cmp(&to) {
        Ordering::Less => Some(Segment { l: from, r: to, delta }),
        // The chain of a falling segment has a vertical segment inside one grid column; vertical ones run upward.
        Ordering::Greater => Some(Segment { l: to, r: from, delta: delta.map(|d| -d) }),
        Ordering::Equal => None,
    }
}
