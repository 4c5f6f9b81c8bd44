//! Comparing a device with a described one.

use std::collections::BTreeMap;

use phidl_core::param::Value;
use phidl_core::prelude::*;
use serde::Deserialize;
use serde_json::Value as Json;

use super::region::{merged_area, xor_area};
use super::{Case, differences};

/// How far a point may be from the reference's (µm), as the design promises.
const POINT_TOLERANCE: f64 = 1e-6;
/// How far angles may be apart (degrees).
const ANGLE_TOLERANCE: f64 = 1e-6;
/// How far numbers of an info record may be apart, relative to their size.
const INFO_TOLERANCE: f64 = 1e-9;
/// Width of the strip along the outlines that regions may differ by (µm).
const REGION_STRIP: f64 = 1e-3;
/// Width of the strip along the outlines by which merged areas may differ (µm).
const MERGE_STRIP: f64 = 5e-5;

#[derive(Debug, Deserialize)]
struct Described {
    bbox: Option<[[f64; 2]; 2]>,
    #[serde(default)]
    layers: BTreeMap<String, DescribedLayer>,
    #[serde(default)]
    ports: BTreeMap<String, DescribedPort>,
    #[serde(default)]
    info: BTreeMap<String, Json>,
    hash_geometry: Option<String>,
}

#[derive(Debug, Deserialize)]
struct DescribedLayer {
    polygons: usize,
    vertices: usize,
    area: f64,
    points: Option<Vec<Vec<[f64; 2]>>>,
}

#[derive(Debug, Deserialize)]
struct DescribedPort {
    midpoint: [f64; 2],
    width: f64,
    orientation: f64,
}

/// What of a device is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extent {
    /// Points in order, hash, box, ports and info.
    All,
    /// The covered region, ports and info.
    Region,
    /// Every polygon of the reference is there; ours has glyphs besides. Ports and info.
    Contains,
    /// Ports and info.
    Ports,
}

/// Runs all cases, prints a line for each, and panics with all that failed.
///
/// # Panics
/// If a case fails, or a deliberate difference has disappeared.
pub fn assert_all(cases: &[Case], draw: impl Fn(&Case) -> Result<Device>) {
    let mut failures = Vec::new();
    for case in cases {
        let outcome = check(case, draw(case));
        #[expect(clippy::print_stdout, reason = "one line a case, shown by the test runner on failure or demand")]
        {
            println!("{:<28} {}", case.id, outcome.as_ref().map_or_else(String::as_str, |()| "ok"));
        }
        failures.extend(outcome.err().map(|why| format!("{}: {why}", case.id)));
    }
    assert!(failures.is_empty(), "{} of {} cases:\n{}", failures.len(), cases.len(), failures.join("\n"));
}

fn check(case: &Case, drawn: Result<Device>) -> Result<(), String> {
    let difference = differences().into_iter().find(|difference| difference.applies_to(case));
    let extent = match difference.as_ref().map(|d| d.compare.as_str()) {
        Some("nothing") => return Ok(()),
        Some("error") => return drawn.map_or(Ok(()), |_| Err("ours draws what it is said to refuse".to_owned())),
        Some("region") => Extent::Region,
        Some("ports") => Extent::Ports,
        Some(other) => return Err(format!("differences.toml compares by {other:?}, which nothing does")),
        None if case.compare.as_deref() == Some("region") => Extent::Region,
        None if case.text => Extent::Contains,
        None => Extent::All,
    };
    if case.expect.get("error").is_some() {
        return drawn.map_or(Ok(()), |_| Err("the reference refuses it, ours draws it".to_owned()));
    }
    let device = drawn.map_err(|error| format!("ours refuses it: {}", error.in_full()))?;
    compare(&device, &case.expect, extent)
}

/// Compares a device with a described one in all that it states.
///
/// # Errors
/// What differs.
pub fn compare_device(device: &Device, expect: &Json) -> Result<(), String> {
    compare(device, expect, Extent::All)
}

