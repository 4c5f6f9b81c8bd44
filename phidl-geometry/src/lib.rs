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
//! Names, parameters, defaults, ports and drawn points are PHIDL's, so that a script and its mask carry over; deliberate
//! differences are listed in the project's `docs/differences.md`. Lengths are micrometers, angles degrees
//! counter-clockwise; generators never round. [`polygon`] rounds and cuts single outlines, [`Microstrip`] relates widths
//! and impedances. The feature `fonts` (on by default) lets [`text`](fn@text) use fonts from files and of the system.
//!
//! ## Basic shapes
//!
//! [`rectangle`](fn@rectangle), [`bbox`](fn@bbox), [`straight`](fn@straight), [`cross`](fn@cross),
//! [`circle`](fn@circle), [`ellipse`](fn@ellipse), [`ring`](fn@ring), [`arc`](fn@arc), [`turn`](fn@turn),
//! [`l`](fn@l), [`c`](fn@c).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/rectangle.svg"),
    include_str!("../docs/bbox.svg"),
    include_str!("../docs/straight.svg"),
    include_str!("../docs/cross.svg"),
    include_str!("../docs/circle.svg"),
    include_str!("../docs/ellipse.svg"),
    include_str!("../docs/ring.svg"),
    include_str!("../docs/arc.svg"),
    include_str!("../docs/turn.svg"),
    include_str!("../docs/L.svg"),
    include_str!("../docs/C.svg"),
    "</div>\n"
)]
//!
//! ## Pads, branches and adapters
//!
//! [`compass`](fn@compass), [`compass_multi`](fn@compass_multi), [`connector`](fn@connector),
//! [`flagpole`](fn@flagpole), [`tee`](fn@tee), [`polygon_ports`](fn@polygon_ports).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/compass.svg"),
    include_str!("../docs/compass_multi.svg"),
    include_str!("../docs/connector.svg"),
    include_str!("../docs/flagpole.svg"),
    include_str!("../docs/tee.svg"),
    include_str!("../docs/polygon_ports.svg"),
    "</div>\n"
)]
//!
//! ## Tapers
//!
//! [`taper`](fn@taper), [`ramp`](fn@ramp), [`hecken_taper`](fn@hecken_taper), [`meander_taper`](fn@meander_taper).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/taper.svg"),
    include_str!("../docs/ramp.svg"),
    include_str!("../docs/hecken_taper.svg"),
    include_str!("../docs/meander_taper.svg"),
    "</div>\n"
)]
//!
//! ## Superconducting nanowires
//!
//! [`optimal_hairpin`](fn@optimal_hairpin), [`optimal_step`](fn@optimal_step), [`optimal_90deg`](fn@optimal_90deg),
//! [`snspd`](fn@snspd), [`snspd_expanded`](fn@snspd_expanded), [`snspd_candelabra`](fn@snspd_candelabra),
//! [`ytron_round`](fn@ytron_round).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/optimal_hairpin.svg"),
    include_str!("../docs/optimal_step.svg"),
    include_str!("../docs/optimal_90deg.svg"),
    include_str!("../docs/snspd.svg"),
    include_str!("../docs/snspd_expanded.svg"),
    include_str!("../docs/snspd_candelabra.svg"),
    include_str!("../docs/ytron_round.svg"),
    "</div>\n"
)]
//!
//! ## Photonics
//!
//! [`grating`](fn@grating), [`racetrack_gradual`](fn@racetrack_gradual).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/grating.svg"),
    include_str!("../docs/racetrack_gradual.svg"),
    "</div>\n"
)]
//!
//! ## Lithography marks
//!
//! [`litho_steps`](fn@litho_steps), [`litho_star`](fn@litho_star), [`litho_calipers`](fn@litho_calipers),
//! [`litho_ruler`](fn@litho_ruler).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/litho_steps.svg"),
    include_str!("../docs/litho_star.svg"),
    include_str!("../docs/litho_calipers.svg"),
    include_str!("../docs/litho_ruler.svg"),
    "</div>\n"
)]
//!
//! ## Electrical tests
//!
//! [`test_via`](fn@test_via), [`test_comb`](fn@test_comb), [`test_ic`](fn@test_ic), [`test_res`](fn@test_res).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/test_via.svg"),
    include_str!("../docs/test_comb.svg"),
    include_str!("../docs/test_ic.svg"),
    include_str!("../docs/test_res.svg"),
    "</div>\n"
)]
//!
//! ## Dies and lettering
//!
//! [`basic_die`](fn@basic_die), [`text`](fn@text).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/basic_die.svg"),
    include_str!("../docs/text.svg"),
    "</div>\n"
)]
//!
//! ## Arranging and filling
//!
//! [`grid`](fn@grid), [`gridsweep`](fn@gridsweep), [`packer`](fn@packer), [`fill_rectangle`](fn@fill_rectangle).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/grid.svg"),
    include_str!("../docs/gridsweep.svg"),
    include_str!("../docs/packer.svg"),
    include_str!("../docs/fill_rectangle.svg"),
    "</div>\n"
)]
//!
//! ## Parts and copies of cells
//!
//! [`extract`](fn@extract), [`copy_layer`](fn@copy_layer), [`copy`](fn@copy), [`deepcopy`](fn@deepcopy),
//! [`flatten`](fn@flatten), [`ports_to_geometry`](fn@ports_to_geometry), [`geometry_to_ports`](fn@geometry_to_ports),
//! [`preview_layerset`](fn@preview_layerset).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/extract.svg"),
    include_str!("../docs/copy_layer.svg"),
    include_str!("../docs/copy.svg"),
    include_str!("../docs/deepcopy.svg"),
    include_str!("../docs/flatten.svg"),
    include_str!("../docs/ports_to_geometry.svg"),
    include_str!("../docs/geometry_to_ports.svg"),
    include_str!("../docs/preview_layerset.svg"),
    "</div>\n"
)]
//!
//! ## Set operations
//!
//! [`boolean`](fn@boolean), [`offset`](fn@offset), [`outline`](fn@outline), [`invert`](fn@invert),
//! [`xor_diff`](fn@xor_diff), [`union`](fn@union), [`kl_boolean`](fn@kl_boolean), [`kl_offset`](fn@kl_offset),
//! [`kl_outline`](fn@kl_outline), [`kl_invert`](fn@kl_invert).
//!
#![doc = concat!(
    "<div>\n",
    include_str!("../docs/boolean.svg"),
    include_str!("../docs/offset.svg"),
    include_str!("../docs/outline.svg"),
    include_str!("../docs/invert.svg"),
    include_str!("../docs/xor_diff.svg"),
    include_str!("../docs/union.svg"),
    include_str!("../docs/kl_boolean.svg"),
    include_str!("../docs/kl_offset.svg"),
    include_str!("../docs/kl_outline.svg"),
    include_str!("../docs/kl_invert.svg"),
    "</div>\n"
)]

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
pub mod polygon;
pub mod select;
pub mod taper;
pub mod test_structure;
#[cfg(test)]
mod testing;
pub mod text;

#[doc(inline)]
pub use arrange::{GridParams, GridsweepParams, PackerParams, grid, gridsweep, packer};
#[doc(inline)]
pub use basic::*;
#[doc(inline)]
pub use boolean::*;
#[doc(inline)]
pub use connect::{
    CompassMultiParams, CompassParams, ConnectorParams, FlagpoleParams, PolygonPortsParams, TeeParams, compass,
    compass_multi, connector, flagpole, polygon_ports, tee,
};
#[doc(inline)]
pub use die::{BasicDieParams, basic_die};
#[doc(inline)]
pub use fill::{FillRectangleParams, fill_rectangle};
#[doc(inline)]
pub use litho::*;
#[doc(inline)]
pub use nanowire::*;
#[doc(inline)]
pub use photonic::*;
#[doc(inline)]
pub use select::*;
#[doc(inline)]
pub use taper::*;
#[doc(inline)]
pub use test_structure::*;
#[doc(inline)]
pub use text::{TextParams, text};
