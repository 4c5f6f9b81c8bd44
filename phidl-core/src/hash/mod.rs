//! Hashes: who a cell is ([`Digest`]), and the reference library's geometry hash.

mod content;
mod geometry;

pub use content::Digest;
pub(crate) use content::{content, drawing};
pub(crate) use geometry::geometry;
