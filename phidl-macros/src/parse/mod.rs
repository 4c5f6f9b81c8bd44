//! From tokens to the [model](crate::model); every token that may have to be blamed is kept.

mod attributes;
mod options;
mod signature;

pub(crate) use options::number;
pub(crate) use signature::{Function, generator};
