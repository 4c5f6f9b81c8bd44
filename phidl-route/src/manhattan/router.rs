//! [`Router`]: the waypoints of a wire with a width between two ports.
//!
//! PHIDL chooses waypoints by the radius alone, and its wires run over themselves and over the ports where these are close.
//! Here the ordinary waypoints are kept wherever the drawn wire is clear of itself and of a keep-out behind each port, which
//! stands for the device that the wire connects. Otherwise the shortest clear line is taken. Where there is none, it is the
//! ordinary line, with the number of its crossings. Whether a detour or a crossing is acceptable is decided by the caller
//! with [`RoutedPath::check`].

use phidl_core::Result;
use phidl_core::geom::{Point, Rect};
use phidl_core::scene::DeviceBuilder;

use super::footprint::{self, Footprint, Wire};
use super::waypoints::{self, MARGIN};
use super::{RouteBend, detour};
use crate::path_type::turns;
use crate::port_pair::{PortPair, micrometers, round3};

/// A wire with bends, and the ports that it joins.
pub(crate) struct Router<'a> {
    pair: &'a PortPair<'a>,
    wire: Wire,
    /// Length that every corner needs on both legs (µm).
    extent: f64,
    /// The keep-outs behind the ports, in the frame of the first.
    keepouts: [Footprint; 2],
}

/// Waypoints, and what a wire along them runs over.
#[derive(Debug, Clone)]
pub(crate) struct RoutedPath {
    pub(crate) points: Vec<Point>,
    /// Number of pairs of its own legs and bends that overlap.
    pub(crate) crossings: usize,
    /// Number of port keep-outs that it overlaps.
    pub(crate) over_ports: usize,
    /// Why and how far it deviates from the route with the fewest corners.
    pub(crate) detour: Option<Detour>,
}

/// A deviation from the route with the fewest corners.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Detour {
    /// Why it is needed, as a clause.
    reason: String,
    /// How far it goes beyond the box around both ports (µm).
    excursion: f64,
    /// Its corners.
    bends: usize,
}

/// What a caller accepts.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Allowed {
    pub(crate) detour: bool,
    pub(crate) crossings: bool,
}

impl<'a> Router<'a> {
    /// A wire of a width (µm).
    pub(crate) fn new(pair: &'a PortPair<'a>, bend: RouteBend, radius: f64, width: f64) -> Result<Self> {
        let extent = bend.extent(radius, 90.0)? + MARGIN;
        let wire = Wire::with_bends(width, bend, radius);
        Ok(Self { pair, wire, extent, keepouts: keepouts(pair, extent) })
    }

    /// The route of the wire.
    pub(crate) fn route(&mut self) -> Result<RoutedPath> {
        waypoints::check_right_angles(self.pair)?;
        let ordinary = self.along(waypoints::ordinary(self.pair, self.extent)?)?;
        let reason = shortage(self.pair, self.extent);
        let clear = ordinary.crossings + ordinary.over_ports == 0;
        if clear {
            return Ok(self.with_detour(ordinary, reason));
        }
        let over = || Some("the route with the fewest corners runs over itself or over a port".to_owned());
        if let Some(points) = detour::shortest(self.pair, self.extent, &mut self.wire, &self.keepouts)? {
            let route = self.along(points)?;
            return Ok(self.with_detour(route, reason.or_else(over)));
        }
        if ordinary.crossings > 0
            && let Some(points) = detour::shortest(self.pair, self.extent, &mut self.wire, &[])?
        {
            let route = self.along(points)?;
            return Ok(self.with_detour(route, reason.or_else(over)));
        }
        Ok(self.with_detour(ordinary, reason))
    }

    /// The wire along given waypoints.
    pub(crate) fn along(&mut self, points: Vec<Point>) -> Result<RoutedPath> {
        self.pair.check_waypoints(&points)?;
        let local: Vec<Point> = points.iter().map(|p| self.pair.to_local(*p)).collect();
        let footprints = self.wire.footprints(&local)?;
        let is_run_over = |keepout: &&Footprint| footprints.iter().any(|footprint| footprint.overlaps(keepout));
        let over_ports = self.keepouts.iter().filter(is_run_over).count();
        Ok(RoutedPath { points, crossings: footprint::self_overlaps(&footprints), over_ports, detour: None })
    }

    /// The footprints of the wire along waypoints, in global coordinates.
    pub(crate) fn footprints(&mut self, points: &[Point]) -> Result<Vec<Footprint>> {
        self.wire.footprints(points)
    }

    fn with_detour(&self, route: RoutedPath, reason: Option<String>) -> RoutedPath {
        let detour = reason.map(|reason| Detour::along(self.pair, &route.points, reason));
        RoutedPath { detour, ..route }
    }
}

impl RoutedPath {
    /// Refuses a detour or a crossing that is not allowed.
    pub(crate) fn check(&self, pair: &PortPair<'_>, allowed: Allowed) -> Result<()> {
        if let Some(detour) = self.detour.as_ref().filter(|_| !allowed.detour) {
            return Err(pair.error(format_args!("{}; `allow_detour` draws {}", detour.reason, detour.described())));
        }
        if self.crossings + self.over_ports > 0 && !allowed.crossings {
            let runs = match (self.crossings, self.over_ports) {
                (0, _) => "over the keep-out behind a port".to_owned(),
                (_, 0) => "over itself".to_owned(),
                _ => "over itself and over the keep-out behind a port".to_owned(),
            };
            let message =
                format_args!("there is no room: the wire would run {runs}; `allow_crossings` draws it all the same");
            return Err(pair.error(message));
        }
        Ok(())
    }
}

