//! Routes of a given length: [`route_serpentine`] and [`delay_line`].
//!
//! The missing length is added on one straight piece (`line`) by bumps to one side (`bumps`). Changing the radius instead was
//! rejected: it would change the loss of the bends.

mod bumps;
mod line;

use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use crate::manhattan::{Allowed, ManhattanWire};
use crate::port_pair::{PortPair, check_positive};
use crate::{RouteBend, RouteWidth};
use line::Serpentine;

/// Draws a wire of a given length between two ports at right angles, in bumps on a straight piece.
///
/// ```text
///             ╭─╮ ╭─╮ ╭─╮
///   port1 ├───╯ ╰─╯ ╰─╯ ╰───┤ port2
/// ```
///
/// The rest is a [`route_manhattan`](fn@crate::route_manhattan). The bumps are on the longest straight piece, on the left;
/// where the wire would run over itself there, they are on the right, or on another piece.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as `port1`.
///
/// # Info
/// `length` of the drawn centerline, within 0.1 nm of the given length; and the info of a Manhattan route.
///
/// # Errors
/// As for [`route_manhattan`](fn@crate::route_manhattan); and if the length is less than that of the direct route, if no
/// straight piece has room for a bump, or if the bumps would be higher than `max_height`: each with the missing length.
/// Bumps that would run over the route on every piece with room are refused too.
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
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Length of the centerline from port to port.
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// The bends.
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
    /// Width: a number, a pair from start to end, or a cross-section; that of both ports if not given.
    #[default(None)]
    #[param(unit = "um", named)]
    width: Option<RouteWidth>,
    /// Whether the route may take more corners than the ports call for.
    #[default(false)]
    #[param(named)]
    allow_detour: bool,
    /// Whether the wire may run over itself and over what lies behind the ports.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    let pair = PortPair::new("route_serpentine", &port1, &port2)?;
    let wire = ManhattanWire { pair: &pair, bend, radius, width: width.as_ref(), layer: &layer };
    let allowed = Allowed { detour: allow_detour, crossings: allow_crossings };
    Serpentine { wire, length, max_height, allowed }.draw()?.build()
}

impl RouteSerpentineParams {
    /// The centerline of the route, with bends at the corners.
    ///
    /// # Errors
    /// As for [`route_serpentine`](fn@route_serpentine).
    pub fn centerline(&self) -> Result<Path> {
        check_positive("route_serpentine", "length", self.length)?;
        let pair = PortPair::new("route_serpentine", &self.port1, &self.port2)?;
        let (bend, radius, width) = (self.bend, self.radius, self.width.as_ref());
        let wire = ManhattanWire { pair: &pair, bend, radius, width, layer: &self.layer };
        let allowed = Allowed { detour: self.allow_detour, crossings: self.allow_crossings };
        let route = Serpentine { wire, length: self.length, max_height: self.max_height, allowed }.route()?;
        Path::smooth(route.points, radius, bend)
    }
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
    /// The bends.
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
    let wire = ManhattanWire { pair: &pair, bend, radius, width: None, layer: &layer };
    Serpentine { wire, length, max_height: None, allowed: Allowed::default() }.draw()?.build()
}

/// The waypoints of [`route_serpentine`](fn@route_serpentine) with bends at their corners, for an extrusion by hand.
///
/// # Errors
/// As for [`route_serpentine`](fn@route_serpentine). The width is that of the wider port.
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
    let (width, layer) = (RouteWidth::Constant(port1.width().max(port2.width())), Layers::default());
    let wire = ManhattanWire { pair: &pair, bend, radius, width: Some(&width), layer: &layer };
    let route = Serpentine { wire, length, max_height: None, allowed: Allowed::default() }.route()?;
    Path::smooth(route.points, radius, bend)
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
    fn lengths_without_room_are_refused_with_what_is_missing() {
        let error = delay_line(90, 100, 1, RouteBend::Circular, 5, 0).unwrap_err().to_string();
        assert!(error.contains("the length is 90 µm") && error.contains("10 µm are missing"), "{error}");
        let error = delay_line(200, 30, 1, RouteBend::Circular, 10, 0).unwrap_err().to_string();
        assert!(error.contains("straight piece is 30 µm, but must be at least 40 µm: 10 µm"), "{error}");
        let flat = RouteSerpentineParams::new(((0, 0), 1, 0), ((100, 0), 1, 180), 1000).max_height(50);
        assert!(flat.build().unwrap_err().to_string().contains("`max_height` is 50 µm"));
    }

    #[test]
    fn bumps_go_to_the_clear_side() {
        // A C to the left: its long leg runs back above the ports, so that bumps on its left would cross the route.
        let (a, b) = (Port::new((0, 0), 1, 0), Port::new((-200, 5), 1, 180));
        let device = RouteSerpentineParams::new(&a, &b, 900).radius(5).allow_detour(true).build().unwrap();
        assert!((device.info()["length"].as_f64().unwrap() - 900.0).abs() < 1e-4);
    }

    #[test]
    fn tiny_radii_end_with_a_bounded_number_of_bumps() {
        for (radius, width) in [(1e-3, 1.0), (1e-9, 1e-9), (1e-300, 1e-300)] {
            let line = delay_line(1000, 200, width, RouteBend::Circular, radius, 0);
            assert!(line.is_err(), "{radius}");
        }
        // As many bumps as have a million points together.
        let path = serpentine_centerline(((0, 0), 0.002, 0), ((90, 0), 0.002, 180), 100, RouteBend::Circular, 0.002);
        assert!(path.unwrap().points().len() <= 1 << 20);
    }
}
