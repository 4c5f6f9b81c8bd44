//! The main steps of PHIDL's waveguide tutorial: paths from pieces, smoothing, cross-sections, transitions, vias.

use std::f64::consts::PI;

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Path, Section, WidthChange, transition};

/// A path from pieces, drawn with one width, with a width that grows, and with few points.
fn pieces() -> Result<Vec<Device>> {
    let mut path = Path::arc(10, 90)?;
    path.append(Path::straight(10)?).append(Path::euler(3, -90)?).append(Path::straight(40)?);
    path.append([Path::arc(8, -45)?, Path::straight(10)?, Path::arc(8, 45)?, Path::straight(10)?]);
    path.movey(10).set_xmin(20);
    let few = Extrusion::new(&path, &CrossSection::of_width(1.5, 5)).simplify(1e-3).build()?;
    Ok(vec![path.extrude_width(1.5, 3)?, path.extrude_width((0.7, 3.7), 4)?, few])
}

/// Sharp corners from points or from turns, and round ones through the same points.
fn corners() -> Result<Vec<Device>> {
    let points = [(20, 10), (40, 10), (20, 40), (50, 40), (50, 20), (70, 20)];
    let mut turns = Path::line(10)?;
    turns.turn(90).append(Path::line(10)?).turn(-135).append(Path::line(15)?);
    let round = Path::smooth(points, 2, EulerBend::new())?;
    let tight = Path::smooth(points, 2, ArcBend::new())?.with_tolerance(0.001)?;
    [Path::from_points(points)?, turns, round, tight].iter().map(|path| path.extrude_width(1, 1)).collect()
}

/// A cross-section with ports, a second one, and a taper between the two, joined.
fn waveguides() -> Result<Device> {
    let narrow = CrossSection::new()
        .add(Section::new(1.2).layer(2).named("wg").ports("in1", "out1"))
        .add(Section::new(2.2).layer(3).named("etch"))
        .add(Section::new(1.1).offset(3).layer(1).named("wg2"));
    let wide = CrossSection::new()
        .add(Section::new(1).layer(2).named("wg").ports("in2", "out2"))
        .add(Section::new(3.5).layer(3).named("etch"))
        .add(Section::new(3).offset(5).layer(1).named("wg2"));
    let taper = transition(&narrow, &wide, WidthChange::Sine)?;

    let mut d = Device::builder("waveguides");
    let first = d.add(Path::straight(10)?.extrude(&narrow)?);
    let between = d.add(EulerBend::new().p(0.5).path(25, 45)?.extrude(&taper)?);
    let last = d.add(Path::straight(10)?.extrude(&wide)?);
    let out = d[first].port("out1")?;
    d[between].connect("in2", &out)?;
    let out = d[between].port("out1")?;
    d[last].connect("in2", &out)?;
    d.build()
}

/// Widths and offsets that follow a function, and vias along a path.
fn along_the_way() -> Result<Vec<Device>> {
    let wavy = CrossSection::new()
        .add(Section::new(3).offset(-6))
        .add(Section::new(|t: f64| 3.0 + (10.0 * PI * t).cos()))
        .add(Section::new(1).offset(|t: f64| 6.0 + (6.0 * PI * t).cos()).layer(1));
    let mut via = Device::builder("via");
    via.add_polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)], 4)?;
    let via = via.build()?;
    let path = Path::from_points([(20, 10), (30, 10), (40, 30), (50, 30), (50, 20), (55, 20)])?;
    let mut d = Device::builder("vias");
    for station in path.interpolate((0..12).map(|i| 4 * i), 0.2)? {
        d.add(station.place(&via));
    }
    Ok(vec![Path::straight(40)?.extrude(&wavy)?, d.build()?])
}

/// Prints what was drawn.
#[expect(clippy::print_stdout, reason = "an example shows what it did")]
pub(crate) fn main() -> Result<()> {
    let mut devices = pieces()?;
    devices.extend(corners()?);
    devices.push(waveguides()?);
    devices.extend(along_the_way()?);
    for device in &devices {
        let (polygons, size) = (device.flat_polygons().count(), device.size());
        println!("{:<12} {polygons} polygons, {:.3} × {:.3} µm", device.name(), size.width, size.height);
    }
    Ok(())
}
