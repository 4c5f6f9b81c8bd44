//! GDSII layout in Rust: cells, ports, shapes, paths, routes, booleans and mask files behind one dependency.
//!
//! ```
//! use phidl::prelude::*;
//! use phidl::shapes as pg;
//!
//! # fn main() -> Result<()> {
//! let mut d = Device::builder("first");
//! let ring = d.add(pg::ring(10, 0.5, 2.5, 1)?);       // radius, width, resolution, layer
//! let bus = d.add(pg::straight((0.5, 30), 1)?);       // size, layer
//! d[bus].rotate(90).set_x(0);
//! let top = d[bus].ymax();
//! d[ring].set_ymin(top + 0.2);                        // 200 nm above the bus
//! let device = d.build()?;
//! assert_eq!(device.layers(), [Layer::new(1, 0)]);
//! # Ok(())
//! # }
//! ```
//!
//! # Where to begin
//! | to do | use |
//! |---|---|
//! | draw a cell | [`scene::Device::builder`], [`scene::DeviceBuilder`] |
//! | place, move, rotate, align, connect | [`scene::Reference`], [`place::Movable`], [`place::Align`] |
//! | write a generator | [`macro@device`] |
//! | take a ready shape | [`shapes`]: tapers, rings, nanowires, marks, text, test structures |
//! | draw a waveguide | [`path`]: paths, cross-sections, extrusion |
//! | connect two ports | [`route`] |
//! | combine, grow, invert | [`boolean`] |
//! | write and read files, draw pictures | [`io`] |
//! | list or build generators by name | [`registry`] |
//!
//! # Features
//! All but `cli` are on by default. A program that needs less says `default-features = false` and names what it uses.
//!
//! | feature | module |
//! |---|---|
//! | `shapes` | [`shapes`]; includes `boolean` |
//! | `path` | [`path`] |
//! | `route` | [`route`]; includes `path` |
//! | `boolean` | [`boolean`] |
//! | `io` | [`io`] |
//! | `cli` | `io::cli`: commands that list and draw the generators of a program |
//! | `fonts` | `shapes::text` draws fonts from files and of the system; without it there is the built-in font only |
//! | `parallel` | [`Device::flattened`](scene::Device::flattened) uses all cores |
//!
//! # Conventions
//! Lengths are micrometers in `f64`, angles are degrees counter-clockwise, y is up. Coordinates are rounded to a grid in
//! two places only: on entry into the boolean engine and when a file is written.
//!
//! The module [`shapes`] is the crate `phidl-geometry`; [`path`], [`route`], [`boolean`] and [`io`] are crates of those
//! names, and the remaining modules are those of `phidl-core`. Each crate can also be used by itself.

pub mod prelude;

#[doc(hidden)]
pub use phidl_core::__private;
#[doc(inline)]
pub use phidl_core::{
    Error, Generator, Result, cache, error, geom, hash, layer, num, param, place, port, registry, runtime, scene,
};
#[doc(inline)]
pub use phidl_macros::{Choice, device};

#[cfg(feature = "boolean")]
#[doc(inline)]
pub use phidl_boolean as boolean;
#[cfg(feature = "shapes")]
#[doc(inline)]
pub use phidl_geometry as shapes;
#[cfg(feature = "io")]
#[doc(inline)]
pub use phidl_io as io;
#[cfg(feature = "path")]
#[doc(inline)]
pub use phidl_path as path;
#[cfg(feature = "route")]
#[doc(inline)]
pub use phidl_route as route;

/// The example of this crate's README.
#[cfg(all(doctest, feature = "shapes", feature = "io"))]
#[doc = include_str!("../README.md")]
struct Readme;
