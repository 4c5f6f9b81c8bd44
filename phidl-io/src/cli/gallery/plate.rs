//! One device of the gallery: its example, drawn, and how to call it.

use std::path::PathBuf;

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::GeneratorInfo;
use phidl_io::svg;

use super::figure_options;
use crate::summary::first_paragraph;

/// Modules whose results are only understood beside what they were made from.
const SHOW_SOURCES: [&str; 3] = ["phidl_geometry::boolean", "phidl_geometry::fill", "phidl_geometry::select::extract"];

/// A device with everything that the gallery shows of it.
pub(crate) struct Plate {
    pub(crate) name: &'static str,
    /// Its crate and its family, `phidl_geometry::basic`.
    pub(crate) family: String,
    /// The first paragraph of its documentation.
    pub(crate) summary: String,
    /// Where its figure lies in the repository, if its documentation shows one.
    pub(crate) file: Option<PathBuf>,
    pub(crate) device: Device,
    pub(crate) figure: String,
    pub(crate) rust: String,
    pub(crate) json: String,
}

/// The devices of our libraries, by name.
pub(crate) fn all(mut begin: impl FnMut(&str)) -> anyhow::Result<Vec<Plate>> {
    let ours = |entry: &&GeneratorInfo| ["phidl_geometry", "phidl_route"].contains(&krate(entry));
    registry::all()
        .filter(ours)
        .map(|entry| {
            begin(entry.name);
            plate(entry)
        })
        .collect()
}

fn plate(entry: &'static GeneratorInfo) -> anyhow::Result<Plate> {
    let params = entry.example().map_err(crate::report)?;
    let device = entry.build(&params.by_name()).map_err(crate::report)?;
    let mut options = figure_options(&device)?;
    if SHOW_SOURCES.iter().any(|family| entry.module.starts_with(family)) {
        params.iter().for_each(|(_, value)| devices_in(value, &mut options.sources));
    }
    let figure = svg::figure(&device, &options).map_err(|error| anyhow::anyhow!(error.report()))?;
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

fn krate(entry: &GeneratorInfo) -> &'static str {
    entry.module.split("::").next().unwrap_or(entry.module)
}

/// The parameters that are not at their defaults, as `cargo xtask device --params` takes them.
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use phidl_io::gds::{self, GdsOptions, ReadOptions};

    use super::*;

    /// What a generator draws and labels must be what a file can say: a sweep labels its cells in several lines.
    #[test]
    fn every_plate_can_be_written_to_a_file_and_read_back() {
        for plate in all(|_| {}).unwrap() {
            let bytes = gds::to_bytes(&plate.device, &GdsOptions::default());
            let bytes = bytes.unwrap_or_else(|error| panic!("{}: {}", plate.name, error.report()));
            let back = gds::read_bytes(&bytes, &ReadOptions::default()).unwrap();
            assert_eq!(back.problems, [], "{}", plate.name);
            let texts = |device: &Device| -> BTreeSet<String> {
                device.cells().iter().flat_map(|cell| cell.labels().iter().map(|label| label.text.clone())).collect()
            };
            assert_eq!(texts(&back.device), texts(&plate.device), "{}", plate.name);
        }
    }
}
