//! Electrical test structures: vias, insulation, critical current, resistance.
//!
//! They have no ports, like their models: probes land on the pads. All positions come from the parameters and never
//! from what is drawn, so that a structure with a layer left out keeps the rest in its place.

mod block;
mod comb;
mod critical_current;
mod resistance;
mod via;

pub use comb::{TestCombParams, test_comb};
pub use critical_current::{TestIcParams, test_ic};
pub use resistance::{TestResParams, test_res};
pub use via::{TestViaParams, test_via};
