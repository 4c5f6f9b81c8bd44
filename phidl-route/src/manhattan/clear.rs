//! [`Site`]: where a wire with a width is led between two ports.
//!
//! The reference chooses way points by the radius alone, and its wires run over themselves and over the ports where these
//! are close. Here the usual way points are kept wherever the drawn wire is clear of itself, and of a piece of wire behind
//! either port: what it comes from and leads to must be somewhere. Otherwise the shortest clear way is taken. Where there
//! is none, it is the usual way, and the route says how often it runs over what.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_path::Bend;

use super::auto::{self, MARGIN};
use super::cover::{self, Piece, Wire};
use super::{RouteBend, detour};
use crate::request::Request;

/// A wire with bends, and the ports between which it is led.
pub(crate) struct Site<'a> {
    request: &'a Request<'a>,
    wire: Wire<'a>,
    /// How much room every corner gets (µm).
    reach: f64,
    /// What lies behind the ports, in the frame of the first.
    stubs: [Piece; 2],
}

/// What a wire runs over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Overlaps {
    /// How many pairs of its own legs and bends lie on one another.
    pub(crate) own: usize,
    /// How many of the pieces behind the two ports it lies on.
    pub(crate) ports: usize,
}

impl<'a> Site<'a> {
    /// A wire as wide as the first port.
    pub(crate) fn new(request: &'a Request<'a>, bend: &'a RouteBend, radius: f64) -> Result<Self> {
        let reach = bend.reach(radius)? + MARGIN;
        let wire = Wire::bent(request.port1.width(), bend as &dyn Bend, radius);
        Ok(Self { request, wire, reach, stubs: stubs(request, reach) })
    }

    /// The way points.
    pub(crate) fn way_points(&mut self) -> Result<Vec<Point>> {
        auto::check_right_angles(self.request)?;
        let usual = auto::usual(self.request, self.reach)?;
        let overlaps = self.overlaps(&usual)?;
        if overlaps.own + overlaps.ports == 0 {
            return Ok(usual);
        }
        if let Some(points) = detour::shortest(self.request, self.reach, &mut self.wire, &self.stubs)? {
            return Ok(points);
        }
        if overlaps.own == 0 {
            return Ok(usual);
        }
        Ok(detour::shortest(self.request, self.reach, &mut self.wire, &[])?.unwrap_or(usual))
    }

    /// What the wire runs over on a way of its own.
    pub(crate) fn overlaps(&mut self, points: &[Point]) -> Result<Overlaps> {
        let seen: Vec<Point> = points.iter().map(|p| self.request.seen(*p)).collect();
        let pieces = self.wire.cover(&seen)?;
        let is_run_over = |stub: &&Piece| pieces.iter().any(|piece| piece.overlaps(stub));
        Ok(Overlaps { own: cover::self_overlaps(&pieces), ports: self.stubs.iter().filter(is_run_over).count() })
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
