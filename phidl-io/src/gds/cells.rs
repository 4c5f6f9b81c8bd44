//! The cells of a file with their names.

use phidl_core::scene::Device;

use super::names;
use super::options::GdsOptions;
use crate::distinct::DistinctCells;
use crate::error::Result;

/// The different cells below a device, with the names that a file gives them.
#[derive(Debug)]
pub(crate) struct CellTable {
    cells: DistinctCells,
    names: Vec<String>,
}

impl CellTable {
    /// The cells of the file that is written of a device with these options.
    pub(crate) fn of(top: &Device, options: &GdsOptions) -> Result<Self> {
        options.check()?;
        let cells = DistinctCells::of(top);
        let names = names::unique_names(cells.as_slice(), options.top_name.as_deref(), options.max_cellname_length);
        Ok(Self { cells, names })
    }

    /// The cells with their names: children before parents, the top cell last.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = (&Device, &str)> {
        self.cells.as_slice().iter().zip(self.names.iter().map(String::as_str))
    }

    /// The name of the cell that a device of the hierarchy is written as.
    pub(crate) fn name_of(&self, device: &Device) -> &str {
        &self.names[self.cells.place_of(device)]
    }
}
