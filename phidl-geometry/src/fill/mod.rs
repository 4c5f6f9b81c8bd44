//! Dummy fill of empty area, for a uniform density of each layer.

mod avoided;
mod raster;
mod rectangle;

pub use rectangle::{AvoidLayers, FillRectangleParams, fill_rectangle};
