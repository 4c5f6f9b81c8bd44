//! [`FilledContours`]: shapes that touch or cross themselves, filled one by one.
//!
//! A figure-eight winds +1 around one lobe and −1 around the other, and the −1 would cancel the +1 of another shape over
//! it. So each such contour is filled on its own by the non-zero rule, and from then on all its winding is positive. Its
//! chains are filled, not the contour itself: rounding once is enough.

use rayon::prelude::*;

use super::scan::{Boundary, Scan, in_order};
use crate::{
    engine::{
        input::Rule,
        segment::Segment,
        segment_set::SegmentSet,
        snap::{Kind, SnapChains},
    },
    jobs::per_job,
    op::{Fill, Operation},
};

/// The boundaries of the self-intersecting contours, by the strip in which each segment begins.
#[derive(Default)]
pub(in crate::engine) struct FilledContours {
    within: Vec<Vec<Segment>>,
    leaving: Vec<Vec<Segment>>,
}

impl FilledContours {
    /// Fills the contours that touch or cross themselves.
    pub(in crate::engine) fn fill(chains: &SnapChains) -> Self {
        if !chains.has_self_intersecting() {
            return Self::default();
        }
        let plan = chains.plan;
        let mut filled = Self { within: vec![Vec::new(); plan.len()], leaving: vec![Vec::new(); plan.len()] };
        for segment in boundaries(gathered(chains), chains.segments) {
            let strip = plan.strip_of(segment.l.x);
            let is_within = strip == plan.strip_of(segment.r.x);
            (if is_within { &mut filled.within } else { &mut filled.leaving })[strip].push(segment);
        }
        filled
    }

    /// The segments that stay in a strip.
    pub(in crate::engine) fn within(&self, strip: usize) -> &[Segment] {
        self.within.get(strip).map_or(&[], Vec::as_slice)
    }

    /// The segments that begin in a strip and end in a later one.
    pub(super) fn leaving(&self, strip: usize) -> &[Segment] {
        self.leaving.get(strip).map_or(&[], Vec::as_slice)
    }
}

/// The chain segments of the self-intersecting contours, with the number of the contour.
fn gathered(chains: &SnapChains) -> Vec<(u32, Segment)> {
    let in_strip = |strip| {
        let mut segments = Vec::new();
        chains.within(strip, Kind::SelfIntersecting, |contour, segment| segments.push((contour, segment)));
        chains.leaving(strip, Kind::SelfIntersecting, |contour, segment| segments.push((contour, segment)));
        segments
    };
    (0..chains.plan.len()).into_par_iter().flat_map_iter(in_strip).collect()
}

/// The boundary of what each contour covers.
fn boundaries(mut segments: Vec<(u32, Segment)>, set: &SegmentSet) -> Vec<Segment> {
    segments.sort_by_key(|&(contour, _)| contour);
    let contours: Vec<&[(u32, Segment)]> = segments.chunk_by(|a, b| a.0 == b.0).collect();
    let per_job = per_job(contours.len(), segments.len());
    let filled: Vec<Vec<Segment>> = contours
        .into_par_iter()
        .with_min_len(per_job)
        .map(|own| {
            let segments: Vec<Segment> = own.iter().map(|&(_, segment)| segment).collect();
            boundary(&segments, set.operand_of(own[0].0))
        })
        .collect();
    filled.concat()
}

/// The boundary of what one contour of an operand covers, with winding number 1 inside.
fn boundary(segments: &[Segment], operand: usize) -> Vec<Segment> {
    let segments = in_order(segments);
    let mut scan = Scan::new(Rule { operation: Operation::Or, fill: Fill::NonZero }, &segments, i64::MAX);
    scan.run(segments.len(), std::iter::empty());
    let once = |(segment, boundary): (&Segment, Boundary)| {
        let mut delta = [0, 0];
        delta[operand] = match boundary {
            Boundary::None => return None,
            Boundary::CoveredAbove => 1,
            Boundary::CoveredBelow => -1,
        };
        Some(Segment { delta, ..*segment })
    };
    segments.iter().zip(scan.boundaries()).filter_map(once).collect()
}
