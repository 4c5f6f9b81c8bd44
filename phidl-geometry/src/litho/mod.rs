//! Marks that show what the lithography did: line widths, resolution, offset, lengths.

mod calipers;
mod ruler;
mod star;
mod steps;

pub use calipers::{LithoCalipersParams, litho_calipers};
pub use ruler::{LithoRulerParams, litho_ruler};
pub use star::{LithoStarParams, litho_star};
pub use steps::{LithoStepsParams, litho_steps};
