//! Shapes whose point is their ports.

mod compass;
mod fillet;
mod flagpole;

pub use compass::{CompassParams, compass};
pub use fillet::filleted;
pub use flagpole::{FlagpoleParams, PoleShape, PoleTaper, flagpole};
