//! Generators that take generators, as a sweep does.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_macros::device;

static DRAWN: AtomicUsize = AtomicUsize::new(0);

#[device]
fn pillar(
    #[default(1)]
    #[param(unit = "um", above = 0)]
    radius: f64,
    #[default(0)] layer: Layers,
) -> Result<Device> {
    DRAWN.fetch_add(1, Ordering::SeqCst);
    let mut d = Device::builder("pillar");
    d.add_polygon([(0.0, 0.0), (radius, 0.0), (0.0, radius)], layer)?;
    d.build()
}

/// Draws a generator once for each value of a parameter.
#[device]
fn row(what: Partial, values: BTreeMap<String, Vec<Value>>) -> Result<Device> {
    let mut d = Device::builder("row");
    let mut partials = Vec::new();
    for (name, values) in &values {
        for value in values {
            let partial = what.with([(name.as_str(), value.clone())])?;
            partial.record()?; // all of them, before anything is drawn
            partials.push(partial);
        }
    }
    for partial in partials {
        d.add(partial.build()?);
    }
    d.build()
}

fn values(name: &str, values: impl IntoIterator<Item = f64>) -> [(String, Vec<Value>); 1] {
    [(name.to_owned(), values.into_iter().map(Value::from).collect())]
}

#[test]
fn a_generator_is_given_with_presets_and_swept() {
    let swept = row(PillarParams::default().layer(3), values("radius", [1.0, 2.0])).unwrap();
    assert_eq!(swept.references().len(), 2);
    assert!(swept.references()[1].device().same_cell(&pillar(2, 3).unwrap()));

    let json = r#"{"what": {"device": "pillar", "params": {"layer": 3}}, "values": {"radius": [1.0, 2.0]}}"#;
    let by_name = registry::find("row").unwrap().build(&serde_json::from_str(json).unwrap()).unwrap();
    assert_eq!(by_name.references()[1].device(), swept.references()[1].device());
    let short = r#"{"what": "pillar", "values": {"radius": [5]}}"#;
    let short = registry::find("row").unwrap().build(&serde_json::from_str(short).unwrap()).unwrap();
    assert!(short.references()[0].device().same_cell(&pillar(5, 0).unwrap()));
}

#[test]
fn a_bad_value_is_found_before_anything_is_drawn() {
    let before = |radius: f64| PillarParams::default().radius(radius).layer(77);
    let error = row(before(1.0), values("radius", [70.0, 71.0, -1.0])).unwrap_err();
    assert_eq!(error.report(), "in row: pillar: radius is -1 µm, but it must be greater than 0 µm");
    let drawn = DRAWN.load(Ordering::SeqCst);
    pillar(70, 77).unwrap();
    assert!(DRAWN.load(Ordering::SeqCst) > drawn, "it was not drawn by the sweep");
    let error = row(before(1.0), values("diameter", [1.0])).unwrap_err();
    assert_eq!(error.report(), "in row: pillar: there is no parameter \"diameter\"; known are radius, layer");
}
