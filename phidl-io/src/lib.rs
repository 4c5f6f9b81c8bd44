//! Files in and out of phidl.
pub mod atomic;
mod error;
pub mod gds;

pub use error::{IoError, Item, Result};
