//! [`describe`]: a device as a flat list of what can be seen of it, to compare devices by.

use std::collections::BTreeMap;

use phidl_core::geom::{Point, Rect};
use phidl_core::layer::Layer;
use phidl_core::place::Bounded;
use phidl_core::port::Port;
use phidl_core::scene::Device;
use serde_json::{Map, Value as Json, json as object};

use super::json;

/// Points are written to this part of a micrometer, as reference results are.
const PARTS: f64 = 1e7;
/// Precision of the geometry hash (µm), as reference results have it.
const HASH_PRECISION: f64 = 1e-4;

/// What can be seen of a device: box, flattened polygons by layer, ports, info and geometry hash.
///
/// ```text
/// {"bbox": [[x0, y0], [x1, y1]] or null,
///  "layers": {"1/0": {"polygons": n, "vertices": n, "area": µm², "points": [[[x, y], …], …]}},
///  "ports": {name: {"midpoint": [x, y], "width": µm, "orientation": degrees}},
///  "info": {key: value},
///  "hash_geometry": hexadecimal}
/// ```
///
/// Points are rounded to 1e-7 µm, everything else is exact. `area` is what the layer covers; where polygons overlap,
/// it counts once.
#[must_use]
pub fn describe(device: &Device) -> Json {
    let hash = device.hash_geometry(HASH_PRECISION).expect("invariant: the precision is a positive length");
    object!({
        "bbox": device.bbox().map(corners),
        "layers": layers(device),
        "ports": device.ports().map(|port| (port.name().to_owned(), describe_port(port))).collect::<Map<_, _>>(),
        "info": device.info().iter().map(|(key, value)| (key.clone(), json(value))).collect::<Map<_, _>>(),
        "hash_geometry": hash,
    })
}

/// Midpoint, width and orientation.
pub(super) fn describe_port(port: &Port) -> Json {
    object!({"midpoint": pair(port.midpoint()), "width": port.width(), "orientation": port.orientation()})
}

pub(super) fn corners(rect: Rect) -> Json {
    object!([pair(rect.min), pair(rect.max)])
}

pub(super) fn pair(point: Point) -> Json {
    object!([point.x, point.y])
}

fn layers(device: &Device) -> Map<String, Json> {
    let mut layers: BTreeMap<Layer, Vec<Vec<Point>>> = BTreeMap::new();
    for polygon in device.flat_polygons() {
        layers.entry(polygon.layer.unwrap_or_default()).or_default().push(polygon.points().collect());
    }
    layers.iter().map(|(layer, outlines)| (layer.to_string(), describe_layer(outlines))).collect()
}

fn describe_layer(outlines: &[Vec<Point>]) -> Json {
    let round = |p: &Point| object!([(p.x * PARTS).round() / PARTS, (p.y * PARTS).round() / PARTS]);
    let points: Vec<Vec<Json>> = outlines.iter().map(|outline| outline.iter().map(round).collect()).collect();
    object!({
        "polygons": outlines.len(),
        "vertices": outlines.iter().map(Vec::len).sum::<usize>(),
        "points": points,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::prelude::*;

    #[test]
    fn a_device_is_described_flat_with_ports_and_info() {
        let mut d = Device::builder("pad");
        d.add_polygon([(0, 0), (2, 0), (2, 1), (0, 1)], (3, 1)).unwrap();
        let pad = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(pad.array(2, 1, (5, 5)));
        d.add_port("e", ((7.0, 0.5), 1, 0)).unwrap();
        d.info("length", 0.1);
        let described = describe(&d.build().unwrap());
        assert_eq!(described["bbox"], object!([[0.0, 0.0], [7.0, 1.0]]));
        let layer = &described["layers"]["3/1"];
        assert_eq!((&layer["polygons"], &layer["vertices"]), (&object!(2), &object!(8)));
        assert_eq!(layer["points"][1][0], object!([5.0, 0.0]));
        assert_eq!(described["ports"]["e"], object!({"midpoint": [7.0, 0.5], "width": 1.0, "orientation": 0.0}));
        assert_eq!(described["info"], object!({"length": 0.1}));
    }

    #[test]
    fn an_empty_device_has_no_box() {
        let described = describe(&Device::builder("nothing").build().unwrap());
        assert_eq!((&described["bbox"], &described["layers"]), (&Json::Null, &object!({})));
    }
}
