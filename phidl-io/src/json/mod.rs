//! Devices as JSON: [`describe`] for comparing, [`metadata`] to lie beside a mask file.
//!
//! Reading is not part of it: a device is built from JSON by its generator, never from its drawing.

mod describe;
mod metadata;
mod value;

use phidl_core::scene::Source;

pub(crate) use describe::corners;
pub use describe::describe;
pub use metadata::metadata;

/// The parameters of a generator as JSON text on one line.
pub(crate) fn parameters(source: &Source) -> String {
    serde_json::Value::Object(value::params(source)).to_string()
}

/// JSON as text for a file: indented, with a newline at the end.
#[must_use]
pub fn to_text(json: &serde_json::Value) -> String {
    format!("{json:#}\n")
}
