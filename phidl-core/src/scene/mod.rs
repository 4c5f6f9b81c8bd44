//! The scene graph: open cells, finished cells, and their elements.
//!
//! A [`DeviceBuilder`] is the open cell, the only one that can be edited; [`DeviceBuilder::build`] turns it into a
//! [`Device`], which never changes again. A device can only refer to finished devices. So a cycle of cells cannot be
//! built, and properties of a hierarchy (its bounding box, its hash) can be cached in its top cell.

mod addable;
mod aliases;
mod builder;
mod cell;
mod cell_id;
mod device;
mod edit;
mod elements;
mod extent;
mod flat_counts;
mod flatten;
mod geo;
mod group;
mod key_space;
mod keys;
mod label;
mod leaves_first;
mod map_cells;
mod named_list;
mod open;
#[cfg(feature = "parallel")]
mod parallel;
mod placing;
mod polygon;
mod polygon_store;
mod port_mut;
mod ports;
mod queries;
mod reference;
mod selection;
mod source;
mod target;
mod walk;

pub use addable::Addable;
pub use builder::DeviceBuilder;
pub use device::Device;
pub use edit::LayerTarget;
pub use extent::ExtentError;
pub use flat_counts::FLAT_LIMIT;
pub use group::{Element, Group};
pub use keys::{Key, LabelKey, PolygonKey, ReferenceKey};
pub use label::{Anchor, Label, TextStyle};
pub use polygon::{Polygon, Properties};
pub use polygon_store::PolygonView;
pub use port_mut::PortMut;
pub use reference::{Array, Reference};
pub use selection::Selection;
pub use source::Source;
pub use target::{PortTarget, ReferenceTarget, Target};
pub use walk::{FlatPolygon, FlatPolygons, Instance, Instances};

pub(crate) use cell::Cell;
use open::OpenCell;
