//! [`IsolatedPolygons`]: contours that take no part in snapping and sweeping.
//!
//! A contour is *isolated* if no edge of another contour comes into its bounding box and if it is a [simple polygon](simple).
//! Snap rounding leaves each of its edges as it is, since chains of other segments stay in the bounding boxes of those
//! segments. What surrounds it is the same everywhere along it, so the sweep of the others answers one query point. Fields
//! of vias and dots then cost little more than a copy.
//!
//! The set found here decides only the speed: results are the same, point for point, for every subset. So the search may
//! give up in crowded cells and on contours with many corners.

mod grid_index;
mod simple;

use std::ops::Range;

use rayon::prelude::*;

use grid_index::without_neighbors;
use simple::simple_polygon;

use super::input::Operand;
use crate::{
    contours::Contours,
    point::{GridPoint, signed_area2},
};

/// Contours handled by one parallel job.
const CONTOURS_PER_JOB: usize = 256;

/// The isolated contours of both operands as polygons, numbered in the order of their leftmost points.
pub(super) struct IsolatedPolygons {
    /// Whether each contour is isolated; indices of the second operand follow those of the first.
    is_isolated: Vec<bool>,
    /// The isolated contours without repeated points, counter-clockwise, each from its leftmost point on; in the order of
    /// the contours.
    polygons: Contours,
    /// Operand and winding delta of each polygon, from outside to inside.
    steps: Vec<(usize, i32)>,
    /// The leftmost point of each polygon, ascending, and its index in `polygons`.
    order: Vec<(GridPoint, u32)>,
}

/// The isolated contours that one job found, by number.
#[derive(Default)]
struct Found {
    numbers: Vec<usize>,
    polygons: Contours,
    steps: Vec<(usize, i32)>,
}

impl IsolatedPolygons {
    pub(super) fn find(operands: &[Operand; 2]) -> Self {
        let contours: Vec<(&[GridPoint], usize)> =
            (0..2).flat_map(|index| operands[index].contours().iter().map(move |points| (points, index))).collect();
        let mut is_isolated = without_neighbors(&contours);
        let jobs: Vec<usize> = (0..contours.len()).step_by(CONTOURS_PER_JOB).collect();
        let found: Vec<Found> = jobs
            .into_par_iter()
            .map(|start| {
                let (mut found, mut corners) = (Found::default(), Vec::new());
                for number in (start..(start + CONTOURS_PER_JOB).min(contours.len())).filter(|&n| is_isolated[n]) {
                    let (points, operand) = contours[number];
                    if simple_polygon(points, &mut corners) {
                        found.numbers.push(number);
                        found.polygons.push(corners.iter().copied());
                        found.steps.push((operand, winding_step(operands[operand], points)));
                    }
                }
                found
            })
            .collect();

        is_isolated.fill(false);
        let count = |of: fn(&Contours) -> usize| found.iter().map(|part| of(&part.polygons)).sum();
        let polygons = Contours::with_capacity(count(Contours::len), count(Contours::point_count));
        let mut all = Self { is_isolated, polygons, steps: Vec::new(), order: Vec::new() };
        found.into_iter().for_each(|part| all.append(part));
        all.sort();
        all
    }

    fn append(&mut self, part: Found) {
        part.numbers.into_iter().for_each(|number| self.is_isolated[number] = true);
        self.polygons.append(&part.polygons);
        self.steps.extend(part.steps);
    }

    fn sort(&mut self) {
        let begins = self.polygons.iter().zip(0u32..);
        self.order = begins.filter_map(|(polygon, index)| Some((*polygon.first()?, index))).collect();
        self.order.par_sort_unstable();
    }

    /// No contour at all, for comparison.
    #[cfg(test)]
    pub(super) fn none(operands: &[Operand; 2]) -> Self {
        let contours = operands.iter().map(|operand| operand.contours().len()).sum();
        Self { is_isolated: vec![false; contours], polygons: Contours::new(), steps: Vec::new(), order: Vec::new() }
    }

    /// Whether a contour is isolated.
    pub(super) fn contains(&self, contour: usize) -> bool {
        self.is_isolated[contour]
    }

    /// The winding numbers inside a polygon from those outside.
    pub(super) fn inside(&self, polygon: usize, mut outside: [i32; 2]) -> [i32; 2] {
        let (operand, step) = self.steps[self.order[polygon].1 as usize];
        outside[operand] += step;
        outside
    }

    /// Number of polygons.
    pub(super) fn len(&self) -> usize {
        self.order.len()
    }

    /// Numbers of the polygons whose leftmost points are in some grid columns.
    pub(super) fn in_columns(&self, (first, last): (i64, i64)) -> Range<usize> {
        let before = self.order.partition_point(|(begin, _)| begin.x < first);
        before..self.order.partition_point(|(begin, _)| begin.x <= last)
    }

    /// The leftmost point of a polygon.
    pub(super) fn begin(&self, polygon: usize) -> GridPoint {
        self.order[polygon].0
    }

    /// The points of a polygon.
    pub(super) fn polygon(&self, polygon: usize) -> &[GridPoint] {
        self.polygons.get(self.order[polygon].1 as usize).unwrap_or_default()
    }
}

/// Shapes cover what they enclose in any direction; oriented contours wind in theirs.
fn winding_step(operand: Operand, points: &[GridPoint]) -> i32 {
    match operand {
        Operand::Shapes(_) => 1,
        Operand::Oriented(_) => {
            if signed_area2(points) > 0 {
                1
            } else {
                -1
            }
        }
    }
}
