//! A first chip: polygons, library shapes, ports, references, a file.
//!
//! `cargo run -p phidl-geometry --example quick_start`
#![expect(clippy::print_stdout, reason = "an example shows what it draws")]

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_io::gds::{self, GdsOptions};

pub(crate) fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    // An open cell, a polygon from x and y coordinates, and one from points.
    let mut d = Device::builder("quick_start");
    let poly1 = d.add_polygon(([8, 6, 7, 9], [6, 8, 9, 5]), 0)?;
    d.add_polygon([(0, 0), (1, 1), (1, 3), (-3, 3)], 1)?;

    // Shapes of the library, and one that is moved once it is there.
    let straight = pg::straight((10, 1.5), 2)?;
    let wg1 = d.add(&straight);
    let wg2 = d.add(&straight);
    let wg3 = d.add(pg::taper(10, 1.5, 3, 3)?);
    d.add(pg::circle(6, 2.5, 4)?.place().moved_by((20, 0)));

    // Placement methods chain.
    d[wg1].rotate(45).movex(1);
    d[wg2].move_by((1, 5)).rotate(-90);
    d.select(poly1).set_ymax(0);

    // Ports connect cells.
    let target = d[wg1].port("1")?;
    d[wg2].connect("2", &target)?;
    let target = d[wg2].port("1")?;
    d[wg3].connect("2", &target)?;

    // The ports that the next cell up shall see.
    d.add_port("in", d[wg1].port("2")?)?;
    d.add_port("out", d[wg3].port("1")?)?;
    let d = d.build()?;
    println!("{d}");

    // Cells in cells.
    let mut top = Device::builder("top");
    let a = top.add(&d);
    let b = top.add(d.place().mirrored((0, 0), (0, 1)));
    top.group([a, b]).distribute(Direction::X, 10).align(Edge::YMin);
    top.add_label("quick start", (0, 0), 10)?;
    let top = top.build()?;
    println!("{top}\n{} µm wide, {} polygons", top.xsize(), top.flat_polygons().count());
    let file = std::env::temp_dir().join("quick_start.gds");
    gds::write(&top, &file, &GdsOptions::default())?;
    println!("{}", file.display());
    Ok(())
}
