//! Arranging finished cells: in rows and columns, over swept parameters, or as densely as they fit.

mod device_list;
mod grid;
mod gridsweep;
mod lattice;
mod maxrects;
mod packer;
mod sweep;

pub use device_list::{DeviceList, Slot};
pub use grid::{GridParams, GridShape, grid};
pub use gridsweep::{GridsweepParams, gridsweep};
pub use lattice::{EdgeX, EdgeY};
pub use packer::{PackerParams, packer};
pub use sweep::Sweep;
