//! The runtime of `#[device]`: generators, their cache and their registry.
//!
//! A [`Generator`] is a struct of parameters that can be drawn. [`cache`] draws each parameter set once for the
//! process; [`registry`] lists every generator that is linked into the program and builds from values.
//! A [`Partial`] is a generator with some parameters, not drawn yet: what sweeps take.
//!
//! There are two ways to call a generator. In Rust: its function, `ring(12, 0.5, 2.5, 1)`, or its parameter struct,
//! `RingParams::default().radius(12).build()`. By name, from JSON or a command line: [`registry::find`] and
//! [`GeneratorInfo::build`].

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
