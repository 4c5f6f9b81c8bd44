//! [`Source`]: which generator drew a cell, and with what.

use crate::runtime::ParamValues;

/// The generator of a finished cell with every parameter it was called with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Name of the generator, as registered.
    pub generator: &'static str,
    /// Path of the module it stands in.
    pub module: &'static str,
    /// Version of the crate it stands in.
    pub version: &'static str,
    /// Every parameter in the generator's order, by its registered name.
    pub params: ParamValues,
}
