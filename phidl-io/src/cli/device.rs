//! `cargo xtask device`: draws one device by its registered name, or many.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use phidl_core::param::Value;
use phidl_core::registry;
use phidl_core::scene::Device;
use phidl_io::gds::{self, GdsOptions};
use phidl_io::svg::{self, SvgOptions};
use phidl_io::{atomic, json};
use serde::Deserialize;
use serde_json::{Value as Json, json as object};

use crate::flags::DeviceFlags;
use crate::gallery::figure_options;
use crate::progress::Progress;

/// One entry of a batch.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    /// Read before the rest, so that an entry with a mistake gets a file that says so.
    #[serde(rename = "id")]
    _id: String,
    device: String,
    #[serde(default)]
    params: BTreeMap<String, Value>,
}

/// Draws what the flags name.
pub(crate) fn run(flags: &DeviceFlags) -> anyhow::Result<()> {
    match (&flags.name, &flags.out, &flags.batch, &flags.out_dir) {
        (Some(name), Some(out), ..) => one(name, flags, out),
        (_, _, Some(batch), Some(out_dir)) => many(batch, out_dir),
        _ => bail!("give NAME with --out, or --batch with --out-dir"),
    }
}

fn one(name: &str, flags: &DeviceFlags, out: &Path) -> anyhow::Result<()> {
    let params = serde_json::from_str(&flags.params).context("--params")?;
    let progress = Progress::new();
    progress.step(format!("drawing {name}"));
    let device = draw(name, &params)?;
    progress.step(format!("writing {}", out.display()));
    match flags.figure {
        true => write_figure(&device, out)?,
        false => write(&device, out)?,
    }
    drop(progress);
    println!("{device}\n{}", out.display());
    Ok(())
}

fn draw(name: &str, params: &BTreeMap<String, Value>) -> anyhow::Result<Device> {
    registry::find(name).and_then(|entry| entry.build(params)).map_err(crate::report)
}

/// Writes a device in the format that the ending of the file names.
fn write(device: &Device, out: &Path) -> anyhow::Result<()> {
    let written = match out.extension().and_then(|ending| ending.to_str()) {
        Some("gds") => gds::write(device, out, &GdsOptions::default()).map(drop),
        Some("svg") => svg::write(device, out, &SvgOptions::default()).map(drop),
        Some("json") => atomic::write(out, json::to_text(&json::describe(device)).as_bytes()).map(drop),
        _ => bail!("{}: the file must end in .gds, .svg or .json", out.display()),
    };
    written.map_err(|error| anyhow::anyhow!(error.report()))
}

/// Draws a device as the figures of the documentation are drawn.
fn write_figure(device: &Device, out: &Path) -> anyhow::Result<()> {
    ensure!(out.extension().is_some_and(|ending| ending == "svg"), "{}: a figure is a .svg file", out.display());
    let figure = svg::figure(device, &figure_options(device)?);
    let written = figure.and_then(|figure| atomic::write(out, figure.as_bytes()));
    written.map(drop).map_err(|error| anyhow::anyhow!(error.report()))
}

/// Draws every entry; what a generator refuses, its file says. Only entries without a file to write to are an error,
/// after all others are done.
fn many(batch: &Path, out_dir: &Path) -> anyhow::Result<()> {
    let text = std::fs::read_to_string(batch).with_context(|| batch.display().to_string())?;
    let entries: Vec<Json> = serde_json::from_str(&text).with_context(|| batch.display().to_string())?;
    std::fs::create_dir_all(out_dir).with_context(|| out_dir.display().to_string())?;
    let progress = Progress::new();
    let mut refused = 0;
    let mut homeless = Vec::new();
    for (number, entry) in entries.iter().enumerate() {
        progress.step(format!("entry {} of {}", number + 1, entries.len()));
        let Some(file) = file_of(entry, out_dir) else {
            homeless.push(number);
            continue;
        };
        let result =
            Entry::deserialize(entry).map_err(anyhow::Error::from).and_then(|entry| draw(&entry.device, &entry.params));
        let described = match result {
            Ok(device) => json::describe(&device),
            Err(error) => {
                refused += 1;
                object!({ "error": format!("{error:#}") })
            }
        };
        atomic::write(&file, json::to_text(&described).as_bytes()).map_err(|error| anyhow::anyhow!(error.report()))?;
    }
    drop(progress);
    println!("{} drawn, {refused} refused", entries.len() - refused - homeless.len());
    ensure!(homeless.is_empty(), "entries {homeless:?} have no \"id\" that can be the name of a file");
    Ok(())
}

/// The file of an entry; none if its id would lead out of the folder.
fn file_of(entry: &Json, out_dir: &Path) -> Option<PathBuf> {
    let id = entry.get("id")?.as_str()?;
    let plain = !id.is_empty() && !id.starts_with('.') && !id.contains(['/', '\\', '\0']);
    plain.then(|| out_dir.join(format!("{id}.json")))
}
