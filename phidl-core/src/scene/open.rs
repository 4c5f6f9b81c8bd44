//! [`OpenCell`]: a cell with one owner, which can be edited.
//!
//! It is allocated at its final address, so that finishing a cell moves nothing: a cell is larger than most shapes that
//! are drawn in it.

use std::ops::{Deref, DerefMut};

use triomphe::UniqueArc;

use super::device::Finished;
use super::{Cell, Device};

/// The only owner of a cell.
pub(crate) struct OpenCell(UniqueArc<Finished>);

impl OpenCell {
    pub(crate) fn finish(self) -> Device {
        Device::of(self.0.shareable())
    }
}

impl From<Cell> for OpenCell {
    fn from(cell: Cell) -> Self {
        Self(UniqueArc::new(Finished::new(cell)))
    }
}

impl std::fmt::Debug for OpenCell {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Debug::fmt(&**self, f)
    }
}

impl Clone for OpenCell {
    fn clone(&self) -> Self {
        Cell::clone(self).into()
    }
}

impl Deref for OpenCell {
    type Target = Cell;

    fn deref(&self) -> &Cell {
        &self.0.cell
    }
}

impl DerefMut for OpenCell {
    fn deref_mut(&mut self) -> &mut Cell {
        &mut self.0.cell
    }
}
