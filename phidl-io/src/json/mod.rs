//! JSON out of phidl: the described device, and the metadata of a mask.
//!
//! Both are values of serde_json; whoever wants a file writes [`to_text`] with [`atomic::write`](crate::atomic::write).

mod describe;
mod metadata;

pub use describe::describe;
pub use metadata::metadata;

use phidl_core::param::Value;
use serde_json::Value as Json;

/// The JSON of a value; every float comes back from it with the same bits.
fn json(value: &Value) -> Json {
    serde_json::to_value(value).expect("invariant: maps have texts as keys, and finished cells hold finite numbers only")
}

/// JSON as text, indented, with a newline at the end.
#[must_use]
pub fn to_text(json: &Json) -> String {
    format!("{json:#}\n")
}
