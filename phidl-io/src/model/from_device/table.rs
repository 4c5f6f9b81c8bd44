//! [`CellTable`]: the cells of a file with their names.

use phidl_core::scene::Device;

use super::distinct::{DistinctCells, MergeCells};
use super::limits::FileLimits;
use super::names;
use crate::model::{CellId, CellNames};

/// What is written into a file: one top device, or several.
#[derive(Debug, Clone, Copy)]
pub struct Content<'a>(&'a [Device]);

impl<'a> Content<'a> {
    /// The top devices, in the order of the file.
    #[must_use]
    pub fn tops(&self) -> &'a [Device] {
        self.0
    }
}

impl<'a> From<&'a Device> for Content<'a> {
    fn from(top: &'a Device) -> Self {
        Self(std::slice::from_ref(top))
    }
}

impl<'a> From<&'a [Device]> for Content<'a> {
    fn from(tops: &'a [Device]) -> Self {
        Self(tops)
    }
}

impl<'a> From<&'a Vec<Device>> for Content<'a> {
    fn from(tops: &'a Vec<Device>) -> Self {
        Self(tops)
    }
}

/// How the cells of a file are chosen and named.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Naming<'a> {
    /// The name of the top cell, if it is not the device's own. It counts for a single top cell.
    pub(crate) top_name: Option<&'a str>,
    /// The longest name that is made up.
    pub(crate) max_cellname_length: usize,
    pub(crate) limits: &'a FileLimits,
    pub(crate) merge: MergeCells,
}

/// The distinct cells below some devices, with the names that a file gives them.
#[derive(Debug)]
pub(crate) struct CellTable {
    cells: DistinctCells,
    names: CellNames,
}

impl CellTable {
    /// The cells of the file that is written of these devices.
    pub(crate) fn of(content: Content<'_>, naming: &Naming<'_>) -> Self {
        let cells = DistinctCells::of(content.tops(), naming.merge);
        let mut names = CellNames::default();
        // All names differ, so the number of a name is the index of its cell.
        for name in names::unique_names(cells.as_slice(), content.tops().len(), naming) {
            names.intern(&name);
        }
        Self { cells, names }
    }

    /// The cells with their names: children before parents, the top cells last.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = (&Device, &str)> {
        self.cells.as_slice().iter().map(|cell| (cell, self.name_of(cell)))
    }

    /// All names.
    pub(crate) fn names(&self) -> &CellNames {
        &self.names
    }

    /// The number of the name of a device of the hierarchy.
    pub(crate) fn id_of(&self, device: &Device) -> CellId {
        self.names.id(self.cells.index_of(device))
    }

    /// The name of the cell that a device of the hierarchy is written as.
    pub(crate) fn name_of(&self, device: &Device) -> &str {
        self.names.name(self.id_of(device))
    }
}
