//! [`Check`]: rules of a generator that `#[param]` cannot state, such as one parameter against another.

use super::unit::Quantity;
use crate::error::{Error, ParamError, Result};
use crate::runtime;

/// Rules over the parameters of one generator. Each one that is broken is an error with device, parameter, value and
/// rule; NaN and infinity break all of them.
///
/// ```
/// # use phidl_core::param::Check;
/// let check = Check::device("optimal_hairpin").unit("um");
/// let (pitch, width) = (0.2, 0.35);
/// assert_eq!(
///     check.greater("pitch", pitch, ("width", width)).unwrap_err().to_string(),
///     "optimal_hairpin: pitch is 0.2 µm, but it must be greater than width, 0.35 µm"
/// );
/// check.greater("width", width, 0)?;
/// check.at_most("width", width, ("twice the pitch", 2.0 * pitch))?;
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// In the body of a generator the unit comes from the `#[param(unit = …)]` of the parameter and need not be given.
#[derive(Debug, Clone, Copy)]
pub struct Check<'a> {
    device: &'a str,
    unit: Option<&'a str>,
}

/// What a parameter is compared with: a number, or a number with a name, `("width", width)`.
#[derive(Debug, Clone, Copy)]
pub struct Bound<'a> {
    name: Option<&'a str>,
    number: f64,
}

/// A number that rules compare: lengths, angles and counts.
pub trait ToF64 {
    /// The number as a float; counts beyond 2⁵³ to the nearest one.
    fn amount(self) -> f64;
}

macro_rules! amounts {
    ($($number:ty),*) => {$(
        impl ToF64 for $number {
            fn amount(self) -> f64 {
                self as f64
            }
        }
    )*};
}

amounts!(f64, f32, i64, i32, i16, i8, u64, u32, u16, u8, usize);

impl<N: ToF64> From<N> for Bound<'_> {
    fn from(number: N) -> Self {
        Self { name: None, number: number.amount() }
    }
}

impl<'a, N: ToF64> From<(&'a str, N)> for Bound<'a> {
    fn from((name, number): (&'a str, N)) -> Self {
        Self { name: Some(name), number: number.amount() }
    }
}

impl<'a> Check<'a> {
    /// Rules of the generator with this name.
    #[must_use]
    pub fn device(name: &'a str) -> Self {
        Self { device: name, unit: None }
    }

    /// The same, with numbers in this unit, spelled as in `#[param(unit = …)]`.
    #[must_use]
    pub fn unit(self, unit: &'a str) -> Self {
        Self { unit: Some(unit), ..self }
    }

    /// The parameter must be a finite number.
    ///
    /// # Errors
    /// [`ParamError`], here and in all other rules.
    pub fn finite(&self, param: &str, value: impl ToF64) -> Result<()> {
        let value = value.amount();
        self.require(param, value, value.is_finite(), || "be finite".to_owned())
    }

    /// The parameter must be greater than the limit.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn greater<'l>(&self, param: &str, value: impl ToF64, limit: impl Into<Bound<'l>>) -> Result<()> {
        self.compare(param, value.amount(), "greater than", limit.into(), |v, limit| v > limit)
    }

    /// The parameter must not be less than the limit.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn at_least<'l>(&self, param: &str, value: impl ToF64, limit: impl Into<Bound<'l>>) -> Result<()> {
        self.compare(param, value.amount(), "at least", limit.into(), |v, limit| v >= limit)
    }

    /// The parameter must be less than the limit.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn less<'l>(&self, param: &str, value: impl ToF64, limit: impl Into<Bound<'l>>) -> Result<()> {
        self.compare(param, value.amount(), "less than", limit.into(), |v, limit| v < limit)
    }

    /// The parameter must not be greater than the limit.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn at_most<'l>(&self, param: &str, value: impl ToF64, limit: impl Into<Bound<'l>>) -> Result<()> {
        self.compare(param, value.amount(), "at most", limit.into(), |v, limit| v <= limit)
    }

    /// The parameter must lie between the limits or on one of them.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn between<'l>(
        &self,
        param: &str,
        value: impl ToF64,
        low: impl Into<Bound<'l>>,
        high: impl Into<Bound<'l>>,
    ) -> Result<()> {
        let value = value.amount();
        self.at_least(param, value, low)?;
        self.at_most(param, value, high)
    }

    /// Any other rule: refuses the parameter unless the condition holds. The rule is the end of "it must …".
    ///
    /// ```
    /// # use phidl_core::param::Check;
    /// let error = Check::device("star").that("num_points", 2, false, "be at least 3 to enclose anything").unwrap_err();
    /// assert_eq!(error.to_string(), "star: num_points is 2, but it must be at least 3 to enclose anything");
    /// ```
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn that(&self, param: &str, value: impl std::fmt::Display, condition: bool, rule: &str) -> Result<()> {
        if condition { Ok(()) } else { Err(self.error(param, value.to_string(), rule.to_owned())) }
    }

    fn compare(
        &self,
        param: &str,
        value: f64,
        words: &str,
        limit: Bound<'_>,
        holds: impl Fn(f64, f64) -> bool,
    ) -> Result<()> {
        self.finite(param, value)?;
        self.require(param, value, holds(value, limit.number), || {
            let number = Quantity(limit.number, self.unit_of(param));
            match limit.name {
                Some(name) => format!("be {words} {name}, {number}"),
                None => format!("be {words} {number}"),
            }
        })
    }

    fn require(&self, param: &str, value: f64, holds: bool, rule: impl FnOnce() -> String) -> Result<()> {
        if holds {
            return Ok(());
        }
        Err(self.error(param, Quantity(value, self.unit_of(param)).to_string(), rule()))
    }

    /// The unit of a parameter: as told, or as the generator that is being drawn states it.
    fn unit_of(&self, param: &str) -> &'a str {
        self.unit.unwrap_or_else(|| runtime::unit_while_drawing(self.device, param).unwrap_or_default())
    }

    fn error(&self, param: &str, value: String, rule: String) -> Error {
        ParamError { device: self.device.to_owned(), param: param.to_owned(), value, rule }.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_hold_on_the_right_side_of_their_limit() {
        let check = Check::device("ring");
        assert!(check.greater("width", 0.5, 0).is_ok() && check.greater("width", 0, 0).is_err());
        assert!(check.at_least("width", 0, 0).is_ok() && check.at_least("width", -0.1, 0).is_err());
        assert!(check.less("width", 0.5, 1).is_ok() && check.less("width", 1, 1).is_err());
        assert!(check.at_most("width", 1, 1).is_ok() && check.at_most("width", 1.5, 1).is_err());
        assert!(check.between("width", 1, 0, 1).is_ok() && check.between("width", 2, 0, 1).is_err());
    }

    #[test]
    fn a_number_that_is_none_breaks_every_rule() {
        let check = Check::device("ring");
        for broken in [
            check.finite("width", f64::NAN),
            check.at_least("width", f64::INFINITY, 0),
            check.at_most("width", f64::NEG_INFINITY, 0),
            check.less("width", f64::NAN, 0),
        ] {
            assert!(broken.unwrap_err().to_string().ends_with("it must be finite"));
        }
    }
}
