//! Comparing a device with a described one.

use std::collections::BTreeMap;

use phidl_core::param::Value;
use phidl_core::prelude::*;
use serde::Deserialize;
use serde_json::Value as Json;

use super::Case;
use super::region::{agree_on_grid, merged_area, xor_area};

/// By which part a number is changed by a hair.
pub(super) const HAIR: f64 = 2e-9;
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
pub(super) struct Described {
    bbox: Option<[[f64; 2]; 2]>,
    #[serde(default)]
    pub(super) layers: BTreeMap<String, DescribedLayer>,
    #[serde(default)]
    ports: BTreeMap<String, DescribedPort>,
    #[serde(default)]
    info: BTreeMap<String, Json>,
    hash_geometry: Option<String>,
}

#[derive(Debug, Deserialize)]
pub(super) struct DescribedLayer {
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

/// The functions whose results are regions on a grid: where an outline begins and where a hole is cut open is not defined.
const SET_FUNCTIONS: [&str; 6] = ["boolean", "offset", "outline", "invert", "xor_diff", "union"];
/// Their grid step by default (µm).
const SET_PRECISION: f64 = 1e-4;

/// What of a device is compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Extent {
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
    /// Area of each layer, box, port widths and info to this part of them.
    Within(f64),
    /// Every polygon of the reference is there; ours has glyphs besides. Ports and info.
    Contains,
    /// Ports and info.
    Ports,
}

impl Extent {
    /// What a case has compared.
    pub(super) fn of(case: &Case) -> Self {
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
pub(super) fn step_of(case: &Case) -> f64 {
    case.params.get("precision").and_then(Json::as_f64).unwrap_or(SET_PRECISION)
}

/// Compares a device with a described one in all that it states.
///
/// # Errors
/// What differs.
pub fn compare_device(device: &Device, expect: &Json) -> Result<(), String> {
    compare(device, expect, Extent::All)
}

pub(super) fn compare(device: &Device, expect: &Json, extent: Extent) -> Result<(), String> {
    let expected = Described::deserialize(expect).map_err(|error| format!("the description is off: {error}"))?;
    if let Extent::Within(part) = extent {
        return within(device, &expected, part);
    }
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

/// Areas, box, port widths and info agree to a part of them; box and ports to that part of the size.
fn within(device: &Device, expected: &Described, part: f64) -> Result<(), String> {
    let size = expected.bbox.map_or(0.0, |[min, max]| Point::from(min).distance(max.into()));
    bbox(device, expected.bbox, part * size)?;
    for (name, expected) in &expected.ports {
        let port = device.port(name).map_err(|error| error.to_string())?;
        let near = port.midpoint().distance(expected.midpoint.into()) <= part * size
            && (port.width() - expected.width).abs() <= part * expected.width
            && phidl_core::num::angle::between(port.orientation(), expected.orientation) <= ANGLE_TOLERANCE;
        if !near {
            return Err(format!("{port}, expected {expected:?} to {part}"));
        }
    }
    info(device.info(), &expected.info, part)?;
    let drawn = outlines_by_layer(device);
    for (name, expected) in &expected.layers {
        let area = drawn.get(name).map_or(0.0, |outlines| merged_area(outlines));
        if (area - expected.area).abs() > part * expected.area {
            return Err(format!("the area on layer {name} is {area} µm², expected {} µm² to {part}", expected.area));
        }
    }
    Ok(())
}

pub(super) fn outlines_by_layer(device: &Device) -> BTreeMap<String, Vec<Vec<Point>>> {
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

pub(super) fn layer(outlines: &[Vec<Point>], expected: &DescribedLayer, extent: Extent) -> Result<(), String> {
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
pub(super) fn contains(outlines: &[Vec<Point>], expected: &[Vec<Point>]) -> Result<(), String> {
    let same = |a: &[Point], b: &[Point]| {
        a.len() == b.len() && a.iter().zip(b).all(|(p, q)| p.distance(*q) <= POINT_TOLERANCE)
    };
    let mut left: Vec<&Vec<Point>> = outlines.iter().collect();
    for outline in expected {
        match left.iter().position(|ours| same(ours, outline)) {
            Some(index) => drop(left.swap_remove(index)),
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

fn bbox(element: &impl Bounded, expected: Option<[[f64; 2]; 2]>, tolerance: f64) -> Result<(), String> {
    match (element.bbox(), expected) {
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
