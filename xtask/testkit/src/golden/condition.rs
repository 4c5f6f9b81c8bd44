//! Conditions on the parameters of a case, as `differences.toml` writes them.

use std::collections::BTreeMap;

use phidl_core::runtime::registry;
use serde::Deserialize;
use serde_json::Value as Json;

use super::Case;

/// Conditions on parameters, by name. A name may go into a list or a map: `size.0`, `port.width`. All must hold.
pub(super) type When = BTreeMap<String, Condition>;

/// What a parameter must be: a value, or what a table says of it.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(super) enum Condition {
    /// Tests; all must hold.
    Tests(Tests),
    /// A wrong table is not a value: this variant keeps a misspelt test from being read as one.
    Wrong(BTreeMap<String, Json>),
    /// This value; numbers are equal as numbers.
    Value(Json),
}

/// Tests of a value. Those with bounds hold for a list if they hold for one of its numbers; against a list of bounds,
/// number by number.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Tests {
    above: Option<Bound>,
    at_least: Option<Bound>,
    below: Option<Bound>,
    at_most: Option<Bound>,
    /// One of these values.
    any_of: Option<Vec<Json>>,
    /// None of these values.
    none_of: Option<Vec<Json>>,
    /// Whether the case gives it (and not null); with the default it does not count as given.
    given: Option<bool>,
    /// Whether it is null.
    null: Option<bool>,
    /// Whether it is a list, a map or several layers.
    several: Option<bool>,
    /// A map with a key that is none of these.
    key_none_of: Option<Vec<String>>,
    /// A list that is not as long as this parameter.
    not_as_long_as: Option<String>,
}

