//! [`Check`]: rules of a generator that `#[param]` cannot state, such as one parameter against another.
//!
//! `#[device]` hands the rules to the body as `check`. The alternative, a constructor that takes the name of the
//! generator, was rejected: a renamed generator would keep its old name in errors and lose the units of its parameters.

use super::ParamSpec;
use super::unit::Quantity;
use crate::error::{Error, ParamError, Result};
use crate::num::count;

/// Rules over the parameters of one generator. A broken rule is an error with device, parameter, value and rule. NaN
/// and infinity break every rule.
///
/// The body of a `#[device]` function finds the rules of its own generator under the name `check`; the units come from
/// the `#[param(unit = …)]` of its parameters. A function that the body calls takes `check` as an argument.
///
/// ```
/// # use phidl_core::param::Check;
/// let check = Check::new("optimal_hairpin").unit("µm"); // in a generator: `check` is there
/// let (pitch, width) = (0.2, 0.35);
/// assert_eq!(
///     check.greater("pitch", pitch, ("width", width)).unwrap_err().to_string(),
///     "optimal_hairpin: pitch is 0.2 µm, but it must be greater than width, 0.35 µm"
/// );
/// check.greater("width", width, 0)?;
/// check.at_most("width", width, ("twice the pitch", 2.0 * pitch))?;
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Check<'a> {
    device: &'a str,
    /// The parameters that have units.
    params: &'a [ParamSpec],
    /// The sign of the unit of all numbers, whatever `params` say.
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
    /// Rules of an ordinary function that draws a device with this name. No parameter has a unit.
    #[must_use]
    pub const fn new(device: &'a str) -> Self {
        Self { device, params: &[], unit: None }
    }

    /// Rules of a generator.
    pub(crate) fn of(device: &'a str, params: &'a [ParamSpec]) -> Self {
        Self { device, params, unit: None }
    }

    /// The same rules for a number that is computed from parameters, shown with this sign of its unit: `µm`.
    #[must_use]
    pub fn unit(self, sign: &'a str) -> Self {
        Self { unit: Some(sign), ..self }
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

    /// A count that the parameters decide, such as the points of a curve, must not be greater than
    /// [`count::MOST`]. To be checked before memory is taken for them.
    #[expect(clippy::missing_errors_doc, reason = "stated for all rules in `finite`")]
    pub fn count(&self, what: &str, n: impl ToF64) -> Result<()> {
        self.at_most(what, n, count::MOST)
    }

    /// Any other rule: refuses the parameter unless the condition holds. The rule is the end of "it must …".
    ///
    /// ```
    /// # use phidl_core::param::Check;
    /// # let check = Check::new("star");
    /// let error = check.that("num_points", 2, false, "be at least 3 to enclose anything").unwrap_err();
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
        relation: &str,
        limit: Bound<'_>,
        holds: impl Fn(f64, f64) -> bool,
    ) -> Result<()> {
        self.finite(param, value)?;
        self.require(param, value, holds(value, limit.number), || {
            let number = Quantity(limit.number, self.unit_of(param));
            match limit.name {
                Some(name) => format!("be {relation} {name}, {number}"),
                None => format!("be {relation} {number}"),
            }
        })
    }

    fn require(&self, param: &str, value: f64, holds: bool, rule: impl FnOnce() -> String) -> Result<()> {
        if holds {
            return Ok(());
        }
        Err(self.error(param, Quantity(value, self.unit_of(param)).to_string(), rule()))
    }

    /// The sign of the unit of a parameter or of a part of one, such as `size.width` or `gaps[2]`.
    fn unit_of(&self, param: &str) -> &'a str {
        let name = param.split(['.', '[']).next().unwrap_or(param);
        let stated = || self.params.iter().find(|spec| spec.name() == name).map(|spec| spec.unit().sign());
        self.unit.or_else(stated).unwrap_or_default()
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
        let check = Check::new("ring");
        assert!(check.greater("width", 0.5, 0).is_ok() && check.greater("width", 0, 0).is_err());
        assert!(check.at_least("width", 0, 0).is_ok() && check.at_least("width", -0.1, 0).is_err());
        assert!(check.less("width", 0.5, 1).is_ok() && check.less("width", 1, 1).is_err());
        assert!(check.at_most("width", 1, 1).is_ok() && check.at_most("width", 1.5, 1).is_err());
        assert!(check.between("width", 1, 0, 1).is_ok() && check.between("width", 2, 0, 1).is_err());
    }

    #[test]
    fn counts_have_one_limit() {
        let check = Check::new("ellipse");
        assert!(check.count("number of points", count::MOST).is_ok());
        let error = check.count("number of points", count::MOST + 1).unwrap_err();
        let sentence = "ellipse: number of points is 16777217, but it must be at most 16777216";
        assert_eq!(error.to_string(), sentence);
    }

    #[test]
    fn nan_and_infinity_break_every_rule() {
        let check = Check::new("ring");
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
