//! Hashes: the identity of a cell ([`Digest`]), and PHIDL's geometry hash.

mod content;
mod geometry;

pub use content::Digest;
pub(crate) use content::{content, drawing};
pub(crate) use geometry::geometry;
