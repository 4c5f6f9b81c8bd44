//! The top cell.

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_macros::device;

use super::layers::{NAME, PAD};
use super::marks::{alignment_mark, die_frame, dose_test};
use super::nanowires::nanowire_row;
use super::rings::ring_sweep;

/// A 10 mm × 10 mm chip: 240 ring filters, nanowires between pads, a dose test, marks and an edge.
#[device]
pub(crate) fn demo_chip(
    /// Side of the die.
    #[default(10_000.0)]
    #[param(unit = "um", min = 10_000.0)]
    side: f64,
) -> Result<Device> {
    let mut d = Device::builder("demo_chip");
    let frame = d.add_as("frame", die_frame(side, 50)?);

    let radii: Vec<f64> = linspace(20.0, 130.0, 12).collect();
    let gaps: Vec<f64> = (0..20).map(|i| f64::from(10 + i) / 100.0).collect();
    let rings = d.add_as("rings", ring_sweep(radii, gaps, (750, 315))?);
    let wires = d.add_as("nanowires", nanowire_row([0.06, 0.08, 0.1, 0.12, 0.15, 0.2, 0.3, 0.5])?);
    let dose = d.add_as("dose", dose_test([1, 2, 4, 8], 40)?);
    let pads = d.add_as("pads", pg::compass((150, 150), PAD)?.array(40, 2, (225, 225)));

    // Relations instead of arithmetic: everything stands on what lies below it.
    d[pads].set_x(0).set_ymin(-4800);
    let below = d[pads].ymax();
    d[wires].set_x(0).set_ymin(below + 200.0);
    let below = d[wires].ymax();
    d[rings].set_x(0).set_ymin(below + 200.0);
    let below = d[rings].ymax();
    d[dose].set_x(0).set_ymin(below + 200.0);

    let inside = d[frame].bbox().map_or(0.0, |b| b.max.x) - 400.0;
    for quarter in 0..4 {
        d.add(alignment_mark(200)?.place().moved_by((inside, inside)).rotated(90 * quarter));
    }
    d.add(Label::new("phidl demo", (0.0, inside), NAME));
    d.build()
}
