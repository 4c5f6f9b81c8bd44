//! [`CandidateSearch`]: pairs of segments with bounding boxes that touch, and segments with a point in their box.
//!
//! It is an interval sweep over bins. Bins divide the longer side of the strip, each box is entered into the bins that it
//! touches, and each bin is swept in the other direction. So a segment is compared only with what is near it in both
//! directions. Rejected: one sorted list for the whole strip. It compares a segment with everything beside it, which was
//! half of the time of snapping.
//!
//! Boxes are kept in 32 bits, relative to the strip. In wider strips the lowest bits are dropped: boxes that touch still
//! touch, and callers test every candidate exactly.

use crate::{engine::segment::Segment, point::GridPoint};

/// The aimed number of segments per bin; a segment is compared with about half of its bin at most.
const BIN: usize = 24;

/// Bins with more entries than this choose their own sweep direction.
const CROWDED: usize = 8 * BIN;

/// Entries between two looks at `stop`.
const ENTRIES_PER_CHECK: usize = 64;

/// Marks an entry whose segment is also in the previous bin.
const ENTERED: u32 = 1 << 31;

/// The bounding boxes of the segments of a strip, by bin.
pub(super) struct CandidateSearch {
    frame: StripFrame,
    /// Entries of all bins; each bin is sorted by `low`.
    entries: Vec<Entry>,
    bins: Vec<Bin>,
}

#[derive(Clone, Copy)]
struct Bin {
    start: usize,
    /// BoundaryEdges across the strip like the others, not along it.
    is_across: bool,
}

/// The box of a segment in a bin: `low` to `high` in the sweep direction of the bin.
#[derive(Clone, Copy, Default)]
struct Entry {
    low: u32,
    high: u32,
    side_low: u32,
    side_high: u32,
    /// Index of the segment, with [`ENTERED`].
    segment: u32,
}

impl Entry {
    fn turned(self) -> Self {
        Self {
            low: self.side_low,
            high: self.side_high,
            side_low: self.low,
            side_high: self.high,
            segment: self.segment,
        }
    }

    fn number(self) -> u32 {
        self.segment & !ENTERED
    }
}

impl CandidateSearch {
    /// A search over segments, clipped to some grid columns.
    pub(super) fn new(segments: &[Segment], columns: (i64, i64)) -> Self {
        let frame = StripFrame::new(segments, columns);
        let boxes: Vec<Entry> = (0u32..).zip(segments).map(|(segment, e)| frame.entry(segment, e)).collect();
        let mut starts = vec![0; frame.bins + 1];
        for b in &boxes {
            frame.bins_of(*b).for_each(|bin| starts[bin] += 1);
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut entries = vec![Entry::default(); total];
        // In reverse, so that bins keep the order of the segments, which is mostly from left to right already.
        for b in boxes.iter().rev() {
            let first = frame.bin_of(b.side_low);
            for bin in frame.bins_of(*b) {
                let entered = if bin > first { ENTERED } else { 0 };
                starts[bin] -= 1;
                entries[starts[bin]] = Entry { segment: b.segment | entered, ..*b };
            }
        }
        let bins = starts.windows(2).map(|range| Bin::sorted(&mut entries, range[0], range[1]));
        let mut bins: Vec<Bin> = bins.collect();
        bins.push(Bin { start: total, is_across: true });
        Self { frame, entries, bins }
    }

    /// Calls `visit` once for each pair of segments whose boxes touch, and possibly for further pairs. Ends early if `stop`
    /// becomes true.
    pub(super) fn for_each_pair(&self, mut visit: impl FnMut(u32, u32), stop: impl Fn() -> bool) {
        for range in self.bins.windows(2) {
            let entries = &self.entries[range[0].start..range[1].start];
            for (index, a) in entries.iter().enumerate() {
                if index.is_multiple_of(ENTRIES_PER_CHECK) && stop() {
                    return;
                }
                for b in &entries[index + 1..] {
                    if b.low > a.high {
                        break;
                    }
                    let beside = (b.side_low <= a.side_high) & (b.side_high >= a.side_low);
                    // A pair that shares the previous bin was found there.
                    if beside & (a.segment & b.segment & ENTERED == 0) {
                        visit(a.number(), b.number());
                    }
                }
            }
        }
    }

    /// Calls `visit` for each segment and each distinct point in its box, and possibly for further points.
    pub(super) fn for_each_point(&self, points: &[GridPoint], mut visit: impl FnMut(u32, GridPoint)) {
        let mut binned: Vec<BinnedPoint> = points.iter().map(|&point| self.binned(point)).collect();
        binned.sort_unstable_by_key(|p| (p.bin_and_along, p.across));
        binned.dedup_by_key(|p| p.point);
        let mut rest = &binned[..];
        while let Some(first) = rest.first() {
            let bin = first.bin();
            let (own, others) = rest.split_at(rest.partition_point(|p| p.bin() == bin));
            rest = others;
            sweep_bin(&self.entries[self.bins[bin].start..self.bins[bin + 1].start], own, &mut visit);
        }
    }

    fn binned(&self, point: GridPoint) -> BinnedPoint {
        let (across, along) = self.frame.transform(point);
        let bin = self.frame.bin_of(along);
        let (low, side) = if self.bins[bin].is_across { (across, along) } else { (along, across) };
        BinnedPoint { bin_and_along: (bin as u64) << 32 | u64::from(low), across: side, point }
    }
}

/// A point in its bin.
struct BinnedPoint {
    /// The bin, and the coordinate in its sweep direction.
    bin_and_along: u64,
    across: u32,
    point: GridPoint,
}

impl BinnedPoint {
    fn bin(&self) -> usize {
        (self.bin_and_along >> 32) as usize
    }

