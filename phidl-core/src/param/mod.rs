//! Parameters and records.
mod value;
pub use value::Value;
pub(crate) use value::float_key;
