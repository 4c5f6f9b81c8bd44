//! [`Work`]: an operation as the hierarchy needs it, with how far things can feel each other.

use phidl_core::num::grid::Grid;

use crate::{
    contours::Contours,
    device::{Options, offset::Frame},
    error::BooleanError,
    grid,
    offset::{Growth, Join},
    op::Operation,
    options::RunOptions,
    region::Region,
};

/// Between things that are farther apart than this (steps), rounding couples nothing: vertices move by half a step when
/// they are rounded, and edges by half a step when they bend; the rest is to spare.
const ROUNDING: f64 = 2.0;

/// What is done with the two sides.
#[derive(Debug, Clone, Copy)]
pub(super) enum Work {
    Combine(Operation),
    /// Side 0 is moved by a distance in steps.
    Offset(f64, Growth),
    /// Side 0 is framed, side 1 is what its ports keep open.
    Frame(Frame),
}

impl Work {
    /// How far around a shape (steps) others are told apart from it only by looking at both.
    pub(super) fn margin(&self, grid: &Grid) -> f64 {
        ROUNDING
            + match self {
                Self::Combine(_) => 0.0,
                Self::Offset(distance, growth) => distance.abs() * reach(growth.join),
                Self::Frame(frame) => grid.scaled(frame.distance).abs() * reach(frame.growth.join),
            }
    }

    /// Refuses bad options even where nothing is left to do.
    pub(super) fn check(&self, options: &Options) -> Result<(), BooleanError> {
        self.region(&Default::default(), &options.grid()?, &options.run).map(drop)
    }

    pub(super) fn region(&self, [a, b]: &[Contours; 2], grid: &Grid, run: &RunOptions) -> Result<Region, BooleanError> {
        match self {
            Self::Combine(operation) => grid::boolean(a, b, *operation, run),
            Self::Offset(distance, growth) => grid::offset(a, *distance, growth, run),
            Self::Frame(frame) => frame.region(a, b, grid, run),
        }
    }
}

/// The farthest that a join puts a point, in distances.
fn reach(join: Join) -> f64 {
    match join {
        Join::Miter { limit } => limit.max(std::f64::consts::SQRT_2),
        Join::Capped { extension } => extension.hypot(1.0),
        Join::Bevel => std::f64::consts::SQRT_2,
        Join::Round { .. } => 1.0,
    }
}
