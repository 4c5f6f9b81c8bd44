//! Every kind of parameter, in the short forms in which it may be given.

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

#[derive(Debug, Clone, Copy, PartialEq, Choice)]
enum Style {
    Straight,
    #[choice("fillet")]
    Round,
}

/// The parameters of a call as the cell records them.
fn recorded(cell: &Device) -> Vec<String> {
    cell.source().unwrap().params.iter().map(|(_, value)| value.to_string()).collect()
}

#[device]
fn numbers(length: f64, count: usize, offset: i64, flag: bool, letter: char, size: Size, at: Point) -> Result<Device> {
    let _ = (length, count, offset, flag, letter, size, at);
    Device::builder("numbers").build()
}

#[test]
fn integers_are_lengths_and_pairs_are_points() {
    let cell = numbers(5, 3, -2, true, 'µ', (4, 2.5), Port::new((1, 2), 3, 0)).unwrap();
    assert_eq!(recorded(&cell), ["5", "3", "-2", "true", "\"µ\"", "[4, 2.5]", "[1, 2]"]);
    assert!(cell.same_cell(&numbers(5.0_f32, 3, -2, true, 'µ', Size::new(4.0, 2.5), [1, 2]).unwrap()));
}

#[device]
fn optional(
    length: Option<f64>,
    count: Option<usize>,
    text: Option<String>,
    layer: Option<Layers>,
    size: Option<Size>,
    port: Option<Port>,
    inside: Option<Device>,
    style: Option<Style>,
    lengths: Option<Vec<f64>>,
) -> Result<Device> {
    let _ = (length, count, text, layer, size, port, inside, style, lengths);
    Device::builder("optional").build()
}

#[test]
fn an_optional_parameter_is_given_bare_or_not_at_all() {
    let none = optional(None, None, None, None, None, None, None, None, None).unwrap();
    assert_eq!(recorded(&none), ["none"; 9]);
    let pad = Device::builder("pad").build().unwrap();
    let all = optional(5, 3, "a", (7, 3), (1, 2), ((0, 0), 1, 0), &pad, Style::Round, [1, 2]).unwrap();
    assert_eq!(recorded(&all)[..5], ["5", "3", "\"a\"", "[7, 3]", "[1, 2]"]);
    assert_eq!(recorded(&all)[6..], ["pad", "\"fillet\"", "[1, 2]"]);
    let same = optional(
        Some(5.0),
        Some(3),
        Some("a".to_owned()),
        Some(Layers::from((7, 3))),
        Some(Size::new(1.0, 2.0)),
        Some(Port::new((0, 0), 1, 0)),
        Some(pad),
        Some(Style::Round),
        Some(vec![1.0, 2.0]),
    );
    assert!(all.same_cell(&same.unwrap()));
}

#[device]
fn collections(
    lengths: Vec<f64>,
    counts: Vec<usize>,
    points: Vec<Point>,
    nested: Vec<Vec<f64>>,
    by_name: BTreeMap<String, usize>,
    devices: Vec<Device>,
) -> Result<Device> {
    let _ = (lengths, counts, points, nested, by_name, devices);
    Device::builder("collections").build()
}

#[test]
fn lists_are_given_as_any_iterator() {
    let pad = Device::builder("pad").build().unwrap();
    let cell = collections([1, 2], 3..5, [(0, 1)], [[1, 2], [3, 4]], [("N", 1)], [&pad]).unwrap();
    assert_eq!(recorded(&cell), ["[1, 2]", "[3, 4]", "[[0, 1]]", "[[1, 2], [3, 4]]", "{N: 1}", "[pad]"]);
    let none = collections(Vec::<f64>::new(), [], Vec::<Point>::new(), Vec::<Vec<f64>>::new(), [("N", 1)], [pad]);
    assert_eq!(recorded(&none.unwrap())[..4], ["[]"; 4]);
}

#[device]
fn defaults(
    #[default(10)] length: f64,
    #[default(-0.5)] shift: f64,
    #[default(3)] count: usize,
    #[default((4, 2))] size: Size,
    #[default("p")] text: String,
    #[default([1, 2, 4])] lengths: Vec<f64>,
    #[default([])] nothing: Vec<Point>,
    #[default([("N", 3), ("S", 4)])] by_name: BTreeMap<String, usize>,
    #[default(5)] maybe: Option<f64>,
    #[default(None)] port: Option<Port>,
    #[default(Style::Straight)] style: Style,
    #[default([1, 2])] layer: Layers,
    #[default(NumbersParams::new(1, 2, 3, true, 'x', (1, 2), (3, 4)))] what: Partial,
) -> Result<Device> {
    let _ = (length, shift, count, size, text, lengths, nothing, by_name, maybe, port, style, layer, what);
    Device::builder("defaults").build()
}

#[test]
fn defaults_are_converted_like_arguments() {
    let cell = DefaultsParams::default().build().unwrap();
    let recorded_values = recorded(&cell);
    let expected = [
        "10",
        "-0.5",
        "3",
        "[4, 2]",
        "\"p\"",
        "[1, 2, 4]",
        "[]",
        "{N: 3, S: 4}",
        "5",
        "none",
        "\"straight\"",
        "{layers: [1, 2]}",
    ];
    assert_eq!(recorded_values[..12], expected);
    assert!(recorded_values[12].starts_with("{device: \"numbers\", params: {"), "{}", recorded_values[12]);
}

#[device]
fn rare(
    #[default(1)] width: f64,
    #[default(0)]
    #[param(named)]
    shift: f64,
    height: f64,
) -> Result<Device> {
    Device::builder(format!("rare_{width}_{shift}_{height}")).build()
}

#[test]
fn a_named_parameter_is_in_the_struct_only() {
    assert_eq!(rare(2, 3).unwrap().name(), "rare_2_0_3");
    assert_eq!(RareParams::new(3).shift(1).build().unwrap().name(), "rare_1_1_3");
    assert_eq!(RareParams { shift: 2.0, ..RareParams::new(3) }.build().unwrap().name(), "rare_1_2_3");
}

#[test]
fn the_taper_of_the_design_page_is_called_as_it_is_there() {
    /// As in the design: a number, a size, an optional number and layers.
    #[device]
    fn taper(length: f64, width1: f64, width2: Option<f64>, layer: Layers) -> Result<Device> {
        Device::builder(format!("{length} {width1} {width2:?} {layer}")).build()
    }
    assert_eq!(taper(20, 3, 0.5, 1).unwrap().name(), "20 3 Some(0.5) 1/0");
    assert_eq!(taper(20, 3, None, (1, 2)).unwrap().name(), "20 3 None 1/2");
}

#[device]
fn nothing() -> Result<Device> {
    Device::builder("nothing").build()
}

#[test]
fn a_generator_needs_no_parameters() {
    assert!(nothing().unwrap().same_cell(&NothingParams::default().build().unwrap()));
}
