//! The described device: what a cell comes down to, in the form of the reference results.

use indexmap::IndexMap;
use phidl_core::geom::Rect;
use phidl_core::place::Bounded;
use phidl_core::port::Port;
use phidl_core::scene::{Device, FlatPolygon};
use serde_json::{Map, Value, json};

use super::value::{map, point};

/// Points are listed if there are not more of them than this in the whole device.
const MOST_LISTED: usize = 20_000;

/// The precision at which reference results are hashed (µm).
const HASH_PRECISION: f64 = 1e-4;

/// Describes a device: its box, what is drawn on each layer (all levels, in order of first appearance), ports, info and
/// the geometry hash at 1e-4 µm.
///
/// `points` are listed for up to 20,000 points in all; `area` is what the polygons of a layer cover together (µm²), null
/// where that is beyond what numbers can hold.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
/// let described = phidl_io::json::describe(&d.build()?);
/// assert_eq!(described["bbox"].to_string(), "[[0.0,0.0],[4.0,2.0]]");
/// assert_eq!(described["layers"]["1/0"]["vertices"], 4);
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[must_use]
pub fn describe(device: &Device) -> Value {
    let hash = device.hash_geometry(HASH_PRECISION).expect("invariant: the precision is a length");
    json!({
        "bbox": device.bbox().map(corners),
        "layers": layers(device),
        "ports": device.ports().map(|p| (p.name().to_owned(), port(p))).collect::<Map<_, _>>(),
        "info": map(device.info()),
        "hash_geometry": hash,
    })
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

fn layers(device: &Device) -> Map<String, Value> {
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
    for (layer, area) in phidl_boolean::merged_areas(device).unwrap_or_default() {
        layers.entry(layer.to_string()).or_default().area = Some(area);
    }
    let described = layers.into_iter().map(|(layer, drawn)| {
        let mut described = json!({ "polygons": drawn.polygons, "vertices": drawn.vertices, "area": drawn.area });
        if listed {
            described["points"] = drawn.points.into();
        }
        (layer, described)
    });
    described.collect()
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
        assert_eq!(describe(&d.build().unwrap()), expected);
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
        let described = describe(&d.build().unwrap());
        assert_eq!(described["layers"]["1/0"]["polygons"], 4);
        assert_eq!(described["layers"]["1/0"]["area"], 2.0);
        assert_eq!(described["layers"]["1/0"]["points"][3][0], json!([10.0, 10.0]));
        assert_eq!(described["ports"]["e"], json!({"midpoint": [1.0, 2.0], "width": 3.0, "orientation": 90.0}));
        assert_eq!(described["info"], json!({"length": 1.5, "turns": 3}));
        let empty = describe(&Device::builder("nothing").build().unwrap());
        assert_eq!((&empty["bbox"], &empty["layers"]), (&Value::Null, &json!({})));
    }
}
