//! Draws one device by its registered name, or many.

use std::collections::BTreeMap;
use std::path::Path;

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
        Some("json") => json::describe(device)
            .and_then(|described| atomic::write(out, json::to_text(&described).as_bytes()))
            .map(drop),
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

/// Draws every entry; the file of an entry that a generator refuses holds the error. Entries without a file of their own
/// are listed as an error after all others are drawn.
fn many(batch: &Path, out_dir: &Path, mut step: impl FnMut(String)) -> Result<String, CliError> {
    let text = std::fs::read_to_string(batch).map_err(CliError::path(batch))?;
    let entries: Vec<Json> = serde_json::from_str(&text).map_err(CliError::json(batch.display().to_string()))?;
    std::fs::create_dir_all(out_dir).map_err(CliError::path(out_dir))?;
    let mut files = FileNames::default();
    let (mut drawn, mut refused, mut failed) = (0, 0, Vec::new());
    for (number, entry) in entries.iter().enumerate() {
        step(format!("entry {} of {}", number + 1, entries.len()));
        let described = draw_entry(entry).and_then(|device| Ok(json::describe(&device)?));
        let is_drawn = described.is_ok();
        let described = described.unwrap_or_else(|error| object!({ "error": error.to_string() }));
        let written = files.name(number, entry).and_then(|file| {
            let text = json::to_text(&described);
            atomic::write_in(out_dir, &file, text.as_bytes()).map_err(|error| error.report())
        });
        match written {
            Ok(_) if is_drawn => drawn += 1,
            Ok(_) => refused += 1,
            Err(problem) => failed.push(format!("entry {number}: {problem}")),
        }
    }
    if !failed.is_empty() {
        return Err(CliError::Usage(failed.join("\n")));
    }
    Ok(format!("{drawn} drawn, {refused} refused"))
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

/// The longest name of a file that all usual systems take (bytes).
const LONGEST_FILE_NAME: usize = 255;

/// The names of the files of a batch.
#[derive(Default)]
struct FileNames {
    /// The entry of each id.
    entries: BTreeMap<String, usize>,
}

impl FileNames {
    /// The name of an entry's file. An id that cannot be a name, or is that of an earlier entry, is an error.
    fn name(&mut self, number: usize, entry: &Json) -> Result<String, String> {
        let id = entry.get("id").and_then(Json::as_str).ok_or("it has no \"id\" that is a text")?;
        if id.is_empty() || id.starts_with('.') || id.contains(['/', '\\']) || id.contains(char::is_control) {
            return Err(format!("its id {id:?} cannot be the name of a file"));
        }
        let file = format!("{id}.json");
        if file.len() > LONGEST_FILE_NAME {
            let most = LONGEST_FILE_NAME - ".json".len();
            return Err(format!("its id is {} bytes long, but it must have at most {most}", id.len()));
        }
        if let Some(first) = self.entries.get(id) {
            return Err(format!("its id {id:?} is that of entry {first} already"));
        }
        self.entries.insert(id.to_owned(), number);
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_that_cannot_be_files_of_their_own_say_why() {
        let mut files = FileNames::default();
        let mut name = |id: &str| {
            let number = files.entries.len();
            files.name(number, &object!({ "id": id }))
        };
        assert_eq!(name("a"), Ok("a.json".to_owned()));
        assert_eq!(name("a"), Err("its id \"a\" is that of entry 0 already".to_owned()));
        assert!(name(&"x".repeat(250)).is_ok());
        assert_eq!(name(&"x".repeat(251)), Err("its id is 251 bytes long, but it must have at most 250".to_owned()));
        for id in ["", ".hidden", "../a", "/a", "a\\b", "a\0", "a\n", "a\u{1b}[31m"] {
            assert!(name(id).unwrap_err().contains("cannot be the name of a file"), "{id:?}");
        }
    }
}
