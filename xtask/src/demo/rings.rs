//! All-pass rings beside a bus, and a sweep of them.

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_macros::device;

use super::layers::{NAME, WAVEGUIDE};

/// An all-pass ring beside a straight bus, with a taper at either end of the bus for the light to come in.
///
/// ```text
///            ╭───╮
///            ╰───╯  gap
///   in ◁──────────────▷ out
/// ```
///
/// # Ports
/// `in` on the left and `out` on the right, `facet_width` wide.
///
/// # Info
/// `circumference`: length of the ring's middle line (µm).
#[device]
pub(crate) fn ring_filter(
    /// Radius of the ring's middle line.
    #[default(20.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Distance from the ring to the bus, edge to edge.
    #[default(0.2)]
    #[param(unit = "um", min = 0.0)]
    gap: f64,
    /// Waveguide width.
    #[default(0.5)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Length of the straight bus.
    #[default(120.0)]
    #[param(unit = "um", above = 0.0)]
    bus_length: f64,
    /// Length of either taper.
    #[default(60.0)]
    #[param(unit = "um", above = 0.0)]
    taper_length: f64,
    /// Width of the tapers at their outer ends.
    #[default(3.0)]
    #[param(unit = "um", above = 0.0)]
    facet_width: f64,
    /// Where it is drawn.
    #[default(WAVEGUIDE)]
    layer: Layers,
) -> Result<Device> {
    let mut ring = pg::RingParams { radius, width, layer: layer.clone(), ..Default::default() }.build()?.place();
    let bus = pg::straight((width, bus_length), &layer)?.place().rotated(90).centered((0, 0));
    ring.set_ymin(bus.ymax() + gap).set_x(bus.x());
    let taper = pg::taper(taper_length, facet_width, width, &layer)?;

    let mut d = Device::builder("ring_filter");
    d.add_as("ring", ring);
    let bus = d.add_as("bus", bus);
    for (name, end) in [("in", "1"), ("out", "2")] {
        let mut facet = taper.place();
        facet.connect("2", &d[bus].port(end)?)?;
        d.add_port(name, facet.port("1")?)?;
        d.add(facet);
    }
    d.info("circumference", TAU * radius);
    d.build()
}

/// Rings of growing radius (to the right) and gap (upwards), each with its name.
///
/// # Info
/// `rings`: how many there are.
#[device]
pub(crate) fn ring_sweep(
    /// Radii.
    #[param(unit = "um", above = 0.0)]
    radii: Vec<f64>,
    /// Gaps.
    #[param(unit = "um", min = 0.0)]
    gaps: Vec<f64>,
    /// From one ring to the next, to the right and upwards.
    #[default((300, 150))]
    #[param(unit = "um", above = 0.0)]
    pitch: Size,
) -> Result<Device> {
    let mut d = Device::builder("ring_sweep");
    for (column, radius) in radii.iter().enumerate() {
        for (row, gap) in gaps.iter().enumerate() {
            let corner = Point::new(pitch.width * column as f64, pitch.height * row as f64);
            let mut filter = ring_filter(*radius, *gap, 1, 400, 100, 8, WAVEGUIDE)?.place();
            filter.set_xmin(corner.x).set_ymin(corner.y);
            d.add_label(format!("R{radius} G{gap}"), (filter.x(), filter.ymin() - 18.0), NAME)?;
            d.add(filter);
        }
    }
    d.info("rings", radii.len() * gaps.len());
    d.build()
}
