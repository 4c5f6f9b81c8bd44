//! [`Corners`]: the corners of a polygon, numbered from left to right.
//!
//! Rings touch in corners, so a corner may occur in several rings. All later steps compare numbers and count into buckets;
//! this is the only sort of points.

use rayon::prelude::*;

use crate::point::GridPoint;

/// The corners of a polygon and the rings as lists of their numbers.
pub(super) struct Corners {
    /// Ascending.
    points: Vec<GridPoint>,
    /// Numbers of the corners, ring after ring.
    rings: Vec<u32>,
    /// Ring `r` has `rings[ends[r - 1]..ends[r]]`.
    ends: Vec<u32>,
}

impl Corners {
    /// Numbers the corners of some rings.
    #[expect(clippy::cast_possible_truncation, reason = "a region has fewer than 2^31 points")]
    pub(super) fn new(rings: &[&[GridPoint]]) -> Self {
        let mut ends = Vec::with_capacity(rings.len());
        let mut all: Vec<(GridPoint, u32)> = Vec::with_capacity(rings.iter().map(|ring| ring.len()).sum());
        for ring in rings {
            let first = all.len() as u32;
            all.extend(ring.iter().copied().zip(first..));
            ends.push(all.len() as u32);
        }
        all.par_sort_unstable();
        let mut points: Vec<GridPoint> = Vec::with_capacity(all.len());
        let mut numbers = vec![0; all.len()];
        for (point, index) in all {
            if points.last() != Some(&point) {
                points.push(point);
            }
            numbers[index as usize] = points.len() as u32 - 1;
        }
        Self { points, rings: numbers, ends }
    }

    /// How many different corners there are.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// How many edges the rings have together.
    pub(super) fn edges(&self) -> usize {
        self.rings.len()
    }

    /// A corner by its number.
    #[inline]
    pub(super) fn point(&self, corner: u32) -> GridPoint {
        self.points[corner as usize]
    }

    /// The rings, as numbers of corners.
    pub(super) fn rings(&self) -> impl Iterator<Item = &[u32]> {
        let start = |ring: usize| if ring == 0 { 0 } else { self.ends[ring - 1] as usize };
        self.ends.iter().enumerate().map(move |(ring, &end)| &self.rings[start(ring)..end as usize])
    }
}

/// Numbers of items by the corner that each belongs to.
pub(super) struct Buckets {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Buckets {
    /// Distributes items, given the corner of each, to `corners` buckets.
    pub(super) fn new(corners: usize, items: impl Iterator<Item = u32> + Clone) -> Self {
        let mut starts = vec![0; corners + 1];
        items.clone().for_each(|corner| starts[corner as usize] += 1);
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut distributed = vec![0; sum as usize];
        for (item, corner) in (0u32..).zip(items) {
            starts[corner as usize] -= 1;
            distributed[starts[corner as usize] as usize] = item;
        }
        Self { starts, items: distributed }
    }

    /// Sorts the items of each bucket.
    pub(super) fn sort_each(&mut self, order: impl Fn(u32, u32) -> std::cmp::Ordering) {
        for range in self.starts.windows(2).filter(|range| range[1] - range[0] > 1) {
            self.items[range[0] as usize..range[1] as usize].sort_unstable_by(|&a, &b| order(a, b));
        }
    }

    /// The items of a corner.
    #[inline]
    pub(super) fn of(&self, corner: u32) -> &[u32] {
        &self.items[self.starts[corner as usize] as usize..self.starts[corner as usize + 1] as usize]
    }

    /// All items, bucket after bucket.
    pub(super) fn all(&self) -> &[u32] {
        &self.items
    }
}
