//! Every registered shape beside PHIDL.

use anyhow::Context;
use phidl_core::registry;
use phidl_core::runtime::{GeneratorInfo, cache};
use serde_json::{Value as Json, json};

use super::table::{Section, Times};
use super::{Sitting, clock};

const NOTES: &str = "Each shape with its defaults, or with the parameters of its example in the documentation where it \
    needs some. Both sides draw the shape and all that it is made of anew (PHIDL's own memory of six shapes is \
    switched off). Ours ends with a finished cell that records its parameters.";

/// Times every shape of the library.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let entries: Vec<&'static GeneratorInfo> = registry::all()
        .filter(|entry| entry.module.starts_with("phidl_geometry"))
        .filter(|entry| sitting.filter.is_none_or(|filter| entry.name.contains(filter)))
        .collect();
    let peers = peers(sitting, &entries)?;
    cache::set_limit(0);
    let mut section = Section::new("Shapes", NOTES, &["PHIDL"]);
    for entry in entries {
        let example = entry.example()?.by_name();
        let draw = || entry.build(&example);
        draw().map_err(crate::report)?;
        section.add(format!("`{}`", entry.name), clock::best(&draw), &peers, entry.name);
    }
    cache::set_limit(cache::DEFAULT_LIMIT);
    Ok(section)
}

/// PHIDL's times for the same shapes, with those parameters that differ from the defaults.
fn peers(sitting: &Sitting<'_>, entries: &[&'static GeneratorInfo]) -> anyhow::Result<Times> {
    let jobs: Vec<Json> = entries.iter().map(|entry| job(entry)).collect::<anyhow::Result<_>>()?;
    let file = sitting.folder.join("shapes.json");
    std::fs::write(&file, serde_json::to_vec(&jobs)?).with_context(|| file.display().to_string())?;
    sitting.peers("shapes", &file)
}

fn job(entry: &'static GeneratorInfo) -> anyhow::Result<Json> {
    let mut params = serde_json::Map::new();
    for (info, (name, value)) in entry.params().into_iter().zip(entry.example()?.iter()) {
        if info.default.as_ref() != Some(value) {
            params.insert((*name).to_owned(), json!({ "kind": info.kind.to_string(), "value": value }));
        }
    }
    Ok(json!({ "device": entry.name, "params": params }))
}
