//! `cargo xtask devices`: the registry, readable.

use phidl_core::param::Bounds;
use phidl_core::registry;
use phidl_core::runtime::{Entry, ParamInfo};

use crate::flags::DevicesFlags;

/// Prints every registered device whose name matches.
pub(crate) fn run(flags: &DevicesFlags) -> anyhow::Result<()> {
    let filter = flags.filter.as_deref().unwrap_or_default();
    let entries: Vec<&Entry> = registry::all().filter(|entry| entry.name.contains(filter)).collect();
    anyhow::ensure!(!entries.is_empty(), "no device has a name that contains {filter:?}");
    for entry in entries {
        println!("{}", describe(entry));
    }
    Ok(())
}

/// Name, first paragraph of the docs, and a line for each parameter.
fn describe(entry: &Entry) -> String {
    let summary = entry.docs.trim().split("\n\n").next().unwrap_or_default().replace('\n', " ");
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
    let docs = param.docs.trim().lines().next().unwrap_or_default();
    format!("{:<18} {default:<14} {docs}\n    {:<18} {:<14} ({takes})", param.name, "", "")
}
