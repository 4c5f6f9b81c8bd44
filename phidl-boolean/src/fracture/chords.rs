//! Chords that cut a polygon with holes into mountains.
//!
//! A sweep from left to right cuts the inside into trapezoids by a vertical line through each corner. Each trapezoid has
//! one corner that began it and one that ends it; the line between the two lies inside the trapezoid, so these chords
//! cross nothing (Fournier and Montuno 1984). The chord that ends at the leftmost corner of a hole connects the hole
//! with something further left: followed from hole to hole, with the outline. Those chords are the seams.

use std::cmp::Ordering;

use rayon::prelude::*;

use crate::point::{GridPoint, side};

/// A line inside a polygon between two of its corners, from the left one to the right one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Chord {
    pub(super) from: GridPoint,
    pub(super) to: GridPoint,
    /// Connects a hole with the outline; no piece may reach over it.
    pub(super) is_seam: bool,
}

/// An edge from left to right.
struct Side {
    l: GridPoint,
    r: GridPoint,
    /// The polygon is above.
    is_floor: bool,
}

impl Side {
    /// A corner may also touch a side from outside, in the middle of it; a ceiling is then below the corner.
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
    /// For each floor: the corner that began the trapezoid over it.
    begun: Vec<GridPoint>,
    /// The sides over the present corner, from bottom to top.
    active: Vec<usize>,
    chords: Vec<Chord>,
}

/// All chords of one polygon, given as its outer outline (counter-clockwise) and its holes (clockwise).
pub(super) fn chords(outlines: &[&[GridPoint]]) -> Vec<Chord> {
    let mut sides: Vec<Side> = outlines.iter().flat_map(|outline| outline_sides(outline)).collect();
    sides.par_sort_unstable_by(|a, b| a.l.cmp(&b.l).then_with(|| side(a.l, b.r, a.r)));
    let mut corners: Vec<GridPoint> = outlines.concat();
    corners.par_sort_unstable();
    corners.dedup();
    let mut hole_starts: Vec<GridPoint> = outlines.iter().skip(1).filter_map(|hole| hole.first().copied()).collect();
    hole_starts.sort_unstable();

    let begun = sides.iter().map(|side| side.l).collect();
    let mut sweep = Sweep { sides, begun, active: Vec::new(), chords: Vec::new() };
    let mut first = 0;
    for corner in corners {
        let end = first + sweep.sides[first..].iter().take_while(|side| side.l == corner).count();
        sweep.visit(corner, first..end, hole_starts.binary_search(&corner).is_ok());
        first = end;
    }
    sweep.chords
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

    fn end_trapezoid(&mut self, position: usize, corner: GridPoint, is_seam: bool) {
        let floor = self.active[position];
        let from = self.begun[floor];
        // A trapezoid that began and ends on the same side has that side, not a chord, between its two corners.
        let is_side = |s: usize| self.sides[s].l == from && self.sides[s].r == corner;
        let is_chord = !is_side(floor) && !self.active.get(position + 1).is_some_and(|&above| is_side(above));
        if self.sides[floor].is_floor && is_chord {
            self.chords.push(Chord { from, to: corner, is_seam });
        }
    }
}
