//! Wires around a chip: every kind of route, with its info.
//!
//! `cargo run -p phidl-route --example around_a_chip`
#![expect(clippy::print_stdout, reason = "an example shows what it draws")]

use phidl_core::prelude::*;
use phidl_path::{CrossSection, EulerBend, Section};
use phidl_route::{
    PathType, RouteBasicParams, RouteBend, RouteManhattanParams, RouteProfile, RouteSmoothParams, path_j,
    route_manhattan_auto, route_quad, route_serpentine, route_sharp, route_xy,
};

pub(crate) fn main() -> Result<()> {
    let (pad, chip) = (Port::new((0, 0), 20, 0).named("pad"), Port::new((300, 120), 10, 270).named("chip"));
    let mut d = Device::builder("around_a_chip");

    // One wire, with mitered corners, with bends of a given radius and a taper, and with clothoids around an obstacle.
    d.add(route_sharp(&pad, &chip, None, PathType::Manhattan, 1)?);
    d.add(RouteManhattanParams::new(&pad, &chip).bend(RouteBend::Gradual).radius(30).width((20, 10)).layer(2).build()?);
    let around = RouteSmoothParams::new(&pad, &chip).radius(25).width((20, 10)).path_type(PathType::Z);
    let wire = d.add(around.length1(100).length2(60).layer(3).build()?);
    println!(
        "smooth: {} µm long, radius {}",
        d[wire].device().info()["length"],
        d[wire].device().info()["smallest_radius"]
    );

    // The three steps by hand: waypoints, bends, and a cross-section of three strips.
    let gap = |offset: i32| Section::new(4).offset(offset).layer(5);
    let guide = CrossSection::new().add(Section::new(10).layer(4).ports("1", "2")).add(gap(12)).add(gap(-12));
    d.add(path_j(&pad, ((300, -200), 10, 90), 150, 80)?.smoothed(40, EulerBend::new().use_eff())?.extrude(&guide)?);

    // A joint of two pads, an S between two wires, a fan of steps, and a bus.
    d.add(route_quad(((0, 300), 20, 0), ((60, 320), 5, 180), None, None, 1)?);
    d.add(RouteBasicParams::new(((60, 320), 5, 0), ((200, 380), 5, 180)).path_type(RouteProfile::Sine).build()?);
    for (row, directions) in ["yyyxy", "yyxyy", "yxyyy"].into_iter().enumerate() {
        let x = 12.0 * row as f64;
        d.add(route_xy(((400.0 + x, 0.0), 4, 90), ((500.0 + x, 200.0), 4, 270), directions, None, 6)?);
    }
    let bus: Vec<Port> =
        (0..4).flat_map(|i| [Port::new((600, 15 * i), 4, 0), Port::new((800 - 15 * i, 200), 4, 270)]).collect();
    d.add(route_manhattan_auto(bus, RouteBend::Circular, 20, 7)?);

    // A wire of exactly 1500 µm.
    let late = d.add(route_serpentine(((0, 500), 4, 0), ((500, 600), 4, 180), 1500, RouteBend::Euler, 15, 8)?);
    println!("serpentine: {} µm long", d[late].device().info()["length"]);

    let d = d.build()?;
    println!("{} polygons within {:?}", d.flat_polygons().count(), d.bbox());
    Ok(())
}
