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
//! | basic | [`rectangle`], [`bbox`], [`straight`]; [`cross`]; [`circle`], [`ellipse`]; [`ring`], [`arc`], [`turn`]; [`l`], [`c`] |
//! | connecting | [`compass`], [`compass_multi`], [`connector`], [`flagpole`], [`tee`], [`polygon_ports`] |
//! | tapers | [`taper`](fn@taper), [`ramp`], [`hecken_taper`], [`meander_taper`]; [`Microstrip`] |
//! | nanowires | [`optimal_hairpin`], [`optimal_step`], [`optimal_90deg`]; [`snspd`], [`snspd_expanded`], [`snspd_candelabra`]; [`ytron_round`] |
//! | photonics | [`grating`], [`racetrack_gradual`] |
//! | lithography | [`litho_steps`], [`litho_star`], [`litho_calipers`], [`litho_ruler`] |
//! | electrical tests | [`test_via`], [`test_comb`], [`test_ic`], [`test_res`] |
//! | dies | [`basic_die`] |
//! | arranging | [`grid`](fn@grid), [`gridsweep`](fn@gridsweep), [`packer`](fn@packer), [`fill_rectangle`](fn@fill_rectangle) |
//! | copying, selecting | [`extract`](fn@extract), [`copy_layer`](fn@copy_layer), [`copy`](fn@copy), [`deepcopy`](fn@deepcopy), [`flatten`](fn@flatten) |
//! | exchanging | [`ports_to_geometry`](fn@ports_to_geometry), [`geometry_to_ports`](fn@geometry_to_ports), [`preview_layerset`](fn@preview_layerset) |
//! | lettering | [`text`](fn@text) |
//! | set operations | [`boolean`](fn@boolean), [`offset`](fn@offset), [`outline`], [`invert`], [`xor_diff`], [`union`]; [`kl_boolean`], [`kl_offset`], [`kl_outline`], [`kl_invert`] |
//!
//! Names, parameters, defaults, ports and drawn points are PHIDL's, so that a script and its mask carry over. Lengths
//! are micrometers, angles degrees counter-clockwise; nothing is rounded. A program that names no shape but builds some
//! by name links them with `use phidl_geometry as _;`.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod arguments;
pub mod arrange;
pub mod basic;
pub mod boolean;
pub mod connect;
pub mod die;
pub mod fill;
pub mod litho;
pub mod nanowire;
pub mod photonic;
pub mod select;
pub mod taper;
pub mod test_structure;
#[cfg(test)]
mod testing;
pub mod text;

pub use arrange::{GridParams, GridsweepParams, PackerParams, grid, gridsweep, packer};
pub use basic::*;
pub use boolean::*;
pub use connect::{
    CompassMultiParams, CompassParams, ConnectorParams, FlagpoleParams, PolygonPortsParams, TeeParams, compass,
    compass_multi, connector, flagpole, polygon_ports, tee,
};
pub use die::{BasicDieParams, basic_die};
pub use fill::{FillRectangleParams, fill_rectangle};
pub use litho::*;
pub use nanowire::*;
pub use photonic::*;
pub use select::*;
pub use taper::*;
pub use test_structure::*;
pub use text::{TextParams, text};
