//! The layout model: what a layout file holds, between its bytes and devices. GDSII and OASIS share it.
//!
//! ```text
//!         gds::decode_layout        to_device
//!   bytes ──────────────────▶ Layout ─────────▶ Device
//!         ◀──────────────────        ◀─────────
//!         gds::encode_layout       from_device
//! ```
//!
//! A [`Layout`] keeps what a [`Device`](phidl_core::scene::Device) has no counterpart for: paths as paths, boxes, nodes,
//! several top cells, dates, units, cells that are referenced and not defined. Coordinates are whole grid steps, 32 bits,
//! as both formats have them. Rounding, cutting and naming happen on the way from devices to the model and nowhere else;
//! cycles, missing cells and outlines of paths are resolved on the way back.
//!
//! Elements of one kind are one list per cell, and polygons are one flat buffer: a file of a million rectangles costs two
//! allocations. One list of an enum would keep the order across kinds, which no reader relies on, and cost twice the memory.

mod cell;
mod date;
mod element;
mod from_device;
mod names;
mod polygons;
mod problem;
mod to_device;

use phidl_core::num::grid::Grid;

pub use cell::Cell;
pub use date::Date;
pub use element::{BoxElement, Lattice, Node, Path, PathEnd, Placement, Text};
pub(crate) use from_device::{CellTable, Changes, Converter, DistinctCells, Naming, Rules, check_name};
pub use from_device::{Content, FileLimits, MergeCells};
pub use names::{CellId, CellNames};
pub use polygons::{PolygonRef, Polygons};
pub use problem::{Problem, ProblemKind, Problems};
#[cfg(feature = "oasis")]
pub(crate) use to_device::outlines;
pub(crate) use to_device::{choose, devices};

/// A point in grid steps.
pub type Corner = [i32; 2];

/// The content of a layout file.
#[derive(Debug, Clone)]
pub struct Layout {
    /// The name of the library. OASIS has none; it is empty then.
    pub name: String,
    /// The grid: one step is the database unit of the file.
    pub grid: Grid,
    /// The unit in which other programs show lengths (µm). Coordinates do not depend on it.
    pub user_unit: f64,
    /// The two numbers of UNITS as a GDSII file states them, so that they are written as they were read.
    pub gds_units: Option<[f64; 2]>,
    /// When the library was last modified, as the file states it.
    pub modified: Option<Date>,
    /// The names of all cells, of those that are only referenced as well.
    pub names: CellNames,
    /// The cells in the order of the file. No two have the same name.
    pub cells: Vec<Cell>,
    /// What the reader left out or read as something else.
    pub problems: Problems,
}

impl Layout {
    /// A layout without cells.
    #[must_use]
    pub fn new(grid: Grid) -> Self {
        Self {
            name: String::new(),
            grid,
            user_unit: 1.0,
            gds_units: None,
            modified: None,
            names: CellNames::default(),
            cells: Vec::new(),
            problems: Problems::default(),
        }
    }

    /// For each cell name, the index of its cell in [`Layout::cells`]; `None` for names that are only referenced.
    #[must_use]
    pub fn definitions(&self) -> Vec<Option<usize>> {
        let mut definitions = vec![None; self.names.len()];
        for (index, cell) in self.cells.iter().enumerate() {
            definitions[cell.name.index()] = Some(index);
        }
        definitions
    }

    /// The indices of the cells that no other cell places, in the order of the file.
    #[must_use]
    pub fn tops(&self) -> Vec<usize> {
        let mut placed = vec![false; self.names.len()];
        for placement in self.cells.iter().flat_map(|cell| &cell.placements) {
            placed[placement.child.index()] = true;
        }
        (0..self.cells.len()).filter(|cell| !placed[self.cells[*cell].name.index()]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_that_no_cell_places_are_the_top_cells() {
        let mut layout = Layout::new(Grid::new(1e-3).unwrap());
        let [a, b, missing] = ["a", "b", "missing"].map(|name| layout.names.intern(name));
        layout.cells = vec![Cell::new(a), Cell::new(b)];
        layout.cells[0].placements.extend([Placement::new(b), Placement::new(missing)]);
        assert_eq!(layout.tops(), [0]);
        assert_eq!(layout.definitions(), [Some(0), Some(1), None]);
    }
}
