//! [`StripPlan`]: vertical strips with about the same number of vertices each.
//!
//! Rejected: square tiles. Nothing lies below a strip, so a sweep needs no start values; below a tile there may be
//! anything. The status structure of a strip is longer than that of a tile, but a search in it is logarithmic.

use std::ops::Range;

use rayon::prelude::*;

use super::segment_set::SegmentSet;
use crate::{jobs::per_job, options::StripCount};

/// Samples of x per strip from which the seams are chosen.
const SAMPLES_PER_STRIP: usize = 32;

/// Up to this many strips, all threads are busy even if every segment is in two strips on average.
const FEW_STRIPS: usize = 64;

/// With more strips than that, at most one segment in this many may be in two strips; otherwise the strips become wider.
const ONCE_PER_TWICE: usize = 6;

/// Chunks of segments that are distributed to the strips by one job each, at most: each has a list of all strips.
const MOST_CHUNKS: usize = 64;

/// Strips of the plane and the segments that touch each.
///
/// The plan depends on the segments and the strip count alone, never on the threads.
pub(super) struct StripPlan {
    seams: Seams,
    /// Numbers of the segments that touch each strip, ascending.
    touching: Vec<Vec<u32>>,
}

impl StripPlan {
    pub(super) fn new(set: &SegmentSet, count: StripCount) -> Self {
        let mut strips = count.strips(set.len());
        loop {
            let seams = Seams::new(set, strips);
            let touched = seams.touched_by_all(set);
            let memberships: usize = touched.iter().flatten().map(|touched| touched.strips.len()).sum();
            if seams.strips() == 1 || memberships <= most_memberships(set.len(), strips) {
                return Self { touching: seams.distribute(touched), seams };
            }
            strips /= 2;
        }
    }

    /// Number of strips, at least one.
    pub(super) fn len(&self) -> usize {
        self.touching.len()
    }

    /// The strip that owns a grid column.
    pub(super) fn strip_of(&self, x: i64) -> usize {
        self.seams.strip_of(x)
    }

    /// First and last grid column of a strip.
    pub(super) fn columns(&self, strip: usize) -> (i64, i64) {
        self.seams.columns(strip)
    }

    /// Numbers of the segments that touch a strip, ascending.
    pub(super) fn touching(&self, strip: usize) -> &[u32] {
        &self.touching[strip]
    }
}

/// The largest accepted sum of the numbers of segments of all strips.
fn most_memberships(segments: usize, strips: usize) -> usize {
    if strips <= FEW_STRIPS { 2 * segments } else { segments + segments / ONCE_PER_TWICE }
}

/// First grid column of each strip but the first, which begins at −∞.
struct Seams(Vec<i64>);

impl Seams {
    /// Columns that divide a sample of the vertices evenly.
    fn new(set: &SegmentSet, strips: usize) -> Self {
        if strips < 2 {
            return Self(Vec::new());
        }
        let stride = (set.len() / (strips * SAMPLES_PER_STRIP)).max(1);
        let mut reader = set.reader();
        let mut sample: Vec<i64> =
            numbers(0..set.len()).step_by(stride).filter_map(|segment| Some(reader.columns(segment)?.0)).collect();
        sample.par_sort_unstable();
        let mut firsts: Vec<i64> =
            (1..strips).filter_map(|strip| sample.get(strip * sample.len() / strips).copied()).collect();
        firsts.dedup();
        Self(firsts)
    }

    fn strips(&self) -> usize {
        self.0.len() + 1
    }

    fn strip_of(&self, x: i64) -> usize {
        self.0.partition_point(|&first| first <= x)
    }

    fn columns(&self, strip: usize) -> (i64, i64) {
        let first = if strip == 0 { i64::MIN } else { self.0[strip - 1] };
        (first, self.0.get(strip).map_or(i64::MAX, |next| next - 1))
    }

    /// The strip of a column; fast if it is the strip `guess`.
    #[inline]
    fn strip_near(&self, x: i64, guess: usize) -> usize {
        let (first, last) = self.columns(guess);
        if first <= x && x <= last { guess } else { self.strip_of(x) }
    }

    /// The strips that the segments touch, by chunks of segments.
    fn touched_by_all(&self, set: &SegmentSet) -> Vec<Vec<Touched>> {
        let length = set.len().div_ceil(MOST_CHUNKS).max(per_job(set.len(), set.len()));
        let chunks = (0..set.len().div_ceil(length)).into_par_iter();
        chunks.map(|s| self.touched(set, s * length..((s + 1) * length).min(set.len()))).collect()
    }

    /// The strips that some segments touch. Consecutive segments are mostly in one strip.
    fn touched(&self, set: &SegmentSet, segments: Range<usize>) -> Vec<Touched> {
        let mut touched = Vec::with_capacity(segments.len());
        let (mut reader, mut first) = (set.reader(), 0);
        for segment in numbers(segments) {
            if let Some((left, right)) = reader.columns(segment) {
                first = self.strip_near(left, first);
                touched.push(Touched { segment, strips: number(first)..number(self.strip_near(right, first)) + 1 });
            }
        }
        touched
    }

