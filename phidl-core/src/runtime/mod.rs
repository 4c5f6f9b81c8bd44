//! What stands behind `#[device]`: generators, their cache and their registry.
//!
//! A [`Generator`] is a plain struct of parameters that can be drawn. [`cache`] draws each parameter set once for the
//! process; [`registry`] lists every generator that is linked into the program and builds from plain values.
//! A [`Recipe`] is a generator with some parameters, not drawn yet: what sweeps take.

pub mod cache;
mod draw;
mod entry;
mod flight;
mod generator;
mod key;
mod reader;
mod recipe;
pub mod registry;
mod stack;
mod worker;

pub use entry::{Entry, ParamInfo, Redraw, Row};
pub use generator::{Generator, Record};
pub use reader::Reader;
pub use recipe::Recipe;

pub(crate) use draw::unit_while_drawing;
