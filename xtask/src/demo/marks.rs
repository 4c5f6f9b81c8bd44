//! Alignment marks, the dose test and the edge of the die.

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_macros::device;

use super::layers::{DOSE, FRAME, MARK};

/// A cross in a ring, for the aligner to find.
#[device]
pub(crate) fn alignment_mark(
    /// Outer diameter of the ring.
    #[default(200.0)]
    #[param(unit = "um", above = 0.0)]
    diameter: f64,
) -> Result<Device> {
    let width = diameter / 20.0;
    let mut d = Device::builder("alignment_mark");
    d.add(pg::ring((diameter - width) / 2.0, width, 2.5, MARK)?);
    d.add(pg::cross(0.7 * diameter, width, MARK)?);
    d.build()
}

/// Fields of dots, each field of one size: which size comes out tells the dose.
#[device]
pub(crate) fn dose_test(
    /// Diameters of the dots.
    #[param(unit = "um", above = 0.0)]
    diameters: Vec<f64>,
    /// Dots along either side of a field.
    #[default(40)]
    #[param(min = 1)]
    dots: u32,
) -> Result<Device> {
    let mut d = Device::builder("dose_test");
    let mut fields = Vec::new();
    for diameter in diameters {
        let dot = pg::circle(diameter / 2.0, 10, DOSE)?;
        fields.push(d.add(dot.array(dots, dots, (3.0 * diameter, 3.0 * diameter))));
    }
    d.group(fields).distribute(Direction::X, 50).align(Edge::YMin);
    d.build()
}

/// The edge of a square die: a frame around the origin.
#[device]
pub(crate) fn die_frame(
    /// Outer side.
    #[default(10_000.0)]
    #[param(unit = "um", above = 0.0)]
    side: f64,
    /// Width of the frame.
    #[default(50.0)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
) -> Result<Device> {
    let bar = pg::rectangle((side - width, width), FRAME)?;
    let mut d = Device::builder("die_frame");
    for quarter in 0..4 {
        let edge = bar.place().moved_by((-side / 2.0, -side / 2.0));
        d.add(edge.rotated(90 * quarter));
    }
    d.build()
}
