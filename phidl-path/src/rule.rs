//! Rules for parameters, in one way for the whole crate.
//!
//! The wording is that of the generators (`device: parameter is value, but it must rule`), so that a bad bend reads the
//! same in a path as in a device.

use phidl_core::error::ParamError;
use phidl_core::{Error, Result};

/// The error for a parameter of a curve or an operation.
pub(crate) fn refused(what: &str, param: &str, value: impl std::fmt::Display, rule: impl Into<String>) -> Error {
    ParamError { device: what.to_owned(), param: param.to_owned(), value: value.to_string(), rule: rule.into() }.into()
}

/// Refuses a length that is not finite and greater than zero.
pub(crate) fn positive_length(what: &str, param: &str, um: f64) -> Result<()> {
    match um > 0.0 && um.is_finite() {
        true => Ok(()),
        false => Err(refused(what, param, format!("{um} µm"), "be greater than 0 µm and finite")),
    }
}

/// Refuses a length that is not finite or less than zero.
pub(crate) fn length(what: &str, param: &str, um: f64) -> Result<()> {
    match um >= 0.0 && um.is_finite() {
        true => Ok(()),
        false => Err(refused(what, param, format!("{um} µm"), "be at least 0 µm and finite")),
    }
}

/// Refuses a number of points that is not finite and greater than zero.
pub(crate) fn point_count(what: &str, num_pts: f64) -> Result<()> {
    match num_pts > 0.0 && num_pts.is_finite() {
        true => Ok(()),
        false => Err(refused(what, "num_pts", num_pts, "be greater than 0 and finite")),
    }
}

/// Refuses an angle that turns nothing or is not finite.
pub(crate) fn turn(what: &str, degrees: f64) -> Result<()> {
    match degrees != 0.0 && degrees.is_finite() {
        true => Ok(()),
        false => Err(refused(what, "angle", format!("{degrees}°"), "be finite and not 0°")),
    }
}
