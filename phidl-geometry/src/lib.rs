//! The shape library of phidl: every shape is a generator that is called like a function.
//!
//! | family | shapes |
//! |---|---|
//! | [`basic`] | [`rectangle`](fn@rectangle), [`bbox`](fn@bbox), [`straight`](fn@straight), [`cross`](fn@cross), [`circle`](fn@circle), [`ellipse`](fn@ellipse), [`ring`](fn@ring), [`arc`](fn@arc), [`turn`](fn@turn) |
//! | [`connect`] | [`compass`](fn@compass), [`flagpole`](fn@flagpole) |
//! | [`taper`](mod@taper) | [`taper`](fn@taper), [`ramp`](fn@ramp), [`hecken_taper`](fn@hecken_taper), [`meander_taper`](fn@meander_taper), [`Microstrip`] |
//! | [`nanowire`] | [`optimal_hairpin`](fn@optimal_hairpin), [`optimal_step`](fn@optimal_step), [`optimal_90deg`](fn@optimal_90deg), [`snspd`](fn@snspd), [`snspd_expanded`](fn@snspd_expanded), [`snspd_candelabra`](fn@snspd_candelabra), [`ytron_round`](fn@ytron_round) |
//! | [`photonic`] | [`grating`](fn@grating), [`racetrack_gradual`](fn@racetrack_gradual) |

pub mod basic;
pub mod connect;
pub mod nanowire;
pub mod photonic;
pub mod taper;
#[cfg(test)]
mod testing;

pub use basic::*;
pub use connect::*;
pub use nanowire::*;
pub use photonic::*;
pub use taper::*;
