//! Changes of width.

mod hecken;
mod linear;
mod meander;
mod microstrip;

pub use hecken::{HeckenTaperParams, hecken_taper};
pub use linear::{RampParams, TaperParams, ramp, taper};
pub use meander::{MeanderTaperParams, meander_taper};
pub use microstrip::Microstrip;