/// A number, another parameter, or a multiple of another parameter.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
enum Bound {
    Number(f64),
    Param(String),
    #[serde(rename_all = "snake_case")]
    Multiple(Multiple),
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Multiple {
    times: f64,
    of: String,
}

/// Whether all conditions hold for a case; parameters that it does not give are the registry's defaults.
#[must_use]
pub(super) fn all_hold(when: &When, case: &Case) -> bool {
    when.iter().all(|(name, condition)| condition.holds(name, case))
}

/// A parameter of a case, or what it is by default; a name may go into lists and maps.
#[must_use]
pub(super) fn parameter(case: &Case, name: &str) -> Option<Json> {
    let mut steps = name.split('.');
    let first = steps.next()?;
    let value = case.params.get(first).cloned().or_else(|| default(case, first))?;
    steps.try_fold(value, |value, step| match step.parse::<usize>() {
        Ok(index) => value.get(index).cloned(),
        Err(_) => value.get(step).cloned(),
    })
}

fn default(case: &Case, name: &str) -> Option<Json> {
    let generator = if case.device.is_empty() { &case.function } else { &case.device };
    let params = registry::find(generator).ok()?.params();
    let default = params.into_iter().find(|param| param.name == name)?.default?;
    serde_json::to_value(default).ok()
}

impl Condition {
    fn holds(&self, name: &str, case: &Case) -> bool {
        let value = parameter(case, name);
        match self {
            Self::Tests(tests) => tests.hold(name, value.as_ref(), case),
            Self::Wrong(table) => panic!("differences.toml has no test like {table:?}, of {name}"),
            Self::Value(expected) => value.is_some_and(|value| same(&value, expected)),
        }
    }
}

impl Tests {
    fn hold(&self, name: &str, value: Option<&Json>, case: &Case) -> bool {
        let compares = |bound: &Option<Bound>, holds: fn(f64, f64) -> bool| {
            bound.as_ref().is_none_or(|bound| value.is_some_and(|value| bound.is_met(value, case, holds)))
        };
        let is_one_of = |values: &[Json]| value.is_some_and(|value| values.iter().any(|other| same(value, other)));
        compares(&self.above, |a, b| a > b)
            && compares(&self.at_least, |a, b| a >= b)
            && compares(&self.below, |a, b| a < b)
            && compares(&self.at_most, |a, b| a <= b)
            && self.any_of.as_ref().is_none_or(|values| is_one_of(values))
            && self.none_of.as_ref().is_none_or(|values| !is_one_of(values))
            && self.given.is_none_or(|given| case.params.get(name).is_some_and(|value| !value.is_null()) == given)
            && self.null.is_none_or(|null| value.is_some_and(Json::is_null) == null)
            && self.several.is_none_or(|several| value.is_some_and(|v| v.is_array() || v.is_object()) == several)
            && self.key_none_of.as_ref().is_none_or(|keys| has_another_key(value, keys))
            && self.not_as_long_as.as_ref().is_none_or(|other| differ_in_length(value, parameter(case, other).as_ref()))
    }
}

impl Bound {
    fn is_met(&self, value: &Json, case: &Case, holds: fn(f64, f64) -> bool) -> bool {
        let (of, times) = match self {
            Self::Number(bound) => return numbers(value).iter().any(|v| holds(*v, *bound)),
            Self::Param(of) => (of, 1.0),
            Self::Multiple(multiple) => (&multiple.of, multiple.times),
        };
        let bounds = parameter(case, of).map(|bound| numbers(&bound)).unwrap_or_default();
        match (&numbers(value)[..], &bounds[..]) {
            (values, [bound]) => values.iter().any(|v| holds(*v, times * bound)),
            (values, bounds) => values.iter().zip(bounds).any(|(v, bound)| holds(*v, times * bound)),
        }
    }
}

/// The number, or those of a list.
pub(super) fn numbers(value: &Json) -> Vec<f64> {
    match value {
        Json::Array(list) => list.iter().filter_map(Json::as_f64).collect(),
        single => single.as_f64().into_iter().collect(),
    }
}

fn has_another_key(value: Option<&Json>, keys: &[String]) -> bool {
    value.and_then(Json::as_object).is_some_and(|map| map.keys().any(|key| !keys.contains(key)))
}

fn differ_in_length(a: Option<&Json>, b: Option<&Json>) -> bool {
    let length = |value: Option<&Json>| value.and_then(Json::as_array).map(Vec::len);
    length(a) != length(b)
}

/// Equality of values; `10` is `10.0`.
fn same(a: &Json, b: &Json) -> bool {
    match (a, b) {
        (Json::Number(a), Json::Number(b)) => a.as_f64() == b.as_f64(),
        (Json::Array(a), Json::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Json::Object(a), Json::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
        }
        (a, b) => a == b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(params: &str) -> Case {
        serde_json::from_str(&format!(r#"{{"id": "x", "device": "nothing", "params": {params}, "expect": {{}}}}"#))
            .unwrap()
    }

    fn holds(when: &str, params: &str) -> bool {
        all_hold(&toml::from_str(when).unwrap(), &case(params))
    }

    #[test]
    fn numbers_are_compared_with_numbers_and_other_parameters() {
        assert!(holds("a.above = 1", r#"{"a": 2}"#) && !holds("a.above = 2", r#"{"a": 2}"#));
        assert!(holds("a.below = 'b'", r#"{"a": 2, "b": 3}"#) && !holds("a.below = 'b'", r#"{"a": 2}"#));
        assert!(holds("a.above = { times = 30, of = 'b' }", r#"{"a": 31, "b": 1}"#));
        assert!(!holds("a.above = { times = 30, of = 'b' }", r#"{"a": 30, "b": 1}"#));
        assert!(
            holds("'s.1' = { at_most = 0 }", r#"{"s": [1, 0]}"#)
                && !holds("'s.0' = { at_most = 0 }", r#"{"s": [1, 0]}"#)
        );
    }

    #[test]
    fn lists_are_compared_number_by_number() {
        assert!(holds("a.below = 'b'", r#"{"a": [5, 1], "b": [4, 2]}"#));
        assert!(!holds("a.below = 'b'", r#"{"a": [5, 3], "b": [4, 2]}"#));
        assert!(holds("a.not_as_long_as = 'b'", r#"{"a": [5, 3], "b": [4]}"#));
    }

    #[test]
    fn values_are_equal_as_numbers_and_words_as_words() {
        assert!(holds("a = 10", r#"{"a": 10.0}"#) && holds("a = [1, 2.0]", r#"{"a": [1.0, 2]}"#));
        assert!(
            holds("a = { any_of = ['x', 'y'] }", r#"{"a": "y"}"#) && !holds("a = { none_of = ['x'] }", r#"{"a": "x"}"#)
        );
        assert!(holds("a = { given = true }", r#"{"a": 1}"#) && holds("a = { given = false }", r#"{"a": null}"#));
        assert!(holds("a = { key_none_of = ['N'] }", r#"{"a": {"n": 1}}"#));
    }

    #[test]
    #[should_panic(expected = "no test like")]
    fn a_misspelt_test_is_a_mistake() {
        holds("a = { abov = 1 }", r#"{"a": 1}"#);
    }
}
