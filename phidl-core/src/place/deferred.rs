//! [`DeferredError`]: the first invalid call of a chain of placement methods.

use crate::error::Error;
use crate::geom::Point;

/// A placement method that was called with an invalid argument. The element keeps it, and the next fallible call on that
/// element (adding it to a cell, `connect`, `build`) makes an [`Error`] of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeferredError {
    /// The method.
    pub method: &'static str,
    /// Why the call is invalid.
    pub reason: Reason,
}

/// Why a call of a placement method is invalid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// A number is NaN or infinite.
    NumberNotFinite(f64),
    /// A point is not finite.
    PointNotFinite(Point),
    /// A factor is zero or negative.
    FactorNotPositive(f64),
    /// A tolerance is negative or not finite.
    BadTolerance(f64),
    /// The two points of a mirror line are the same.
    MirrorLineOfOnePoint(Point),
    /// The element is empty, so it has no edge to move.
    Empty,
    /// This member of a group or selection is empty, so it has no edge to line up.
    EmptyMember(usize),
}

impl Reason {
    /// Whether an argument is NaN, as the edges of an empty element are.
    pub(crate) fn is_nan(&self) -> bool {
        match self {
            Self::NumberNotFinite(v) => v.is_nan(),
            Self::PointNotFinite(p) => p.x.is_nan() || p.y.is_nan(),
            _ => false,
        }
    }
}

impl DeferredError {
    /// The error for it. `device` is the name of the cell, `what` names the element with its article: `the polygon`.
    #[must_use]
    pub fn into_error(self, device: &str, what: &str) -> Error {
        let method = self.method;
        let hint = if self.reason.is_nan() { " (as is every edge of an empty element)" } else { "" };
        let not_finite = |value: &dyn std::fmt::Display| Error::NotFinite {
            device: device.into(),
            what: format!("the argument of {method} for {what}").into(),
            value: format!("{value}{hint}").into(),
        };
        let empty = |what: String| Error::EmptyGeometry { device: device.into(), method, what: what.into() };
        match self.reason {
            Reason::NumberNotFinite(v) => not_finite(&v),
            Reason::PointNotFinite(p) => not_finite(&p),
            Reason::FactorNotPositive(factor) => Error::invalid(
                device,
                format!("the factor of {method} for {what} is {factor}, but it must be greater than 0"),
            ),
            Reason::BadTolerance(tolerance) => Error::invalid(
                device,
                format!(
                    "the tolerance of {method} for {what} is {tolerance} µm, but it must be finite and at least 0 µm"
                ),
            ),
            Reason::MirrorLineOfOnePoint(p) => Error::invalid(
                device,
                format!("the line of {method} for {what} needs two different points, but both are {p}"),
            ),
            Reason::Empty => empty(what.to_owned()),
            Reason::EmptyMember(index) => empty(format!("member {index} of {what}, counted from 0,")),
        }
    }
}
