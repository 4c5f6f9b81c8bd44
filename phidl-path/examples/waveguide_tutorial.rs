//! PHIDL's tutorial on waveguides and paths, step by step: every function is a chapter and returns its drawing.
//!
//! `cargo run -p phidl-path --example waveguide_tutorial` prints what came out; nothing is written. The pictures are in
//! `docs/guide/waveguides.md`, where `cargo xtask gallery --bless` draws them from [`chapters`].

use std::f64::consts::PI;

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Overlaps, Path, Section, TransitionShape, transition};

/// A path from pieces. Everything that can be moved has the same methods.
pub(crate) fn pieces() -> Result<Path> {
    let mut path = Path::arc(10, 90)?;
    path.append(Path::straight(10)?).append(Path::euler(3, -90)?).append(Path::straight(40)?);
    path.append([Path::arc(8, -45)?, Path::straight(10)?, Path::arc(8, 45)?, Path::straight(10)?]);
    path.movey(10).set_xmin(20);
    Ok(path)
}

/// Extrusions: one width, a width that grows, or a cross-section with port names for its ends.
fn extrusions(path: &Path) -> Result<[Device; 3]> {
    let x = CrossSection::new()
        .add(Section::new(1).layer(0).ports("in", "out"))
        .add(Section::new(3).offset(2).layer(2))
        .add(Section::new(3).offset(-2).layer(2));
    // The outer strips are wider than the bend of 3 µm allows. PHIDL draws them all the same.
    let wide = Extrusion::new(path, &x).overlaps(Overlaps::Keep).build()?;
    Ok([path.extrude_width(1.5, 3)?, path.extrude_width((0.7, 3.7), 4)?, wide])
}

/// Pieces that repeat, in lists and in lists of lists.
fn repetition() -> Result<Path> {
    let (left, right, straight) = (Path::euler(4, 90)?, Path::euler(4, -90)?, Path::straight(10)?);
    let s_bend = [&straight, &left, &straight, &right, &straight];
    let mut path = Path::of(s_bend);
    path.append([[&left, &right], [&left, &right], [&left, &right]]);
    Ok(path)
}

/// Sharp corners: from points, or piece by piece with turns. An appended piece is rotated into the direction of the path,
/// and so are points; a path that starts with points keeps them.
fn sharp_corners() -> Result<[Path; 3]> {
    let points = [(20, 10), (30, 10), (40, 30), (50, 30), (50, 20), (70, 20)];
    let mut walk = Path::line(10)?;
    walk.turn(90).append(Path::line(10)?).turn(-135).append(Path::line(15)?);
    walk.set_end_angle(0).append(Path::line(10)?);
    Ok([Path::from_points(points)?, Path::of(points), walk])
}

/// Round corners through the same points, as Euler bends or as arcs.
fn round_corners() -> Result<[Path; 2]> {
    let points = [(20, 10), (40, 10), (20, 40), (50, 40), (50, 20), (70, 20)];
    Ok([Path::smooth(points, 2, EulerBend::new())?, Path::smooth(points, 2, ArcBend::new())?])
}

/// Custom points between pieces: a limaçon that ends in a loop.
fn custom_curve() -> Result<Path> {
    let limacon = |i: u32| {
        let t = -PI + PI * f64::from(i) / 999.0;
        Point::new(t.cos(), t.sin()) * (20.0 + 25.0 * t.sin())
    };
    let curve: Vec<Point> = (0..1000).map(limacon).collect();
    let mut path = Path::arc(10, 90)?;
    path.append(Path::straight(5)?).append(Path::arc(5, -90)?).append(curve).rotate(-45);
    Ok(path)
}

/// Fewer points: by a tolerance for the edges, or by one for the path.
fn fewer_points(path: &Path) -> Result<[Device; 4]> {
    let x = CrossSection::new().add(Section::new(0.5).offset(2)).add(Section::new(1.5).layer(2).ports("in", "out"));
    let coarse = |tolerance: f64| Extrusion::new(path, &x).simplify(tolerance).build();
    Ok([path.extrude(&x)?, coarse(1e-3)?, coarse(0.1)?, path.with_tolerance(1e-3)?.extrude(&x)?])
}

/// Vias in rows on a path and beside it, each rotated into the direction of the path.
fn vias() -> Result<Device> {
    let mut via = Device::builder("via");
    via.add_polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)], 4)?;
    let via = via.build()?;
    let path = Path::from_points([(20, 10), (30, 10), (40, 30), (50, 30), (50, 20), (55, 20)])?;
    let mut d = Device::builder("vias");
    d.add(path.extrude_width(0.3, 1)?);
    for (offset, row) in [(0.0, 0..15), (0.9, 1..14)] {
        for point in path.interpolate(row.map(|i| 4 * i), offset)? {
            d.add(point.place(&via));
        }
    }
    d.build()
}

/// The curvature along a path, drawn as the width of a strip: a clothoid's rises and falls linearly, an arc's jumps.
fn curvature() -> Result<[Device; 2]> {
    let drawn = |bend: Path| -> Result<Device> {
        let mut path = Path::straight(5)?;
        path.append(bend).append(Path::straight(5)?);
        let (_, curvature) = path.curvature()?;
        // One for every point: the curvature is that of the segment before it.
        let widths: Vec<f64> = std::iter::once(0.0).chain(curvature.iter().map(|k| 3.5 * k.abs())).collect();
        path.extrude(&CrossSection::of_width(0.1, 1).add(Section::new(widths)))
    };
    Ok([drawn(EulerBend::new().p(0.5).use_eff().path(3, 90)?)?, drawn(Path::arc(3, 90)?)?])
}

