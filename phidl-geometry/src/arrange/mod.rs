//! Arranging finished cells: in rows and columns, over swept parameters, or as densely as they fit.

mod cell_grid;
mod grid;
mod grid_cells;
mod gridsweep;
mod maxrects;
mod packer;
mod sweep;

pub use cell_grid::{EdgeX, EdgeY};
pub use grid::{GridParams, GridShape, grid};
pub use grid_cells::{GridCell, GridCells};
pub use gridsweep::{GridsweepParams, gridsweep};
pub use packer::{PackerParams, packer};
pub use sweep::Sweep;
