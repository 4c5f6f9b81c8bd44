//! Changes of width.

mod linear;

pub use linear::{TaperParams, taper};
