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
//! | arranging | [`grid`](fn@grid), [`gridsweep`](fn@gridsweep), [`packer`](fn@packer), [`fill_rectangle`](fn@fill_rectangle) |
//! | copying, selecting | [`extract`](fn@extract), [`copy_layer`](fn@copy_layer), [`copy`](fn@copy), [`deepcopy`](fn@deepcopy), [`flatten`](fn@flatten) |
//! | exchanging | [`ports_to_geometry`](fn@ports_to_geometry), [`geometry_to_ports`](fn@geometry_to_ports), [`preview_layerset`](fn@preview_layerset) |
//!
//! Names, parameters, defaults, ports and drawn points are PHIDL's, so that a script and its mask carry over. Lengths
//! are micrometers, angles degrees counter-clockwise; nothing is rounded. A program that names no shape but builds some
//! by name links them with `use phidl_geometry as _;`.

pub mod arguments;
pub mod arrange;
pub mod basic;
pub mod connect;
pub mod fill;
pub mod select;
pub mod taper;

pub use arrange::{GridParams, GridsweepParams, PackerParams, grid, gridsweep, packer};
pub use basic::*;
pub use connect::{CompassParams, FlagpoleParams, compass, flagpole};
pub use fill::{FillRectangleParams, fill_rectangle};
pub use select::*;
pub use taper::*;
