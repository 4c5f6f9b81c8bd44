//! The faces into which diagonals divide a polygon.
//!
//! Each edge of a ring is a half-edge with the polygon on its left, each diagonal is two. Around a face, a half-edge is
//! followed by the next one clockwise from its twin. Half-edges are in buckets by their start, so no step needs a search.

use std::cmp::Ordering;

use super::{
    corners::{Buckets, Corners},
    diagonals::Diagonal,
};
use crate::point::side;

/// The half-edges of a polygon: the edges of its rings in order, then two for each diagonal, twins in pairs.
pub(super) struct HalfEdges<'a> {
    corners: &'a Corners,
    /// Start and end of each.
    ends: Vec<(u32, u32)>,
    /// Half-edges by start, and around it counter-clockwise.
    around: Buckets,
}

impl<'a> HalfEdges<'a> {
    pub(super) fn new<'d>(corners: &'a Corners, diagonals: impl Iterator<Item = &'d Diagonal> + Clone) -> Self {
        let mut ends = Vec::with_capacity(corners.edges() + 2 * diagonals.clone().count());
        for ring in corners.rings() {
            ends.extend(ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)));
        }
        ends.extend(diagonals.flat_map(|&Diagonal { from, to, .. }| [(from, to), (to, from)]));
        let mut around = Buckets::new(corners.len(), ends.iter().map(|&(from, _)| from));
        around.sort_each(|a, b| {
            let (from, a) = ends[a as usize];
            counter_clockwise(corners, from, a, ends[b as usize].1)
        });
        Self { corners, ends, around }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// Calls `visit` with the corners of each face, counter-clockwise, and the half-edges that start at them.
    pub(super) fn for_each_face(&self, mut visit: impl FnMut(&[u32], &[u32])) {
        let mut is_done = vec![false; self.len()];
        let (mut corners, mut halves) = (Vec::new(), Vec::new());
        for &first in self.around.all() {
            corners.clear();
            halves.clear();
            let mut half = first;
            while !is_done[half as usize] {
                is_done[half as usize] = true;
                corners.push(self.ends[half as usize].0);
                halves.push(half);
                half = self.following(half);
            }
            if !halves.is_empty() {
                visit(&corners, &halves);
            }
        }
    }

    /// The half-edge that follows around the same face.
    fn following(&self, half: u32) -> u32 {
        let (from, to) = self.ends[half as usize];
        let around = self.around.of(to);
        let is_before = |&other: &u32| counter_clockwise(self.corners, to, self.ends[other as usize].1, from).is_lt();
        let before = around.partition_point(is_before);
        around[before.checked_sub(1).unwrap_or(around.len() - 1)]
    }
}

/// Order of the directions from a corner to two others, counter-clockwise from straight down (excluded).
fn counter_clockwise(corners: &Corners, from: u32, a: u32, b: u32) -> Ordering {
    let leads_left = |to: u32| to < from;
    let angle = || side(corners.point(from), corners.point(b), corners.point(a));
    leads_left(a).cmp(&leads_left(b)).then_with(angle)
}
