//! Files of phidl: masks, pictures, and the data beside them.
//!
//! | Module | What it does |
//! |---|---|
//! | [`layout`] | one front for all layout formats: GDSII, OASIS, gzip; files inspected and converted |
//! | [`gds`] | GDSII files, written and read: cells, arrays, labels, properties, units, a fixed date |
//! | `oasis` | OASIS files (SEMI P39), written and read (feature `oasis`, on by default) |
//! | [`model`] | what a layout file holds, shared by all formats: paths, boxes, several top cells, dates |
//! | [`svg`] | pictures with the hierarchy kept, so that a large chip is a small file |
//! | [`json`] | a device described for comparing; generators, parameters and ports beside a mask file |
//! | [`weld`] | joints that do not gap: found across the hierarchy, written with one grid point for each corner |
//! | `cli` | commands that list and draw the generators of a program (feature `cli`) |
//! | [`lyp`] | KLayout's layer properties: colors, patterns and groups of layers |
//! | [`Summary`] | a mask in a few numbers: cells, polygons, areas, labels, box, SHA-256 |
//! | [`mask`] | a mask build: a device into a folder of files |
//! | [`atomic`] | how files are written: whole, or not at all |
//!
//! Writers never change a device, and two runs write the same bytes: no clock, no order of hash tables. Everything that
//! can fail returns an [`IoError`], which names the file or cell, the element and the rule. Lengths are micrometers.

pub mod atomic;
#[cfg(feature = "cli")]
pub mod cli;
mod counts;
mod error;
pub mod gds;
mod input;
pub mod json;
pub mod layout;
pub mod lyp;
pub mod mask;
pub mod model;
#[cfg(feature = "oasis")]
pub mod oasis;
mod placements;
mod summary;
pub mod svg;
pub mod weld;

pub use error::{IoError, Item, Result};
pub use summary::{LayerSummary, Summary};

/// The README's example, kept true by the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
