//! What the documentation of every shape must say, as far as a program can tell.

use std::path::Path;

use phidl_core::param::ParamType;
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::{GeneratorInfo, ParamInfo};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use testkit::domain::params;

/// Terms that explain a number without unit.
const REASONS: [&str; 12] = [
    "factor",
    "part",
    "multiple",
    "exponent",
    "pure number",
    "relative",
    "squares",
    "width to height",
    "length over width",
    "hundredths",
    "in units of",
    "in distances",
];

fn shapes() -> impl Iterator<Item = &'static GeneratorInfo> {
    registry::all().filter(|entry| entry.module.starts_with("phidl_geometry"))
}

/// Runs a check over all shapes and reports all that is missing, not only the first item.
fn for_every_shape(check: impl Fn(&'static GeneratorInfo, &mut Vec<String>)) {
    let mut missing = Vec::new();
    shapes().for_each(|entry| check(entry, &mut missing));
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// The text below a heading, up to the next one.
fn section<'a>(docs: &'a str, heading: &str) -> Option<&'a str> {
    let (_, below) = docs.split_once(&format!("\n# {heading}\n"))?;
    // In code a line that begins with `# ` is hidden; headings begin with a capital.
    let end = below.match_indices("\n# ").find(|(i, _)| below[i + 3..].starts_with(char::is_uppercase));
    Some(&below[..end.map_or(below.len(), |(i, _)| i)])
}

fn example(entry: &'static GeneratorInfo) -> Device {
    entry.build(&entry.example().unwrap().by_name()).unwrap()
}

#[test]
fn every_shape_has_its_sections() {
    for_every_shape(|entry, missing| {
        for heading in ["Ports", "Examples", "Source"] {
            if section(entry.docs, heading).is_none_or(|text| text.trim().is_empty()) {
                missing.push(format!("{}: no section {heading}", entry.name));
            }
        }
    });
}

/// Bounds stand at the parameters; every other refusal belongs under a heading of its own. What takes devices can refuse
/// them, unless it only copies.
#[test]
fn shapes_that_refuse_more_than_their_bounds_say_so() {
    for_every_shape(|entry, missing| {
        if section(entry.docs, "Errors").is_some() {
            return;
        }
        let mut runner = TestRunner::new_with_rng(Config::default(), TestRng::deterministic_rng(RngAlgorithm::ChaCha));
        let Some(values) = params(entry) else { return };
        for _ in 0..64 {
            let params = values.new_tree(&mut runner).unwrap().current();
            if let Err(error) = entry.build(&params) {
                missing.push(format!("{}: no section Errors, but {}", entry.name, error.report()));
                return;
            }
        }
    });
}

#[test]
fn every_port_and_every_note_of_the_example_is_described() {
    for_every_shape(|entry, missing| {
        let device = example(entry);
        let ports = section(entry.docs, "Ports").unwrap_or_default();
        let info = section(entry.docs, "Info").unwrap_or_default();
        // Those of another device.
        if ports.starts_with("Those ") {
            return;
        }
        if device.ports().len() == 0 && !ports.starts_with("None") {
            missing.push(format!("{}: describes ports that its example has not: {ports}", entry.name));
        }
        // Of `N1`, `N2`, …, the first one is enough.
        let named = |name: &str| ports.contains(&format!("`{name}`"));
        let described = |name: &str| named(name) || named(&format!("{}1", name.trim_end_matches(char::is_numeric)));
        for port in device.ports().filter(|port| !described(port.name())) {
            missing.push(format!("{}: port {} is not described", entry.name, port.name()));
        }
        for key in device.info().keys().filter(|key| !info.contains(&format!("`{key}`"))) {
            missing.push(format!("{}: info {key} is not described", entry.name));
        }
    });
}

#[test]
fn every_parameter_is_described_and_every_number_has_a_unit_or_a_reason() {
    let is_number = |param: &ParamInfo| match &param.kind {
        ParamType::Optional(inner) => matches!(**inner, ParamType::Number | ParamType::Point | ParamType::Size),
        ParamType::List(inner) => matches!(**inner, ParamType::Number | ParamType::Point | ParamType::Size),
        kind => matches!(kind, ParamType::Number | ParamType::Point | ParamType::Size),
    };
    for_every_shape(|entry, missing| {
        for param in entry.params() {
            if param.docs.is_empty() {
                missing.push(format!("{}: {} is not described", entry.name, param.name));
            }
            let text = param.docs.to_lowercase();
            if is_number(&param) && param.unit.is_none() && !REASONS.iter().any(|reason| text.contains(reason)) {
                missing.push(format!("{}: {} has no unit: {}", entry.name, param.name, param.docs));
            }
        }
    });
}

#[test]
fn every_shape_has_a_figure_that_markdown_can_hold() {
    for_every_shape(|entry, missing| {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(entry.picture.unwrap_or("none"));
        let figure = std::fs::read_to_string(&file).unwrap_or_default();
        if !figure.starts_with("<svg ") || figure.contains("\n\n") || !figure.ends_with("</svg>\n") {
            missing.push(format!("{}: {} is no such figure", entry.name, file.display()));
        }
    });
}

/// The front page of the crate shows every shape with its picture.
#[test]
fn the_front_page_lists_every_shape_with_its_picture() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).unwrap();
    for_every_shape(|entry, missing| {
        let picture = format!("include_str!(\"../docs/{}.svg\")", entry.name);
        let link = format!("[`{}`]", entry.name).to_lowercase();
        if !page.contains(&picture) || !page.to_lowercase().contains(&link) {
            missing.push(format!("{}: not on the front page", entry.name));
        }
    });
}