fn compare(device: &Device, expect: &Json, extent: Extent) -> Result<(), String> {
    let expected = Described::deserialize(expect).map_err(|error| format!("the description is off: {error}"))?;
    ports(device, &expected.ports)?;
    info(device.info(), &expected.info)?;
    if extent == Extent::Ports {
        return Ok(());
    }
    let drawn = outlines_by_layer(device);
    layers(&drawn, &expected, extent)?;
    if extent != Extent::All {
        return Ok(());
    }
    bbox(device, expected.bbox)?;
    match expected.hash_geometry {
        Some(hash) if device.hash_geometry(1e-4).as_ref() != Ok(&hash) => Err("hash_geometry differs".to_owned()),
        _ => Ok(()),
    }
}

fn outlines_by_layer(device: &Device) -> BTreeMap<String, Vec<Vec<Point>>> {
    let mut layers: BTreeMap<String, Vec<Vec<Point>>> = BTreeMap::new();
    for polygon in device.flat_polygons() {
        let name = polygon.layer.unwrap_or_default().to_string();
        layers.entry(name).or_default().push(polygon.points().collect());
    }
    layers
}

fn layers(drawn: &BTreeMap<String, Vec<Vec<Point>>>, expected: &Described, extent: Extent) -> Result<(), String> {
    let names = |keys: Vec<&String>| keys.into_iter().cloned().collect::<Vec<_>>().join(" ");
    let same_layers = drawn.keys().eq(expected.layers.keys());
    if extent != Extent::Contains && !same_layers {
        let (ours, theirs) = (names(drawn.keys().collect()), names(expected.layers.keys().collect()));
        return Err(format!("layers are {ours}, expected {theirs}"));
    }
    for (name, expected) in &expected.layers {
        let outlines = drawn.get(name).map_or(&[][..], Vec::as_slice);
        layer(outlines, expected, extent).map_err(|why| format!("layer {name}: {why}"))?;
    }
    Ok(())
}

fn layer(outlines: &[Vec<Point>], expected: &DescribedLayer, extent: Extent) -> Result<(), String> {
    let points: Option<Vec<Vec<Point>>> = expected
        .points
        .as_ref()
        .map(|outlines| outlines.iter().map(|outline| outline.iter().map(|p| Point::from(*p)).collect()).collect());
    match (extent, points) {
        (Extent::Region, Some(points)) => region(outlines, &points),
        (Extent::Contains, Some(points)) => contains(outlines, &points).map(drop),
        (_, points) => {
            let vertices: usize = outlines.iter().map(Vec::len).sum();
            if (outlines.len(), vertices) != (expected.polygons, expected.vertices) {
                return Err(format!(
                    "{} polygons with {vertices} vertices, expected {} with {}",
                    outlines.len(),
                    expected.polygons,
                    expected.vertices
                ));
            }
            match points {
                Some(points) => contains(outlines, &points).map(drop),
                None => area(outlines, expected.area),
            }
        }
    }
}

/// Whether every expected outline is there, point by point in order; each of ours is taken once.
fn contains(outlines: &[Vec<Point>], expected: &[Vec<Point>]) -> Result<(), String> {
    let same = |a: &[Point], b: &[Point]| {
        a.len() == b.len() && a.iter().zip(b).all(|(p, q)| p.distance(*q) <= POINT_TOLERANCE)
    };
    let mut left: Vec<&Vec<Point>> = outlines.iter().collect();
    for outline in expected {
        match left.iter().position(|ours| same(ours, outline)) {
            Some(place) => drop(left.swap_remove(place)),
            None => return Err(format!("no polygon like the one of {} points from {}", outline.len(), outline[0])),
        }
    }
    Ok(())
}

fn region(outlines: &[Vec<Point>], expected: &[Vec<Point>]) -> Result<(), String> {
    let allowed = expected.iter().map(|outline| perimeter(outline)).sum::<f64>() * REGION_STRIP;
    let xor = xor_area(outlines, expected);
    if xor <= allowed { Ok(()) } else { Err(format!("regions differ by {xor} µm², more than {allowed} µm²")) }
}

