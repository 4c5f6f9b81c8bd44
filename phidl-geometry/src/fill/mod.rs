//! Filling free area, so that every part of a layer is covered about alike.

mod raster;
mod rectangle;
mod region;

pub use rectangle::{AvoidLayers, FillRectangleParams, fill_rectangle};
