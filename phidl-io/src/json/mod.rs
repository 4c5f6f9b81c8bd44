//! Devices as JSON: [`describe`] for comparing, [`metadata`] to lie beside a mask file.
//!
//! Reading is not part of it: a device is built from JSON by its generator, never from its drawing.

mod describe;
mod metadata;
mod value;

pub(crate) use describe::corners;
pub use describe::describe;
pub use metadata::metadata;

/// JSON as text for a file: indented, with a newline at the end.
#[must_use]
pub fn to_text(json: &serde_json::Value) -> String {
    format!("{json:#}\n")
}
