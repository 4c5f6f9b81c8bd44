//! One device of the gallery: its example, drawn, and how to call it.

use std::path::PathBuf;

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::GeneratorInfo;

use super::figure_options;
use crate::cli::{CliError, first_paragraph};
use crate::svg;

/// Modules whose results are only understood beside their sources.
const SHOW_SOURCES: [&str; 3] = ["phidl_geometry::boolean", "phidl_geometry::fill", "phidl_geometry::select::extract"];

/// A device with all that the gallery shows of it.
pub struct Plate {
    /// Its registered name.
    pub name: &'static str,
    /// Its crate and its family, `phidl_geometry::basic`.
    pub family: String,
    /// The first paragraph of its documentation.
    pub summary: String,
    /// Where its figure lies in the repository, if its documentation shows one.
    pub file: Option<PathBuf>,
    /// The example.
    pub device: Device,
    /// Its figure as SVG.
    pub figure: String,
    /// Its call in Rust.
    pub rust: String,
    /// Its parameters for a call by name.
    pub json: String,
}

/// The devices that a filter accepts, by name. `begin` hears the name of each before it is drawn.
///
/// # Errors
/// [`CliError::Draw`] if an example is refused, [`CliError::Write`] if its figure cannot be drawn.
pub fn all(is_wanted: impl Fn(&GeneratorInfo) -> bool, mut begin: impl FnMut(String)) -> Result<Vec<Plate>, CliError> {
    registry::all()
        .filter(|entry| is_wanted(entry))
        .map(|entry| {
            begin(format!("drawing {}", entry.name));
            plate(entry)
        })
        .collect()
}

fn plate(entry: &'static GeneratorInfo) -> Result<Plate, CliError> {
    let params = entry.example()?;
    let device = entry.build(&params.by_name())?;
    let mut options = figure_options(&device)?;
    if SHOW_SOURCES.iter().any(|family| entry.module.starts_with(family)) {
        params.iter().for_each(|(_, value)| devices_in(value, &mut options.sources));
    }
    let figure = svg::figure(&device, &options)?;
    let file = entry.picture.map(|file| PathBuf::from(krate(entry).replace('_', "-")).join(file));
    Ok(Plate {
        name: entry.name,
        family: entry.module.split("::").take(2).collect::<Vec<_>>().join("::"),
        summary: first_paragraph(entry.docs),
        file,
        device,
        figure,
        rust: format!("{}.build()?", entry.example_source),
        json: json(entry, &params),
    })
}

/// The crate of a generator, as Rust spells it.
#[must_use]
pub fn krate(entry: &GeneratorInfo) -> &'static str {
    entry.module.split("::").next().unwrap_or(entry.module)
}

/// The parameters that are not at their defaults, as `device --params` takes them.
fn json(entry: &GeneratorInfo, params: &[(&str, Value)]) -> String {
    let defaults = entry.params().into_iter().map(|param| param.default);
    let given = params.iter().zip(defaults).filter(|((_, value), default)| Some(value) != default.as_ref());
    let map: serde_json::Map<String, serde_json::Value> =
        given.map(|((name, value), _)| ((*name).to_owned(), serde_json::json!(value))).collect();
    serde_json::Value::Object(map).to_string()
}

/// All devices in a value.
fn devices_in(value: &Value, found: &mut Vec<Device>) {
    match value {
        Value::Device(device) => found.push(device.clone()),
        Value::List(list) => list.iter().for_each(|inner| devices_in(inner, found)),
        Value::Map(map) => map.values().for_each(|inner| devices_in(inner, found)),
        _ => {}
    }
}
