//! Photonic shapes.

mod grating;
mod racetrack;

pub use grating::{GratingParams, grating};
pub use racetrack::{RacetrackGradualParams, racetrack_gradual};
