use phidl_core::prelude::*;
use phidl_macros::Choice;
use phidl_macros::device;
use std::collections::BTreeMap;

#[derive(Debug, Clone, Copy, PartialEq, Choice)]
pub(crate) enum Style {
    Straight,
    #[choice("fillet")]
    Round,
}

/// Draws a ring.
#[device]
pub fn ring(
    /// Radius of the middle of the ring.
    #[default(10)]
    #[param(unit = "um", above = 0)]
    radius: f64,
    #[default(0.5)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    #[default(0)] layer: Layers,
    #[default(None)]
    #[param(named)]
    port: Option<Port>,
) -> Result<Device> {
    let mut d = Device::builder("ring");
    d.add_polygon([(0.0, 0.0), (radius, 0.0), (0.0, width)], layer)?;
    if let Some(port) = port {
        d.add_port("1", port)?;
    }
    d.build()
}

#[device]
fn many(
    text: String,
    #[default((4, 2))] size: Size,
    #[default([1, 2, 4])] line_widths: Vec<f64>,
    #[default("p")] shape: String,
    #[default([])] points: Vec<Point>,
    #[default([("N", 3), ("S", 4)])] counts: BTreeMap<String, usize>,
    #[default([1, 2])] ns: Vec<usize>,
    #[default(5)] opt: Option<f64>,
    #[default(Style::Round)] style: Style,
    #[default(RingParams::default())] recipe: Recipe,
    #[default(None)] dev: Option<Device>,
    #[default(3)]
    #[param(name = "N")]
    n: usize,
    #[default([[1, 2], [3, 4]])] nested: Vec<Vec<f64>>,
    #[default(None)] style2: Option<Style>,
    #[default(true)] flag: bool,
) -> Result<Device> {
    let _ = (text, size, line_widths, shape, points, counts, ns, opt, style, recipe, dev, n, nested, style2, flag);
    Device::builder("many").build()
}

#[device]
fn none() -> Result<Device> {
    Device::builder("none").build()
}

#[test]
fn every_kind_of_parameter_is_taken_in_its_short_form() {
    let a = ring(12, 0.5, 1).unwrap();
    let b = RingParams { radius: 12.0, layer: 1.into(), ..Default::default() }.build().unwrap();
    assert!(a.same_cell(&b));
    let m = many(
        "x",
        (1, 2),
        [1, 2],
        "q",
        [(0, 1)],
        [("N", 1)],
        vec![1],
        None,
        Style::Round,
        RingParams::default(),
        &a,
        3,
        [vec![1.0]],
        None,
        false,
    );
    m.unwrap();
    ManyParams::new("x").size((3, 4)).opt(3).line_widths([3]).build().unwrap();
    none().unwrap();
}
