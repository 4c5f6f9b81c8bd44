//! [`SpanningSegments`]: the segments of all chains that span a seam.

use rayon::prelude::*;

use super::self_intersecting::FilledContours;
use crate::{
    engine::{
        segment::{Segment, drop_last_cancelled, push_merged},
        snap::{Kind, SnapChains},
    },
    jobs::per_job,
};

/// The chain segments that reach from one strip into another, numbered from left to right.
///
/// A segment belongs to the strip of its left end and enters every strip after that, up to the one of its right end.
pub(in crate::engine) struct SpanningSegments {
    segments: Vec<Segment>,
    /// Strip `s` has `segments[owned[s]..owned[s + 1]]`.
    owned: Vec<usize>,
    entering: Vec<Vec<u32>>,
}

impl SpanningSegments {
    /// Joins what the strips know of each chain, and takes the boundaries of self-intersecting contours.
    pub(in crate::engine) fn join(chains: &SnapChains, filled: &FilledContours) -> Self {
        let strips = chains.plan.len();
        let leaving: Vec<Leaving> = (0..strips)
            .into_par_iter()
            .with_min_len(per_job(strips, chains.segments.len()))
            .map(|strip| Leaving::new(chains, filled, strip))
            .collect();
        let mut spanning = Self {
            segments: Vec::with_capacity(leaving.iter().map(|own| own.segments.len()).sum()),
            owned: Vec::with_capacity(strips + 1),
            entering: vec![Vec::new(); strips],
        };
        for (strip, own) in leaving.iter().enumerate() {
            spanning.add(strip, own);
        }
        spanning.owned.push(spanning.segments.len());
        spanning
    }

    #[expect(clippy::cast_possible_truncation, reason = "segment numbers fit a u32, and spanning ones are not more")]
    fn add(&mut self, strip: usize, own: &Leaving) {
        let first = self.segments.len();
        self.owned.push(first);
        self.segments.extend(&own.segments);
        for (number, &end) in (first as u32..).zip(&own.ends) {
            self.entering[strip + 1..=end].iter_mut().for_each(|entering| entering.push(number));
        }
    }

    /// How many there are.
    pub(in crate::engine) fn len(&self) -> usize {
        self.segments.len()
    }

    /// A spanning segment by its number.
    pub(super) fn segment(&self, number: u32) -> Segment {
        self.segments[number as usize]
    }

    /// The spanning segments whose left end is in a strip.
    pub(in crate::engine) fn owned(&self, strip: usize) -> &[Segment] {
        &self.segments[self.owned[strip]..self.owned[strip + 1]]
    }

    /// The number of a spanning segment whose left end is in a strip.
    #[expect(clippy::cast_possible_truncation, reason = "segment numbers fit a u32, and spanning ones are not more")]
    pub(super) fn number_of(&self, strip: usize, segment: &Segment) -> u32 {
        let before = self.owned(strip).partition_point(|other| (other.l, other.r) < (segment.l, segment.r));
        (self.owned[strip] + before) as u32
    }

    /// Numbers of the segments that enter a strip over its left seam.
    pub(super) fn entering(&self, strip: usize) -> &[u32] {
        &self.entering[strip]
    }
}

/// The spanning segments that begin in one strip.
struct Leaving {
    /// By left end, then by right end; coincident ones are merged.
    segments: Vec<Segment>,
    /// The strip of each right end.
    ends: Vec<usize>,
}

impl Leaving {
    fn new(chains: &SnapChains, filled: &FilledContours, strip: usize) -> Self {
        let mut all = filled.leaving(strip).to_vec();
        chains.leaving(strip, Kind::Ordinary, |_, segment| all.push(segment));
        all.sort_unstable_by_key(|segment| (segment.l, segment.r));
        let mut segments = Vec::with_capacity(all.len());
        all.into_iter().for_each(|segment| push_merged(&mut segments, segment));
        drop_last_cancelled(&mut segments);
        let ends = segments.iter().map(|segment| chains.plan.strip_of(segment.r.x)).collect();
        Self { segments, ends }
    }
}
