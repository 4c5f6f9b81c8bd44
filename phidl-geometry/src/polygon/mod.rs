//! Operations on one outline: [`Fillet`] rounds its corners, [`fractured`] cuts it into smaller ones.
//!
//! They take and return corners, so that the result can be drawn by `add_polygon` on any layer. Generators over whole cells
//! were rejected: a radius and a limit of points belong to single outlines, and the GDSII writer cuts large outlines anyway.

mod fillet;
mod fracture;

pub use fillet::{Fillet, filleted};
pub use fracture::fractured;
