//! Basic shapes.

mod cross;
mod directions;
mod ellipse;
mod letters;
mod rectangle;
mod ring;
mod turn;

pub use cross::{CrossParams, cross};
pub use ellipse::{CircleParams, EllipseParams, circle, ellipse};
pub use letters::{CParams, LParams, c, l};
pub use rectangle::{BboxParams, Corners, RectangleParams, StraightParams, bbox, rectangle, straight};
pub use ring::{ArcParams, RingParams, arc, ring};
pub use turn::{TurnParams, turn};
