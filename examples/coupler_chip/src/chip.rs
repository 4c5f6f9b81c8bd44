//! The chip: couplers one above the other, wired to both edges.

use phidl::prelude::*;
use phidl::route::RouteBasicParams;
use phidl::shapes as pg;

use crate::coupler::coupler;
use crate::layers::{CORE, DIE, DUMMY, NAME, TRENCH};

/// A chip with a coupler for every gap, wires from its four ports to the edges, trenches, names and dummy squares.
///
/// # Ports
/// `a1.1`, `a2.1`, `b1.1`, `b2.1`, `a1.2`, …: the facets, by port and number of the coupler.
#[device]
pub fn coupler_chip(
    /// The gaps, from bottom to top.
    #[param(unit = "um", above = 0.0)]
    gaps: Vec<f64>,
    /// How long the waveguides of a coupler run beside each other.
    #[default(12.0)]
    #[param(unit = "um", min = 0.0)]
    length: f64,
    /// Width and height of the die.
    #[default((1200, 800))]
    #[param(unit = "um", above = 0.0)]
    size: Size,
    /// Between facets of fibers on an edge.
    #[default(60.0)]
    #[param(unit = "um", above = 0.0)]
    fiber_pitch: f64,
    /// What is written on the chip.
    #[default("coupler chip")]
    name: String,
) -> Result<Device> {
    let guides = waveguides(&gaps, length, size.width, fiber_pitch)?;
    // On the grid of the file, where trenches and waveguides then have the same edges; open at the facets by more than
    // the trenches are wide.
    let trench = pg::OutlineParams::new(&guides).distance(3).open_ports(4).precision(0.001).layer(TRENCH).build()?;
    let die = pg::BasicDieParams::default().size(size).street_length(100).street_width(20).die_name("").layer(DIE);
    let letters = pg::TextParams::default().text(name).size(30).layer(NAME).build()?;

    let mut d = Device::builder("coupler_chip");
    let die = d.add(die.draw_bbox(false).build()?);
    d.add(&guides);
    d.add(&trench);
    let letters = d.add(letters);
    let corner = Point::new(d[die].xmin() + 40.0, d[die].ymax() - 40.0);
    d[letters].set_xmin(corner.x).set_ymax(corner.y);

    let fill = pg::FillRectangleParams::new(d.clone().build()?).fill_size((20, 20)).margin(10);
    d.add(fill.fill_layers(DUMMY).fill_densities(0.25).build()?);
    d.add_ports(guides.ports().cloned())?;
    d.build()
}

/// All that guides light: couplers around the origin, and wires to the edges at `-width / 2` and `width / 2`.
fn waveguides(gaps: &[f64], length: f64, width: f64, fiber_pitch: f64) -> Result<Device> {
    let mut d = Device::builder("waveguides");
    let fibers = 2.0 * fiber_pitch;
    for (row, gap) in gaps.iter().enumerate() {
        let y = fibers * (row as f64 - (gaps.len() - 1) as f64 / 2.0);
        let coupler = d.add(coupler(*gap, length, 0.5, 25, 15, CORE)?.place().moved_by((0, y)));
        for (name, x, y) in [
            ("a1", -width / 2.0, y + fiber_pitch / 2.0),
            ("a2", -width / 2.0, y - fiber_pitch / 2.0),
            ("b1", width / 2.0, y + fiber_pitch / 2.0),
            ("b2", width / 2.0, y - fiber_pitch / 2.0),
        ] {
            let port = d[coupler].port(name)?;
            let facet = port.flipped().moved_to(port.midpoint(), (x, y));
            let wire = d.add(RouteBasicParams::new(port, facet).layer(CORE).build()?);
            d.add_port(format!("{name}.{}", row + 1), d[wire].port("2")?)?;
        }
    }
    d.build()
}
