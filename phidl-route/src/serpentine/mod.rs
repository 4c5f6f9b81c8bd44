//! Routes of a given length: [`route_serpentine`] and [`delay_line`].
//!
//! What a route lacks in length is made up on one of its straight pieces (`line`), in bumps to one side (`bumps`). The
//! alternative, changing the radius, would change what the bends do to the light.

mod bumps;
mod line;

use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use crate::RouteBend;
use crate::port_pair::{PortPair, check_positive};
use line::Serpentine;

/// Draws a wire of a given length between two ports at right angles, in bumps on a straight piece.
///
/// ```text
///             ╭─╮ ╭─╮ ╭─╮
///   port1 ├───╯ ╰─╯ ╰─╯ ╰───┤ port2
/// ```
///
/// Otherwise it is [`route_manhattan`](fn@crate::route_manhattan). The bumps are on the longest straight piece, on the left
/// of the way; where the wire would run over itself there, they are on the right, or on another footprint.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as `port1`.
///
/// # Info
/// `length`: that of the drawn centerline, within 0.1 nm of what was asked for; and what a manhattan route records.
///
/// # Errors
/// As for [`route_manhattan`](fn@crate::route_manhattan); and if the length is less than that of the plain route, if no
/// straight piece has room for a bump, if the bumps would be higher than `max_height`: each with what is missing. Bumps
/// that would run over the route wherever they have room are refused too.
///
/// # Numerics
/// The length is the sum over the chords of the centerline, before a file rounds the points to its grid. That moves no
/// edge by more than half a step.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, route_serpentine};
/// let wire = route_serpentine(((0, 0), 1, 0), ((300, 80), 1, 180), 1000, RouteBend::Euler, 10, 1)?;
/// assert!((wire.info()["length"].as_f64().unwrap() - 1000.0).abs() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design.
#[device(picture = "docs/route_serpentine.svg", example = RouteSerpentineParams::new(((0, 0), 2, 0), ((300, 80), 2, 180), 1000))]
pub fn route_serpentine(
    /// Where it starts; its width is that of the route.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Length of the centerline from port to port.
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Smallest radius of the bends, on the centerline.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// How far the bumps may extent to the side.
    #[default(None)]
    #[param(unit = "um", named, above = 0.0)]
    max_height: Option<f64>,
) -> Result<Device> {
    let pair = PortPair::new("route_serpentine", &port1, &port2)?;
    Serpentine { pair: &pair, length, bend, radius, max_height }.drawn(&layer)?.build()
}

/// Draws a wire of a given length on a given span: a delay line.
///
/// ```text
///        ╭─╮ ╭─╮ ╭─╮
///   1 ├──╯ ╰─╯ ╰─╯ ╰──┤ 2      from (0, 0) to (span, 0)
/// ```
///
/// # Ports
/// `1` at the origin, facing 180°, and `2` at the end of the span, facing 0°.
///
/// # Info
/// As for [`route_serpentine`](fn@route_serpentine).
///
/// # Errors
/// As for [`route_serpentine`](fn@route_serpentine): the length must be at least the span, and the span have room.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, delay_line};
/// let line = delay_line(2000, 200, 0.5, RouteBend::Circular, 5, 1)?;
/// assert!((line.info()["length"].as_f64().unwrap() - 2000.0).abs() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design.
#[device(picture = "docs/delay_line.svg")]
pub fn delay_line(
    /// Length of the centerline.
    #[default(1000.0)]
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// Distance of its ends.
    #[default(200.0)]
    #[param(unit = "um", above = 0.0)]
    span: f64,
    /// Width of the wire.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Smallest radius of the bends, on the centerline.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (port1, port2) = (Port::new((0, 0), width, 0), Port::new((span, 0), width, 180));
    let pair = PortPair::new("delay_line", &port1, &port2)?;
    Serpentine { pair: &pair, length, bend, radius, max_height: None }.drawn(&layer)?.build()
}

/// The waypoints of [`route_serpentine`](fn@route_serpentine) with bends at their corners, for an extrusion by hand.
///
/// # Errors
/// As for [`route_serpentine`](fn@route_serpentine), but that nothing is said of a width.
pub fn serpentine_centerline(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    length: impl Into<f64>,
    bend: RouteBend,
    radius: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2, length, radius) = (port1.into(), port2.into(), length.into(), radius.into());
    check_positive("serpentine_centerline", "length", length)?;
    let pair = PortPair::new("serpentine_centerline", &port1, &port2)?;
    let routed = Serpentine { pair: &pair, length, bend, radius, max_height: None }.route()?;
    Path::smooth(routed.points, radius, bend)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_length_from_the_shortest_on_is_met() {
        for length in [100.0, 100.01, 101.0, 122.0, 123.0, 150.0, 400.0, 5000.0] {
            let path = serpentine_centerline(
                ((3, 4), 1, 30),
                (Point::new(3.0, 4.0) + Point::polar(100.0, 30.0), 1, 210),
                length,
                RouteBend::Circular,
                5,
            )
            .unwrap();
            assert!((path.length() - length).abs() <= 1e-4, "{length}: {}", path.length());
        }
    }

    #[test]
    fn what_cannot_be_is_refused_with_what_is_missing() {
        let error = delay_line(90, 100, 1, RouteBend::Circular, 5, 0).unwrap_err().to_string();
        assert!(error.contains("a length of 90 µm") && error.contains("10 µm are missing"), "{error}");
        let error = delay_line(200, 30, 1, RouteBend::Circular, 10, 0).unwrap_err().to_string();
        assert!(error.contains("a straight piece of 30 µm, but it must have at least 40 µm: 10 µm"), "{error}");
        let flat = RouteSerpentineParams::new(((0, 0), 1, 0), ((100, 0), 1, 180), 1000).max_height(50);
        assert!(flat.build().unwrap_err().to_string().contains("a max_height of 50 µm"));
    }

    #[test]
    fn bumps_turn_to_the_side_that_is_free() {
        // A C to the left: its long leg runs back above the ports, so that bumps on its left would cross the way.
        let (a, b) = (Port::new((0, 0), 1, 0), Port::new((-200, 5), 1, 180));
        let device = RouteSerpentineParams::new(&a, &b, 900).radius(5).build().unwrap();
        assert!((device.info()["length"].as_f64().unwrap() - 900.0).abs() < 1e-4);
    }
}
