//! The operations on devices, in micrometers: round once, operate on the grid, and draw the result.
//!
//! An operand is anything that implements [`Shapes`]. It is gathered as a cell of its own that places the devices it is
//! made of: hierarchies, arrays, mirrors and magnifications are then the scene graph's business, and so is refusing a
//! shape with a bad coordinate. The alternative, a walk of our own over every kind of shape, would need each of
//! these rules a second time.

mod area;
mod boolean;
mod convert;
pub mod hierarchy;
mod klayout;
mod offset;
mod operand;
mod options;
mod params;
mod shapes;

pub use area::{merged_area, merged_areas};
pub use boolean::{IntoOperation, boolean, union, union_by_layer, xor_diff};
pub use klayout::{KlOptions, kl_boolean, kl_invert, kl_offset, kl_outline};
pub use offset::{Border, OpenPorts, invert, offset, outline};
pub use options::Options;
pub use shapes::Shapes;