    /// The segments of each strip.
    fn distribute(&self, touched: Vec<Vec<Touched>>) -> Vec<Vec<u32>> {
        let segments = touched.iter().map(Vec::len).sum();
        let chunks: Vec<Distributed> =
            touched.into_par_iter().map(|touched| Distributed::new(&touched, self.strips())).collect();
        let joined = |strip| {
            let mut all = Vec::with_capacity(chunks.iter().map(|chunk| chunk.of(strip).len()).sum());
            chunks.iter().for_each(|chunk| all.extend_from_slice(chunk.of(strip)));
            all
        };
        let strips = (0..self.strips()).into_par_iter();
        strips.with_min_len(per_job(self.strips(), segments)).map(joined).collect()
    }
}

/// A segment and the strips that it touches.
struct Touched {
    segment: u32,
    strips: Range<u32>,
}

/// A chunk of segments, distributed to the strips.
struct Distributed {
    /// Strip `s` has `segments[starts[s]..starts[s + 1]]`.
    starts: Vec<u32>,
    segments: Vec<u32>,
}

impl Distributed {
    fn new(touched: &[Touched], strips: usize) -> Self {
        let mut starts = vec![0; strips + 1];
        for Touched { strips, .. } in touched {
            strips.clone().for_each(|strip| starts[strip as usize + 1] += 1);
        }
        for strip in 0..strips {
            starts[strip + 1] += starts[strip];
        }
        let mut next = starts.clone();
        let mut segments = vec![0; starts[strips] as usize];
        for Touched { segment, strips } in touched {
            for strip in strips.clone() {
                let index = &mut next[strip as usize];
                segments[*index as usize] = *segment;
                *index += 1;
            }
        }
        Self { starts, segments }
    }

    fn of(&self, strip: usize) -> &[u32] {
        &self.segments[self.starts[strip] as usize..self.starts[strip + 1] as usize]
    }
}

/// The stored form of the number of a segment or a strip.
#[expect(clippy::cast_possible_truncation, reason = "segment numbers fit a u32, and strips are not more")]
fn number(index: usize) -> u32 {
    index as u32
}

fn numbers(segments: Range<usize>) -> Range<u32> {
    number(segments.start)..number(segments.end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{contours::Contours, engine::input::Operand, point::GridPoint};

    /// Plans for contours of two segments each, from `x0` to `x1` and back.
    fn with_plan(spans: impl Iterator<Item = (i64, i64)>, count: StripCount, test: impl Fn(&SegmentSet, &StripPlan)) {
        let there_and_back = |(x0, x1)| [GridPoint::new(x0, 0), GridPoint::new(x1, 1)];
        let contours: Contours = spans.map(there_and_back).collect();
        let operands = [Operand::Oriented(&contours), Operand::Oriented(&Contours::new())];
        let set = SegmentSet::new(&operands, |_| false).unwrap();
        test(&set, &StripPlan::new(&set, count));
    }

    #[test]
    fn every_column_belongs_to_the_strip_that_claims_it() {
        let spans = (0..50).map(|x| (x * 7 % 90, x * 7 % 90 + 3));
        with_plan(spans, StripCount::VerticesPerStrip(10), |_, plan| {
            assert!(plan.len() > 3);
            for strip in 0..plan.len() {
                let (first, last) = plan.columns(strip);
                assert_eq!((plan.strip_of(first), plan.strip_of(last)), (strip, strip));
            }
        });
    }

    #[test]
    fn a_strip_receives_exactly_the_segments_that_touch_it() {
        let spans = (0..3000).map(|x| (x % 700, x % 700 + 2)); // more than one chunk
        with_plan(spans, StripCount::VerticesPerStrip(200), |set, plan| {
            for strip in 0..plan.len() {
                let (first, last) = plan.columns(strip);
                let touches = |&number: &u32| set.segment(number).l.x <= last && set.segment(number).r.x >= first;
                let touching: Vec<u32> = numbers(0..set.len()).filter(touches).collect();
                assert_eq!(plan.touching(strip), touching);
            }
        });
    }

    #[test]
    fn long_segments_make_strips_wider_instead_of_filling_every_strip() {
        with_plan((0..500).map(|x| (x, x + 100_000)), StripCount::VerticesPerStrip(1), |set, plan| {
            assert!((0..plan.len()).map(|strip| plan.touching(strip).len()).sum::<usize>() <= 2 * set.len());
        });
    }

    #[test]
    fn no_strip_receives_the_segment_between_repeated_points() {
        let repeated: Contours = [[GridPoint::new(3, 0); 2].to_vec()].into_iter().collect();
        let operands = [Operand::Oriented(&repeated), Operand::Oriented(&repeated)];
        let set = SegmentSet::new(&operands, |_| false).unwrap();
        assert!(StripPlan::new(&set, StripCount::default()).touching(0).is_empty());
    }
}
