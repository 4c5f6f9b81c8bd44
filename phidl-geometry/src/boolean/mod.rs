//! The boolean functions of phidl-boolean as generators, under PHIDL's names and with its parameters.
//!
//! | combine | resize | KLayout's names |
//! |---|---|---|
//! | [`boolean`](fn@boolean), [`union`], [`xor_diff`] | [`offset`](fn@offset), [`outline`], [`invert`] | [`kl_boolean`], [`kl_offset`], [`kl_outline`], [`kl_invert`] |
//!
//! As generators they are cached and can be built by name, and their operands are devices. phidl-boolean's own functions
//! take references, polygons and outlines too, and say what PHIDL's parameters only encode: `tolerance` is a miter limit
//! with one join and a number of points with another.

mod combine;
mod klayout;
mod params;
mod resize;

pub use combine::*;
pub use klayout::*;
pub use params::{Divisions, Elements, JoinName, NumCpu};
pub use resize::*;
