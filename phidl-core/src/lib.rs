//! The scene graph of phidl: cells, placements, ports and layers of a mask, and the methods that place them.
//!
//! ```
//! use phidl_core::prelude::*;
//!
//! let mut d = Device::builder("pad");                       // an open cell
//! d.add_polygon([(0, 0), (40, 0), (40, 20), (0, 20)], 1)?;
//! d.add_port("e", ((40, 10), 20, 0))?;
//! let pad = d.build()?;                                     // a finished one: it never changes
//!
//! let mut row = Device::builder("row");
//! let first = row.add(&pad);
//! let mut second = pad.place();                             // a placement is a value: relate it, then add it
//! second.connect("e", &row[first].port("e")?)?;
//! row.add(second);
//! assert_eq!(row.build()?.bbox(), Some(Rect::new((0, 0), (80, 20))));
//! # Ok::<(), phidl_core::Error>(())
//! ```
//!
//! | concept | what it is | module |
//! |---|---|---|
//! | [`Device`](scene::Device), [`DeviceBuilder`](scene::DeviceBuilder) | the finished cell; the open one | [`scene`] |
//! | [`Reference`](scene::Reference), [`Group`](scene::Group) | one placement or array of a cell; several elements handled as one | [`scene`] |
//! | [`Movable`](place::Movable), [`Align`](place::Align) | the placement methods of every element | [`place`] |
//! | [`Port`](port::Port) | an opening at which cells are joined | [`port`] |
//! | [`Layer`](layer::Layer), [`Layers`](layer::Layers), [`LayerSet`](layer::LayerSet) | one; one, several or none; named and colored | [`layer`] |
//! | [`Point`](geom::Point), [`Transform`](geom::Transform), [`Rect`](geom::Rect) | coordinates, GDSII's placements, boxes | [`geom`] |
//! | [`Grid`](num::grid::Grid), angles, point counts | the one rounding rule; exact quarter turns | [`num`] |
//! | [`Value`](param::Value), [`Param`](param::Param), [`Check`](param::Check) | what parameters and records are made of; what can be a parameter; rules between them | [`param`] |
//! | [`Generator`], [`Partial`](runtime::Partial) | parameters that can be drawn, cached; a generator to be drawn with others | [`runtime`] |
//! | [`cache`], [`registry`] | each parameter set is drawn once; every generator of a program by name | [`runtime`] |
//!
//! # Conventions
//! Lengths are micrometers in `f64`, angles are degrees counter-clockwise, y is up. Multiples of 90° are exact. A
//! placement mirrors across the x axis, magnifies, rotates and shifts, in this order, as GDSII does. Nothing here rounds
//! to a grid; that happens on entry into the boolean engine and when a file is written.
//!
//! # Features
//! `parallel`: [`Device::flattened`](scene::Device::flattened) expands large hierarchies on all cores (with rayon), and
//! generators may be called from parallel loops of rayon. Turn it on to use rayon around or inside generators.
//!
//! This crate knows no file format, no boolean engine and no clock, and it never prints.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
pub mod error;
pub mod geom;
pub mod hash;
pub mod layer;
pub mod num;
pub mod param;
pub mod place;
pub mod port;
pub mod prelude;
pub mod runtime;
pub mod scene;

pub use error::{Error, Result};
pub use runtime::{Generator, cache, registry};
