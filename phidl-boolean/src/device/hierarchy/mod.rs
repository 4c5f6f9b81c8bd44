//! Results that keep the hierarchy ([`Hierarchy::Keep`](super::Hierarchy::Keep)).
//!
//! Repeated cells become cells of the result, referenced as arrays where their positions are regular. All other geometry is
//! drawn flat.
//!
//! # Interaction clusters
//!
//! Placements of both operands are opened from the top down. At each level, placements whose boxes are within the
//! interaction distance (which counts the reach of an offset with its joins) form an interaction cluster, and so does an
//! outline of the flat geometry that runs through such a box or encloses it. Two clusters are congruent if they have the
//! same cells at the same distances, mirrored, rotated and magnified alike, and if their shift is a whole number of grid
//! steps. Arrays of the same pitch are one cluster. A cluster without congruent ones, or near flat geometry, is opened: its
//! largest members are replaced by their content.
//!
//! Clusters between grid points are distinguished by their fraction of a step, so equal fractions repeat. A corner *at* a
//! half step rounds away from zero. So cells with such corners repeat on one side of zero only, and are drawn flat where
//! they lie across it; [`rounding`] decides this by the corners.
//!
//! Rejected: quarter turns of one result (snap rounding uses half-open pixels, which are not the same after a turn);
//! comparing the placed corners of all placements (as much work as a flat result in the case that matters).

mod cluster;
mod congruence;
mod lattice;
mod placement;
mod rounding;
mod solve;

use phidl_core::geom::Transform;
use phidl_core::layer::Layers;
use phidl_core::scene::DeviceBuilder;

use super::{operand::Operand, operation::DeviceOperation, options::Options};
use crate::{error::BooleanError, point::GridPoint};
use placement::{FlatGeometry, open_cell};
use solve::Solver;

/// Draws the result of an operation on two operands into an open cell. The cells that it references are named after it.
pub(super) fn draw(
    cell: &mut DeviceBuilder,
    operation: DeviceOperation,
    operands: &[Operand; 2],
    layers: &Layers,
    options: &Options,
) -> Result<(), BooleanError> {
    let grid = options.grid()?;
    // Bad options are refused even if nothing is left to do.
    operation.region(&Default::default(), &grid, &options.run)?;
    let (mut placements, mut flat) = (Vec::new(), FlatGeometry::default());
    for (side, operand) in operands.iter().enumerate() {
        open_cell(operand.cell(), side, &Transform::IDENTITY, &grid, &mut placements, &mut flat)?;
    }
    let name = cell.name().to_owned();
    options.run.on_threads(|| {
        // The threads are running already; the inner operations must not start their own.
        let mut inner = *options;
        inner.run.threads = None;
        Solver::new(operation, &name, layers, grid, &inner).draw(cell, placements, flat, GridPoint::default())
    })
}
