//! The registry, readable.

use phidl_core::param::{Bounds, ParamType};
use phidl_core::registry;
use phidl_core::runtime::{GeneratorInfo, ParamInfo};
use serde_json::{Value as Json, json};

use super::{CliError, first_paragraph};

/// Every registered device whose name contains a text: for people, or as JSON for programs.
///
/// # Errors
/// [`CliError::Usage`] if there is none.
pub fn list(filter: &str, as_json: bool) -> Result<String, CliError> {
    let entries: Vec<&GeneratorInfo> = registry::all().filter(|entry| entry.name.contains(filter)).collect();
    if entries.is_empty() {
        return Err(CliError::Usage(format!("no device has a name that contains {filter:?}")));
    }
    Ok(match as_json {
        true => format!("{:#}", to_json(&entries)),
        false => entries.into_iter().map(describe).collect::<Vec<_>>().join("\n"),
    })
}

/// What other programs need to draw devices by name: parameters with kinds in words, words to choose from, bounds, units
/// and defaults.
#[must_use]
pub fn to_json(entries: &[&GeneratorInfo]) -> Json {
    let devices = entries.iter().map(|entry| {
        let params: Vec<Json> = entry.params().iter().map(param_to_json).collect();
        json!({ "name": entry.name, "module": entry.module, "version": entry.version, "params": params })
    });
    devices.collect()
}

fn param_to_json(param: &ParamInfo) -> Json {
    let Bounds { min, above, max, below } = param.bounds;
    json!({
        "name": param.name,
        "kind": param.kind.to_string(),
        "choices": choices(&param.kind),
        "optional": matches!(param.kind, ParamType::Optional(_)),
        "required": param.default.is_none(),
        "default": param.default,
        "unit": param.unit,
        "bounds": { "min": min, "above": above, "max": max, "below": below },
    })
}

fn choices(kind: &ParamType) -> Option<&'static [&'static str]> {
    match kind {
        ParamType::Choice(words) => Some(words),
        ParamType::Optional(inner) => choices(inner),
        _ => None,
    }
}

/// Name, first paragraph of the docs, and a line for each parameter.
fn describe(entry: &GeneratorInfo) -> String {
    let summary = first_paragraph(entry.docs);
    let mut text = format!("{}  ({} {})\n    {summary}\n", entry.name, entry.module, entry.version);
    for param in entry.params() {
        text += &format!("    {}\n", describe_param(&param));
    }
    text
}

/// What it takes, what it is if it is not given, and what it is for.
fn describe_param(param: &ParamInfo) -> String {
    let mut takes = param.kind.to_string();
    if let Some(unit) = param.unit {
        takes += &format!(" in {unit}");
    }
    if param.bounds != Bounds::NONE {
        takes += &format!(", {}", param.bounds);
    }
    let default = param.default.as_ref().map_or_else(|| "required".to_owned(), |default| format!("= {default}"));
    let docs = first_paragraph(param.docs);
    format!("{:<18} {default:<14} {docs}\n    {:<18} {:<14} ({takes})", param.name, "", "")
}
