//! [`Serpentine`]: from a length to waypoints.
//!
//! The length is that of the line that is drawn, the sum over its chords, and it is met to a tenth of a step of the
//! ordinary grid: the height of the bumps is corrected once more by what the finished line lacks.
//!
//! The bumps go where there is most room, the left side first; the other side and the other straight pieces are taken
//! where the wire would run over itself otherwise. One footprint takes all: bumps on several would be lower, but no two
//! lengths would look alike.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::layer::Layers;
use phidl_core::scene::DeviceBuilder;
use phidl_path::Path;

use super::bumps::Bumps;
use crate::RouteBend;
use crate::manhattan::{RoutedPath, Router, draw_wire};
use crate::port_pair::{PortPair, refused};

/// To how much a length is met (µm): a tenth of a step of the usual database grid.
const EXACT: f64 = 1e-4;
/// By how much a straight piece may be too short for its bumps (µm).
const ROUNDING: f64 = 1e-9;

/// A route on its way to its length.
pub(super) struct Serpentine<'a> {
    pub(super) pair: &'a PortPair<'a>,
    pub(super) length: f64,
    pub(super) bend: RouteBend,
    pub(super) radius: f64,
    pub(super) max_height: Option<f64>,
}

impl Serpentine<'_> {
    pub(super) fn drawn(&self, layer: &Layers) -> Result<DeviceBuilder> {
        draw_wire(self.pair, &self.route()?, self.bend, self.radius, layer)
    }

    /// The wire along waypoints with bumps.
    pub(super) fn route(&self) -> Result<RoutedPath> {
        let mut router = Router::new(self.pair, self.bend, self.radius)?;
        let plain = router.route()?;
        let missing = self.length - self.measured(&plain.points)?;
        if missing.abs() <= EXACT {
            return Ok(plain);
        }
        if missing < 0.0 {
            return Err(self.pair.missing("a length", self.length, self.length - missing));
        }
        let routed = self.lengthened(&mut router, &plain, missing)?;
        let left = self.length - self.measured(&routed.points)?;
        match left.abs() <= EXACT {
            true => Ok(routed),
            false => Err(self.pair.missing("a length", self.length - left, self.length)),
        }
    }

    fn measured(&self, points: &[Point]) -> Result<f64> {
        Ok(Path::smooth(points, self.radius, self.bend)?.length())
    }

    /// The wire with bumps on the first straight piece and side on which it is clear. If it is nowhere, the error is that
    /// of the footprint with most room.
    fn lengthened(&self, router: &mut Router<'_>, plain: &RoutedPath, missing: f64) -> Result<RoutedPath> {
        let mut first_error = None;
        for (leg, room) in self.by_room(&plain.points)? {
            let bumps = match self.bumps(missing, room) {
                Ok(bumps) => bumps,
                Err(error) => {
                    first_error.get_or_insert(error);
                    continue;
                }
            };
            for side in [1.0, -1.0] {
                let routed = router.along(self.corrected(bumps, &plain.points, leg, side)?)?;
                if routed.crossings <= plain.crossings && routed.over_ports <= plain.over_ports {
                    return Ok(routed);
                }
            }
            first_error.get_or_insert_with(|| self.no_side());
        }
        Err(first_error.unwrap_or_else(|| self.no_side()))
    }

    /// The legs by how long their straight pieces are (µm), the longest first.
    fn by_room(&self, points: &[Point]) -> Result<Vec<(usize, f64)>> {
        let extent = self.bend.extent(self.radius, 90.0)?;
        let last = points.len() - 2;
        let room = |leg: usize| {
            let corners = u8::from(leg > 0) + u8::from(leg < last);
            (leg, points[leg].distance(points[leg + 1]) - f64::from(corners) * extent)
        };
        let mut legs: Vec<(usize, f64)> = (0..=last).map(room).collect();
        legs.sort_by(|a, b| b.1.total_cmp(&a.1));
        Ok(legs)
    }

    /// The bumps that add a length in a room.
    fn bumps(&self, added: f64, room: f64) -> Result<Bumps> {
        let Some(bumps) = Bumps::adding(added, room, self.bend, self.radius)? else {
            let longer = self.length - added + Bumps::least(self.bend, self.radius)?;
            let what = "a length between the plain route and its flattest bump";
            return Err(self.pair.missing(what, self.length, longer));
        };
        self.pair.check_room("a straight piece", room + ROUNDING, bumps.span())?;
        match self.max_height {
            Some(most) if bumps.height() > most => Err(self.pair.missing("a max_height", most, bumps.height())),
            _ => Ok(bumps),
        }
    }

    /// The waypoints with bumps whose legs add what the corners of the finished line lack for rounding.
    fn corrected(&self, mut bumps: Bumps, plain: &[Point], leg: usize, side: f64) -> Result<Vec<Point>> {
        bumps.lengthen(self.length - self.measured(&bumps.inserted(plain, leg, side))?);
        Ok(bumps.inserted(plain, leg, side))
    }

    fn no_side(&self) -> phidl_core::Error {
        let given = format!("{} µm, bumps that cross the route {}", self.length, self.pair.between());
        refused(self.pair.what(), "length", given, "leave one side of a straight piece with room free")
    }
}
