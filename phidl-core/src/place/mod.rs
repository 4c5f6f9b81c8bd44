//! The one set of words for everything that has a place.
//!
//! A type gives the kernel, [`Transformable`] and [`Bounded`]; the words of [`Place`] come from it by blanket
//! implementation, so they mean the same for a polygon, a label, a port, a reference, a group, a path and an open cell.
//! What handles several members at once gives [`Arrange`] and can be aligned and distributed.

mod arrange;
mod fault;
mod kernel;
mod words;

pub use arrange::{Arrange, Direction, Edge};
pub use fault::{PlaceFault, Refusal};
pub use kernel::{Bounded, Transformable};
pub use words::Place;
