//! Routes between ports.
//!
//! <div>
#![doc = include_str!("../docs/routes.svg")]
//! </div>
//!
//! | route | meaning |
//! |---|---|
//! | [`route_quad`](fn@route_quad) | the quadrilateral between two ports |
//! | [`route_basic`](fn@route_basic) | one straight or sine-shaped piece between ports that face each other |
//! | [`route_smooth`](fn@route_smooth), [`route_sharp`](fn@route_sharp) | a wire of a shape of your choice ([`PathType`]), with bends or with mitered corners |
//! | [`route_manhattan`](fn@route_manhattan), [`route_manhattan_auto`](fn@route_manhattan_auto) | wires at right angles, with bends of your choice ([`RouteBend`]), one or many |
//! | [`route_xy`](fn@route_xy) | steps along x and y, for any orientation of the ports |
//! | [`route_serpentine`](fn@route_serpentine), [`delay_line`](fn@delay_line) | a wire of an exact length |
//! | [`route_custom`] | a wire along given waypoints, with any bend and any cross-section |
//!
//! ```
//! use phidl_core::prelude::*;
//! use phidl_route::{PathType, RouteBend, path_j, route_manhattan, route_smooth};
//! use phidl_path::EulerBend;
//!
//! let (a, b) = (Port::new((40, 0), 5, 180), Port::new((0, -40), 5, 270));
//! let wire = route_smooth(&a, &b, 5, None, PathType::Manhattan, 1)?; // an ordinary call, cached
//! assert_eq!(wire.port("1")?.midpoint(), a.midpoint());
//! let arcs = route_manhattan(&a, &b, RouteBend::Circular, 10, 1)?;
//!
//! // The three steps by hand: waypoints, bends, width.
//! let by_hand = path_j(&a, &b, 60, 20)?.smoothed(10, EulerBend::new().use_eff())?.extrude_width(5, 1)?;
//! # Ok::<(), Error>(())
//! ```
//!
//! A route is a cell in the coordinates of its ports. It leaves the first port forwards, enters the second from the front,
//! and has ports `1` and `2` that face them; [`route_quad`](fn@route_quad) and [`route_xy`](fn@route_xy) accept any
//! orientation. A route that cannot be made is an error with both ports and the missing length. A Manhattan route that has
//! no room for its fewest corners, or that would run over itself, is refused unless that is allowed.
//!
//! Waypoints ([`path_straight`], [`path_l`], [`path_u`], [`path_j`], [`path_c`], [`path_v`], [`path_z`], [`path_xy`],
//! [`path_manhattan`]) are polylines, to be edited, smoothed and extruded. Names, parameters, defaults, ports and drawn
//! points are PHIDL's. A program that builds routes by name only links them with `use phidl_route as _;`.

mod basic;
mod custom;
mod draw;
mod manhattan;
mod options;
mod path_type;
mod port_pair;
mod quad;
mod serpentine;
mod sharp;
mod smooth;
mod width;
mod xy;

pub use basic::{RouteBasicParams, RouteProfile, route_basic};
pub use custom::route_custom;
pub use manhattan::{
    RouteBend, RouteManhattanAutoParams, RouteManhattanParams, manhattan_centerline, path_c, path_j, path_l,
    path_manhattan, path_straight, path_u, path_v, path_z, route_manhattan, route_manhattan_auto,
};
pub use options::SmoothOptions;
pub use path_type::PathType;
pub use quad::{RouteQuadParams, route_quad};
pub use serpentine::{DelayLineParams, RouteSerpentineParams, delay_line, route_serpentine, serpentine_centerline};
pub use sharp::{RouteSharpParams, route_sharp};
pub use smooth::{RouteSmoothParams, route_smooth};
pub use width::RouteWidth;
pub use xy::{RouteXyParams, path_xy, route_xy};

/// The README's example, kept true by the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
