//! Rules for parameters, shared by the whole crate.
//!
//! The sentence is that of the generators (`device: parameter is value, but it must rule`), so that an invalid bend has the
//! same message in a path as in a device. A rule between several values has a sentence of its own, as [`Error::custom`].

use phidl_core::error::ParamError;
use phidl_core::num::count;
use phidl_core::{Error, Result};

/// The error for a parameter of a curve or an operation.
pub(crate) fn refused(what: &str, param: &str, value: impl std::fmt::Display, rule: impl Into<String>) -> Error {
    ParamError { device: what.to_owned(), param: param.to_owned(), value: value.to_string(), rule: rule.into() }.into()
}

/// A length in a message, rounded to a picometer.
pub(crate) fn um(length: f64) -> String {
    format!("{} µm", (length * 1e6).round() / 1e6)
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

/// Refuses a number of points per turn that is not finite and greater than zero, or that is too large for an angle.
pub(crate) fn point_count(what: &str, num_pts: f64, degrees: f64) -> Result<()> {
    if num_pts.is_nan() || num_pts <= 0.0 || num_pts.is_infinite() {
        return Err(refused(what, "num_pts", num_pts, "be greater than 0 and finite"));
    }
    match num_pts * degrees.abs() / 360.0 <= count::MOST as f64 {
        true => Ok(()),
        false => Err(refused(what, "num_pts", num_pts, format!("be small enough for at most {} points", count::MOST))),
    }
}

/// Refuses an angle that is 0 or not finite.
pub(crate) fn turn(what: &str, degrees: f64) -> Result<()> {
    match degrees != 0.0 && degrees.is_finite() {
        true => Ok(()),
        false => Err(refused(what, "angle", format!("{degrees}°"), "be finite and not 0°")),
    }
}
