//! `differences.toml`: where ours differs from the reference on purpose.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value as Json;

use super::Case;
use super::cases::own_folder;

/// One deliberate difference. Everything that is in none must match.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Difference {
    /// The generator or route it is about.
    pub function: String,
    /// When it applies, in words.
    pub condition: String,
    /// When it applies: parameters that the case gives with these values. None: always.
    #[serde(default)]
    pub when: BTreeMap<String, Json>,
    /// When it applies: parameters that the case gives at all.
    #[serde(default)]
    pub given: Vec<String>,
    /// Why ours differs: the Quirk of the specification, or a proof.
    pub reason: String,
    /// What is compared instead, in words.
    pub instead: String,
    /// What is compared instead: `region`, `ports` (with info), `error` (ours refuses), or `nothing` here because a test of its own does.
    pub compare: String,
}

impl Difference {
    /// Whether it applies to a case.
    #[must_use]
    pub fn applies_to(&self, case: &Case) -> bool {
        (self.function == case.device || self.function == case.function)
            && self.given.iter().all(|name| case.params.contains_key(name))
            && self.when.iter().all(|(name, value)| case.params.get(name) == Some(value))
    }
}

/// All deliberate differences.
///
/// # Panics
/// If the file cannot be read.
#[must_use]
pub fn differences() -> Vec<Difference> {
    #[derive(Deserialize)]
    struct File {
        #[serde(default)]
        difference: Vec<Difference>,
    }
    let path = own_folder().join("differences.toml");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let file: File = toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    file.difference
}
