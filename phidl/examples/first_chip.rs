//! The first chip: a generator of one's own, three variants of it with names, a die, and the files.
//!
//! `cargo run -p phidl --example first_chip`
#![expect(clippy::print_stdout, reason = "an example shows what it draws")]

use phidl::io::{gds, svg};
use phidl::prelude::*;
use phidl::shapes as pg;

const GUIDE: Layer = Layer::new(1, 0);
const LETTERS: Layer = Layer::new(2, 0);
const DIE: Layer = Layer::new(99, 0);

/// An all-pass ring beside a straight bus.
///
/// # Ports
/// `in` and `out`, the ends of the bus.
#[device]
pub fn ring_filter(
    /// Radius of the ring's centerline.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Coupling gap, edge to edge.
    #[default(0.2)]
    #[param(unit = "um", min = 0.0)]
    gap: f64,
) -> Result<Device> {
    let mut d = Device::builder("ring_filter");
    let ring = d.add(pg::RingParams::default().radius(radius).width(0.5).layer(GUIDE).build()?);
    let bus = d.add(pg::StraightParams::default().size((0.5, 4.0 * radius)).layer(GUIDE).build()?);
    d[bus].rotate(90).set_center((0, 0));
    let top = d[bus].ymax();
    d[ring].set_x(0).set_ymin(top + gap);
    d.add_port("in", d[bus].port("1")?)?;
    d.add_port("out", d[bus].port("2")?)?;
    d.build()
}

/// The chip: one ring for each gap, with the gap written beside it.
fn chip(gaps: &[f64]) -> Result<Device> {
    let mut d = Device::builder("first_chip");
    for (row, gap) in gaps.iter().enumerate() {
        let y = 40.0 * row as f64;
        let filter = d.add(ring_filter(10, *gap)?.place().moved_by((0, y)));
        let name = pg::TextParams::default().text(format!("{:.0} nm", 1000.0 * gap)).size(5).layer(LETTERS).build()?;
        let name = d.add(name);
        let right = d[filter].xmax() + 5.0;
        d[name].set_xmin(right).set_y(y);
    }
    d.set_center(.., (0, 0));
    let die = pg::BasicDieParams::default().size((200, 200)).street_width(10).street_length(40);
    d.add(die.die_name("first chip").text_size(8).layer(DIE).build()?);
    d.build()
}

pub(crate) fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let chip = chip(&[0.15, 0.2, 0.25])?;
    println!("{chip}");
    let folder = std::env::temp_dir();
    for file in ["first_chip.gds", "first_chip.svg"].map(|name| folder.join(name)) {
        match file.extension().is_some_and(|extension| extension == "gds") {
            true => drop(gds::write(&chip, &file, &gds::GdsOptions::default())?),
            false => drop(svg::write(&chip, &file, &svg::SvgOptions::default())?),
        }
        println!("{}", file.display());
    }
    Ok(())
}
