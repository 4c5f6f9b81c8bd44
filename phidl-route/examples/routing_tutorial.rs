//! PHIDL's tutorial on routing, step by step: every function is a chapter and returns what it draws.
//!
//! `cargo run -p phidl-route --example routing_tutorial` prints what came out; nothing is written. The pictures are in
//! `docs/guide/routing.md`, where `cargo xtask gallery --bless` draws them from [`chapters`].

use phidl_core::prelude::*;
use phidl_path::{CrossSection, EulerBend, Section};
use phidl_route::{
    PathType, RouteSharpParams, RouteSmoothParams, SmoothOptions, path_manhattan, route_quad, route_sharp,
    route_smooth, route_xy,
};

/// A pad with a port on each side, at a place.
fn pad(size: (f64, f64), center: (i32, i32)) -> Result<Reference> {
    let (w, h) = (size.0 / 2.0, size.1 / 2.0);
    let mut d = Device::builder("pad");
    d.add_polygon([(-w, -h), (w, -h), (w, h), (-w, h)], 1)?;
    for (name, at, width, orientation) in [
        ("E", (w, 0.0), 2.0 * h, 0),
        ("N", (0.0, h), 2.0 * w, 90),
        ("W", (-w, 0.0), 2.0 * h, 180),
        ("S", (0.0, -h), 2.0 * w, 270),
    ] {
        d.add_port(name, (at, width, orientation))?;
    }
    Ok(d.build()?.place().moved_by(center))
}

/// The quickest joint of two pads: a quadrilateral from port to port.
fn quadrilateral() -> Result<Device> {
    let (a, b) = (pad((10.0, 20.0), (0, 0))?, pad((30.0, 10.0), (60, 35))?);
    let mut d = Device::builder("quadrilateral");
    d.add(route_quad(&a.port("E")?, &b.port("W")?, None, None, 2)?);
    d.add(a);
    d.add(b);
    d.build()
}

/// Two ports around a corner, which the next chapters join.
fn corner() -> [Port; 2] {
    [Port::new((40, 0), 5, 180), Port::new((0, -40), 5, 270)]
}

/// Waypoints are chosen automatically, with bends or sharp corners.
fn automatic() -> Result<[Device; 2]> {
    let [a, b] = corner();
    let smooth = route_smooth(&a, &b, 10, None, PathType::Manhattan, 2)?;
    let sharp = route_sharp(&a, &b, None, PathType::Manhattan, 2)?;
    Ok([smooth, sharp])
}

/// The four ways to say how wide: as the ports are, a number, from one to another, and a cross-section.
fn widths() -> Result<[Device; 4]> {
    let [a, b] = corner();
    let strips = CrossSection::new()
        .add(Section::new(1).layer(4).ports("1", "2"))
        .add(Section::new(2.5).offset(3).layer(5))
        .add(Section::new(2.5).offset(-3).layer(5));
    let route = || RouteSmoothParams::new(&a, &b).radius(10);
    Ok([route().build()?, route().width(2).build()?, route().width((7, 1.5)).build()?, route().width(strips).build()?])
}

/// What a route does, by hand: waypoints, bends, width.
pub(crate) fn by_hand() -> Result<[Device; 2]> {
    let [a, b] = corner();
    let points = path_manhattan(&a, &b, 10)?;
    let by_hand = points.smoothed(10, EulerBend::new().use_eff())?.extrude_width(5, 2)?;
    Ok([by_hand, RouteSmoothParams::new(&a, &b).radius(10).width(5).layer(2).build()?])
}

/// Bends of one's own: arcs of few points.
fn coarse_arcs() -> Result<Device> {
    let [a, b] = corner().map(|port| port.with_width(3));
    let coarse = SmoothOptions::Arc { num_pts: 16.0 };
    RouteSmoothParams::new(&a, &b).radius(10).smooth_options(coarse).build()
}

/// Around an obstacle: a J with a longer first leg, a C to the other side, or waypoints by hand, which begin and end on
/// the ports.
fn around_an_obstacle() -> Result<[Device; 3]> {
    let [a, b] = corner();
    let j = RouteSmoothParams::new(&a, &b).radius(10).path_type(PathType::J).length1(60).length2(20).build()?;
    let facing = Port::new((40, -5), 5, 0);
    let c = RouteSharpParams::new(((0, 0), 5, 180), &facing).path_type(PathType::C);
    let c = c.length1(10).length2(10).left1(-10).build()?;
    let (x, y) = (b.x(), b.y());
    let points = [a.midpoint(), (20.0, 0.0).into(), (20.0, -60.0).into(), (x, -60.0).into(), (x, y).into()];
    let manual = RouteSmoothParams::new(&a, &b).radius(10).path_type(PathType::Manual).manual_path(points.to_vec());
    Ok([j, c, manual.build()?])
}

