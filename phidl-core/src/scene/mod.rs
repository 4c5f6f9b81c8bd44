//! The scene graph: open cells, finished cells, and what stands in them.
//!
//! A [`DeviceBuilder`] is the open cell and the only thing that can be edited; [`DeviceBuilder::build`] makes a
//! [`Device`] of it, which never changes again. A device can only refer to finished devices, so a cycle of cells cannot
//! be built, and what hangs below a cell (its box, its hash) can be remembered in it.

mod builder;
mod by_name;
mod cell;
mod device;
mod edit;
mod flatten;
mod group;
mod keys;
mod label;
mod map_cells;
mod open;
mod outlines;
#[cfg(feature = "parallel")]
mod parallel;
mod polygon;
mod reference;
mod selection;
mod source;
mod walk;

pub use builder::{Addable, DeviceBuilder};
pub use device::Device;
pub use edit::LayerTarget;
pub use group::{Element, Group};
pub use keys::{Key, LabelKey, PolygonKey, ReferenceKey};
pub use label::{Anchor, Label};
pub use outlines::PolygonView;
pub use polygon::{Polygon, Properties};
pub use reference::{Array, Reference};
pub use selection::Selection;
pub use source::Source;
pub use walk::{FlatPolygon, FlatPolygons, Instance, Instances};

pub(crate) use cell::Cell;
use open::OpenCell;
