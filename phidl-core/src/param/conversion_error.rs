//! [`ConversionError`]: a value that cannot be taken for a parameter.

use super::Value;
use crate::error::{Error, ParamError};

/// Why a [`Value`] is not what a parameter takes: the value, the rule, and the path inside the parameter.
///
/// ```
/// # use phidl_core::param::{ConversionError, Value};
/// let mismatch = ConversionError::new(&Value::from("x"), "be a number").at("[3]");
/// assert_eq!(mismatch.to_string(), "[3] is \"x\", but it must be a number");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ConversionError(Box<Inner>);

#[derive(Debug, Clone, PartialEq)]
struct Inner {
    path: String,
    value: String,
    rule: String,
    /// What went wrong when the value was to be drawn.
    cause: Option<Error>,
}

impl ConversionError {
    /// A value that breaks a rule; the rule is the end of "it must …".
    pub fn new(value: &Value, rule: impl Into<String>) -> Self {
        let (value, rule) = (excerpt(value.to_string()), rule.into());
        Self(Box::new(Inner { path: String::new(), value, rule, cause: None }))
    }

    /// A value that names a device which could not be drawn.
    pub(crate) fn caused_by(value: &Value, cause: Error) -> Self {
        let mut mismatch = Self::new(value, "be a device that can be drawn");
        mismatch.0.cause = Some(cause);
        mismatch
    }

    /// The same, one level further out: `[3]` in a list, `.width` in a size.
    #[must_use]
    pub fn at(mut self, path: impl std::fmt::Display) -> Self {
        self.0.path.insert_str(0, &path.to_string());
        self
    }

    /// The error of a generator's parameter.
    pub(crate) fn into_error(self, device: &str, param: &str) -> Error {
        let Inner { path, value, rule, cause } = *self.0;
        match cause {
            Some(cause) => cause.within(device),
            None => ParamError { device: device.to_owned(), param: format!("{param}{path}"), value, rule }.into(),
        }
    }
}

/// A text that fits into a message, since a list may have a million items.
fn excerpt(mut text: String) -> String {
    /// The length from which on a text is cut.
    const LONGEST: usize = 200;
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    text
}

impl std::fmt::Display for ConversionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Inner { path, value, rule, .. } = &*self.0;
        let path = if path.is_empty() { "the value" } else { path };
        write!(f, "{path} is {value}, but it must {rule}")
    }
}

impl std::error::Error for ConversionError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.0.cause.as_ref().map(|cause| cause as _)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_value_is_cut_in_the_message() {
        let error = ConversionError::new(&vec![7; 1_000_000].into(), "be a number").to_string();
        assert!(error.starts_with("the value is [7, 7, ") && error.ends_with("…, but it must be a number"), "{error}");
        assert!(error.len() < 300);
    }
}
