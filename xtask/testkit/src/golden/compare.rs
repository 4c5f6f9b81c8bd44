//! Comparing a device with a described one.

use std::collections::BTreeMap;

use phidl_core::param::Value;
use phidl_core::prelude::*;
use serde::Deserialize;
use serde_json::Value as Json;

use super::Case;
use super::condition::parameter;
use super::differences::{Difference, Instead, differences};
use super::region::{agree_on_grid, merged_area, xor_area};

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

/// The functions whose results are regions on a grid: where an outline begins and where a hole is cut open is nobody's.
const SET_FUNCTIONS: [&str; 6] = ["boolean", "offset", "outline", "invert", "xor_diff", "union"];
/// The grid step that they have unless told otherwise (µm).
const SET_PRECISION: f64 = 1e-4;

/// What of a device is compared.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Extent {
    /// Points in order, hash, box, ports and info.
    All,
    /// Points in order, box, ports and info: the hash cuts coordinates off, so that a hair may change it.
    Points,
    /// The covered region, ports and info.
    Region,
    /// The covered region and the box to some steps of this grid (µm), ports and info.
    OnGrid(f64),
    /// The corners in any order and the box to a step of this grid (µm), ports and info.
    Corners(f64),
    /// Every polygon of the reference is there; ours has glyphs besides. Ports and info.
    Contains,
    /// Ports and info.
    Ports,
}

impl Extent {
    /// What a case has compared.
    fn of(case: &Case) -> Self {
        if case.compare.as_deref() == Some("region") {
            return Self::Region;
        }
        if SET_FUNCTIONS.contains(&case.device.as_str()) {
            return Self::OnGrid(step_of(case));
        }
        if case.text { Self::Contains } else { Self::All }
    }
}

/// The grid step of a set function (µm).
fn step_of(case: &Case) -> f64 {
    case.params.get("precision").and_then(Json::as_f64).unwrap_or(SET_PRECISION)
}

/// By which part a number is changed by a hair.
const HAIR: f64 = 2e-9;

/// Runs all cases, prints a line for each, and panics with all that failed.
///
/// # Panics
/// If a case fails.
pub fn assert_all(cases: &[Case], draw: impl Fn(&Case) -> Result<Device>) {
    let differences = differences();
    let mut failures = Vec::new();
    for case in cases {
        let outcome = check(case, None, &draw).or_else(|why| {
            match differences.iter().find(|difference| difference.applies_to(case)) {
                Some(difference) => check(case, Some(difference), &draw),
                None => Err(why),
            }
        });
        #[expect(clippy::print_stdout, reason = "one line a case, shown by the test runner on failure or demand")]
        {
            println!("{:<28} {}", case.id, outcome.as_ref().map_or_else(String::as_str, |()| "ok"));
        }
        failures.extend(outcome.err().map(|why| format!("{}: {why}", case.id)));
    }
    assert!(failures.is_empty(), "{} of {} cases:\n{}", failures.len(), cases.len(), failures.join("\n"));
}

/// Checks that every difference about one of these functions is needed by a case, or is marked as for further ones: that
/// the first difference which applies to a case is about something in which the two do differ.
///
/// # Panics
/// With the differences that are not.
pub fn assert_differences_are_needed(cases: &[Case], functions: &[&str], draw: impl Fn(&Case) -> Result<Device>) {
    let differences = differences();
    let mut needed = vec![false; differences.len()];
    for case in cases {
        if let Some(i) = differences.iter().position(|difference| difference.applies_to(case)) {
            needed[i] = needed[i] || check(case, None, &draw).is_err();
        }
    }
    let about = |d: &Difference| functions.iter().any(|name| d.is_about(name));
    let wrong: Vec<String> = differences
        .iter()
        .zip(needed)
        .filter(|(difference, needed)| about(difference) && difference.further == *needed)
        .map(|(difference, needed)| format!("{:?} ({}): needed is {needed}", difference.function, difference.condition))
        .collect();
    assert!(wrong.is_empty(), "differences.toml has `further` wrong:\n{}", wrong.join("\n"));
}

fn check(case: &Case, difference: Option<&Difference>, draw: impl Fn(&Case) -> Result<Device>) -> Result<(), String> {
    let drawn = draw(case);
    if drawn.is_err() && case.expect.get("error").is_some() {
        return Ok(());
    }
    let same = |drawn: Result<Device>, extent: Extent| -> Result<(), String> {
        if case.expect.get("error").is_some() {
            return Err("the reference refuses it, ours draws it".to_owned());
        }
        let device = drawn.map_err(|error| format!("ours refuses it: {}", error.report()))?;
        compare(&device, &case.expect, extent)
    };
    match difference.map(|difference| (difference.compare, difference)) {
        Some((Instead::Nothing, _)) => Ok(()),
        Some((Instead::Error, _)) => drawn.map_or(Ok(()), |_| Err("ours draws it and is said to refuse".to_owned())),
        Some((Instead::ErrorOrSame, _)) if drawn.is_err() => Ok(()),
        Some((Instead::Drawn, _)) => drawn.map_or_else(|error| Err(error.report()), |_| Ok(())),
        Some((Instead::Nearby, difference)) => same(drawn, Extent::of(case)).or_else(|why| {
            let nearby = difference.nudge.iter().flat_map(|name| nudged(case, name));
            let found = nearby.map(|case| same(draw(&case), Extent::Points)).any(|outcome| outcome.is_ok());
            if found {
                Ok(())
            } else {
                Err(format!("{why}; nor is it the reference's with a number changed by a hair"))
            }
        }),
        Some((Instead::With, difference)) => {
            let mut case = case.clone();
            case.params.extend(difference.with.clone());
            same(draw(&case), Extent::of(&case))
        }
        Some((Instead::CornersToAStep, _)) => same(drawn, Extent::Corners(step_of(case))),
        Some((Instead::Region, _)) => same(drawn, Extent::Region),
        Some((Instead::Ports, _)) => same(drawn, Extent::Ports),
        Some((Instead::ErrorOrSame, _)) | None => same(drawn, Extent::of(case)),
    }
}