/// The reference merges on a grid of 1e-4 µm, so that every edge may be half a step off.
fn area(outlines: &[Vec<Point>], expected: f64) -> Result<(), String> {
    let area = merged_area(outlines);
    let allowed = outlines.iter().map(|outline| perimeter(outline)).sum::<f64>() * MERGE_STRIP;
    if (area - expected).abs() <= allowed {
        Ok(())
    } else {
        Err(format!("merged area is {area} µm², expected {expected} µm² to {allowed} µm²"))
    }
}

fn perimeter(outline: &[Point]) -> f64 {
    (0..outline.len()).map(|i| outline[i].distance(outline[(i + 1) % outline.len()])).sum()
}

fn bbox(thing: &impl Bounded, expected: Option<[[f64; 2]; 2]>) -> Result<(), String> {
    match (thing.bbox(), expected) {
        (Some(a), Some([min, max]))
            if a.min.distance(min.into()) <= POINT_TOLERANCE && a.max.distance(max.into()) <= POINT_TOLERANCE =>
        {
            Ok(())
        }
        (None, None) => Ok(()),
        // The reference gives an empty device a box at the origin.
        (None, Some([[0.0, 0.0], [0.0, 0.0]])) => Ok(()),
        (a, b) => Err(format!("box is {a:?}, expected {b:?}")),
    }
}

fn ports(device: &Device, expected: &BTreeMap<String, DescribedPort>) -> Result<(), String> {
    let mut ours: Vec<&str> = device.ports().map(Port::name).collect();
    ours.sort_unstable();
    if !ours.iter().copied().eq(expected.keys().map(String::as_str)) {
        return Err(format!("ports are {ours:?}, expected {:?}", expected.keys()));
    }
    expected.iter().try_for_each(|(name, expected)| {
        let port = device.port(name).map_err(|error| error.to_string())?;
        port_matches(port, expected)
    })
}

fn port_matches(port: &Port, expected: &DescribedPort) -> Result<(), String> {
    let near = port.midpoint().distance(expected.midpoint.into()) <= POINT_TOLERANCE
        && (port.width() - expected.width).abs() <= POINT_TOLERANCE
        && phidl_core::num::angle::between(port.orientation(), expected.orientation) <= ANGLE_TOLERANCE;
    if near { Ok(()) } else { Err(format!("{port}, expected {expected:?}")) }
}

/// Every record of the reference is there; ours may have more.
fn info(ours: &BTreeMap<String, Value>, expected: &BTreeMap<String, Json>) -> Result<(), String> {
    for (key, expected) in expected {
        match ours.get(key) {
            Some(value) if same_value(value, expected) => {}
            value => return Err(format!("info {key:?} is {value:?}, expected {expected}")),
        }
    }
    Ok(())
}

fn same_value(ours: &Value, expected: &Json) -> bool {
    match (ours, expected) {
        (Value::List(ours), Json::Array(expected)) => {
            ours.len() == expected.len() && ours.iter().zip(expected).all(|(a, b)| same_value(a, b))
        }
        (Value::Map(ours), Json::Object(expected)) => {
            ours.len() == expected.len()
                && expected.iter().all(|(key, b)| ours.get(key).is_some_and(|a| same_value(a, b)))
        }
        (Value::Text(a), Json::String(b)) => a == b,
        (Value::Bool(a), Json::Bool(b)) => a == b,
        (Value::Null, Json::Null) => true,
        (ours, expected) => match (ours.as_f64(), expected.as_f64()) {
            (Some(a), Some(b)) => (a - b).abs() <= INFO_TOLERANCE * b.abs().max(1.0),
            _ => false,
        },
    }
}

/// Compares the box and the ports of a reference with what `expect` states of it.
///
/// # Errors
/// What differs.
pub fn compare_reference(reference: &Reference, expect: &Json) -> Result<(), String> {
    let expected = Described::deserialize(expect).map_err(|error| format!("the description is off: {error}"))?;
    bbox(reference, expected.bbox)?;
    expected.ports.iter().try_for_each(|(name, expected)| {
        let port = reference.port(name).map_err(|error| error.to_string())?;
        port_matches(&port, expected)
    })
}
