//! The described device: what a cell draws, in the form of the reference results.

use indexmap::IndexMap;
use phidl_core::geom::Rect;
use phidl_core::place::Bounded;
use phidl_core::port::Port;
use phidl_core::scene::{Device, FlatPolygon};
use serde_json::{Map, Value, json};

use super::value::{map, point};
use crate::counts::Counts;
use crate::error::{IoError, Result};

/// Points are listed if there are not more of them than this in the whole device.
const MOST_LISTED: usize = 20_000;

/// Devices with more instances or corners are not walked.
const MOST_FLAT: u64 = 1 << 26;

/// The precision at which reference results are hashed (µm).
const HASH_PRECISION: f64 = 1e-4;

/// Describes a device: its box, what is drawn on each layer (all levels, in order of first appearance), ports, info and
/// the geometry hash at 1e-4 µm.
///
/// `points` are listed for up to 20,000 points in all; `area` is what the polygons of a layer cover together (µm²).
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
/// let described = phidl_io::json::describe(&d.build()?)?;
/// assert_eq!(described["bbox"].to_string(), "[[0.0,0.0],[4.0,2.0]]");
/// assert_eq!(described["layers"]["1/0"]["vertices"], 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::TooLarge`] beyond 2²⁶ instances or corners; [`IoError::Area`] for what the boolean engine refuses.
pub fn describe(device: &Device) -> Result<Value> {
    Counts::check_flat(device, MOST_FLAT)?;
    let hash = device.hash_geometry(HASH_PRECISION).expect("invariant: the precision is a length");
    Ok(json!({
        "bbox": device.bbox().map(corners),
        "layers": layers(device)?,
        "ports": device.ports().map(|p| (p.name().to_owned(), port(p))).collect::<Map<_, _>>(),
        "info": map(device.info()),
        "hash_geometry": hash,
    }))
}

pub(crate) fn corners(rect: Rect) -> Value {
    [point(rect.min), point(rect.max)].into_iter().collect()
}

pub(super) fn port(port: &Port) -> Value {
    let mut described = json!({
        "midpoint": point(port.midpoint()),
        "width": port.width(),
        "orientation": port.orientation(),
    });
    if !port.info().is_empty() {
        described["info"] = map(port.info()).into();
    }
    described
}

#[derive(Default)]
struct Drawn {
    polygons: usize,
    vertices: usize,
    area: Option<f64>,
    points: Vec<Value>,
}

fn layers(device: &Device) -> Result<Map<String, Value>> {
    let listed = device.flat_counts().is_ok_and(|(_, points)| points <= MOST_LISTED);
    let mut layers: IndexMap<String, Drawn> = IndexMap::new();
    for polygon in device.flat_polygons() {
        let Some(layer) = polygon.layer else { continue };
        let drawn = layers.entry(layer.to_string()).or_default();
        drawn.polygons += 1;
        drawn.vertices += polygon.len();
        if listed {
            drawn.points.push(outline(&polygon));
        }
    }
    let areas = phidl_boolean::merged_areas(device)
        .map_err(|source| IoError::Area { cell: device.name().into(), source: Box::new(source) })?;
    for (layer, area) in areas {
        layers.entry(layer.to_string()).or_default().area = Some(area);
    }
    let described = layers.into_iter().map(|(layer, drawn)| {
        let mut described = json!({ "polygons": drawn.polygons, "vertices": drawn.vertices, "area": drawn.area });
        if listed {
            described["points"] = drawn.points.into();
        }
        (layer, described)
    });
    Ok(described.collect())
}

fn outline(polygon: &FlatPolygon<'_>) -> Value {
    polygon.points().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The case `rectangle-b` of the reference results, drawn by hand.
    #[test]
    fn a_rectangle_is_described_as_in_the_reference_results() {
        let mut d = Device::builder("rectangle");
        let corners = [(45.035, 19.261), (45.035, 0.0), (0.0, 0.0), (0.0, 19.261)];
        d.add_polygon(corners, [(8, 0), (29, 0), (48, 3)]).unwrap();
        let points = json!([[[45.035, 19.261], [45.035, 0.0], [0.0, 0.0], [0.0, 19.261]]]);
        let layer = json!({ "polygons": 1, "vertices": 4, "area": 867.419135, "points": points });
        let expected = json!({
            "bbox": [[0.0, 0.0], [45.035, 19.261]],
            "layers": { "8/0": layer, "29/0": layer, "48/3": layer },
            "ports": {},
            "info": {},
            "hash_geometry": "c4e88bd284ec6dd6fb3017411c5e9e0f69c7e8c7",
        });
        assert_eq!(describe(&d.build().unwrap()).unwrap(), expected);
    }

    #[test]
    fn a_device_of_endless_placements_is_refused() {
        let mut device = Device::builder("nothing").build().unwrap();
        for _ in 0..5 {
            let mut d = Device::builder("array");
            d.add(device.array(60_000, 60_000, (1, 1)));
            device = d.build().unwrap();
        }
        let error = describe(&device).unwrap_err();
        assert!(matches!(error, IoError::TooLarge { what: "instances", size: u64::MAX, .. }), "{error}");
    }

    #[test]
    fn placed_polygons_ports_and_info_are_described() {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        let dot = d.build().unwrap();
        let mut d = Device::builder("field");
        d.add(dot.array(2, 2, (10, 10)));
        d.add_port("e", ((1, 2), 3, 90)).unwrap();
        d.info("length", 1.5).info("turns", 3);
        let described = describe(&d.build().unwrap()).unwrap();
        assert_eq!(described["layers"]["1/0"]["polygons"], 4);
        assert_eq!(described["layers"]["1/0"]["area"], 2.0);
        assert_eq!(described["layers"]["1/0"]["points"][3][0], json!([10.0, 10.0]));
        assert_eq!(described["ports"]["e"], json!({"midpoint": [1.0, 2.0], "width": 3.0, "orientation": 90.0}));
        assert_eq!(described["info"], json!({"length": 1.5, "turns": 3}));
        let empty = describe(&Device::builder("nothing").build().unwrap()).unwrap();
        assert_eq!((&empty["bbox"], &empty["layers"]), (&Value::Null, &json!({})));
    }
}
