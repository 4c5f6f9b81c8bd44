//! The figures in the crate documentation of phidl-path and phidl-route, which show more than one device.

use std::path::PathBuf;

use phidl_core::prelude::*;
use phidl_io::svg::{self, FigureOptions};
use phidl_path::{ArcBend, CrossSection, EulerBend, Path, Section, Spiral, TransitionShape, transition};
use phidl_route::{
    PathType, RouteBasicParams, RouteBend, RouteProfile, RouteSerpentineParams, RouteSmoothParams,
    route_manhattan_auto, route_quad, route_sharp,
};

use super::{Drawn, figure_options};

/// Distance between the items of a figure (µm).
const GAP: f64 = 12.0;

/// All of them.
pub(super) fn all() -> anyhow::Result<Vec<Drawn>> {
    let figures = [
        ("phidl-path/docs/pieces.svg", pieces()),
        ("phidl-path/docs/waveguide.svg", waveguide()),
        ("phidl-route/docs/routes.svg", routes()),
    ];
    figures.into_iter().map(|(path, device)| drawn(path.into(), &device.map_err(crate::report)?)).collect()
}

pub(super) fn drawn(path: PathBuf, device: &Device) -> anyhow::Result<Drawn> {
    let options = FigureOptions { size: Size::new(640.0, 420.0), ..figure_options(device)? };
    let text = svg::figure(device, &options).map_err(|error| anyhow::anyhow!(error.report()))?;
    Ok(Drawn { path, text })
}

/// The README's waveguide: a rib, its slab and a heater.
fn waveguide() -> Result<Device> {
    let rib = CrossSection::new()
        .add(Section::new(5).layer(0).named("slab"))
        .add(Section::new(1.2).layer(1).ports("in", "out").named("core"))
        .add(Section::new(0.8).offset(4.5).layer(3).named("heater"));
    let mut path = Path::smooth([(0, 0), (40, 0), (40, 40), (90, 40)], 12, EulerBend::new().use_eff())?;
    path.append(Path::euler(10, -90)?).append(Path::straight(5)?);
    path.with_tolerance(0.01)?.extrude(&rib)
}

/// What paths are made of, and what is drawn along them.
fn pieces() -> Result<Device> {
    let points = [(0, 0), (30, 0), (10, 30), (40, 30), (40, 10), (60, 10)];
    let narrow = CrossSection::new().add(Section::new(1).layer(1).named("core")).add(Section::new(3).named("clad"));
    let wide = CrossSection::new().add(Section::new(4).layer(1).named("core")).add(Section::new(9).named("clad"));
    let narrow = narrow.add(Section::new(1).offset(4).layer(3).named("wire"));
    let wide = wide.add(Section::new(2).offset(8).layer(3).named("wire"));
    let spiral = Spiral { num_turns: 3.0, gap: 3.0, inner_gap: 9.0, num_pts: 2000.0 };
    let wavy = |t: f64| 3.0 + 1.5 * (6.0 * PI * t).cos();
    rows(
        GAP,
        [
            vec![
                ("arc", ArcBend::new().path(25, 90)?.extrude_width(2, 0)?),
                ("Euler bend", EulerBend::new().use_eff().path(25, 90)?.extrude_width(2, 0)?),
                ("spiral", spiral.path()?.extrude_width(1.5, 0)?),
                ("corners", Path::from_points(points)?.extrude_width(2, 0)?),
                ("smooth", Path::smooth(points, 5, EulerBend::new().use_eff())?.extrude_width(2, 0)?),
            ],
            vec![
                ("width by a list", Path::straight(50)?.extrude_width((1, 6), 0)?),
                ("by a function", Path::straight(50)?.extrude(&CrossSection::new().add(Section::new(wavy)))?),
                (
                    "transition",
                    EulerBend::new().path(50, 60)?.extrude(&transition(&narrow, &wide, TransitionShape::Sine)?)?,
                ),
            ],
        ],
    )
}

/// Every kind of route.
fn routes() -> Result<Device> {
    let ends = || (Port::new((0, 0), 3, 0), Port::new((60, 35), 3, 180));
    let (a, b) = ends();
    let bus: Vec<Port> =
        (0..3).flat_map(|i| [Port::new((0, 7 * i), 2, 0), Port::new((50 - 7 * i, 40), 2, 270)]).collect();
    let serpentine = RouteSerpentineParams::new(((0, 0), 2, 0), ((120, 30), 2, 180), 400).bend(RouteBend::Euler);
    rows(
        GAP,
        [
            vec![
                ("quad", route_quad(((0, 0), 12, 0), ((40, 12), 4, 180), None, None, 0)?),
                (
                    "basic",
                    RouteBasicParams::new(((0, 0), 2, 0), ((50, 25), 6, 180)).path_type(RouteProfile::Sine).build()?,
                ),
                ("sharp", route_sharp(&a, &b, None, PathType::Manhattan, 0)?),
                ("smooth", RouteSmoothParams::new(&a, &b).radius(10).path_type(PathType::Manhattan).build()?),
            ],
            vec![
                ("manhattan_auto", route_manhattan_auto(bus, RouteBend::Circular, 8, 0)?),
                ("serpentine", serpentine.radius(8).allow_detour(true).build()?),
            ],
        ],
    )
}

/// Devices in rows at a distance (µm), each with its name below.
pub(super) fn rows<const N: usize>(gap: f64, rows: [Vec<(&str, Device)>; N]) -> Result<Device> {
    let name_gap = gap / 3.0;
    let mut d = Device::builder("figure");
    let mut top = 0.0;
    for row in rows {
        let (mut left, height) = (0.0, row.iter().map(|(_, thing)| thing.size().height).fold(0.0, f64::max));
        for (name, thing) in row {
            let mut thing = thing.place();
            thing.set_xmin(left).set_y(top - height / 2.0);
            if !name.is_empty() {
                d.add_label(name, (thing.x(), top - height - name_gap), 0)?;
            }
            left = thing.xmax() + gap;
            d.add(thing);
        }
        top -= height + name_gap + gap;
    }
    d.build()
}
