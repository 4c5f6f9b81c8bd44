//! [`Operand`]: the shapes of one side of an operation, gathered in a cell.

use phidl_core::geom::Rect;
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::place::Bounded;
use phidl_core::port::Port;
use phidl_core::scene::{Device, LayerTarget, Reference};

use super::Shapes;
use crate::{
    error::BooleanError,
    grid::{Contours, snap_device},
    options::RunOptions,
};

/// Bytes per point of the shapes, before an operation begins.
const BYTES_PER_POINT: usize = 32;

/// The shapes of one operand.
pub(super) struct Operand {
    cell: Device,
}

impl Operand {
    /// Gathers shapes; errors name them `name`.
    pub(super) fn new(name: &str, shapes: &(impl Shapes + ?Sized)) -> Result<Self, BooleanError> {
        let mut cell = Device::builder(name);
        shapes.add_to(&mut cell)?;
        Ok(Self { cell: cell.build()? })
    }

    /// Refuses more flat points than the memory of an operation can hold, before they are gathered.
    ///
    /// # Errors
    /// [`BooleanError::Memory`] in the largest placed cell, or the error of a count that is too large for any memory.
    pub(super) fn check_size(&self, run: &RunOptions) -> Result<(), BooleanError> {
        let (_, points) = self.cell.flat_counts()?;
        if points.saturating_mul(BYTES_PER_POINT) <= run.memory_limit {
            return Ok(());
        }
        let source = BooleanError::Memory { edges: points, crossings: 0, limit: run.memory_limit };
        let size = |reference: &&Reference| reference.device().flat_counts().map_or(usize::MAX, |(_, points)| points);
        Err(match self.cell.references().iter().max_by_key(size) {
            Some(largest) => BooleanError::InCell { cell: largest.device().name().into(), source: Box::new(source) },
            None => source,
        })
    }

    /// All shapes, rounded to the grid.
    pub(super) fn contours(&self, grid: &Grid) -> Result<Contours, BooleanError> {
        snap_device(grid, &self.cell, None)
    }

    /// The shapes on one layer, rounded to the grid.
    pub(super) fn contours_on(&self, grid: &Grid, layer: Layer) -> Result<Contours, BooleanError> {
        snap_device(grid, &self.cell, Some(layer.into()))
    }

    /// The shapes on one layer, in the same hierarchy.
    pub(super) fn on_layer(&self, layer: Layer) -> Result<Self, BooleanError> {
        let mut cell = self.cell.edit();
        cell.keep_layers(layer, LayerTarget::All);
        Ok(Self { cell: cell.build()? })
    }

    /// The temporary cell that places all given shapes.
    pub(super) fn cell(&self) -> &Device {
        &self.cell
    }

    /// The layers with shapes, ascending.
    pub(super) fn layers(&self) -> Vec<Layer> {
        self.cell.layers()
    }

    /// The bounding box (µm).
    pub(super) fn bbox(&self) -> Option<Rect> {
        self.cell.bbox()
    }

    /// The ports of the given devices and references, without those of the cells below them.
    pub(super) fn ports(&self) -> Result<Vec<Port>, BooleanError> {
        Ok(self.cell.ports_recursive(Some(1))?)
    }

    /// The ports of the operand if it is a single device or reference.
    pub(super) fn ports_of_only_element(&self) -> Vec<Port> {
        let is_only = self.cell.polygons().len() == 0;
        match self.cell.references() {
            [reference] if is_only && reference.array().is_none() => reference.ports().collect(),
            _ => Vec::new(),
        }
    }
}