/// The case with a number a hair smaller, and a hair larger.
fn nudged(case: &Case, name: &str) -> Vec<Case> {
    let Some(value) = parameter(case, name).and_then(|value| value.as_f64()) else { return Vec::new() };
    let (first, rest) = name.split_once('.').map_or((name, None), |(first, rest)| (first, Some(rest)));
    let with = |value: f64| {
        let mut case = case.clone();
        let mut whole = parameter(&case, first).unwrap_or(Json::Null);
        match rest.and_then(|rest| rest.parse::<usize>().ok()) {
            Some(index) => whole[index] = value.into(),
            None => whole = value.into(),
        }
        case.params.insert(first.to_owned(), whole);
        case
    };
    [1.0 - HAIR, 1.0 + HAIR].map(|factor| with(value * factor)).to_vec()
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
    let tolerance = if extent == Extent::Points { 2.0 * HAIR } else { INFO_TOLERANCE };
    info(device.info(), &expected.info, tolerance)?;
    if extent == Extent::Ports {
        return Ok(());
    }
    let drawn = outlines_by_layer(device);
    layers(&drawn, &expected, extent)?;
    match extent {
        Extent::All => bbox(device, expected.bbox, POINT_TOLERANCE)?,
        Extent::Points => return bbox(device, expected.bbox, POINT_TOLERANCE),
        Extent::OnGrid(step) | Extent::Corners(step) => return bbox(device, expected.bbox, 2.0 * step),
        _ => return Ok(()),
    }
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
        (Extent::OnGrid(step), Some(points)) => agree_on_grid(outlines, &points, step),
        (Extent::Corners(step), Some(points)) => corners(outlines, &points, step),
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

/// Whether every corner has one of the other's within a step, both ways.
fn corners(outlines: &[Vec<Point>], expected: &[Vec<Point>], step: f64) -> Result<(), String> {
    let near = |p: Point, q: Point| (p.x - q.x).abs() <= 1.01 * step && (p.y - q.y).abs() <= 1.01 * step;
    let lonely = |these: &[Vec<Point>], those: &[Vec<Point>]| {
        these.iter().flatten().find(|p| !those.iter().flatten().any(|q| near(**p, *q))).copied()
    };
    match lonely(outlines, expected).or_else(|| lonely(expected, outlines)) {
        None => Ok(()),
        Some(corner) => Err(format!("the corner at {corner} has none within a step of {step} µm")),
    }
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

fn bbox(thing: &impl Bounded, expected: Option<[[f64; 2]; 2]>, tolerance: f64) -> Result<(), String> {
    match (thing.bbox(), expected) {
        (Some(a), Some([min, max]))
            if a.min.distance(min.into()) <= tolerance && a.max.distance(max.into()) <= tolerance =>
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
fn info(ours: &BTreeMap<String, Value>, expected: &BTreeMap<String, Json>, tolerance: f64) -> Result<(), String> {
    for (key, expected) in expected {
        match ours.get(key) {
            Some(value) if same_value(value, expected, tolerance) => {}
            value => return Err(format!("info {key:?} is {value:?}, expected {expected}")),
        }
    }
    Ok(())
}

fn same_value(ours: &Value, expected: &Json, tolerance: f64) -> bool {
    match (ours, expected) {
        (Value::List(ours), Json::Array(expected)) => {
            ours.len() == expected.len() && ours.iter().zip(expected).all(|(a, b)| same_value(a, b, tolerance))
        }
        (Value::Map(ours), Json::Object(expected)) => {
            ours.len() == expected.len()
                && expected.iter().all(|(key, b)| ours.get(key).is_some_and(|a| same_value(a, b, tolerance)))
        }
        (Value::Text(a), Json::String(b)) => a == b,
        (Value::Bool(a), Json::Bool(b)) => a == b,
        (Value::Null, Json::Null) => true,
        (ours, expected) => match (ours.as_f64(), expected.as_f64()) {
            (Some(a), Some(b)) => (a - b).abs() <= tolerance * b.abs().max(1.0),
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
    bbox(reference, expected.bbox, POINT_TOLERANCE)?;
    expected.ports.iter().try_for_each(|(name, expected)| {
        let port = reference.port(name).map_err(|error| error.to_string())?;
        port_matches(&port, expected)
    })
}
