//! The scene graph of phidl.
#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
pub mod error;
pub mod geom;
pub mod hash;
pub mod layer;
pub mod num;
pub mod param;
pub mod place;
pub mod port;
pub mod prelude;
pub mod runtime;
pub mod scene;

pub use error::{Error, Result};
pub use runtime::{Generator, cache, registry};
