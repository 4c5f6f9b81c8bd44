//! `differences.toml`: where ours differs from the reference on purpose.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value as Json;

use super::Case;
use super::cases::own_folder;
use super::condition::{When, all_hold};
use super::facts::{Reference, Rule, is_out_of_domain};

/// One deliberate difference. Everything that is in none must match.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Difference {
    /// The generators or routes it is about; `path.…` for the ways of a path.
    pub function: Names,
    /// When it applies, in words.
    pub condition: String,
    /// When it applies: conditions on parameters, or several sets of them of which one must hold. None: always.
    #[serde(default)]
    when: Whens,
    /// When it applies: what the reference makes of the case.
    reference: Option<Reference>,
    /// When it applies: only where a parameter is outside the domain that the registry states.
    #[serde(default)]
    out_of_domain: bool,
    /// When it applies: a rule that needs computation.
    rule: Option<Rule>,
    /// Whether the given cases hold none that it applies to.
    #[serde(default)]
    pub further: bool,
    /// Why ours differs: the Quirk of the specification, or a proof.
    pub reason: String,
    /// What is compared instead, in words.
    pub instead: String,
    /// What is compared instead.
    pub compare: Instead,
    /// For [`Instead::Nearby`]: numbers that are changed by a hair.
    #[serde(default)]
    pub nudge: Vec<String>,
    /// For [`Instead::With`]: parameters of ours that the reference does not have.
    #[serde(default)]
    pub with: BTreeMap<String, Json>,
}

/// One name or several.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub enum Names {
    /// One function; `*` is every shape.
    One(String),
    /// Several functions.
    Many(Vec<String>),
}

#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
enum Whens {
    One(When),
    AnyOf(Vec<When>),
}

impl Default for Whens {
    fn default() -> Self {
        Self::One(When::new())
    }
}

/// What is compared where ours differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Instead {
    /// The covered region, ports and info.
    Region,
    /// Ports and info.
    Ports,
    /// Ours refuses.
    Error,
    /// Ours refuses, or draws what the reference draws.
    ErrorOrSame,
    /// Ours draws, where the reference refuses.
    Drawn,
    /// Ours with a number changed by a hair draws what the reference draws.
    Nearby,
    /// Ours with other parameters draws what the reference draws.
    With,
    /// Every corner is within a step of the grid; ports, info and box.
    CornersToAStep,
    /// Nothing here: a test of its own does.
    Nothing,
}

impl Names {
    /// The names.
    #[must_use]
    pub fn list(&self) -> Vec<&str> {
        match self {
            Self::One(name) => vec![name],
            Self::Many(names) => names.iter().map(String::as_str).collect(),
        }
    }
}

impl Difference {
    /// Whether it is about a function.
    #[must_use]
    pub fn is_about(&self, function: &str) -> bool {
        self.function.list().contains(&function)
    }

    /// Whether it applies to a case.
    #[must_use]
    pub fn applies_to(&self, case: &Case) -> bool {
        let names = self.function.list();
        let function = if case.device.is_empty() { &case.function } else { &case.device };
        let when = match &self.when {
            Whens::One(when) => all_hold(when, case),
            Whens::AnyOf(whens) => whens.iter().any(|when| all_hold(when, case)),
        };
        let named = names.contains(&function.as_str()) || (names == ["*"] && !case.device.is_empty());
        named
            && when
            && (!self.out_of_domain || is_out_of_domain(case))
            && self.rule.is_none_or(|rule| rule.holds(case))
            && self.reference.is_none_or(|reference| reference.holds(case))
    }
}

/// All deliberate differences.
///
/// # Panics
/// If the file cannot be read.
#[must_use]
pub fn differences() -> Vec<Difference> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        #[serde(default)]
        difference: Vec<Difference>,
    }
    let path = own_folder().join("differences.toml");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let file: File = toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    file.difference
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_compared_has_what_it_needs() {
        for difference in differences() {
            assert_eq!(
                difference.compare == Instead::Nearby,
                !difference.nudge.is_empty(),
                "{:?}",
                difference.function
            );
            assert_eq!(difference.compare == Instead::With, !difference.with.is_empty(), "{:?}", difference.function);
        }
    }
}
