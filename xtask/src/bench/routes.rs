//! Manhattan routes beside PHIDL and gdstk.

use anyhow::Context;
use phidl_core::cache;
use phidl_core::port::Port;
use phidl_core::scene::Device;
use phidl_route::{RouteManhattanParams, path_manhattan};
use serde_json::{Value as Json, json};
use testkit::loads;

use super::table::Section;
use super::{Sitting, clock};

const NOTES: &str = "Ten thousand pairs of ports in all directions and relative placements, at a radius of 10 µm. Way \
    points: `path_manhattan` on both sides. Devices: circular bends with 720 points per turn, extruded, with ports; \
    PHIDL's `route_smooth` does it with arcs; if it refuses a pair, the time of the others is scaled up. \
    gdstk finds no way: FlexPath is given ours, and makes polygons without ports.";

/// Times ways and devices.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let pairs = loads::pairs();
    let file = sitting.folder.join("pairs.json");
    std::fs::write(&file, serde_json::to_vec(&described(&pairs)?)?).with_context(|| file.display().to_string())?;
    let times = sitting.peers("routes", &file)?;
    let mut section = Section::new("Routes", NOTES, &["PHIDL", "FlexPath"]);
    section.add("10,000 manhattan ways", clock::best(|| ways(&pairs)), &times, "way points");
    section.add("the same as devices with circular bends", clock::best(|| devices(&pairs)), &times, "devices");
    Ok(section)
}

/// Each pair with the points of our way.
fn described(pairs: &[[Port; 2]]) -> anyhow::Result<Vec<Json>> {
    let port = |p: &Port| json!([p.midpoint().x, p.midpoint().y, p.width(), p.orientation()]);
    let pair = |[a, z]: &[Port; 2]| {
        let way = path_manhattan(a, z, 10).map_err(crate::report)?;
        let points: Vec<[f64; 2]> = way.points().iter().map(|p| [p.x, p.y]).collect();
        Ok(json!([port(a), port(z), points]))
    };
    pairs.iter().map(pair).collect()
}

fn ways(pairs: &[[Port; 2]]) -> phidl_core::Result<f64> {
    pairs.iter().map(|[a, z]| Ok(path_manhattan(a, z, 10)?.length())).sum()
}

/// A route of any kind: the pairs are in all positions.
fn route(a: &Port, z: &Port) -> RouteManhattanParams {
    RouteManhattanParams::new(a, z).radius(10).width(a.width()).allow_detour(true).allow_crossings(true)
}

fn devices(pairs: &[[Port; 2]]) -> phidl_core::Result<Vec<Device>> {
    cache::bypass(|| pairs.iter().map(|[a, z]| route(a, z).build()).collect())
}
