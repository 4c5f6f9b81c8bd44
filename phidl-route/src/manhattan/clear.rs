//! [`Site`]: where a wire with a width is led between two ports.
//!
//! The reference chooses way points by the radius alone, and its wires run over themselves and over the ports where these
//! are close. Here the usual way points are kept wherever the drawn wire is clear of itself, and of a piece of wire behind
//! either port: what it comes from and leads to must be somewhere. Otherwise the shortest clear way is taken. Where there
//! is none, it is the usual way, and the route says how often it runs over what.

use phidl_core::Result;
use phidl_core::geom::Point;

use super::auto::{self, MARGIN};
use super::cover::{self, Piece, Wire};
use super::{RouteBend, detour};
use crate::request::Request;

/// A wire with bends, and the ports between which it is led.
pub(crate) struct Site<'a> {
    request: &'a Request<'a>,
    wire: Wire,
    /// How much room every corner gets (µm).
    reach: f64,
    /// What lies behind the ports, in the frame of the first.
    stubs: [Piece; 2],
}

/// Way points, and what a wire along them runs over.
#[derive(Debug, Clone)]
pub(crate) struct Led {
    pub(crate) points: Vec<Point>,
    /// How many pairs of its own legs and bends lie on one another.
    pub(crate) crossings: usize,
    /// How many of the pieces behind the two ports it lies on.
    pub(crate) over_ports: usize,
}

impl<'a> Site<'a> {
    /// A wire as wide as the first port.
    pub(crate) fn new(request: &'a Request<'a>, bend: RouteBend, radius: f64) -> Result<Self> {
        let reach = bend.reach(radius, 90.0)? + MARGIN;
        let wire = Wire::bent(request.port1.width(), bend, radius);
        Ok(Self { request, wire, reach, stubs: stubs(request, reach) })
    }

    /// The wire on the way that it takes.
    pub(crate) fn led(&mut self) -> Result<Led> {
        auto::check_right_angles(self.request)?;
        let usual = self.along(auto::usual(self.request, self.reach)?)?;
        if usual.crossings + usual.over_ports == 0 {
            return Ok(usual);
        }
        if let Some(points) = detour::shortest(self.request, self.reach, &mut self.wire, &self.stubs)? {
            return self.along(points);
        }
        if usual.crossings == 0 {
            return Ok(usual);
        }
        match detour::shortest(self.request, self.reach, &mut self.wire, &[])? {
            Some(points) => self.along(points),
            None => Ok(usual),
        }
    }

    /// The wire along way points of its own.
    pub(crate) fn along(&mut self, points: Vec<Point>) -> Result<Led> {
        self.request.check_way(&points)?;
        let seen: Vec<Point> = points.iter().map(|p| self.request.seen(*p)).collect();
        let pieces = self.wire.cover(&seen)?;
        let is_run_over = |stub: &&Piece| pieces.iter().any(|piece| piece.overlaps(stub));
        let over_ports = self.stubs.iter().filter(is_run_over).count();
        Ok(Led { points, crossings: cover::self_overlaps(&pieces), over_ports })
    }

    /// What the wire covers along way points, where these are.
    pub(crate) fn cover(&mut self, points: &[Point]) -> Result<Vec<Piece>> {
        self.wire.cover(points)
    }
}

/// What lies behind the ports, in the frame of the first: a piece of wire as wide as the port and so long (µm).
fn stubs(request: &Request<'_>, length: f64) -> [Piece; 2] {
    let goal = request.seen(request.port2.midpoint());
    let behind = Point::polar(length, request.turn());
    [
        Piece::obstacle(Point::ORIGIN, Point::new(-length, 0.0), request.port1.width()),
        Piece::obstacle(goal, goal - behind, request.port2.width()),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::port::Port;

    fn led(width: f64, x: f64, y: f64, orientation: i32) -> Led {
        let (a, b) = (Port::new((0, 0), width, 0), Port::new((x, y), width, orientation));
        Site::new(&Request::new("test", &a, &b).unwrap(), RouteBend::Circular, 5.0).unwrap().led().unwrap()
    }

    #[test]
    fn a_port_on_the_usual_way_is_led_to_from_elsewhere() {
        // The reference's first leg runs through the second port, at (10, 0).
        let led = led(1.0, 10.0, 0.0, 90);
        assert_eq!((led.crossings, led.over_ports), (0, 0));
        assert!(led.points.windows(2).all(|leg| leg[0].y != 0.0 || leg[1].y != 0.0 || leg[1].x < 10.0), "{led:?}");
    }

    #[test]
    fn where_there_is_no_way_it_is_said() {
        // The second port looks down from just above the first one's wire.
        let led = led(1.0, 1.0, 1.0, 270);
        assert!(led.crossings > 0);
    }

    #[test]
    fn no_size_makes_it_panic_or_hang() {
        for radius in [1e-300, 1e-12, 1e12, 1e150, 1e300, 1e308] {
            for far in [0.0, 1e-300, 1e-9, 1e9, 1e160, 1e308] {
                for turn in 0..4 {
                    for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
                        let (a, b) = (Port::new((0, 0), 1e-3, 0), Port::new((far, -far), 1e-3, 90 * turn));
                        let _ = crate::RouteManhattanParams::new(&a, &b).radius(radius).bend(bend).build_uncached();
                    }
                }
            }
        }
    }
}
