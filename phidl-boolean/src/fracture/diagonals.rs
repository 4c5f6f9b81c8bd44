//! Diagonals that cut a polygon with holes into monotone mountains.
//!
//! A sweep from left to right cuts the inside into trapezoids by a vertical line through each corner. Each trapezoid has
//! one corner where it begins and one where it ends. The line between the two lies inside the trapezoid, so these diagonals
//! cross nothing (Fournier and Montuno 1984). The diagonal that ends at the leftmost corner of a hole connects the hole
//! with a ring further left, and over further holes with the outer ring. Those diagonals are the bridges.

use std::cmp::Ordering;

use super::corners::{Buckets, Corners};
use crate::point::{GridPoint, side};

/// A line inside a polygon between two of its corners, from the left one to the right one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Diagonal {
    pub(super) from: u32,
    pub(super) to: u32,
    /// Connects a hole with the outer ring; no part may reach over it.
    pub(super) is_bridge: bool,
}

/// An edge from left to right.
#[derive(Clone, Copy)]
struct Side {
    l: u32,
    r: u32,
    /// The polygon is above.
    is_floor: bool,
}

struct Sweep<'a> {
    corners: &'a Corners,
    sides: &'a [Side],
    /// For each floor: the corner where the trapezoid over it begins.
    begun: Vec<u32>,
    /// The sides over the current corner, from bottom to top.
    status: Vec<u32>,
    diagonals: Vec<Diagonal>,
}

/// All diagonals of one polygon, given as its outer ring (counter-clockwise) and its holes (clockwise).
pub(super) fn diagonals(corners: &Corners) -> Vec<Diagonal> {
    let sides: Vec<Side> = corners.rings().flat_map(ring_sides).collect();
    let mut by_left_end = Buckets::new(corners.len(), sides.iter().map(|side| side.l));
    by_left_end.sort_each(|a, b| {
        let (a, b) = (sides[a as usize], sides[b as usize]);
        side(corners.point(a.l), corners.point(b.r), corners.point(a.r))
    });
    let mut starts_hole = vec![false; corners.len()];
    corners.rings().skip(1).filter_map(|hole| hole.first()).for_each(|&first| starts_hole[first as usize] = true);

    let begun = sides.iter().map(|side| side.l).collect();
    let mut sweep = Sweep { corners, sides: &sides, begun, status: Vec::new(), diagonals: Vec::new() };
    for (corner, starts_hole) in (0u32..).zip(starts_hole) {
        sweep.visit(corner, by_left_end.of(corner), starts_hole);
    }
    sweep.diagonals
}

fn ring_sides(ring: &[u32]) -> impl Iterator<Item = Side> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| {
        let is_floor = a < b;
        let (l, r) = if is_floor { (a, b) } else { (b, a) };
        Side { l, r, is_floor }
    })
}

impl Sweep<'_> {
    fn visit(&mut self, corner: u32, beginning: &[u32], starts_hole: bool) {
        let at = self.corners.point(corner);
        let low = self.status.partition_point(|&s| self.is_below(self.sides[s as usize], corner, at));
        let ending = self.status[low..].iter().take_while(|&&s| self.sides[s as usize].r == corner).count();
        // The trapezoids that end here: over the floor below the corner, and over each floor that ends in it.
        for position in low.saturating_sub(1)..low + ending {
            self.end_trapezoid(position, corner, starts_hole);
        }
        if let Some(under) = low.checked_sub(1) {
            self.begun[self.status[under] as usize] = corner;
        }
        self.status.splice(low..low + ending, beginning.iter().copied());
    }

    /// A corner may also touch a side from outside, in its interior; a ceiling is then below the corner.
    fn is_below(&self, s: Side, corner: u32, at: GridPoint) -> bool {
        match side(self.corners.point(s.l), self.corners.point(s.r), at) {
            Ordering::Greater => true,
            Ordering::Equal => s.r != corner && !s.is_floor,
            Ordering::Less => false,
        }
    }

    fn end_trapezoid(&mut self, position: usize, corner: u32, is_bridge: bool) {
        let floor = self.status[position];
        let from = self.begun[floor as usize];
        // A trapezoid that began and ends on the same side has that side, not a diagonal, between its two corners.
        let is_side = |s: u32| self.sides[s as usize].l == from && self.sides[s as usize].r == corner;
        let is_diagonal = !is_side(floor) && !self.status.get(position + 1).is_some_and(|&above| is_side(above));
        if self.sides[floor as usize].is_floor && is_diagonal {
            self.diagonals.push(Diagonal { from, to: corner, is_bridge });
        }
    }
}
