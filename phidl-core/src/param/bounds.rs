//! [`Bounds`]: the range that `#[param(min = …)]` states, checked over the value of a parameter.

use super::parameter::REFUSED;
use super::unit::Quantity;
use super::{ParamType, Value};
use crate::error::ParamError;

/// The range of every number in a parameter, in the unit of the parameter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bounds {
    /// The smallest number that is allowed.
    pub min: Option<f64>,
    /// Every number must be greater than this one.
    pub above: Option<f64>,
    /// The largest number that is allowed.
    pub max: Option<f64>,
    /// Every number must be less than this one.
    pub below: Option<f64>,
}

impl Bounds {
    /// No bounds.
    pub const NONE: Self = Self { min: None, above: None, max: None, below: None };

    /// The rule that a number breaks, as the end of "it must …".
    fn broken_by(&self, v: f64, unit: &str) -> Option<String> {
        let rule = |relation: &str, limit: f64| Some(format!("{relation} {}", Quantity(limit, unit)));
        if !v.is_finite() {
            return Some("be finite".to_owned());
        }
        match *self {
            Self { min: Some(min), .. } if v < min => rule("be at least", min),
            Self { above: Some(above), .. } if v <= above => rule("be greater than", above),
            Self { max: Some(max), .. } if v > max => rule("be at most", max),
            Self { below: Some(below), .. } if v >= below => rule("be less than", below),
            _ => None,
        }
    }

    /// Checks every number of a parameter: inside lists, maps and options, and each coordinate of a pair.
    ///
    /// Nearly every value is valid, so the path of a number is written only after one was found to be wrong.
    pub(crate) fn check(&self, at: ParamPath<'_>, kind: fn() -> ParamType, value: &Value) -> Result<(), ParamError> {
        if self.admits(value) { Ok(()) } else { self.explain(at, &kind(), value) }
    }

    /// A fast check: true means valid; false means that `explain` must decide, since a map of the user may contain the
    /// key that marks a refused port.
    fn admits(&self, value: &Value) -> bool {
        match value {
            Value::Float(v) => self.broken_by(*v, "").is_none(),
            Value::Int(v) => self.broken_by(*v as f64, "").is_none(),
            Value::List(list) => list.iter().all(|item| self.admits(item)),
            Value::Map(map) => !map.contains_key(REFUSED) && map.values().all(|item| self.admits(item)),
            Value::Null | Value::Bool(_) | Value::Text(_) | Value::Device(_) => true,
        }
    }

    /// The first number that is wrong, with its path inside the parameter.
    fn explain(&self, at: ParamPath<'_>, kind: &ParamType, value: &Value) -> Result<(), ParamError> {
        let number = |v: f64| match self.broken_by(v, at.unit) {
            Some(rule) => Err(at.error(Quantity(v, at.unit).to_string(), rule)),
            None => Ok(()),
        };
        match value {
            Value::Float(v) => number(*v),
            Value::Int(v) => number(*v as f64),
            Value::List(list) => list.iter().enumerate().try_for_each(|(i, item)| {
                let path = format!("{}{}", at.path, kind.component(i));
                self.explain(ParamPath { path: &path, ..at }, kind.inner(), item)
            }),
            Value::Map(map) if *kind.inner() == ParamType::Port && map.contains_key(REFUSED) => {
                let rule = format!("be placed with sound values, also by {}", map[REFUSED]);
                Err(at.error("a port".to_owned(), rule))
            }
            Value::Map(map) => map.iter().try_for_each(|(key, item)| {
                let path = format!("{}[{key:?}]", at.path);
                self.explain(ParamPath { path: &path, ..at }, kind.inner(), item)
            }),
            Value::Null | Value::Bool(_) | Value::Text(_) | Value::Device(_) => Ok(()),
        }
    }
}

/// Which number is checked.
#[derive(Clone, Copy)]
pub(crate) struct ParamPath<'a> {
    pub(crate) device: &'a str,
    /// The parameter with the path inside it: `size.width`.
    pub(crate) path: &'a str,
    pub(crate) unit: &'a str,
}

impl ParamPath<'_> {
    fn error(&self, value: String, rule: String) -> ParamError {
        ParamError { device: self.device.to_owned(), param: self.path.to_owned(), value, rule }
    }
}

impl std::fmt::Display for Bounds {
    /// As documentation shows them: `at least 0, less than 360`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let limits =
            [("at least", self.min), ("more than", self.above), ("at most", self.max), ("less than", self.below)];
        let mut separator = "";
        for (relation, limit) in limits {
            if let Some(limit) = limit {
                write!(f, "{separator}{relation} {limit}")?;
                separator = ", ";
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: Bounds = Bounds { above: Some(0.0), max: Some(360.0), ..Bounds::NONE };

    fn checked(kind: fn() -> ParamType, value: impl Into<Value>) -> Result<(), String> {
        let at = ParamPath { device: "ring", path: "p", unit: "µm" };
        RANGE.check(at, kind, &value.into()).map_err(|error| error.to_string())
    }

    #[test]
    fn bounds_are_open_or_closed_as_stated() {
        assert!(checked(|| ParamType::Number, 360.0).is_ok());
        assert!(checked(|| ParamType::Number, f64::MIN_POSITIVE).is_ok());
        assert_eq!(
            checked(|| ParamType::Number, 0.0),
            Err("ring: p is 0 µm, but it must be greater than 0 µm".to_owned())
        );
        assert_eq!(
            checked(|| ParamType::Integer, 361),
            Err("ring: p is 361 µm, but it must be at most 360 µm".to_owned())
        );
        assert!(checked(|| ParamType::Number, f64::NAN).unwrap_err().ends_with("it must be finite"));
    }

    #[test]
    fn every_number_inside_a_parameter_is_checked_and_named() {
        assert!(checked(|| ParamType::Size, vec![1.0, -1.0]).unwrap_err().starts_with("ring: p.height is -1 µm"));
        let list = || ParamType::List(Box::new(ParamType::Point));
        let value = vec![Value::from(vec![1.0, 2.0]), Value::from(vec![-3.0, 1.0])];
        assert!(checked(list, value).unwrap_err().starts_with("ring: p[1].x is -3 µm"));
        assert!(checked(|| ParamType::Optional(Box::new(ParamType::Number)), Value::Null).is_ok());
    }
}
