//! [`Router`]: where a wire with a width is routed between two ports.
//!
//! The reference chooses waypoints by the radius alone, and its wires run over themselves and over the ports where these
//! are close. Here the ordinary waypoints are kept wherever the drawn wire is clear of itself, and of a footprint of wire behind
//! either port: what it comes from and leads to must be somewhere. Otherwise the shortest clear way is taken. Where there
//! is none, it is the ordinary way, and the route says how often it runs over what.

use phidl_core::Result;
use phidl_core::geom::Point;

use super::footprint::{self, Footprint, Wire};
use super::waypoints::{self, MARGIN};
use super::{RouteBend, detour};
use crate::port_pair::PortPair;

/// A wire with bends, and the ports between which it is routed.
pub(crate) struct Router<'a> {
    pair: &'a PortPair<'a>,
    wire: Wire,
    /// How much room every corner gets (µm).
    extent: f64,
    /// What lies behind the ports, in the frame of the first.
    keepouts: [Footprint; 2],
}

/// Waypoints, and what a wire along them runs over.
#[derive(Debug, Clone)]
pub(crate) struct RoutedPath {
    pub(crate) points: Vec<Point>,
    /// How many pairs of its own legs and bends lie on one another.
    pub(crate) crossings: usize,
    /// How many of the footprints behind the two ports it lies on.
    pub(crate) over_ports: usize,
}

impl<'a> Router<'a> {
    /// A wire as wide as the first port.
    pub(crate) fn new(pair: &'a PortPair<'a>, bend: RouteBend, radius: f64) -> Result<Self> {
        let extent = bend.extent(radius, 90.0)? + MARGIN;
        let wire = Wire::with_bends(pair.port1.width(), bend, radius);
        Ok(Self { pair, wire, extent, keepouts: keepouts(pair, extent) })
    }

    /// The wire on the way that it takes.
    pub(crate) fn route(&mut self) -> Result<RoutedPath> {
        waypoints::check_right_angles(self.pair)?;
        let ordinary = self.along(waypoints::ordinary(self.pair, self.extent)?)?;
        if ordinary.crossings + ordinary.over_ports == 0 {
            return Ok(ordinary);
        }
        if let Some(points) = detour::shortest(self.pair, self.extent, &mut self.wire, &self.keepouts)? {
            return self.along(points);
        }
        if ordinary.crossings == 0 {
            return Ok(ordinary);
        }
        match detour::shortest(self.pair, self.extent, &mut self.wire, &[])? {
            Some(points) => self.along(points),
            None => Ok(ordinary),
        }
    }

    /// The wire along waypoints of its own.
    pub(crate) fn along(&mut self, points: Vec<Point>) -> Result<RoutedPath> {
        self.pair.check_waypoints(&points)?;
        let seen: Vec<Point> = points.iter().map(|p| self.pair.to_local(*p)).collect();
        let footprints = self.wire.footprints(&seen)?;
        let is_run_over = |keepout: &&Footprint| footprints.iter().any(|footprint| footprint.overlaps(keepout));
        let over_ports = self.keepouts.iter().filter(is_run_over).count();
        Ok(RoutedPath { points, crossings: footprint::self_overlaps(&footprints), over_ports })
    }

    /// What the wire covers along waypoints, where these are.
    pub(crate) fn footprints(&mut self, points: &[Point]) -> Result<Vec<Footprint>> {
        self.wire.footprints(points)
    }
}

/// What lies behind the ports, in the frame of the first: a footprint of wire as wide as the port and so long (µm).
fn keepouts(pair: &PortPair<'_>, length: f64) -> [Footprint; 2] {
    let goal = pair.to_local(pair.port2.midpoint());
    let behind = Point::polar(length, pair.turn());
    [
        Footprint::obstacle(Point::ORIGIN, Point::new(-length, 0.0), pair.port1.width()),
        Footprint::obstacle(goal, goal - behind, pair.port2.width()),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::port::Port;

    fn route(width: f64, x: f64, y: f64, orientation: i32) -> RoutedPath {
        let (a, b) = (Port::new((0, 0), width, 0), Port::new((x, y), width, orientation));
        Router::new(&PortPair::new("test", &a, &b).unwrap(), RouteBend::Circular, 5.0).unwrap().route().unwrap()
    }

    #[test]
    fn a_port_on_the_usual_way_is_led_to_from_elsewhere() {
        // The reference's first leg runs through the second port, at (10, 0).
        let routed = route(1.0, 10.0, 0.0, 90);
        assert_eq!((routed.crossings, routed.over_ports), (0, 0));
        assert!(
            routed.points.windows(2).all(|leg| leg[0].y != 0.0 || leg[1].y != 0.0 || leg[1].x < 10.0),
            "{routed:?}"
        );
    }

    #[test]
    fn where_there_is_no_way_it_is_said() {
        // The second port looks down from just above the first one's wire.
        let routed = route(1.0, 1.0, 1.0, 270);
        assert!(routed.crossings > 0);
    }

    #[test]
    fn no_size_makes_it_panic_or_hang() {
        for radius in [1e-300, 1e-12, 1e12, 1e150, 1e300, 1e308] {
            for far in [0.0, 1e-300, 1e-9, 1e9, 1e160, 1e308] {
                for turn in 0..4 {
                    for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
                        let (a, b) = (Port::new((0, 0), 1e-3, 0), Port::new((far, -far), 1e-3, 90 * turn));
                        let _ = crate::RouteManhattanParams::new(&a, &b).radius(radius).bend(bend).build();
                    }
                }
            }
        }
    }
}
