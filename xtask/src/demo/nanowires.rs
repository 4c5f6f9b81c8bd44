//! Superconducting nanowires between two pads, and a row of them.

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_geometry::connect::{PoleShape, PoleTaper};
use phidl_macros::device;

use super::layers::{NAME, NANOWIRE, PAD};

/// A nanowire that goes up and down, put together from straight wires and half turns by their ports.
///
/// ```text
///   ╭╮╭╮╭╮
///   ││││││
///   │╰╯╰╯│
///   1    2
/// ```
///
/// # Ports
/// `1` at the start and `2` at the end, both below.
///
/// # Info
/// `squares`: length of the wire over its width.
#[device]
pub(crate) fn nanowire(
    /// Width of the wire.
    #[default(0.1)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// From the middle of one straight wire to the next.
    #[default(0.4)]
    #[param(unit = "um", above = 0.0)]
    pitch: f64,
    /// Length of the straight wires.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// How often it goes up and down.
    #[default(10)]
    #[param(min = 1)]
    periods: u32,
) -> Result<Device> {
    let wire = pg::straight((width, length), NANOWIRE)?;
    let right = pg::arc(pitch / 2.0, width, -180, 0, 5, NANOWIRE)?;
    let left = pg::arc(pitch / 2.0, width, 180, 0, 5, NANOWIRE)?;
    let mut d = Device::builder("nanowire");
    let first = d.add(&wire);
    d.add_port("1", d[first].port("2")?)?;
    let mut end = d[first].port("1")?;
    for turn in 1..2 * periods {
        let mut bend = if turn % 2 == 1 { right.place() } else { left.place() };
        bend.connect("1", &end)?;
        let mut next = wire.place();
        next.connect("2", &bend.port("2")?)?;
        end = next.port("1")?;
        d.add(bend);
        d.add(next);
    }
    d.add_port("2", end)?;
    let bends = f64::from(2 * periods - 1);
    d.info("squares", (f64::from(2 * periods) * length + bends * PI * pitch / 2.0) / width);
    d.build()
}

/// A nanowire between two gold pads.
///
/// # Info
/// `squares`: as of the nanowire.
#[device]
pub(crate) fn contacted_nanowire(
    /// Width of the wire.
    #[default(0.1)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Width and height of either pad.
    #[default((150, 200))]
    #[param(unit = "um", above = 0.0)]
    pad: Size,
) -> Result<Device> {
    let wire = nanowire(width, 4.0 * width, 10, 10)?;
    // The pads overlap the wire's ends by some µm, so that the contact survives a shift of the layer.
    let overlap = 3.0;
    let stub = (8.0 * width, 12.0);
    let mut d = Device::builder("contacted_nanowire");
    let wire = d.add_as("wire", &wire);
    for (shape, end) in [(PoleShape::D, "1"), (PoleShape::B, "2")] {
        let mut pole = pg::flagpole(pad, stub, shape, PoleTaper::Fillet, PAD)?.place();
        pole.connect_overlapping("1", &d[wire].port(end)?, overlap)?;
        d.add(pole);
    }
    let squares = d[wire].device().info()["squares"].clone();
    d.add_label(format!("w {width}"), (d.x(..), d.ymax(..) + 10.0), NAME)?;
    d.info("squares", squares);
    d.build()
}

/// Contacted nanowires of several widths, side by side.
#[device]
pub(crate) fn nanowire_row(
    /// Widths.
    #[param(unit = "um", above = 0.0)]
    widths: Vec<f64>,
) -> Result<Device> {
    let mut d = Device::builder("nanowire_row");
    let mut keys = Vec::new();
    for width in widths {
        keys.push(d.add(contacted_nanowire(width, (150, 200))?));
    }
    d.group(keys).distribute(Direction::X, 100).align(Edge::YMax);
    d.build()
}
