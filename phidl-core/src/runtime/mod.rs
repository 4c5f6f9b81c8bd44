//! What stands behind `#[device]`: generators, their cache and their registry.
//!
//! A [`Generator`] is a plain struct of parameters that can be drawn. [`cache`] draws each parameter set once for the
//! process; [`registry`] lists every generator that is linked into the program and builds from plain values.
//! A [`Partial`] is a generator with some parameters, not drawn yet: what sweeps take.

mod build;
pub mod cache;
mod generator;
mod info;
mod param_values;
mod partial;
mod reader;
pub mod registry;
mod stack;

pub use generator::Generator;
pub use info::{GeneratorInfo, ParamInfo};
pub use param_values::ParamValues;
pub use partial::Partial;
pub use reader::ParamReader;