/// Two cross-sections and a taper from one to the other, connected. A copy of a cross-section is independent.
fn transitions() -> Result<Device> {
    let narrow = CrossSection::new()
        .add(Section::new(1.2).layer(2).named("wg").ports("in1", "out1"))
        .add(Section::new(2.2).layer(3).named("etch"))
        .add(Section::new(1.1).offset(3).layer(1).named("wg2"));
    let mut wide = narrow.clone();
    wide["wg"] = Section::new(1).layer(2).named("wg").ports("in2", "out2");
    wide["etch"].width = 3.5.into();
    (wide["wg2"].width, wide["wg2"].offset) = (3.into(), 5.into());
    let taper = transition(&narrow, &wide, TransitionShape::Sine)?;

    let mut d = Device::builder("transitions");
    let first = d.add(Path::straight(10)?.extrude(&narrow)?);
    let between = d.add(EulerBend::new().p(0.5).path(25, 45)?.extrude(&taper)?);
    let last = d.add(Path::straight(10)?.extrude(&wide)?);
    let out = d[first].port("out1")?;
    d[between].connect("in2", &out)?;
    let out = d[between].port("out1")?;
    d[last].connect("in2", &out)?;
    d.build()
}

/// Widths and offsets that are functions of the fraction of the length.
fn functions() -> Result<[Device; 2]> {
    let wavy = CrossSection::new()
        .add(Section::new(3).offset(-6))
        .add(Section::new(|t: f64| 3.0 + (10.0 * PI * t).cos()))
        .add(Section::new(1).offset(|t: f64| 6.0 + (6.0 * PI * t).cos()).layer(1));
    let bent = Path::straight(40)?.offset(|t: f64| 2.0 + (4.0 * PI * t).cos())?;
    Ok([Path::straight(40)?.extrude(&wavy)?, bent.extrude_width(1, 2)?])
}

/// An offset path and its mirror image. Where the path bends more tightly than the offset, the offset path runs backwards.
fn beside(path: &Path) -> Result<Device> {
    let mut beside = path.offset(6)?;
    beside.movey(-2);
    let image = beside.clone().mirrored((0, 0), (1, 0));
    let mut d = Device::builder("beside");
    for (path, layer) in [(path, 1), (&beside, 2), (&image, 3)] {
        let strip = CrossSection::of_width(1, layer);
        d.add(Extrusion::new(path, &strip).overlaps(Overlaps::Keep).build()?);
    }
    d.build()
}

/// The wider strip of a drawing with a square at each of its points.
fn with_points(device: &Device) -> Result<Device> {
    let mut d = Device::builder("with_points");
    let half = Point::new(0.08, 0.08);
    for strip in device.polygons().skip(1) {
        d.add_polygon(strip.points, 1)?;
        for corner in strip.points {
            d.add_polygon(Rect::new(*corner - half, *corner + half), 0)?;
        }
    }
    d.build()
}

/// A drawing and its name.
type Named = (&'static str, Device);

/// The chapters: name and drawings of each.
pub(crate) fn chapters() -> Result<Vec<(&'static str, Vec<Named>)>> {
    let path = pieces()?;
    let strip = |path: &Path| path.extrude_width(1, 1);
    let reduced = fewer_points(&EulerBend::new().num_pts(240).path(5, 90)?)?
        .iter()
        .map(with_points)
        .collect::<Result<Vec<_>>>()?;
    Ok(vec![
        ("pieces", vec![("", strip(&path)?)]),
        ("extrusions", named(["one width", "a width that grows", "a cross-section"], extrusions(&path)?)),
        ("repetition", vec![("", strip(&repetition()?)?)]),
        ("sharp_corners", strips(["where they are", "appended", "walked"], sharp_corners()?)?),
        ("round_corners", strips(["Euler bends", "arcs"], round_corners()?)?),
        ("custom_curve", vec![("", strip(&custom_curve()?)?)]),
        ("fewer_points", named(["all", "1 nm at the edges", "0.1 µm", "1 nm on the path"], reduced)),
        ("vias", vec![("", vias()?)]),
        ("curvature", named(["Euler bend", "arc"], curvature()?)),
        ("transitions", vec![("", transitions()?)]),
        ("functions", named(["of sections", "of the path"], functions()?)),
        ("beside", vec![("", beside(&path)?)]),
    ])
}

fn named<const N: usize>(names: [&'static str; N], devices: impl IntoIterator<Item = Device>) -> Vec<Named> {
    names.into_iter().zip(devices).collect()
}

/// Paths, each as a strip.
fn strips<const N: usize>(names: [&'static str; N], paths: [Path; N]) -> Result<Vec<Named>> {
    let strips = paths.iter().map(|path| path.extrude_width(1, 1));
    Ok(named(names, strips.collect::<Result<Vec<_>>>()?))
}

/// Prints the size of each drawing.
#[expect(clippy::print_stdout, reason = "an example shows what it did")]
pub(crate) fn main() -> Result<()> {
    let path = pieces()?;
    println!("the path has {} points and is {:.3} µm long", path.points().len(), path.length());
    println!("the limaçon ends at {:.3}°", custom_curve()?.end_angle());
    for (chapter, drawings) in chapters()? {
        for (name, device) in drawings {
            let points: usize = device.flat_polygons().map(|polygon| polygon.points().len()).sum();
            let size = device.size();
            println!("{chapter:<14} {name:<20} {points:5} points, {:.3} × {:.3} µm", size.width, size.height);
        }
    }
    Ok(())
}
