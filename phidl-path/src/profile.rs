//! [`Profile`]: a width or an offset along a path.

use std::f64::consts::PI;
use std::sync::Arc;

use phidl_core::Result;

use crate::rule;

/// A length along a path, as a function of t: the fraction (0 to 1) of the path's length before the point.
///
/// A profile can be given as a number, a pair (a linear change from start to end), a function, or a list with one value
/// for each point of the path.
///
/// ```
/// # use phidl_path::Profile;
/// assert_eq!(Profile::from(2).at(0.7), Some(2.0));
/// assert_eq!(Profile::from((2, 4)).at(0.5), Some(3.0));
/// assert_eq!(Profile::from(|t: f64| 3.0 + t * t).at(1.0), Some(4.0));
/// ```
#[derive(Clone)]
#[non_exhaustive]
pub enum Profile {
    /// The same everywhere (µm).
    Constant(f64),
    /// From the first value to the second (µm), in proportion to the length.
    Linear(f64, f64),
    /// From the first value to the second (µm) as a raised cosine: without a kink at either end.
    Sine(f64, f64),
    /// A function of t (µm).
    Function(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
    /// A value for each point of the path (µm).
    Samples(Vec<f64>),
}

impl Profile {
    /// The value at the fraction `t` of the length; `None` for a list, whose values belong to the points of one path.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<f64> {
        match self {
            Self::Constant(v) => Some(*v),
            Self::Linear(from, to) => Some(from + t * (to - from)),
            Self::Sine(from, to) => Some(from + raised_cosine(t) * (to - from)),
            Self::Function(f) => Some(f(t)),
            Self::Samples(_) => None,
        }
    }

    /// The value of a constant profile.
    #[must_use]
    pub fn constant(&self) -> Option<f64> {
        match self {
            Self::Constant(v) => Some(*v),
            _ => None,
        }
    }

    /// The profile with the opposite sign: an offset on the other side of the path.
    #[must_use]
    pub fn negated(&self) -> Self {
        match self {
            Self::Constant(v) => Self::Constant(-v),
            Self::Linear(from, to) => Self::Linear(-from, -to),
            Self::Sine(from, to) => Self::Sine(-from, -to),
            Self::Function(f) => {
                let f = f.clone();
                Self::Function(Arc::new(move |t| -f(t)))
            }
            Self::Samples(values) => Self::Samples(values.iter().map(|v| -v).collect()),
        }
    }

    /// Whether the profile is a number or a known law between two numbers. An offset of this kind is measured square to
    /// the path; see [`Section::offset`](crate::Section::offset).
    pub(crate) fn is_law(&self) -> bool {
        matches!(self, Self::Constant(_) | Self::Linear(..) | Self::Sine(..))
    }

    /// The values at all points of a path.
    pub(crate) fn sampled(&self, what: &str, param: &str, fractions: &[f64]) -> Result<Vec<f64>> {
        let values: Vec<f64> = match self {
            Self::Samples(values) if values.len() == fractions.len() => values.clone(),
            Self::Samples(values) => {
                let rule = format!("have one for each of the {} points of the path", fractions.len());
                return Err(rule::refused(what, param, format!("a list of {} values", values.len()), rule));
            }
            Self::Constant(v) => vec![*v; fractions.len()],
            Self::Linear(from, to) => fractions.iter().map(|t| from + t * (to - from)).collect(),
            Self::Sine(from, to) => fractions.iter().map(|t| from + raised_cosine(*t) * (to - from)).collect(),
            Self::Function(f) => fractions.iter().map(|t| f(*t)).collect(),
        };
        match values.iter().position(|v| !v.is_finite()) {
            None => Ok(values),
            Some(i) => {
                Err(rule::refused(what, param, format!("{} µm at t = {}", values[i], fractions[i]), "be finite"))
            }
        }
    }

    /// Refuses a number that is not finite, before a path is known.
    pub(crate) fn check(&self, what: &str, param: &str) -> Result<()> {
        let numbers = match self {
            Self::Constant(v) => [*v, *v],
            Self::Linear(from, to) | Self::Sine(from, to) => [*from, *to],
            Self::Function(_) | Self::Samples(_) => return Ok(()),
        };
        match numbers.into_iter().find(|v| !v.is_finite()) {
            None => Ok(()),
            Some(v) => Err(rule::refused(what, param, format!("{v} µm"), "be finite")),
        }
    }
}

/// From 0 to 1 with slope 0 at both ends.
fn raised_cosine(t: f64) -> f64 {
    (1.0 - (PI * t).cos()) / 2.0
}

impl std::fmt::Debug for Profile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Constant(v) => v.fmt(f),
            Self::Linear(from, to) => write!(f, "{from} to {to}"),
            Self::Sine(from, to) => write!(f, "{from} to {to} as a raised cosine"),
            Self::Function(_) => f.write_str("a function of t"),
            Self::Samples(values) => values.fmt(f),
        }
    }
}

macro_rules! from_number {
    ($($number:ty),*) => {$(
        impl From<$number> for Profile {
            fn from(v: $number) -> Self {
                Self::Constant(v.into())
            }
        }
    )*};
}

from_number!(f32, f64, i8, i16, i32, u8, u16, u32);

impl<A: Into<f64>, B: Into<f64>> From<(A, B)> for Profile {
    fn from((from, to): (A, B)) -> Self {
        Self::Linear(from.into(), to.into())
    }
}

impl<N: Into<f64>> From<[N; 2]> for Profile {
    fn from([from, to]: [N; 2]) -> Self {
        Self::Linear(from.into(), to.into())
    }
}

impl From<Vec<f64>> for Profile {
    fn from(values: Vec<f64>) -> Self {
        Self::Samples(values)
    }
}

impl From<&Profile> for Profile {
    fn from(profile: &Profile) -> Self {
        profile.clone()
    }
}

impl<F: Fn(f64) -> f64 + Send + Sync + 'static> From<F> for Profile {
    fn from(f: F) -> Self {
        Self::Function(Arc::new(f))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_must_have_a_value_for_each_point() {
        let profile = Profile::from(vec![1.0, 2.0]);
        assert_eq!(profile.sampled("section", "width", &[0.0, 1.0]).unwrap(), [1.0, 2.0]);
        let error = profile.sampled("section", "width", &[0.0, 0.5, 1.0]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "section: width is a list of 2 values, but it must have one for each of the 3 points of the path"
        );
    }

    #[test]
    fn a_function_that_is_not_finite_is_refused_with_its_argument() {
        let error = Profile::from(|t: f64| 1.0 / (t - 0.5)).sampled("section", "width", &[0.0, 0.5]).unwrap_err();
        assert_eq!(error.to_string(), "section: width is inf µm at t = 0.5, but it must be finite");
    }

    #[test]
    fn the_other_side_has_the_other_sign() {
        for profile in [Profile::from(2), (2, 2).into(), Profile::Sine(2.0, 2.0), Profile::from(|_: f64| 2.0)] {
            assert_eq!(profile.negated().at(0.3), Some(-2.0));
        }
    }
}
