//! Where the plane is divided: vertical strips with about the same number of vertices each.
//!
//! Strips instead of square tiles, because the sweep then knows what lies below a strip: nothing. The sweep's list of
//! active edges is longer than a tile's would be, but a search in it is logarithmic.

use rayon::prelude::*;

use super::edge::Edge;
use crate::{jobs::per_job, options::Division};

/// Samples of x per strip from which the borders are chosen.
const SAMPLES_PER_STRIP: usize = 32;

/// Up to this many strips, for which an edge may be seen twice on average, are worth it to keep all threads busy.
const FEW_STRIPS: usize = 64;

/// With more strips than that, at most one edge in this many may be seen twice; otherwise the strips are made wider.
const SEEN_ONCE_PER_TWICE: usize = 6;

/// Strips of the plane and the edges that touch each.
///
/// The plan depends on the edges and the strip size alone, never on the threads.
pub(super) struct StripPlan {
    /// First grid column of each strip but the first, which begins at −∞.
    firsts: Vec<i64>,
    /// Numbers of the edges that touch each strip, ascending; strip `s` has `seen[starts[s]..starts[s + 1]]`.
    seen: Vec<u32>,
    starts: Vec<usize>,
    /// Numbers of the edges that touch more than one strip, ascending.
    long: Vec<u32>,
}

impl StripPlan {
    pub(super) fn new(edges: &[Edge], division: Division) -> Self {
        let mut strips = division.strips(edges.len());
        loop {
            let firsts = borders(edges, strips);
            let per_job = per_job(edges.len(), edges.len());
            let each = edges.par_iter().with_min_len(per_job);
            let ranges: Vec<(u32, u32)> = each.map(|edge| strip_range(&firsts, edge)).collect();
            let seen = ranges.par_iter().with_min_len(per_job).map(|&(first, last)| (last - first) as usize + 1);
            let sightings: usize = seen.sum();
            if firsts.is_empty() || sightings <= most_sightings(edges.len(), strips) {
                return Self::with_ranges(firsts, &ranges, sightings);
            }
            strips /= 2;
        }
    }

    /// Number of strips, at least one.
    pub(super) fn len(&self) -> usize {
        self.firsts.len() + 1
    }

    /// The strip that owns a grid column.
    pub(super) fn strip_of(&self, x: i64) -> usize {
        strip_of(&self.firsts, x)
    }

    /// First and last grid column of a strip.
    pub(super) fn columns(&self, strip: usize) -> (i64, i64) {
        let first = if strip == 0 { i64::MIN } else { self.firsts[strip - 1] };
        (first, self.firsts.get(strip).map_or(i64::MAX, |next| next - 1))
    }

    /// Numbers of the edges that touch a strip, ascending.
    pub(super) fn seen(&self, strip: usize) -> &[u32] {
        &self.seen[self.starts[strip]..self.starts[strip + 1]]
    }

    /// Numbers of the edges that touch more than one strip, ascending.
    pub(super) fn long_edges(&self) -> &[u32] {
        &self.long
    }

    fn with_ranges(firsts: Vec<i64>, ranges: &[(u32, u32)], sightings: usize) -> Self {
        let mut starts = vec![0; firsts.len() + 2];
        for &(first, last) in ranges {
            for strip in first..=last {
                starts[strip as usize + 1] += 1;
            }
        }
        for strip in 1..starts.len() {
            starts[strip] += starts[strip - 1];
        }
        let mut fill = starts.clone();
        let mut seen = vec![0; sightings];
        let mut long = Vec::new();
        for (number, &(first, last)) in (0u32..).zip(ranges) {
            for slot in &mut fill[first as usize..=last as usize] {
                seen[*slot] = number;
                *slot += 1;
            }
            if first < last {
                long.push(number);
            }
        }
        Self { firsts, seen, starts, long }
    }
}

fn most_sightings(edges: usize, strips: usize) -> usize {
    if strips <= FEW_STRIPS { 2 * edges } else { edges + edges / SEEN_ONCE_PER_TWICE }
}

/// Columns that divide a sample of the vertices evenly.
fn borders(edges: &[Edge], strips: usize) -> Vec<i64> {
    if strips < 2 {
        return Vec::new();
    }
    let stride = (edges.len() / (strips * SAMPLES_PER_STRIP)).max(1);
    let mut sample: Vec<i64> = edges.iter().step_by(stride).map(|edge| edge.l.x).collect();
    sample.par_sort_unstable();
    let mut firsts: Vec<i64> = (1..strips).map(|strip| sample[strip * sample.len() / strips]).collect();
    firsts.dedup();
    firsts
}

fn strip_of(firsts: &[i64], x: i64) -> usize {
    firsts.partition_point(|&first| first <= x)
}

#[expect(clippy::cast_possible_truncation, reason = "there are fewer strips than edges, and those fit a u32")]
fn strip_range(firsts: &[i64], edge: &Edge) -> (u32, u32) {
    (strip_of(firsts, edge.l.x) as u32, strip_of(firsts, edge.r.x) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::GridPoint;

    fn edge(x0: i64, x1: i64) -> Edge {
        Edge { l: GridPoint::new(x0, 0), r: GridPoint::new(x1, 1), delta: [1, 0] }
    }

    #[test]
    fn every_column_belongs_to_the_strip_that_claims_it() {
        let edges: Vec<_> = (0..100).map(|x| edge(x * 7 % 90, x * 7 % 90 + 3)).collect();
        let plan = StripPlan::new(&edges, Division::Vertices(10));
        assert!(plan.len() > 3);
        for strip in 0..plan.len() {
            let (first, last) = plan.columns(strip);
            assert_eq!((plan.strip_of(first), plan.strip_of(last)), (strip, strip));
        }
    }

    #[test]
    fn a_strip_sees_all_edges_that_touch_it_and_no_others() {
        let edges: Vec<_> = (0..100).map(|x| edge(x, x + 2)).collect();
        let plan = StripPlan::new(&edges, Division::Vertices(20));
        for strip in 0..plan.len() {
            let (first, last) = plan.columns(strip);
            let touching: Vec<u32> =
                (0u32..).zip(&edges).filter(|(_, e)| e.l.x <= last && e.r.x >= first).map(|(i, _)| i).collect();
            assert_eq!(plan.seen(strip), touching);
        }
    }

    #[test]
    fn long_edges_make_strips_wider_instead_of_filling_every_strip() {
        let edges: Vec<_> = (0..1000).map(|x| edge(x, x + 100_000)).collect();
        let plan = StripPlan::new(&edges, Division::Vertices(1));
        assert!((0..plan.len()).map(|strip| plan.seen(strip).len()).sum::<usize>() <= 2 * edges.len());
    }
}
