//! The shape library of phidl.

pub mod basic;
pub mod connect;
pub mod nanowire;
pub mod photonic;
pub mod taper;

pub use basic::*;
pub use connect::*;
pub use nanowire::*;
pub use photonic::*;
pub use taper::*;
