//! The mental model in one screen: the reference text of the project's design, with the crates' own names.

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_macros::device;

/// An all-pass ring beside a straight bus.
#[device]
#[rustfmt::skip]
pub(crate) fn ring_filter(
    /// Radius of the ring's centerline (µm).
    #[default(10.0)] radius: f64,
    /// Waveguide width (µm).
    #[default(0.5)] width: f64,
    /// Coupling gap, edge to edge (µm).
    #[default(0.2)] gap: f64,
    /// Where it is drawn.
    #[default(1)] layer: Layers,
) -> Result<Device> {
    let mut ring = pg::RingParams { radius, width, layer: layer.clone(), ..Default::default() }.build()?.place();
    let bus = pg::straight((width, 3.0 * radius), layer)?.place().rotated(90.0);
    ring.set_ymin(bus.ymax() + gap);          // the building-block way: relations, not arithmetic
    ring.set_x(bus.x());

    let mut d = Device::builder("ring_filter");
    d.add(ring);
    let bus = d.add_as("bus", bus);           // a key; d["bus"] is the alias
    d.add_port("in", d[bus].port("1")?)?;
    d.add_port("out", d[bus].port("2")?)?;
    d.info("circumference", 2.0 * PI * radius);
    d.build()
}

#[test]
#[rustfmt::skip]
fn calls_by_position_and_by_name_give_the_same_cell() -> Result<()> {
    let a = ring_filter(12.0, 0.5, 0.2, 1)?;                                           // an ordinary function call, cached
    let b = RingFilterParams { radius: 12.0, ..Default::default() }.build()?;          // the same cell, by name and default
    assert!(a.same_cell(&b));
    let mut input = pg::taper(20, 3, 0.5, 1)?.place();                                 // integers are numbers too
    input.connect("2", &a.port("in")?)?;                                               // snap together like building blocks
    assert_eq!(input.port("2")?.midpoint(), a.port("in")?.midpoint());
    Ok(())
}
