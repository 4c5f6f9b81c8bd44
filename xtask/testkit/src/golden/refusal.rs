//! The class of a refusal: whether ours refuses a case for the right reason.

use phidl_core::prelude::*;
use serde_json::Value as Json;

use super::facts::is_out_of_bounds;
use super::{Case, Refusal};

impl Case {
    /// The class of the refusal that the case states for ours, beside the error of the reference.
    #[must_use]
    pub fn refusal(&self) -> Option<Refusal> {
        serde_json::from_value(self.expect.get("refusal")?.clone()).ok()
    }
}

/// Checks that a case was refused, and for a reason of a class.
///
/// # Errors
/// What is wrong.
pub fn assert_refused<T>(case: &Case, expected: Refusal, drawn: &Result<T>) -> Result<(), String> {
    let Err(error) = drawn else { return Err("ours draws it, and should refuse it".to_owned()) };
    let class = class_of(case, error);
    match class == expected {
        true => Ok(()),
        false => Err(format!("refused for {class:?} instead of {expected:?}: {}", error.report())),
    }
}

/// The class of our refusal of a case.
fn class_of(case: &Case, error: &Error) -> Refusal {
    match error.root() {
        Error::Param(param) if param.param.contains("layer") => Refusal::Layer,
        Error::Param(param) if is_word(case, &param.param) => Refusal::Choice,
        Error::Param(_) if is_out_of_bounds(case) => Refusal::Bound,
        Error::Unknown { .. } => Refusal::Choice,
        _ => Refusal::Geometry,
    }
}

/// Whether the refused parameter, which a text names, is a name among choices, or a map by names. Ports are maps, too, and
/// are refused for their position.
fn is_word(case: &Case, param: &str) -> bool {
    let is_choice = |name: &str| {
        case.parameter(name).is_some_and(|value| match value {
            Json::String(_) => name != "text",
            Json::Object(map) => !map.contains_key("midpoint"),
            _ => false,
        })
    };
    param.split([' ', '.', '[']).any(is_choice)
}
