//! [`Sweep`]: the values that a parameter sweep takes along one direction.
//!
//! The order of its parameters decides the order of the cells, so it is a list of names with values. In JSON it may be
//! written as an object, whose names are sorted; a list of pairs keeps another order.

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;

/// Largest number of cells of a sweep.
pub(super) const MOST_CELLS: usize = 100_000;

/// One set of swept values with their names, in the order of the sweep.
pub(super) type Combination = Vec<(String, Value)>;

/// What changes along one direction of a sweep.
///
/// ```
/// # use phidl_geometry::arrange::Sweep;
/// let widths = Sweep::from([("width", [1, 5, 6, 7])]);
/// let shapes = Sweep::over("width", [1, 5]).and("shape", ["p", "q"]); // p, q at width 1, then p, q at width 5
/// let _three_alike = Sweep::from(3);
/// assert_ne!(widths, shapes);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Sweep {
    /// Nothing: one cell.
    Once,
    /// This number of equal cells.
    Copies(i64),
    /// Every combination of the values of these parameters; those of the last one change fastest.
    Over(Vec<(String, Vec<Value>)>),
}

impl Sweep {
    /// The values of one parameter.
    pub fn over<V: Into<Value>>(name: impl Into<String>, values: impl IntoIterator<Item = V>) -> Self {
        Self::Over(vec![(name.into(), values.into_iter().map(Into::into).collect())])
    }

    /// The same for each value of one more parameter, which changes faster than those before. Copies are forgotten.
    #[must_use]
    pub fn and<V: Into<Value>>(self, name: impl Into<String>, values: impl IntoIterator<Item = V>) -> Self {
        let mut all = match self {
            Self::Over(all) => all,
            Self::Once | Self::Copies(_) => Vec::new(),
        };
        all.push((name.into(), values.into_iter().map(Into::into).collect()));
        Self::Over(all)
    }

    /// The names of the swept parameters.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        let parameters = match self {
            Self::Over(parameters) => parameters.as_slice(),
            Self::Once | Self::Copies(_) => &[],
        };
        parameters.iter().map(|(name, _)| name.as_str())
    }

    /// Every combination, in order.
    ///
    /// # Errors
    /// A parameter without values or named twice, no copies, or more combinations than anyone can draw; in the name of
    /// the parameter that the sweep was given for.
    pub(super) fn combinations(&self, check: Check<'_>, param: &str) -> Result<Vec<Combination>> {
        let parameters = match self {
            Self::Once => return Ok(vec![Vec::new()]),
            Self::Copies(copies) => {
                check.between(param, *copies, 1, MOST_CELLS)?;
                return Ok(vec![Vec::new(); usize::try_from(*copies).unwrap_or_default()]);
            }
            Self::Over(parameters) => parameters,
        };
        let mut combinations: Vec<Combination> = vec![Vec::new()];
        for (index, (name, values)) in parameters.iter().enumerate() {
            let site = format!("{param}[{name:?}]");
            check.that(&site, "empty", !values.is_empty(), "have at least one value")?;
            let first = parameters[..index].iter().all(|(other, _)| other != name);
            check.that(&site, "given twice", first, "be given once")?;
            let cells = combinations.len().saturating_mul(values.len());
            check.at_most(&format!("number of cells of {param}"), cells, MOST_CELLS)?;
            combinations = extended(&combinations, name, values);
        }
        Ok(combinations)
    }
}

/// Every combination with every value of one more parameter.
fn extended(combinations: &[Combination], name: &str, values: &[Value]) -> Vec<Combination> {
    let with = |combination: &Combination, value: &Value| {
        let mut longer = combination.clone();
        longer.push((name.to_owned(), value.clone()));
        longer
    };
    combinations.iter().flat_map(|c| values.iter().map(move |value| with(c, value))).collect()
}

impl From<i32> for Sweep {
    fn from(copies: i32) -> Self {
        Self::Copies(copies.into())
    }
}

