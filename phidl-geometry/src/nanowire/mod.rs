//! Superconducting nanowires: shapes without current crowding, and detectors made of them.

mod candelabra;
mod hairpin;
mod least;
mod right_angle;
mod snspd;
mod step;
mod ytron;

pub use candelabra::{Equalization, SnspdCandelabraParams, snspd_candelabra};
pub use hairpin::{OptimalHairpinParams, optimal_hairpin};
pub use right_angle::{Optimal90degParams, optimal_90deg};
pub use snspd::{SnspdExpandedParams, SnspdParams, snspd, snspd_expanded};
pub use step::{OptimalStepParams, optimal_step};
pub use ytron::{Arms, YtronRoundParams, ytron_round};