/// One of each kind of way.
fn path_types() -> Result<Device> {
    let smooth = |a: (i32, i32, i32, i32), b: (i32, i32, i32, i32), path_type| {
        let port = |p: (i32, i32, i32, i32)| Port::new((p.0, p.1), p.2, p.3);
        RouteSmoothParams::new(port(a), port(b)).path_type(path_type)
    };
    let routes = [
        smooth((-50, 0, 4, 90), (-50, 50, 4, 270), PathType::Straight),
        smooth((30, 0, 4, 180), (0, 50, 4, 270), PathType::L),
        smooth((50, 50, 2, 270), (80, 50, 4, 270), PathType::U).radius(10).length1(50),
        smooth((50, 80, 4, 10), (80, 130, 4, 190), PathType::U).length1(20),
        smooth((100, 25, 4, 270), (130, 50, 4, 180), PathType::J).length1(25).length2(10),
        smooth((115, 105, 5, 270), (131, 130, 5, 180), PathType::J).length1(25).length2(30),
        smooth((180, 35, 4, 90), (178, 15, 4, 270), PathType::C).length1(15).left1(30).length2(15),
        smooth((150, 105, 4, 90), (180, 105, 4, 270), PathType::C).length1(25).left1(-15).length2(25),
        smooth((150, 170, 4, 0), (175, 170, 4, 0), PathType::C).length1(10).left1(10).length2(10).radius(4),
        smooth((200, 50, 5, 284), (230, 50, 5, 256), PathType::V),
        smooth((280, 0, 4, 190), (250, 50, 3, -10), PathType::Z).length1(30).length2(40),
    ];
    let mut d = Device::builder("path_types");
    for route in routes {
        d.add(route.build()?);
    }
    d.build()
}

/// A port that faces up at all positions around another one: the shapes of Manhattan routes.
fn sweep() -> Result<Device> {
    let mut d = Device::builder("sweep");
    for (column, x) in [-20, -10, 0, 10, 20].into_iter().enumerate() {
        for (row, y) in [-20, 0, 20].into_iter().enumerate() {
            let at = Point::new(100.0 * column as f64, 100.0 * row as f64);
            let (a, b) = (Port::new(at, 2, 0), Port::new(at + Point::from((x, y)), 2, 90));
            if x != 0 || y != 0 {
                // One of the ports lies on its own route.
                d.add(RouteSmoothParams::new(&a, &b).layer(2).allow_crossings(true).build()?);
            }
        }
    }
    d.build()
}

/// Wires that fan out in steps: each letter is a step, and a letter that occurs four times makes steps of a quarter of the
/// distance.
fn fan_out() -> Result<Device> {
    let mut d = Device::builder("fan_out");
    for (wire, directions) in ["yyyyx", "yyyxy", "yyxyy", "yxyyy"].into_iter().enumerate() {
        let x = wire as f64;
        let (a, b) = (Port::new((x, 0.0), 0.5, 90), Port::new((10.0 + 4.0 * x, 20.0), 0.5, 270));
        d.add(route_xy(&a, &b, directions, None, 2)?);
    }
    d.build()
}

/// A drawing and what it is called.
type Named = (&'static str, Device);

/// The chapters: what each is called, and its drawings.
pub(crate) fn chapters() -> Result<Vec<(&'static str, Vec<Named>)>> {
    Ok(vec![
        ("quadrilateral", vec![("", quadrilateral()?)]),
        ("automatic", named(["route_smooth", "route_sharp"], automatic()?)),
        ("widths", named(["of the ports", "a number", "from one to another", "a cross-section"], widths()?)),
        ("by_hand", named(["by hand", "route_smooth"], by_hand()?)),
        ("coarse_arcs", vec![("", coarse_arcs()?)]),
        ("around_an_obstacle", named(["J", "C", "waypoints by hand"], around_an_obstacle()?)),
        ("path_types", vec![("", path_types()?)]),
        ("sweep", vec![("", sweep()?)]),
        ("fan_out", vec![("", fan_out()?)]),
    ])
}

fn named<const N: usize>(names: [&'static str; N], devices: [Device; N]) -> Vec<Named> {
    names.into_iter().zip(devices).collect()
}

/// Prints what was drawn.
#[expect(clippy::print_stdout, reason = "an example shows what it did")]
pub(crate) fn main() -> Result<()> {
    for (chapter, drawings) in chapters()? {
        for (name, device) in drawings {
            let size = device.size();
            let length = device.info().get("length").and_then(Value::as_f64).unwrap_or_default();
            println!("{chapter:<20} {name:<20} {length:8.3} µm long, {:.3} × {:.3} µm", size.width, size.height);
        }
    }
    Ok(())
}
