//! Parameters of generators and records of cells.
//!
//! A parameter is a type with [`Param`]; its [`Value`] is what the cache compares, what the cell records and what JSON
//! holds. [`Bounds`] and [`Check`] refuse what a generator cannot draw.

mod bounds;
mod check;
mod collections;
mod conversion_error;
mod into_option;
mod param_type;
mod parameter;
mod serde;
mod spec;
mod unit;
mod value;

pub use bounds::Bounds;
pub use check::{Bound, Check, ToF64};
pub use conversion_error::ConversionError;
pub use into_option::IntoOption;
pub use param_type::ParamType;
pub use parameter::Param;
pub use spec::ParamSpec;
pub use unit::Unit;
pub use value::Value;

pub(crate) use bounds::ParamPath;
pub(crate) use value::float_key;
