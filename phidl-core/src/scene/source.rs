//! [`Source`]: the generator of a cell and its parameters.

use crate::runtime::ParamValues;

/// The generator of a finished cell with every parameter it was called with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Name of the generator, as registered.
    pub generator: &'static str,
    /// Path of its module.
    pub module: &'static str,
    /// Version of its crate.
    pub version: &'static str,
    /// Every parameter in the generator's order, by its registered name.
    pub params: ParamValues,
}
