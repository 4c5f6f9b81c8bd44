//! Files in and out of phidl.
pub mod atomic;
mod distinct;
mod error;
pub mod gds;
pub mod json;
pub mod mask;
mod summary;
pub mod svg;

pub use error::{IoError, Item, Result};
pub use summary::{LayerSummary, Summary};
