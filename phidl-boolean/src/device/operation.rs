//! [`DeviceOperation`]: what a function does with its two operands on the grid.

use phidl_core::num::grid::Grid;

use super::frame::Frame;
use crate::{
    contours::Contours,
    error::BooleanError,
    grid,
    offset::{Join, OffsetOptions},
    op::Operation,
    options::RunOptions,
    region::Region,
};

/// Shapes farther apart than this (steps) do not interact by rounding: vertices move by half a step when they are rounded,
/// and segments by half a step when they are snapped; the rest is a safety margin.
const ROUNDING: f64 = 2.0;

/// An operation on the contours of two operands.
#[derive(Debug, Clone, Copy)]
pub(super) enum DeviceOperation {
    Combine(Operation),
    /// Operand 0 is offset by a distance in steps.
    Offset(f64, OffsetOptions),
    /// Operand 0 is framed, operand 1 is the openings at its ports.
    Frame(Frame),
}

impl DeviceOperation {
    /// The interaction distance (steps): shapes farther apart do not influence each other's result.
    pub(super) fn interaction_distance(&self, grid: &Grid) -> f64 {
        ROUNDING
            + match self {
                Self::Combine(_) => 0.0,
                Self::Offset(distance, options) => distance.abs() * reach(options.join),
                Self::Frame(frame) => grid.scaled(frame.distance).abs() * reach(frame.options.join),
            }
    }

    /// The result for some operands.
    pub(super) fn region(&self, [a, b]: &[Contours; 2], grid: &Grid, run: &RunOptions) -> Result<Region, BooleanError> {
        match self {
            Self::Combine(operation) => grid::boolean(a, b, *operation, run),
            Self::Offset(distance, options) => grid::offset(a, *distance, options, run),
            Self::Frame(frame) => frame.region(a, b, grid, run),
        }
    }
}

/// The largest distance of a join from its corner, in offset distances.
fn reach(join: Join) -> f64 {
    match join {
        Join::Miter { limit } => limit.max(std::f64::consts::SQRT_2),
        Join::Extended { extension } => extension.hypot(1.0),
        Join::Bevel => std::f64::consts::SQRT_2,
        Join::Round { .. } => 1.0,
    }
}
