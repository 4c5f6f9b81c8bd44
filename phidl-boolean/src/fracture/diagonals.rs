//! Diagonals that cut a polygon with holes into monotone mountains.
//!
//! A sweep from left to right cuts the inside into trapezoids by a vertical line through each corner. Each trapezoid has
//! one corner where it begins and one where it ends. The line between the two lies inside the trapezoid, so these diagonals
//! cross nothing (Fournier and Montuno 1984). The diagonal that ends at the leftmost corner of a hole connects the hole
//! with a ring further left, and over further holes with the outer ring. Those diagonals are the bridges.

use std::cmp::Ordering;

use rayon::prelude::*;

use crate::point::{GridPoint, side};

/// A line inside a polygon between two of its corners, from the left one to the right one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Diagonal {
    pub(super) from: GridPoint,
    pub(super) to: GridPoint,
    /// Connects a hole with the outer ring; no part may reach over it.
    pub(super) is_bridge: bool,
}

/// An edge from left to right.
struct Side {
    l: GridPoint,
    r: GridPoint,
    /// The polygon is above.
    is_floor: bool,
}

impl Side {
    /// A corner may also touch a side from outside, in its interior; a ceiling is then below the corner.
    fn is_below(&self, corner: GridPoint) -> bool {
        match side(self.l, self.r, corner) {
            Ordering::Greater => true,
            Ordering::Equal => self.r != corner && !self.is_floor,
            Ordering::Less => false,
        }
    }
}

struct Sweep {
    sides: Vec<Side>,
    /// For each floor: the corner where the trapezoid over it begins.
    begun: Vec<GridPoint>,
    /// The sides over the current corner, from bottom to top.
    active: Vec<usize>,
    diagonals: Vec<Diagonal>,
}

/// All diagonals of one polygon, given as its outer ring (counter-clockwise) and its holes (clockwise).
pub(super) fn diagonals(outlines: &[&[GridPoint]]) -> Vec<Diagonal> {
    let mut sides: Vec<Side> = outlines.iter().flat_map(|outline| outline_sides(outline)).collect();
    sides.par_sort_unstable_by(|a, b| a.l.cmp(&b.l).then_with(|| side(a.l, b.r, a.r)));
    let mut corners: Vec<GridPoint> = outlines.concat();
    corners.par_sort_unstable();
    corners.dedup();
    let mut hole_starts: Vec<GridPoint> = outlines.iter().skip(1).filter_map(|hole| hole.first().copied()).collect();
    hole_starts.sort_unstable();

    let begun = sides.iter().map(|side| side.l).collect();
    let mut sweep = Sweep { sides, begun, active: Vec::new(), diagonals: Vec::new() };
    let mut first = 0;
    for corner in corners {
        let end = first + sweep.sides[first..].iter().take_while(|side| side.l == corner).count();
        sweep.visit(corner, first..end, hole_starts.binary_search(&corner).is_ok());
        first = end;
    }
    sweep.diagonals
}

fn outline_sides(outline: &[GridPoint]) -> impl Iterator<Item = Side> {
    outline.iter().zip(outline.iter().cycle().skip(1)).map(|(&a, &b)| {
        let is_floor = a < b;
        let (l, r) = if is_floor { (a, b) } else { (b, a) };
        Side { l, r, is_floor }
    })
}

impl Sweep {
    fn visit(&mut self, corner: GridPoint, beginning: std::ops::Range<usize>, starts_hole: bool) {
        let sides = &self.sides;
        let low = self.active.partition_point(|&s| sides[s].is_below(corner));
        let ending = self.active[low..].iter().take_while(|&&s| sides[s].r == corner).count();
        // The trapezoids that end here: over the floor below the corner, and over each floor that ends in it.
        for position in low.saturating_sub(1)..low + ending {
            self.end_trapezoid(position, corner, starts_hole);
        }
        if let Some(under) = low.checked_sub(1) {
            self.begun[self.active[under]] = corner;
        }
        self.active.splice(low..low + ending, beginning);
    }

    fn end_trapezoid(&mut self, position: usize, corner: GridPoint, is_bridge: bool) {
        let floor = self.active[position];
        let from = self.begun[floor];
        // A trapezoid that began and ends on the same side has that side, not a diagonal, between its two corners.
        let is_side = |s: usize| self.sides[s].l == from && self.sides[s].r == corner;
        let is_diagonal = !is_side(floor) && !self.active.get(position + 1).is_some_and(|&above| is_side(above));
        if self.sides[floor].is_floor && is_diagonal {
            self.diagonals.push(Diagonal { from, to: corner, is_bridge });
        }
    }
}
