//! What the registry tells, and cells built by name from JSON.

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::GeneratorInfo;
use phidl_macros::{Choice, device};

#[derive(Debug, Clone, Copy, PartialEq, Choice)]
enum Ending {
    Straight,
    #[choice("fillet")]
    Round,
}

/// Draws a letter.
///
/// It is only a bar.
#[device(name = "L", example = LetterParams::new("x").thickness(3))]
fn letter(
    /// What is written.
    text: String,
    /// How thick.
    #[default(1)]
    #[param(unit = "um", above = 0, name = "Lk_per_sq")]
    thickness: f64,
    #[default(Ending::Straight)] ending: Ending,
    #[default(0)] layer: Layers,
    #[default(None)]
    #[param(named)]
    port: Option<Port>,
    #[default(None)] inside: Option<Device>,
) -> Result<Device> {
    let mut d = Device::builder("letter");
    d.add_polygon([(0.0, 0.0), (thickness, 0.0), (0.0, 9.0)], layer)?;
    d.info("text", text).info("round", ending == Ending::Round);
    if let Some(port) = port {
        d.add_port("1", port)?;
    }
    if let Some(inside) = inside {
        d.add(inside);
    }
    d.build()
}

/// Draws a pad.
#[device(picture = "tests/it/pad.svg", name = "pictured_pad")]
fn pad(#[default(2)] size: f64) -> Result<Device> {
    let mut d = Device::builder("pad");
    d.add_polygon([(0.0, 0.0), (size, 0.0), (0.0, size)], 0)?;
    d.build()
}

#[test]
fn an_entry_has_the_path_of_its_picture_and_docs_without_it() {
    let entry = registry::find("pictured_pad").unwrap();
    assert_eq!((entry.docs, entry.picture), ("Draws a pad.", Some("tests/it/pad.svg")));
    assert_eq!(entry.example_source, "PadParams::default()");
    assert_eq!(pad(3).unwrap().area(), 4.5);
}

fn entry() -> &'static GeneratorInfo {
    registry::find("L").unwrap()
}

fn build(json: &str) -> Result<Device> {
    entry().build(&serde_json::from_str::<BTreeMap<String, Value>>(json).unwrap())
}