    #[expect(clippy::cast_possible_truncation, reason = "the lower half is the coordinate")]
    fn along(&self) -> u32 {
        self.bin_and_along as u32
    }
}

/// Sweeps the points of a bin and its entries, both sorted.
fn sweep_bin(entries: &[Entry], points: &[BinnedPoint], visit: &mut impl FnMut(u32, GridPoint)) {
    let mut first = 0;
    for entry in entries {
        while first < points.len() && points[first].along() < entry.low {
            first += 1;
        }
        for point in points[first..].iter().take_while(|point| point.along() <= entry.high) {
            if (point.across >= entry.side_low) & (point.across <= entry.side_high) {
                visit(entry.number(), point.point);
            }
        }
    }
}

impl Bin {
    /// Sorts the entries of a bin.
    fn sorted(entries: &mut [Entry], start: usize, end: usize) -> Self {
        let own = &mut entries[start..end];
        let is_across = own.len() <= CROWDED || is_better_across(own);
        if !is_across {
            own.iter_mut().for_each(|entry| *entry = entry.turned());
        }
        own.sort_unstable_by_key(|entry| entry.low);
        Self { start, is_across }
    }
}

/// Whether a sweep in the direction of `low` compares fewer pairs than one in the direction of `side_low`.
fn is_better_across(entries: &[Entry]) -> bool {
    let covered = |low: fn(&Entry) -> u32, high: fn(&Entry) -> u32| {
        let sum: u64 = entries.iter().map(|entry| u64::from(high(entry) - low(entry))).sum();
        let from = entries.iter().map(low).min().unwrap_or(0);
        let to = entries.iter().map(high).max().unwrap_or(0);
        sum as f64 / f64::from((to - from).max(1))
    };
    covered(|e| e.low, |e| e.high) <= covered(|e| e.side_low, |e| e.side_high)
}

/// The transform from grid points to coordinates of a strip: across it, and along it, in the direction of the bins.
struct StripFrame {
    low: GridPoint,
    columns: (i64, i64),
    shift: u32,
    /// The strip is longer in y than in x, in units of the mean segment.
    along_y: bool,
    bins: usize,
    /// Bins per grid step along the strip, times 2³².
    pitch: u64,
}

impl StripFrame {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an estimate of the number of bins, on which no result depends"
    )]
    fn new(segments: &[Segment], columns: (i64, i64)) -> Self {
        let mut low = GridPoint::new(i64::MAX, i64::MAX);
        let mut high = GridPoint::new(i64::MIN, i64::MIN);
        let mut covered = (0.0, 0.0);
        for e in segments {
            let (l, r) = (e.l.x.max(columns.0), e.r.x.min(columns.1));
            let (bottom, top) = (e.l.y.min(e.r.y), e.l.y.max(e.r.y));
            low = GridPoint::new(low.x.min(l), low.y.min(bottom));
            high = GridPoint::new(high.x.max(r), high.y.max(top));
            covered = (covered.0 + (r - l) as f64, covered.1 + (top - bottom) as f64);
        }
        if segments.is_empty() {
            (low, high) = (GridPoint::default(), GridPoint::default());
        }
        let range = ((high.x - low.x) as u64, (high.y - low.y) as u64);
        let along_y = covered.1 / (range.1.max(1) as f64) <= covered.0 / (range.0.max(1) as f64);
        let (length, covered) = if along_y { (range.1, covered.1) } else { (range.0, covered.0) };
        // Bins as high as a mean segment: then a segment is in two of them on average.
        let most = length as f64 * segments.len() as f64 / covered.max(1.0);
        let bins = (segments.len() / BIN).min(most as usize).max(1);
        let shift = (64 - range.0.max(range.1).leading_zeros()).saturating_sub(32);
        let steps = (length >> shift) + 1;
        Self { low, columns, shift, along_y, bins, pitch: ((bins as u64) << 32) / steps }
    }

    /// Coordinates across and along the strip.
    fn transform(&self, point: GridPoint) -> (u32, u32) {
        let x = self.short(point.x.clamp(self.columns.0, self.columns.1) - self.low.x);
        let y = self.short(point.y - self.low.y);
        if self.along_y { (x, y) } else { (y, x) }
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the shift makes it fit")]
    fn short(&self, offset: i64) -> u32 {
        (offset >> self.shift) as u32
    }

    fn entry(&self, segment: u32, e: &Segment) -> Entry {
        let (l, r) = (self.transform(e.l), self.transform(e.r));
        Entry { low: l.0.min(r.0), high: l.0.max(r.0), side_low: l.1.min(r.1), side_high: l.1.max(r.1), segment }
    }

    fn bin_of(&self, along: u32) -> usize {
        ((u64::from(along) * self.pitch) >> 32) as usize
    }

    fn bins_of(&self, entry: Entry) -> std::ops::RangeInclusive<usize> {
        self.bin_of(entry.side_low)..=self.bin_of(entry.side_high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    const COLUMNS: (i64, i64) = (-50, 50);

    /// Short segments, long ones along either axis, and slanted ones; all reach into the columns.
    fn segments(scale: i64) -> impl Strategy<Value = Vec<Segment>> {
        let segment =
            (-45..45i64, -400..400i64, 1..40i64, -9..9i64, 0..4usize).prop_map(move |(x, y, long, wide, kind)| {
                let (dx, dy) = match kind {
                    0 => (1 + wide.abs(), wide),
                    1 => (long, 0),
                    2 => (0, 8 * long),
                    _ => (long, 8 * wide),
                };
                let r = GridPoint::new(x + dx, (y + dy) * scale);
                Segment { l: GridPoint::new(x, y * scale), r, delta: [1, 0] }
            });
        prop::collection::vec(segment, 0..300)
    }

    fn bottom_and_top(e: &Segment) -> (i64, i64) {
        (e.l.y.min(e.r.y), e.l.y.max(e.r.y))
    }

    fn touch(a: &Segment, b: &Segment) -> bool {
        let ((a_low, a_high), (b_low, b_high)) = (bottom_and_top(a), bottom_and_top(b));
        let is_inside = a.l.x.max(b.l.x) <= COLUMNS.1;
        is_inside && a.l.x <= b.r.x && b.l.x <= a.r.x && a_low <= b_high && b_low <= a_high
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        #[test]
        fn segments_whose_boxes_touch_are_visited_once(segments in prop_oneof![segments(1), segments(1 << 25)]) {
            let mut met = BTreeMap::new();
            CandidateSearch::new(&segments, COLUMNS).for_each_pair(|a, b| *met.entry((a.min(b), a.max(b))).or_insert(0) += 1, || false);
            prop_assert!(met.values().all(|&times| times == 1));
            for (number, a) in (0u32..).zip(&segments) {
                for (other, b) in (0..number).zip(&segments) {
                    prop_assert!(!touch(a, b) || met.contains_key(&(other, number)), "{:?} and {:?}", a, b);
                }
            }
        }

        #[test]
        fn every_point_is_visited_for_the_segments_whose_box_has_it(segments in segments(1)) {
            let points: Vec<GridPoint> = segments.iter().flat_map(|e| [e.l, e.l]).collect();
            let mut passed = BTreeMap::new();
            CandidateSearch::new(&segments, COLUMNS).for_each_point(&points, |segment, p| *passed.entry((segment, p)).or_insert(0) += 1);
            prop_assert!(passed.values().all(|&times| times == 1));
            for (number, e) in (0u32..).zip(&segments) {
                let (low, high) = bottom_and_top(e);
                let is_on = |p: &&GridPoint| p.x >= e.l.x && p.x <= e.r.x && p.y >= low && p.y <= high;
                prop_assert!(points.iter().filter(is_on).all(|&p| passed.contains_key(&(number, p))), "{:?}", e);
            }
        }
    }

    #[test]
    fn a_crowded_bin_is_swept_in_its_better_direction() {
        let lines = |y: i64| {
            (0..300).map(move |i| Segment { l: GridPoint::new(0, y + i), r: GridPoint::new(40, y + i), delta: [1, 0] })
        };
        let far = Segment { l: GridPoint::new(0, 1_000_000), r: GridPoint::new(1, 1_000_000), delta: [1, 0] };
        let segments: Vec<Segment> = lines(0).chain([far]).collect();
        let search = CandidateSearch::new(&segments, COLUMNS);
        assert!(search.bins.iter().any(|bin| !bin.is_across));
        let mut pairs = 0;
        search.for_each_pair(|_, _| pairs += 1, || false);
        assert_eq!(pairs, 0);
    }
}
