//! Devices into the layout model: what both writers share.
//!
//! | Module | What it decides |
//! |---|---|
//! | `distinct` | which devices are one cell of the file, and their order |
//! | `names` | the names of the cells |
//! | `outline` | rounding to the grid, corners without effect, cutting |
//! | `lattice` | which arrays a file can state |
//! | `limits` | sizes of texts and numbers |
//! | `convert` | one cell into a [`Cell`](super::Cell) of the model |

mod convert;
mod distinct;
mod lattice;
mod limits;
mod names;
mod outline;
mod split;
mod table;

pub(crate) use convert::{Converter, Rules};
pub(crate) use distinct::DistinctCells;
pub use distinct::MergeCells;
pub use limits::FileLimits;
pub(crate) use names::check as check_name;
pub use table::Content;
pub(crate) use table::{CellTable, Naming};

/// What happened to elements on the way into a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Changes {
    /// Polygons in the file.
    pub(crate) outlines: u64,
    /// Labels in the file.
    pub(crate) labels: u64,
    /// Polygons with too many corners, which are several outlines in the file.
    pub(crate) cut_polygons: u64,
    /// Polygons that enclose nothing on the grid, which are left out.
    pub(crate) collapsed_polygons: u64,
    /// Polygons from which repeated corners and there-and-back edges were taken out.
    pub(crate) cleaned_polygons: u64,
    /// Arrays whose elements are not a lattice on the grid, which are several references in the file.
    pub(crate) arrays_taken_apart: u64,
}