impl From<Option<Self>> for Sweep {
    fn from(sweep: Option<Self>) -> Self {
        sweep.unwrap_or(Self::Once)
    }
}

impl<K: Into<String>, V: Into<Value>, I: IntoIterator<Item = V>, const N: usize> From<[(K, I); N]> for Sweep {
    fn from(parameters: [(K, I); N]) -> Self {
        let parameter = |(name, values): (K, I)| (name.into(), values.into_iter().map(Into::into).collect());
        Self::Over(parameters.into_iter().map(parameter).collect())
    }
}

impl Param for Sweep {
    fn param_type() -> ParamType {
        ParamType::Other("values by parameter, number of copies, or nothing")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Once => Value::Null,
            Self::Copies(copies) => (*copies).into(),
            Self::Over(parameters) => {
                let pair = |(name, values): &(String, Vec<Value>)| {
                    Value::List(vec![name.as_str().into(), Value::List(values.clone())])
                };
                Value::List(parameters.iter().map(pair).collect())
            }
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(Self::Once),
            Value::Map(map) => {
                let parameter = |(name, values): (&String, &Value)| {
                    let values = Vec::from_value(values).map_err(|mismatch| mismatch.at(format_args!("[{name:?}]")))?;
                    Ok((name.clone(), values))
                };
                map.iter().map(parameter).collect::<Result<_, _>>().map(Self::Over)
            }
            Value::List(pairs) => pairs.iter().map(pair).collect::<Result<_, _>>().map(Self::Over),
            number => i64::from_value(number).map(Self::Copies),
        }
    }
}

fn pair(value: &Value) -> Result<(String, Vec<Value>), ConversionError> {
    match value.as_list() {
        Some([Value::Text(name), Value::List(values)]) => Ok((name.clone(), values.clone())),
        _ => Err(ConversionError::new(value, "be a parameter's name and the list of its values")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_parameter_changes_fastest() {
        let sweep = Sweep::over("a", [1, 2]).and("b", ["x", "y", "z"]);
        let shown: Vec<String> = sweep
            .combinations(Check::new("gridsweep"), "param_x")
            .unwrap()
            .iter()
            .map(|c| c.iter().map(|(name, value)| format!("{name}{value}")).collect::<String>())
            .collect();
        let expected = ["a1b\"x\"", "a1b\"y\"", "a1b\"z\"", "a2b\"x\"", "a2b\"y\"", "a2b\"z\""];
        assert_eq!(shown, expected);
    }

    #[test]
    fn sweeps_come_back_from_their_values_and_from_objects() {
        let sweep = Sweep::over("width", [1.5]).and("length", [2, 3]);
        for sweep in [Sweep::Once, Sweep::Copies(4), sweep] {
            assert_eq!(Sweep::from_value(&sweep.to_value()).unwrap(), sweep);
        }
        let object = Value::Map([("width".to_owned(), Value::from([1, 5]))].into());
        assert_eq!(Sweep::from_value(&object).unwrap(), Sweep::over("width", [1, 5]));
        assert!(Sweep::from_value(&Value::from("width")).is_err());
        assert!(Sweep::from_value(&Value::from([1, 2])).is_err());
    }

    #[test]
    fn nothing_to_sweep_over_is_refused() {
        assert!(Sweep::Copies(0).combinations(Check::new("gridsweep"), "param_x").is_err());
        assert!(Sweep::over("a", Vec::<i32>::new()).combinations(Check::new("gridsweep"), "param_x").is_err());
        assert!(Sweep::over("a", [1]).and("a", [2]).combinations(Check::new("gridsweep"), "param_x").is_err());
        let many = (0..10).fold(Sweep::Once, |sweep, n| sweep.and(format!("p{n}"), 0..100));
        assert!(many.combinations(Check::new("gridsweep"), "param_x").is_err());
    }
}
