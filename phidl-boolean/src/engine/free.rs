//! Contours that meet nothing: they need no snapping and no sweep of their own.
//!
//! A contour is *free* if no edge of another contour comes into its box, and if it is plain: it neither crosses nor
//! nearly touches itself. Snapping would leave each of its edges as it is, and bends of other edges stay in the boxes of
//! those edges. So all that is left to know is what lies around it, which is the same everywhere along it; the sweep of
//! the others is asked once. Fields of vias and dots are then hardly more work than copying them.
//!
//! Which contours are free is only a matter of speed: the result is the same, point for point, whatever is found here.
//! That is why the search may give up on crowded places and on contours with many corners.

use rayon::prelude::*;

use super::{Operand, plain::plain_outline, raster::untouched};
use crate::{
    contours::Contours,
    point::{GridPoint, signed_area2},
};

/// Contours handled by one parallel job.
const CONTOURS_PER_JOB: usize = 256;

/// The free contours of both operands.
pub(super) struct Free {
    /// Whether each contour is free; those of the second operand count on from the first.
    is_free: Vec<bool>,
    /// The free contours, cleaned, counter-clockwise, each from its leftmost point on; in the order of those points.
    pub(super) outlines: Contours,
    /// Operand of each outline, and how much the winding number grows on the way into it.
    steps: Vec<(usize, i32)>,
}

impl Free {
    pub(super) fn find(operands: &[Operand; 2]) -> Self {
        let contours: Vec<(&[GridPoint], usize)> =
            (0..2).flat_map(|index| operands[index].contours().iter().map(move |points| (points, index))).collect();
        let mut is_free = untouched(&contours);
        let jobs: Vec<usize> = (0..contours.len()).step_by(CONTOURS_PER_JOB).collect();
        let parts: Vec<Vec<(u32, Vec<GridPoint>)>> = jobs
            .into_par_iter()
            .map(|start| {
                let range = start..(start + CONTOURS_PER_JOB).min(contours.len());
                let plain = |contour: usize| {
                    #[expect(clippy::cast_possible_truncation, reason = "contours are fewer than MAX_EDGES")]
                    plain_outline(contours[contour].0).map(|outline| (contour as u32, outline))
                };
                range.filter(|&contour| is_free[contour]).filter_map(plain).collect()
            })
            .collect();
        let mut plain: Vec<(u32, Vec<GridPoint>)> = parts.concat();
        plain.par_sort_unstable_by_key(|(_, outline)| outline[0]);

        is_free.fill(false);
        let mut free = Self {
            is_free,
            outlines: Contours::with_capacity(plain.len(), plain.iter().map(|(_, outline)| outline.len()).sum()),
            steps: Vec::with_capacity(plain.len()),
        };
        for (contour, outline) in plain {
            let (points, operand) = contours[contour as usize];
            free.is_free[contour as usize] = true;
            free.outlines.push(outline);
            free.steps.push((operand, winding_step(operands[operand], points)));
        }
        free
    }

    /// No contour at all, for comparing.
    #[cfg(test)]
    pub(super) fn none(operands: &[Operand; 2]) -> Self {
        let contours = operands.iter().map(|operand| operand.contours().len()).sum();
        Self { is_free: vec![false; contours], outlines: Contours::new(), steps: Vec::new() }
    }

    /// Whether a contour is free.
    pub(super) fn contains(&self, contour: usize) -> bool {
        self.is_free[contour]
    }

    /// The winding numbers inside an outline whose surroundings have the given ones.
    pub(super) fn inside(&self, outline: usize, mut outside: [i32; 2]) -> [i32; 2] {
        let (operand, step) = self.steps[outline];
        outside[operand] += step;
        outside
    }

    /// The outlines that begin in some grid columns, by number.
    pub(super) fn in_columns(&self, (first, last): (i64, i64)) -> std::ops::Range<usize> {
        let begins_before = |x: i64, including: bool| {
            let (mut low, mut high) = (0, self.outlines.len());
            while low < high {
                let middle = low.midpoint(high);
                let at = self.begin(middle).x;
                if at < x || (including && at == x) { low = middle + 1 } else { high = middle }
            }
            low
        };
        begins_before(first, false)..begins_before(last, true)
    }

    /// The leftmost point of an outline.
    pub(super) fn begin(&self, outline: usize) -> GridPoint {
        self.outlines.get(outline).and_then(|points| points.first().copied()).unwrap_or_default()
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
