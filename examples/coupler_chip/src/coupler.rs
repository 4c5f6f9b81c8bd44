//! The device of this project's own.

use phidl::path::EulerBend;
use phidl::prelude::*;

use crate::layers::CORE;

/// Two waveguides that run beside each other for a while.
///
/// ```text
///   a1 ──╮              ╭── b1
///         ╰────────────╯          gap
///         ╭────────────╮
///   a2 ──╯    length    ╰── b2
/// ```
///
/// # Ports
/// `a1`, `a2` on the left and `b1`, `b2` on the right, `pitch` apart.
///
/// # Info
/// `arm_length`: from port to port, along a waveguide (µm).
#[device]
pub fn coupler(
    /// Between the waveguides, edge to edge.
    #[default(0.2)]
    #[param(unit = "um", above = 0.0)]
    gap: f64,
    /// How long they run beside each other.
    #[default(12.0)]
    #[param(unit = "um", min = 0.0)]
    length: f64,
    /// Waveguide width.
    #[default(0.5)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Between the ports of a side.
    #[default(25.0)]
    #[param(unit = "um", above = 0.0)]
    pitch: f64,
    /// Radius of the bends.
    #[default(15.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(CORE)]
    layer: Layers,
) -> Result<Device> {
    // The arms rise at 30°; a bend by 30° takes radius · tan 15° of the legs beside it.
    let (near, far) = ((gap + width) / 2.0, pitch / 2.0);
    let rise = (far - near) / 30_f64.to_radians().tan();
    let reach = radius * 15_f64.to_radians().tan();
    let (x1, x2) = (length / 2.0 + reach, length / 2.0 + reach + rise);
    let end = x2 + 2.0 * reach;
    let waypoints = [(-end, far), (-x2, far), (-x1, near), (x1, near), (x2, far), (end, far)];
    let arm = Path::smooth(waypoints, radius, EulerBend::new().use_eff())?.with_tolerance(0.001)?;
    let guide = CrossSection::new().add(Section::new(width).layer(layer).ports("1", "2"));
    let wire = arm.extrude(&guide)?;

    let mut d = Device::builder("coupler");
    let upper = d.add(&wire);
    let lower = d.add(wire.place().mirrored((0, 0), (1, 0)));
    for (name, arm, end) in [("a1", upper, "1"), ("b1", upper, "2"), ("a2", lower, "1"), ("b2", lower, "2")] {
        d.add_port(name, d[arm].port(end)?)?;
    }
    d.info("arm_length", arm.length());
    d.build()
}
