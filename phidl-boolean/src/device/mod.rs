//! The operations on devices, in micrometers: round once, operate on the grid, and draw the result.
//!
//! An operand is anything that implements [`Shapes`]. It is gathered as a temporary cell that places the given devices. So
//! the scene graph handles hierarchies, arrays, mirrors and magnifications, and refuses shapes with bad coordinates.
//! Rejected: a traversal of every kind of shape, which would need each of these rules a second time.

mod area;
mod boolean;
mod convert;
mod draw;
mod frame;
mod hierarchy;
pub mod klayout;
mod margin;
mod offset;
mod operand;
mod operation;
mod options;
mod params;
mod shapes;

pub use area::{merged_area, merged_areas};
pub use boolean::{IntoOperation, boolean, union, union_by_layer, xor_diff};
pub use frame::OpenPorts;
pub use margin::Margin;
pub use offset::{invert, offset, outline};
pub use options::{Hierarchy, Options};
pub use shapes::Shapes;
