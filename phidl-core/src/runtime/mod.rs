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
mod reader;
mod recipe;
mod record;
pub mod registry;
mod stack;
mod worker;

pub use entry::{Entry, ParamInfo, Redraw, Row};
pub use generator::Generator;
pub use reader::Reader;
pub use recipe::Recipe;
pub use record::Record;

pub(crate) use draw::unit_while_drawing;
