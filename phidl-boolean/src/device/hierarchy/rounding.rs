//! Which shifts of a cell round exactly like the cell itself.
//!
//! A shift by whole steps commutes with rounding, with two exceptions: halves round away from zero, so their direction
//! differs on the two sides of it; and doubles are inexact, so two positions are shifts of each other only up to their last
//! digits. [`Rounding`] measures how close a cell comes to either.

use std::collections::HashSet;

use phidl_core::geom::{Matrix, Transform};
use phidl_core::num::grid::Grid;
use phidl_core::scene::Device;

use super::placement::Placement;

/// The grid removes noise below half of 2⁻²⁰ of a step before it rounds.
const QUIET: f64 = 1.0 / 2_097_152.0;

/// Coordinates this close to a half step count as half steps, for all smaller noise.
const HALF: f64 = QUIET / 2.0;

/// Relative error of composed and applied transforms: some units in the last place.
const NOISE: f64 = 1.0 / 1_125_899_906_842_624.0;

/// Fractions of a step in which visited positions are remembered.
const PARTS: f64 = 16_777_216.0;

/// The distances of the coordinates of placed cells from half steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rounding {
    /// Distance of the other coordinates from where they would round differently (steps).
    clearance: f64,
    /// Whether there are coordinates at half steps, along each axis.
    has_halves: [bool; 2],
}

impl Rounding {
    /// Of all polygons of some placements; of arrays, the first elements.
    pub(super) fn of(placements: &[Placement], grid: &Grid) -> Self {
        let mut survey =
            Survey { grid, rounding: Self { clearance: 0.5, has_halves: [false; 2] }, seen: HashSet::new() };
        placements.iter().for_each(|placement| survey.visit(&placement.cell, &placement.transform));
        survey.rounding
    }

    /// Whether a shift with an error of `error` steps, of coordinates up to `reach`, rounds alike; `sides` are the sides of
    /// zero of the two positions.
    pub(super) fn allows(&self, error: f64, reach: f64, sides: [[i8; 2]; 2]) -> bool {
        let noise = error + reach * NOISE + 1.0 / PARTS;
        let keeps_halves =
            |axis: usize| sides[0][axis] == sides[1][axis] && sides[0][axis] != 0 && noise < QUIET - HALF;
        noise < self.clearance && (0..2).all(|axis| !self.has_halves[axis] || keeps_halves(axis))
    }

    fn add(&mut self, axis: usize, steps: f64) {
        let from_half = ((steps - steps.floor()) - 0.5).abs();
        if from_half <= HALF {
            self.has_halves[axis] = true;
        } else {
            self.clearance = self.clearance.min(from_half - QUIET);
        }
    }
}

/// A traversal that visits every cell once for each matrix and fraction of a step.
struct Survey<'a> {
    grid: &'a Grid,
    rounding: Rounding,
    seen: HashSet<(usize, [u64; 4], [i64; 2])>,
}

impl Survey<'_> {
    fn visit(&mut self, cell: &Device, transform: &Transform) {
        let matrix = transform.matrix();
        if !self.seen.insert((cell.ptr_id(), bits(&matrix), self.part(transform))) {
            return;
        }
        for point in cell.polygons().flat_map(|polygon| polygon.points) {
            let p = matrix.apply(*point);
            self.rounding.add(0, p.x / self.grid.step());
            self.rounding.add(1, p.y / self.grid.step());
        }
        for reference in cell.references() {
            reference.elements().for_each(|element| self.visit(reference.device(), &element.then(transform)));
        }
    }

    /// The position between grid points, in fractions of a step.
    #[expect(clippy::cast_possible_truncation, reason = "parts of one step")]
    fn part(&self, transform: &Transform) -> [i64; 2] {
        let part = |um: f64| ((um / self.grid.step()).rem_euclid(1.0) * PARTS).round() as i64;
        [part(transform.origin.x), part(transform.origin.y)]
    }
}

/// The identity of a matrix, without its shift.
fn bits(matrix: &Matrix) -> [u64; 4] {
    [matrix.a, matrix.b, matrix.c, matrix.d].map(f64::to_bits)
}
