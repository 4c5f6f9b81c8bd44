//! Coordinates, boxes, outlines and the transforms of GDSII.

mod hull;
mod outline;
mod point;
mod rect;
mod simplify;
mod transform;

pub(crate) use hull::convex_hull;
pub use outline::{Outline, signed_area};
pub use point::{Point, Size};
pub use rect::Rect;
pub use simplify::simplified;
pub use transform::{Matrix, Transform};
