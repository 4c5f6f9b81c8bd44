//! Which edges of a strip are near each other, and near which points?
//!
//! The boxes of the edges are entered into *bands* across the longer way of the strip, and each band is swept the other
//! way. So an edge is only compared with what is near it in both directions. (One sorted list for the whole strip
//! compares an edge with all that lies beside it, which was half of the time that snapping took.)
//!
//! Boxes are kept in 32 bits, relative to the strip, with the lowest bits left off where a strip is wider than that:
//! then boxes that touch still touch, and whoever is told of a pair looks closer anyway.

use super::edge::Edge;
use crate::point::GridPoint;

/// Edges per band that are aimed at; every edge costs a look at about half of its band at most.
const BAND: usize = 24;

/// Bands with more entries than this are swept in the better direction of their own.
const CROWDED: usize = 8 * BAND;

/// Marks an entry whose edge is also in the band before.
const ENTERED: u32 = 1 << 31;

/// The boxes of a strip's edges, by bands.
pub(super) struct Bands {
    frame: Frame,
    /// Entries of all bands; within a band in the order of `low`.
    entries: Vec<Entry>,
    bands: Vec<Band>,
}

#[derive(Clone, Copy)]
struct Band {
    start: usize,
    /// Swept across the strip like the others, not along it.
    is_across: bool,
}

/// A box of an edge in a band: `low` to `high` in the direction in which the band is swept.
#[derive(Clone, Copy, Default)]
struct Entry {
    low: u32,
    high: u32,
    side_low: u32,
    side_high: u32,
    /// Number of the edge, with [`ENTERED`].
    edge: u32,
}

impl Entry {
    fn turned(self) -> Self {
        Self { low: self.side_low, high: self.side_high, side_low: self.low, side_high: self.high, edge: self.edge }
    }

    fn number(self) -> u32 {
        self.edge & !ENTERED
    }
}

impl Bands {
    /// Enters edges, of which only what lies in some grid columns counts.
    pub(super) fn new(edges: &[Edge], columns: (i64, i64)) -> Self {
        let frame = Frame::new(edges, columns);
        let boxes: Vec<Entry> = (0u32..).zip(edges).map(|(edge, e)| frame.entry(edge, e)).collect();
        let mut starts = vec![0; frame.bands + 1];
        for b in &boxes {
            frame.bands_of(*b).for_each(|band| starts[band] += 1);
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut entries = vec![Entry::default(); total];
        // From the last, so that bands keep the order of the edges, which is mostly from left to right already.
        for b in boxes.iter().rev() {
            let first = frame.band_of(b.side_low);
            for band in frame.bands_of(*b) {
                let entered = if band > first { ENTERED } else { 0 };
                starts[band] -= 1;
                entries[starts[band]] = Entry { edge: b.edge | entered, ..*b };
            }
        }
        let bands = starts.windows(2).map(|range| Band::sorted(&mut entries, range[0], range[1]));
        let mut bands: Vec<Band> = bands.collect();
        bands.push(Band { start: total, is_across: true });
        Self { frame, entries, bands }
    }

    /// Calls `meet` once for each two edges whose boxes touch, and maybe for some more.
    pub(super) fn for_each_pair(&self, mut meet: impl FnMut(u32, u32)) {
        for range in self.bands.windows(2) {
            let entries = &self.entries[range[0].start..range[1].start];
            for (index, a) in entries.iter().enumerate() {
                for b in &entries[index + 1..] {
                    if b.low > a.high {
                        break;
                    }
                    let beside = (b.side_low <= a.side_high) & (b.side_high >= a.side_low);
                    // Two that come from the band before have met there.
                    if beside & (a.edge & b.edge & ENTERED == 0) {
                        meet(a.number(), b.number());
                    }
                }
            }
        }
    }

    /// Calls `pass` for each edge and each of the points in its box, and maybe for some more; once for equal points.
    pub(super) fn for_each_point(&self, points: &[GridPoint], mut pass: impl FnMut(u32, GridPoint)) {
        let mut placed: Vec<Placed> = points.iter().map(|&point| self.place(point)).collect();
        placed.sort_unstable_by_key(|p| (p.band_and_along, p.across));
        placed.dedup_by_key(|p| p.point);
        let mut rest = &placed[..];
        while let Some(first) = rest.first() {
            let band = first.band();
            let (own, others) = rest.split_at(rest.partition_point(|p| p.band() == band));
            rest = others;
            pass_band(&self.entries[self.bands[band].start..self.bands[band + 1].start], own, &mut pass);
        }
    }

    fn place(&self, point: GridPoint) -> Placed {
        let (across, along) = self.frame.place(point);
        let band = self.frame.band_of(along);
        let (low, side) = if self.bands[band].is_across { (across, along) } else { (along, across) };
        Placed { band_and_along: (band as u64) << 32 | u64::from(low), across: side, point }
    }
}

/// A point in its band.
struct Placed {
    /// The band, and the coordinate in the direction in which it is swept.
    band_and_along: u64,
    across: u32,
    point: GridPoint,
}

impl Placed {
    fn band(&self) -> usize {
        (self.band_and_along >> 32) as usize
    }

