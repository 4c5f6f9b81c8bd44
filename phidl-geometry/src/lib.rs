//! The shape library of phidl: every shape is a `#[device]` generator under PHIDL's name.
//!
//! ```
//! use phidl_core::prelude::*;
//! use phidl_geometry as pg;
//!
//! let ring = pg::ring(10, 0.5, 2.5, 1)?;                                 // an ordinary call, cached
//! let same = pg::RingParams { layer: 1.into(), ..Default::default() }.build()?; // by name and default
//! assert!(ring.same_cell(&same));
//! # Ok::<(), Error>(())
//! ```
//!
//! | family | shapes |
//! |---|---|
//! | basic | [`rectangle`], [`bbox`], [`straight`]; [`cross`]; [`circle`], [`ellipse`]; [`ring`], [`arc`] |
//! | connecting | [`compass`], [`flagpole`] |
//! | tapers | [`taper`](fn@taper) |
//! | set operations | [`boolean`](fn@boolean), [`offset`](fn@offset), [`outline`], [`invert`], [`xor_diff`], [`union`]; [`kl_boolean`], [`kl_offset`], [`kl_outline`], [`kl_invert`] |
//!
//! Names, parameters, defaults, ports and drawn points are PHIDL's, so that a script and its mask carry over. Lengths
//! are micrometers, angles degrees counter-clockwise; nothing is rounded. A program that names no shape but builds some
//! by name links them with `use phidl_geometry as _;`.

pub mod basic;
pub mod boolean;
pub mod connect;
pub mod taper;

pub use basic::*;
pub use boolean::*;
pub use connect::{CompassParams, FlagpoleParams, compass, flagpole};
pub use taper::*;
