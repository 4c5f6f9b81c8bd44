//! Electrical test structures: vias, insulation, critical current, resistance.
//!
//! They have no ports: probes land on the pads. All positions follow from the parameters and not from drawn polygons, so
//! that leaving out a layer moves nothing.

mod block;
mod comb;
mod critical_current;
mod resistance;
mod via;

pub use comb::{TestCombParams, test_comb};
pub use critical_current::{TestIcParams, test_ic};
pub use resistance::{TestResParams, test_res};
pub use via::{TestViaParams, test_via};