    #[expect(clippy::cast_possible_truncation, reason = "the lower half is the coordinate")]
    fn along(&self) -> u32 {
        self.band_and_along as u32
    }
}

/// Sweeps the points of a band and its entries, both in order.
fn pass_band(entries: &[Entry], points: &[Placed], pass: &mut impl FnMut(u32, GridPoint)) {
    let mut first = 0;
    for entry in entries {
        while first < points.len() && points[first].along() < entry.low {
            first += 1;
        }
        for point in points[first..].iter().take_while(|point| point.along() <= entry.high) {
            if (point.across >= entry.side_low) & (point.across <= entry.side_high) {
                pass(entry.number(), point.point);
            }
        }
    }
}

impl Band {
    /// The band with some of the entries, which it puts in order.
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

/// Whether a list in the order of `low` would hold fewer neighbors for each entry than one in that of `side_low`.
fn is_better_across(entries: &[Entry]) -> bool {
    let covered = |low: fn(&Entry) -> u32, high: fn(&Entry) -> u32| {
        let sum: u64 = entries.iter().map(|entry| u64::from(high(entry) - low(entry))).sum();
        let from = entries.iter().map(low).min().unwrap_or(0);
        let to = entries.iter().map(high).max().unwrap_or(0);
        sum as f64 / f64::from((to - from).max(1))
    };
    covered(|e| e.low, |e| e.high) <= covered(|e| e.side_low, |e| e.side_high)
}

/// How grid points become coordinates of a strip: across it, and along it, where the bands follow one another.
struct Frame {
    low: GridPoint,
    columns: (i64, i64),
    shift: u32,
    /// The strip is longer in y than in x, measured in edges.
    along_y: bool,
    bands: usize,
    /// Bands per step along the strip, times 2³².
    pitch: u64,
}

impl Frame {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an estimate of a good size; it only decides how fast we are"
    )]
    fn new(edges: &[Edge], columns: (i64, i64)) -> Self {
        let mut low = GridPoint::new(i64::MAX, i64::MAX);
        let mut high = GridPoint::new(i64::MIN, i64::MIN);
        let mut covered = (0.0, 0.0);
        for e in edges {
            let (l, r) = (e.l.x.max(columns.0), e.r.x.min(columns.1));
            let (bottom, top) = (e.l.y.min(e.r.y), e.l.y.max(e.r.y));
            low = GridPoint::new(low.x.min(l), low.y.min(bottom));
            high = GridPoint::new(high.x.max(r), high.y.max(top));
            covered = (covered.0 + (r - l) as f64, covered.1 + (top - bottom) as f64);
        }
        if edges.is_empty() {
            (low, high) = (GridPoint::default(), GridPoint::default());
        }
        let range = ((high.x - low.x) as u64, (high.y - low.y) as u64);
        let along_y = covered.1 / (range.1.max(1) as f64) <= covered.0 / (range.0.max(1) as f64);
        let (length, covered) = if along_y { (range.1, covered.1) } else { (range.0, covered.0) };
        // Bands as high as an edge: then an edge is in two of them on average.
        let most = length as f64 * edges.len() as f64 / covered.max(1.0);
        let bands = (edges.len() / BAND).min(most as usize).max(1);
        let shift = (64 - range.0.max(range.1).leading_zeros()).saturating_sub(32);
        let steps = (length >> shift) + 1;
        Self { low, columns, shift, along_y, bands, pitch: ((bands as u64) << 32) / steps }
    }

