//! [`DeferredError`]: a placement word that was refused.

use crate::error::Error;
use crate::geom::Point;

/// A placement word and why it was refused. The thing that was to be placed keeps it, and whoever takes the thing in
/// makes an [`Error`] of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeferredError {
    /// The word.
    pub word: &'static str,
    /// Why it was refused.
    pub refusal: Refusal,
}

/// Why a placement word was refused.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// A number is NaN or infinite.
    NumberNotFinite(f64),
    /// A point is not finite.
    PointNotFinite(Point),
    /// A magnification is zero or negative.
    FactorNotPositive(f64),
    /// A tolerance is negative or not finite.
    BadTolerance(f64),
    /// The two points of a mirror line are the same.
    LineOfOnePoint(Point),
    /// The thing draws nothing, so it has no edge to put anywhere.
    Empty,
}

impl DeferredError {
    /// The error for it, naming the cell and the thing that was to be placed.
    #[must_use]
    pub fn into_error(self, device: &str, what: &str) -> Error {
        let word = self.word;
        let device: Box<str> = device.into();
        match self.refusal {
            Refusal::NumberNotFinite(v) => {
                Error::NotFinite { device, what: format!("{word} of {what}").into(), value: v.to_string().into() }
            }
            Refusal::PointNotFinite(p) => {
                Error::NotFinite { device, what: format!("{word} of {what}").into(), value: p.to_string().into() }
            }
            Refusal::FactorNotPositive(factor) => Error::Refused {
                device,
                what: format!("{word} of {what}").into(),
                value: factor.to_string().into(),
                rule: "be greater than 0".into(),
            },
            Refusal::BadTolerance(tolerance) => Error::Refused {
                device,
                what: format!("tolerance to {word} {what}").into(),
                value: format!("{tolerance} µm").into(),
                rule: "be finite and at least 0 µm".into(),
            },
            Refusal::LineOfOnePoint(p) => Error::Refused {
                device,
                what: format!("the line to {word} {what} at").into(),
                value: format!("{p} to {p}").into(),
                rule: "have two different points".into(),
            },
            Refusal::Empty => Error::EmptyGeometry { device, word, what: what.into() },
        }
    }
}
