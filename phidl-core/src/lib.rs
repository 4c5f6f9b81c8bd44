//! The scene graph of phidl.
pub mod error;
pub mod geom;
pub mod hash;
pub mod layer;
pub mod num;
pub mod param;
pub mod place;
pub mod port;
pub mod prelude;
pub mod scene;

pub use error::{Error, Result};