#[test]
fn an_entry_tells_docs_kinds_units_bounds_and_defaults() {
    let entry = entry();
    assert_eq!(entry.docs, "Draws a letter.\n\nIt is only a bar.");
    assert_eq!((entry.example_source, entry.picture), (r#"LetterParams::new("x").thickness(3)"#, None));
    assert_eq!((entry.module, entry.version), (module_path!(), env!("CARGO_PKG_VERSION")));
    let params = entry.params();
    let listed: Vec<_> = params.iter().map(|p| (p.name, p.kind.to_string(), p.default.clone())).collect();
    let zero = Some(Value::from(0));
    assert_eq!(
        listed,
        [
            ("text", "text".to_owned(), None),
            ("Lk_per_sq", "number".to_owned(), Some(Value::from(1.0))),
            ("ending", "one of straight, fillet".to_owned(), Some(Value::from("straight"))),
            ("layer", "layers".to_owned(), zero),
            ("port", "port or none".to_owned(), Some(Value::Null)),
            ("inside", "device or none".to_owned(), Some(Value::Null)),
        ]
    );
    assert_eq!((params[1].unit, params[1].bounds.above, params[1].docs), (Some("um"), Some(0.0), "How thick."));
}

#[test]
fn a_cell_built_from_json_is_the_cell_of_the_call() {
    let json = r#"{"text": "a", "Lk_per_sq": 2, "ending": "Fillet", "layer": {"layers": [1, [2, 3]]}}"#;
    let called = letter("a", 2, Ending::Round, [(1, 0), (2, 3)], None).unwrap();
    assert!(build(json).unwrap().same_cell(&called));
    let with_port = r#"{"text": "a", "port": {"midpoint": [1, 2], "width": 3, "orientation": 90}}"#;
    assert_eq!(build(with_port).unwrap().port("1").unwrap(), &Port::new((1, 2), 3, 90).named("1"));
    let nested = r#"{"text": "a", "inside": {"device": "L", "params": {"text": "b"}}}"#;
    let inside = letter("b", 1, Ending::Straight, 0, None).unwrap();
    assert!(build(nested).unwrap().references()[0].device().same_cell(&inside));
}

#[test]
fn json_of_a_record_builds_the_same_cell_again() {
    let inside = letter("b", 0.1 + 0.2, Ending::Round, Layers::NONE, None).unwrap();
    let cell = LetterParams::new("a").port(((1, 2), 3, 90)).inside(&inside).build().unwrap();
    let params: BTreeMap<_, _> = cell.source().unwrap().params.iter().cloned().collect();
    let json =
        serde_json::to_string(&Value::Map(params.into_iter().map(|(k, v)| (k.to_owned(), v)).collect())).unwrap();
    assert!(build(&json).unwrap().same_cell(&cell), "{json}");
}

#[test]
fn what_json_gets_wrong_is_named() {
    let cases = [
        (r#"{}"#, "L: text is missing, but it must be given: it has no default and takes text"),
        (r#"{"text": 3}"#, "L: text is 3, but it must be text"),
        (r#"{"text": "a", "Lk_per_sq": "x"}"#, "L: Lk_per_sq is \"x\", but it must be a number"),
        (r#"{"text": "a", "Lk_per_sq": 0}"#, "L: Lk_per_sq is 0 µm, but it must be greater than 0 µm"),
        (r#"{"text": "a", "ending": "no"}"#, "L: ending is \"no\", but it must be one of straight, fillet"),
        (
            r#"{"text": "a", "thickness": 1}"#,
            "L: there is no parameter \"thickness\"; known are text, Lk_per_sq, ending, layer, port, inside",
        ),
        (
            r#"{"text": "a", "inside": {"device": "L", "params": {}}}"#,
            "in L: L: text is missing, but it must be given: it has no default and takes text",
        ),
    ];
    for (json, message) in cases {
        assert_eq!(build(json).unwrap_err().report(), message, "{json}");
    }
}

#[test]
fn the_example_is_what_galleries_draw() {
    let example = entry().example().unwrap().by_name();
    assert_eq!((&example["text"], &example["Lk_per_sq"]), (&Value::from("x"), &Value::from(3.0)));
}

#[test]
fn the_finished_cell_knows_its_generator_and_every_parameter() {
    let cell = LetterParams::new("source").build().unwrap();
    let source = cell.source().unwrap();
    assert_eq!((source.generator, source.module), ("L", module_path!()));
    assert_eq!(source.version, env!("CARGO_PKG_VERSION"));
    let names: Vec<_> = source.params.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["text", "Lk_per_sq", "ending", "layer", "port", "inside"]);
    assert_eq!(source.params[0].1, Value::from("source"));
}

/// Draws nothing,
#[doc = concat!("in ", "two lines.")]
#[device]
fn documented_by_macro() -> Result<Device> {
    Device::builder("documented_by_macro").build()
}

#[test]
fn documentation_may_come_out_of_a_macro() {
    documented_by_macro().unwrap();
    assert_eq!(registry::find("documented_by_macro").unwrap().docs, "Draws nothing,\nin two lines.");
}

mod a {
    use super::*;

    #[device]
    fn ambiguous(#[default(1)] a: f64) -> Result<Device> {
        Device::builder(format!("a{a}")).build()
    }
}

mod b {
    use super::*;

    #[device]
    fn ambiguous(#[default(1)] b: f64) -> Result<Device> {
        Device::builder(format!("b{b}")).build()
    }
}

#[test]
fn generators_of_the_same_name_are_distinguished_by_their_module() {
    let error = registry::find("ambiguous").unwrap_err().to_string();
    let (a, b) = (concat!(module_path!(), "::a::ambiguous"), concat!(module_path!(), "::b::ambiguous"));
    assert_eq!(
        error,
        format!("registry: several generators are called \"ambiguous\": {a}, {b}; name one with its path")
    );
    assert_eq!(registry::find(b).unwrap().params()[0].name, "b");
    assert!(registry::find("no_such_generator").unwrap_err().to_string().contains("known are "));
}

#[test]
fn the_list_is_sorted_and_every_example_that_can_be_drawn_comes_from_its_values() {
    let names: Vec<_> = registry::all().map(|entry| (entry.name, entry.module)).collect();
    assert!(names.is_sorted() && names.len() > 20, "{names:?}");
    for entry in registry::all() {
        let Ok(example) = entry.example() else { continue };
        assert_eq!(entry.record(&example.by_name()).unwrap(), example, "{}", entry.name);
    }
}
