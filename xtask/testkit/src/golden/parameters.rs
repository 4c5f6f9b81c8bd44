//! Parameters of a case as conditions read them. A name may go into lists and maps: `size.0`, `port.width`.

use phidl_core::runtime::registry;
use serde_json::Value as Json;

use super::Case;

impl Case {
    /// A parameter, or its default in the registry.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<Json> {
        let mut steps = name.split('.');
        let first = steps.next()?;
        let value = self.params.get(first).cloned().or_else(|| self.default(first))?;
        steps.try_fold(value, |value, step| match step.parse::<usize>() {
            Ok(index) => value.get(index).cloned(),
            Err(_) => value.get(step).cloned(),
        })
    }

    fn default(&self, name: &str) -> Option<Json> {
        let generator = if self.device.is_empty() { &self.function } else { &self.device };
        let params = registry::find(generator).ok()?.params();
        let default = params.into_iter().find(|param| param.name == name)?.default?;
        serde_json::to_value(default).ok()
    }

    /// A number; NaN, which no comparison holds for, if it is none.
    #[must_use]
    pub fn number(&self, name: &str) -> f64 {
        self.parameter(name).and_then(|value| value.as_f64()).unwrap_or(f64::NAN)
    }

    /// The number, or those of a list.
    #[must_use]
    pub fn numbers(&self, name: &str) -> Vec<f64> {
        match self.parameter(name) {
            Some(Json::Array(list)) => list.iter().filter_map(Json::as_f64).collect(),
            single => single.and_then(|value| value.as_f64()).into_iter().collect(),
        }
    }

    /// A text.
    #[must_use]
    pub fn string(&self, name: &str) -> Option<String> {
        self.parameter(name)?.as_str().map(str::to_owned)
    }

    /// Whether a text is one of these.
    #[must_use]
    pub fn is_one_of(&self, name: &str, values: &[&str]) -> bool {
        self.string(name).is_some_and(|value| values.contains(&value.as_str()))
    }

    /// Whether the case itself gives a parameter, and not null.
    #[must_use]
    pub fn gives(&self, name: &str) -> bool {
        self.params.get(name).is_some_and(|value| !value.is_null())
    }

    /// Whether a parameter is null.
    #[must_use]
    pub fn is_null(&self, name: &str) -> bool {
        self.parameter(name).is_some_and(|value| value.is_null())
    }

    /// Whether a parameter is a list, a map or several layers.
    #[must_use]
    pub fn is_several(&self, name: &str) -> bool {
        self.parameter(name).is_some_and(|value| value.is_array() || value.is_object())
    }

    /// Whether two lists differ in length; a parameter that is no list has no length.
    #[must_use]
    pub fn differ_in_length(&self, a: &str, b: &str) -> bool {
        let length = |name: &str| self.parameter(name).and_then(|value| value.as_array().map(Vec::len));
        length(a) != length(b)
    }

    /// Whether a number of one parameter is more than a multiple of that of another: pair by pair for lists, all of
    /// them against a single number.
    #[must_use]
    pub fn exceeds(&self, a: &str, times: f64, b: &str) -> bool {
        match (&self.numbers(a)[..], &self.numbers(b)[..]) {
            (values, [bound]) => values.iter().any(|v| *v > times * bound),
            (values, bounds) => values.iter().zip(bounds).any(|(v, bound)| *v > times * bound),
        }
    }

    /// Whether the reference refuses the case.
    #[must_use]
    pub fn is_refused(&self) -> bool {
        self.expect.get("error").is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(params: &str) -> Case {
        serde_json::from_str(&format!(r#"{{"id": "x", "device": "nothing", "params": {params}, "expect": {{}}}}"#))
            .unwrap()
    }

    #[test]
    fn names_go_into_lists_and_maps() {
        let case = case(r#"{"size": [1, 2], "port": {"width": 3}}"#);
        assert_eq!((case.number("size.1"), case.number("port.width")), (2.0, 3.0));
        assert!(case.number("size.2").is_nan() && case.number("nothing").is_nan());
    }

    #[test]
    fn lists_are_compared_pair_by_pair_or_with_a_single_number() {
        let case = case(r#"{"a": [1, 9], "b": [1, 2], "c": 8, "d": 10}"#);
        assert!(case.exceeds("a", 2.0, "b") && !case.exceeds("a", 5.0, "b"));
        assert!(case.exceeds("a", 1.0, "c") && !case.exceeds("a", 1.0, "d"));
    }

    #[test]
    fn null_is_not_given() {
        let case = case(r#"{"a": null, "b": 1}"#);
        assert!(case.is_null("a") && !case.gives("a") && case.gives("b") && !case.gives("c"));
        assert!(!case.differ_in_length("a", "b"));
    }
}
