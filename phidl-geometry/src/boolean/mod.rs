//! The boolean functions of phidl-boolean as generators, under PHIDL's names and with its parameters.
//!
//! | combine | resize | KLayout's names |
//! |---|---|---|
//! | [`boolean`](fn@boolean), [`union`], [`xor_diff`] | [`offset`](fn@offset), [`outline`], [`invert`] | [`kl_boolean`], [`kl_offset`], [`kl_outline`], [`kl_invert`] |
//!
//! As generators they are cached and can be built by name; their operands are devices. The functions of phidl-boolean also
//! take references, polygons and outlines, and have typed joins: here `tolerance` is the miter limit of one join and the
//! number of points of another.

mod combine;
mod klayout;
mod params;
mod resize;

pub use combine::*;
pub use klayout::*;
pub use params::{DeviceList, Divisions, JoinName, NumCpu};
pub use resize::*;