    /// Coordinates across and along the strip.
    fn place(&self, point: GridPoint) -> (u32, u32) {
        let x = self.short(point.x.clamp(self.columns.0, self.columns.1) - self.low.x);
        let y = self.short(point.y - self.low.y);
        if self.along_y { (x, y) } else { (y, x) }
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the shift makes it fit")]
    fn short(&self, offset: i64) -> u32 {
        (offset >> self.shift) as u32
    }

    fn entry(&self, edge: u32, e: &Edge) -> Entry {
        let (l, r) = (self.place(e.l), self.place(e.r));
        Entry { low: l.0.min(r.0), high: l.0.max(r.0), side_low: l.1.min(r.1), side_high: l.1.max(r.1), edge }
    }

    fn band_of(&self, along: u32) -> usize {
        ((u64::from(along) * self.pitch) >> 32) as usize
    }

    fn bands_of(&self, entry: Entry) -> std::ops::RangeInclusive<usize> {
        self.band_of(entry.side_low)..=self.band_of(entry.side_high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    const COLUMNS: (i64, i64) = (-50, 50);

    /// Short edges, long ones along either axis, and slanted ones, of which all reach into the columns.
    fn edges(scale: i64) -> impl Strategy<Value = Vec<Edge>> {
        let edge =
            (-45..45i64, -400..400i64, 1..40i64, -9..9i64, 0..4usize).prop_map(move |(x, y, long, wide, kind)| {
                let (dx, dy) = match kind {
                    0 => (1 + wide.abs(), wide),
                    1 => (long, 0),
                    2 => (0, 8 * long),
                    _ => (long, 8 * wide),
                };
                let r = GridPoint::new(x + dx, (y + dy) * scale);
                Edge { l: GridPoint::new(x, y * scale), r, delta: [1, 0] }
            });
        prop::collection::vec(edge, 0..300)
    }

    fn bottom_and_top(e: &Edge) -> (i64, i64) {
        (e.l.y.min(e.r.y), e.l.y.max(e.r.y))
    }

    fn touch(a: &Edge, b: &Edge) -> bool {
        let ((a_low, a_high), (b_low, b_high)) = (bottom_and_top(a), bottom_and_top(b));
        let is_inside = a.l.x.max(b.l.x) <= COLUMNS.1;
        is_inside && a.l.x <= b.r.x && b.l.x <= a.r.x && a_low <= b_high && b_low <= a_high
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        #[test]
        fn edges_whose_boxes_touch_meet_once(edges in prop_oneof![edges(1), edges(1 << 25)]) {
            let mut met = BTreeMap::new();
            Bands::new(&edges, COLUMNS).for_each_pair(|a, b| *met.entry((a.min(b), a.max(b))).or_insert(0) += 1);
            prop_assert!(met.values().all(|&times| times == 1));
            for (number, a) in (0u32..).zip(&edges) {
                for (other, b) in (0..number).zip(&edges) {
                    prop_assert!(!touch(a, b) || met.contains_key(&(other, number)), "{:?} and {:?}", a, b);
                }
            }
        }

        #[test]
        fn every_point_is_passed_to_the_edges_that_it_may_be_on(edges in edges(1)) {
            let points: Vec<GridPoint> = edges.iter().flat_map(|e| [e.l, e.l]).collect();
            let mut passed = BTreeMap::new();
            Bands::new(&edges, COLUMNS).for_each_point(&points, |edge, p| *passed.entry((edge, p)).or_insert(0) += 1);
            prop_assert!(passed.values().all(|&times| times == 1));
            for (number, e) in (0u32..).zip(&edges) {
                let (low, high) = bottom_and_top(e);
                let is_on = |p: &&GridPoint| p.x >= e.l.x && p.x <= e.r.x && p.y >= low && p.y <= high;
                prop_assert!(points.iter().filter(is_on).all(|&p| passed.contains_key(&(number, p))), "{:?}", e);
            }
        }
    }

    #[test]
    fn a_crowded_place_is_swept_in_its_better_direction() {
        let lines = |y: i64| {
            (0..300).map(move |i| Edge { l: GridPoint::new(0, y + i), r: GridPoint::new(40, y + i), delta: [1, 0] })
        };
        let far = Edge { l: GridPoint::new(0, 1_000_000), r: GridPoint::new(1, 1_000_000), delta: [1, 0] };
        let edges: Vec<Edge> = lines(0).chain([far]).collect();
        let bands = Bands::new(&edges, COLUMNS);
        assert!(bands.bands.iter().any(|band| !band.is_across));
        let mut pairs = 0;
        bands.for_each_pair(|_, _| pairs += 1);
        assert_eq!(pairs, 0);
    }
}
