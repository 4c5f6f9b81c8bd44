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

fn describe_param(param: &ParamInfo) -> String {
    let mut text = format!("{:<18} {}", param.name, param.kind);
    if let Some(unit) = param.unit {
        text += &format!(", {unit}");
    }
    if param.bounds != Bounds::NONE {
        text += &format!(", {}", param.bounds);
    }
    match &param.default {
        Some(default) => text += &format!(" = {default}"),
        None => text += ", required",
    }
    let docs = param.docs.trim().lines().next().unwrap_or_default();
    format!("{text:<60} {docs}")
}
