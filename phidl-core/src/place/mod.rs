//! The placement methods, the same for every element.
//!
//! A type implements [`Transformable`] and [`Bounded`]. The methods of [`Movable`] follow by blanket implementation, so
//! they mean the same for a polygon, a label, a port, a reference, a group, a path and an open cell. Types with several
//! members implement [`Align`] and can be aligned and distributed.

mod align;
mod deferred;
mod kernel;
mod movable;

pub use align::{Align, Direction, Edge};
pub use deferred::{DeferredError, Reason};
pub use kernel::{Bounded, Transformable};
pub use movable::Movable;