impl Detour {
    /// The detour of a sharp or smoothed line of Manhattan waypoints, if it is one.
    pub(crate) fn of_waypoints(pair: &PortPair<'_>, radius: f64, points: &[Point]) -> Option<Self> {
        let extent = radius + MARGIN;
        let changed = || {
            let same = waypoints::ordinary(pair, extent).is_ok_and(|ordinary| ordinary == points);
            (!same).then(|| "the route with the fewest corners crosses itself".to_owned())
        };
        shortage(pair, extent).or_else(changed).map(|reason| Self::along(pair, points, reason))
    }

    fn along(pair: &PortPair<'_>, points: &[Point], reason: String) -> Self {
        let ports = [Point::ORIGIN, pair.to_local(pair.port2.midpoint())];
        let inside = Rect::new(ports[0], ports[1]);
        let beyond = |p: &Point| {
            let p = pair.to_local(*p);
            let x = (inside.min.x - p.x).max(p.x - inside.max.x);
            x.max(inside.min.y - p.y).max(p.y - inside.max.y).max(0.0)
        };
        let excursion = points.iter().map(beyond).fold(0.0, f64::max);
        Self { reason, excursion, bends: turns(points).len() }
    }

    fn described(&self) -> String {
        format!("a route of {} bends that reaches {} beyond its ports", self.bends, micrometers(self.excursion))
    }

    /// Records it: `detour` (µm beyond the ports) and `detour_reason`.
    pub(crate) fn record(&self, d: &mut DeviceBuilder) {
        d.info("detour", self.excursion).info("detour_reason", self.reason.as_str());
    }
}

/// Why the route with the fewest corners does not fit, if it does not: what its bends need, and what there is.
fn shortage(pair: &PortPair<'_>, extent: f64) -> Option<String> {
    let (x, y) = (round3(pair.forward_distance()), round3(pair.lateral_distance()));
    let (ahead, beside) = (micrometers(x), micrometers(y.abs()));
    let (one, two) = (micrometers(extent), micrometers(2.0 * extent));
    match pair.turn() {
        180.0 if x > 0.0 && y != 0.0 && y.abs() < 2.0 * extent => {
            Some(format!("two bends need {two} to the side, but port2 lies {beside} to the side"))
        }
        180.0 if x > 0.0 && y != 0.0 && x <= 2.0 * extent => {
            Some(format!("two bends need {two} ahead, but port2 lies {ahead} ahead"))
        }
        0.0 if y != 0.0 && y.abs() < 2.0 * extent => {
            Some(format!("a turn back needs {two} to the side, but port2 lies {beside} to the side"))
        }
        turn @ (90.0 | 270.0) => {
            let towards = if turn == 270.0 { y } else { -y };
            let fits = x > extent && towards > extent;
            (x > 0.0 && towards > 0.0 && !fits).then(|| {
                format!(
                    "a bend needs {one} ahead and to the side, but port2 lies {ahead} ahead and {beside} to the side"
                )
            })
        }
        _ => None,
    }
}

/// The keep-outs behind the ports, in the frame of the first: as wide as the port and of a length (µm).
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
        let pair = PortPair::new("test", &a, &b).unwrap();
        Router::new(&pair, RouteBend::Circular, 5.0, width).unwrap().route().unwrap()
    }

    #[test]
    fn a_port_on_the_ordinary_route_is_reached_by_another_one() {
        // The ordinary first leg runs through the second port, at (10, 0).
        let route = route(1.0, 10.0, 0.0, 90);
        assert_eq!((route.crossings, route.over_ports), (0, 0));
        assert!(route.points.windows(2).all(|leg| leg[0].y != 0.0 || leg[1].y != 0.0 || leg[1].x < 10.0), "{route:?}");
        assert!(route.detour.is_some());
    }

    #[test]
    fn a_route_without_room_counts_its_crossings() {
        // The second port looks down from just above the first one's wire.
        assert!(route(1.0, 1.0, 1.0, 270).crossings > 0);
    }

    #[test]
    fn a_detour_is_what_has_more_corners_than_the_ports_call_for() {
        for (x, y, orientation) in [(50., 0., 180), (50., 20., 180), (50., 20., 270), (-50., 20., 180), (-9., 50., 0)] {
            assert_eq!(route(1.0, x, y, orientation).detour, None, "{x} {y} {orientation}");
        }
        for (x, y, orientation) in [(50., 5., 180), (8., 50., 180), (50., 3., 270), (3., 50., 270), (20., 4., 0)] {
            assert!(route(1.0, x, y, orientation).detour.is_some(), "{x} {y} {orientation}");
        }
        let detour = route(1.0, 50.0, 5.0, 180).detour.unwrap();
        assert_eq!((detour.bends, round3(detour.excursion)), (4, 10.2));
        assert_eq!(detour.reason, "two bends need 10.2 µm to the side, but port2 lies 5 µm to the side");
    }

    #[test]
    fn no_size_makes_it_panic_or_hang() {
        for radius in [1e-300, 1e-12, 1e12, 1e150, 1e300, 1e308] {
            for far in [0.0, 1e-300, 1e-9, 1e9, 1e160, 1e308] {
                for turn in 0..4 {
                    for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
                        let (a, b) = (Port::new((0, 0), 1e-3, 0), Port::new((far, -far), 1e-3, 90 * turn));
                        let params = crate::RouteManhattanParams::new(&a, &b).radius(radius).bend(bend);
                        let _ = params.allow_detour(true).allow_crossings(true).build();
                    }
                }
            }
        }
    }
}
