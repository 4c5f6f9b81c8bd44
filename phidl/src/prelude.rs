//! The names that nearly every layout program uses: `use phidl::prelude::*;`.
//!
//! Shapes and routes are not among them, since `text`, `grid` or `copy` are common names elsewhere. They are called
//! through their module: `use phidl::shapes as pg;`.

pub use phidl_core::prelude::*;
pub use phidl_macros::{Choice, device};

#[cfg(feature = "path")]
pub use phidl_path::{CrossSection, Path, Section};
