//! The mask `demo`: a 10 mm × 10 mm chip of ring filters and nanowires, written as a user would write it.
//!
//! [`demo_chip`] is the top cell. Read [`rings`] first: it is the way from a relation between two shapes to a sweep of
//! 240 of them.

mod chip;
mod layers;
mod marks;
mod nanowires;
mod rings;

pub(crate) use chip::demo_chip;
pub(crate) use layers::layer_set;
#[cfg(test)]
pub(crate) use rings::ring_filter;
