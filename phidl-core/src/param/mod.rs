//! Parameters of generators and records of cells.
//!
//! A parameter is a type with [`Param`]; its [`Value`] is what the cache compares, what the cell records and what JSON
//! holds. [`Bounds`] and [`Check`] refuse what a generator cannot draw.

mod bounds;
mod check;
mod collections;
mod into_option;
mod kind;
mod mismatch;
mod parameter;
mod serde;
mod unit;
mod value;

pub use bounds::Bounds;
pub use check::{Amount, Check, Limit};
pub use into_option::IntoOption;
pub use kind::Kind;
pub use mismatch::Mismatch;
pub use parameter::Param;
pub use value::Value;

pub(crate) use bounds::Site;
pub(crate) use value::float_key;
