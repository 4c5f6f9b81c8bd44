//! Draws one device by its registered name, or many.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use phidl_core::param::Value;
use phidl_core::registry;
use phidl_core::scene::Device;
use serde::Deserialize as _;
use serde_json::{Value as Json, json as object};

use super::gallery::figure_options;
use super::{CliError, DeviceFlags};
use crate::gds::{self, GdsOptions};
use crate::svg::{self, SvgOptions};
use crate::{atomic, json};

/// Draws what the flags name, and says what was done. `step` hears of each step before it begins.
///
/// # Errors
/// [`CliError`]: a refusal of the generator, a bad flag, a file that cannot be read or written.
pub fn run(flags: &DeviceFlags, step: impl FnMut(String)) -> Result<String, CliError> {
    match (&flags.name, &flags.out, &flags.batch, &flags.out_dir) {
        (Some(name), Some(out), ..) => one(name, flags, out, step),
        (_, _, Some(batch), Some(out_dir)) => many(batch, out_dir, step),
        _ => Err(CliError::Usage("give NAME with --out, or --batch with --out-dir".to_owned())),
    }
}

fn one(name: &str, flags: &DeviceFlags, out: &Path, mut step: impl FnMut(String)) -> Result<String, CliError> {
    let params = serde_json::from_str(&flags.params).map_err(CliError::json("--params"))?;
    step(format!("drawing {name}"));
    let device = draw(name, &params)?;
    step(format!("writing {}", out.display()));
    match flags.figure {
        true => write_figure(&device, out)?,
        false => write(&device, out)?,
    }
    Ok(format!("{device}\n{}", out.display()))
}

fn draw(name: &str, params: &BTreeMap<String, Value>) -> Result<Device, CliError> {
    Ok(registry::find(name).and_then(|entry| entry.build(params))?)
}

/// Writes a device in the format that the ending of the file selects.
///
/// # Errors
/// [`CliError::Usage`] for an unknown ending, [`CliError::Write`].
pub fn write(device: &Device, out: &Path) -> Result<(), CliError> {
    let written = match out.extension().and_then(|ending| ending.to_str()) {
        Some("gds") => gds::write(device, out, &GdsOptions::default()).map(drop),
        Some("svg") => svg::write(device, out, &SvgOptions::default()).map(drop),
        Some("json") => atomic::write(out, json::to_text(&json::describe(device)).as_bytes()).map(drop),
        _ => return Err(CliError::Usage(format!("{}: the file must end in .gds, .svg or .json", out.display()))),
    };
    Ok(written?)
}

/// Draws a device in the style of the figures of the documentation.
fn write_figure(device: &Device, out: &Path) -> Result<(), CliError> {
    if out.extension().is_none_or(|ending| ending != "svg") {
        return Err(CliError::Usage(format!("{}: a figure is a .svg file", out.display())));
    }
    let figure = svg::figure(device, &figure_options(device)?)?;
    atomic::write(out, figure.as_bytes())?;
    Ok(())
}

/// Draws every entry; if a generator refuses, the file of the entry says so. Entries without a file to write to are an
/// error after all others are done.
fn many(batch: &Path, out_dir: &Path, mut step: impl FnMut(String)) -> Result<String, CliError> {
    let text = std::fs::read_to_string(batch).map_err(CliError::path(batch))?;
    let entries: Vec<Json> = serde_json::from_str(&text).map_err(CliError::json(batch.display().to_string()))?;
    std::fs::create_dir_all(out_dir).map_err(CliError::path(out_dir))?;
    let mut refused = 0;
    let mut homeless = Vec::new();
    for (number, entry) in entries.iter().enumerate() {
        step(format!("entry {} of {}", number + 1, entries.len()));
        let Some(file) = file_of(entry, out_dir) else {
            homeless.push(number);
            continue;
        };
        let described = match draw_entry(entry) {
            Ok(device) => json::describe(&device),
            Err(error) => {
                refused += 1;
                object!({ "error": error.to_string() })
            }
        };
        atomic::write(&file, json::to_text(&described).as_bytes())?;
    }
    if !homeless.is_empty() {
        let problem = format!("entries {homeless:?} have no \"id\" that can be the name of a file");
        return Err(CliError::Usage(problem));
    }
    Ok(format!("{} drawn, {refused} refused", entries.len() - refused))
}

/// Draws one entry of a batch: `id`, `device`, and perhaps `params`.
fn draw_entry(entry: &Json) -> Result<Device, CliError> {
    let known = ["id", "device", "params"];
    if let Some(key) = entry.as_object().and_then(|map| map.keys().find(|key| !known.contains(&key.as_str()))) {
        return Err(CliError::Usage(format!("there is no field {key:?}; known are id, device and params")));
    }
    let Some(name) = entry["device"].as_str() else {
        return Err(CliError::Usage("the field \"device\" must be the name of a device".to_owned()));
    };
    let params = match entry.get("params") {
        Some(params) => BTreeMap::deserialize(params).map_err(CliError::json("params"))?,
        None => BTreeMap::new(),
    };
    draw(name, &params)
}

/// The file of an entry; none if its id would lead out of the folder.
fn file_of(entry: &Json, out_dir: &Path) -> Option<PathBuf> {
    let id = entry.get("id")?.as_str()?;
    let is_file_name = !id.is_empty() && !id.starts_with('.') && !id.contains(['/', '\\', '\0']);
    is_file_name.then(|| out_dir.join(format!("{id}.json")))
}
