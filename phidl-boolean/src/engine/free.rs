//! Contours that meet nothing: they need no snapping and no sweep of their own.
//!
//! A contour is *free* if no edge of another contour comes into its box, and if it is plain: it neither crosses nor
//! nearly touches itself. Snapping would leave each of its edges as it is, and bends of other edges stay in the boxes of
//! those edges. So all that is left to know is what lies around it, which is the same everywhere along it; the sweep of
//! the others is asked once. Fields of vias and dots are then hardly more work than copying them.
//!
//! Which contours are free is only a matter of speed: the result is the same, point for point, whatever is found here.
//! That is why the search may give up on crowded places and on contours with many corners.

use std::ops::Range;

use rayon::prelude::*;

use super::{Operand, plain::plain_outline, raster::untouched};
use crate::{
    contours::Contours,
    point::{GridPoint, signed_area2},
};

/// Contours handled by one parallel job.
const CONTOURS_PER_JOB: usize = 256;

/// The free contours of both operands; their outlines are numbered in the order of their leftmost points.
pub(super) struct Free {
    /// Whether each contour is free; those of the second operand count on from the first.
    is_free: Vec<bool>,
    /// The free contours, cleaned, counter-clockwise, each from its leftmost point on; in the order of the contours.
    outlines: Contours,
    /// Operand of each of them, and how much the winding number grows on the way into it.
    steps: Vec<(usize, i32)>,
    /// The leftmost point of each outline, ascending, and its place in `outlines`.
    order: Vec<(GridPoint, u32)>,
}

/// What one job found: free contours by number, like [`Free`].
#[derive(Default)]
struct Found {
    numbers: Vec<usize>,
    outlines: Contours,
    steps: Vec<(usize, i32)>,
}

impl Free {
    pub(super) fn find(operands: &[Operand; 2]) -> Self {
        let contours: Vec<(&[GridPoint], usize)> =
            (0..2).flat_map(|index| operands[index].contours().iter().map(move |points| (points, index))).collect();
        let mut is_free = untouched(&contours);
        let jobs: Vec<usize> = (0..contours.len()).step_by(CONTOURS_PER_JOB).collect();
        let found: Vec<Found> = jobs
            .into_par_iter()
            .map(|start| {
                let (mut found, mut corners) = (Found::default(), Vec::new());
                for number in (start..(start + CONTOURS_PER_JOB).min(contours.len())).filter(|&n| is_free[n]) {
                    let (points, operand) = contours[number];
                    if plain_outline(points, &mut corners) {
                        found.numbers.push(number);
                        found.outlines.push(corners.iter().copied());
                        found.steps.push((operand, winding_step(operands[operand], points)));
                    }
                }
                found
            })
            .collect();

        is_free.fill(false);
        let count = |of: fn(&Contours) -> usize| found.iter().map(|part| of(&part.outlines)).sum();
        let outlines = Contours::with_capacity(count(Contours::len), count(Contours::point_count));
        let mut free = Self { is_free, outlines, steps: Vec::new(), order: Vec::new() };
        found.into_iter().for_each(|part| free.append(part));
        free.put_in_order();
        free
    }

    fn append(&mut self, part: Found) {
        part.numbers.into_iter().for_each(|number| self.is_free[number] = true);
        self.outlines.append(&part.outlines);
        self.steps.extend(part.steps);
    }

    fn put_in_order(&mut self) {
        let begins = self.outlines.iter().zip(0u32..);
        self.order = begins.filter_map(|(outline, place)| Some((*outline.first()?, place))).collect();
        self.order.par_sort_unstable();
    }

    /// No contour at all, for comparing.
    #[cfg(test)]
    pub(super) fn none(operands: &[Operand; 2]) -> Self {
        let contours = operands.iter().map(|operand| operand.contours().len()).sum();
        Self { is_free: vec![false; contours], outlines: Contours::new(), steps: Vec::new(), order: Vec::new() }
    }

    /// Whether a contour is free.
    pub(super) fn contains(&self, contour: usize) -> bool {
        self.is_free[contour]
    }

    /// The winding numbers inside an outline whose surroundings have the given ones.
    pub(super) fn inside(&self, outline: usize, mut outside: [i32; 2]) -> [i32; 2] {
        let (operand, step) = self.steps[self.order[outline].1 as usize];
        outside[operand] += step;
        outside
    }

    /// Number of outlines.
    pub(super) fn len(&self) -> usize {
        self.order.len()
    }

    /// The outlines that begin in some grid columns, by number.
    pub(super) fn in_columns(&self, (first, last): (i64, i64)) -> Range<usize> {
        let before = self.order.partition_point(|(begin, _)| begin.x < first);
        before..self.order.partition_point(|(begin, _)| begin.x <= last)
    }

    /// The leftmost point of an outline.
    pub(super) fn begin(&self, outline: usize) -> GridPoint {
        self.order[outline].0
    }

    /// The points of an outline.
    pub(super) fn outline(&self, outline: usize) -> &[GridPoint] {
        self.outlines.get(self.order[outline].1 as usize).unwrap_or_default()
    }
}

/// Drawn shapes cover what they enclose, however they run; others wind as they run.
fn winding_step(operand: Operand, points: &[GridPoint]) -> i32 {
    match operand {
        Operand::Drawn(_) => 1,
        Operand::Wound(_) => {
            if signed_area2(points) > 0 {
                1
            } else {
                -1
            }
        }
    }
}
