//! The one set of words for everything that has a place.
//!
//! A type gives the kernel, [`Transformable`] and [`Bounded`]; the words of [`Movable`] come from it by blanket
//! implementation, so they mean the same for a polygon, a label, a port, a reference, a group, a path and an open cell.
//! What handles several members at once gives [`Align`] and can be aligned and distributed.

mod align;
mod deferred;
mod kernel;
mod movable;

pub use align::{Align, Direction, Edge};
pub use deferred::{DeferredError, Refusal};
pub use kernel::{Bounded, Transformable};
pub use movable::Movable;
