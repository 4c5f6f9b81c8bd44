//! [`Serpentine`]: from a length to waypoints.
//!
//! The length is that of the drawn line, the sum over its chords, to a tenth of a step of the usual grid: the height of the
//! bumps is corrected once by the difference of the drawn line.
//!
//! The bumps go on the longest straight piece, the left side first. The other side and the other straight pieces are tried
//! where the wire would run over itself. One piece takes all bumps: bumps on several pieces would be lower, but no two
//! lengths would look alike.

use phidl_core::geom::Point;
use phidl_core::scene::DeviceBuilder;
use phidl_core::{Error, Result};
use phidl_path::Path;

use super::bumps::Bumps;
use crate::manhattan::{Allowed, ManhattanWire, RoutedPath};
use crate::port_pair::micrometers;

/// Tolerance of a length (µm): a tenth of a step of the usual database grid.
const EXACT: f64 = 1e-4;
/// Length by which a straight piece may be too short for its bumps (µm): rounding.
const ROUNDING: f64 = 1e-9;

/// A wire and its length.
pub(super) struct Serpentine<'a> {
    pub(super) wire: ManhattanWire<'a>,
    pub(super) length: f64,
    pub(super) max_height: Option<f64>,
    pub(super) allowed: Allowed,
}

impl Serpentine<'_> {
    pub(super) fn draw(&self) -> Result<DeviceBuilder> {
        self.wire.check_radius()?;
        self.wire.draw(&self.route()?)
    }

    /// The route with bumps.
    pub(super) fn route(&self) -> Result<RoutedPath> {
        let direct = self.wire.router()?.route()?;
        direct.check(self.wire.pair, self.allowed)?;
        let missing = self.length - self.measured(&direct.points)?;
        if missing.abs() <= EXACT {
            return Ok(direct);
        }
        if missing < 0.0 {
            return Err(self.wire.pair.missing("the length", self.length, self.length - missing));
        }
        let route = self.lengthened(&direct, missing)?;
        let left = self.length - self.measured(&route.points)?;
        match left.abs() <= EXACT {
            true => Ok(route),
            false => Err(self.wire.pair.error(format_args!(
                "bumps meet the length of {} to {} only; a larger radius would do",
                micrometers(self.length),
                micrometers(left)
            ))),
        }
    }

    fn measured(&self, points: &[Point]) -> Result<f64> {
        Ok(Path::smooth(points, self.wire.radius, self.wire.bend)?.length())
    }

    /// The wire with bumps on the first straight piece and side on which it is clear. If there is none, the error is that
    /// of the longest piece.
    fn lengthened(&self, direct: &RoutedPath, missing: f64) -> Result<RoutedPath> {
        let mut router = self.wire.router()?;
        let mut first_error = None;
        for (leg, room) in self.by_room(&direct.points)? {
            let bumps = match self.bumps(missing, room) {
                Ok(bumps) => bumps,
                Err(error) => {
                    first_error.get_or_insert(error);
                    continue;
                }
            };
            for side in [1.0, -1.0] {
                let route = router.along(self.corrected(bumps, &direct.points, leg, side)?)?;
                if route.crossings <= direct.crossings && route.over_ports <= direct.over_ports {
                    return Ok(RoutedPath { detour: direct.detour.clone(), ..route });
                }
            }
            first_error.get_or_insert_with(|| self.no_side());
        }
        Err(first_error.unwrap_or_else(|| self.no_side()))
    }

    /// The legs with the lengths of their straight pieces (µm), the longest first.
    fn by_room(&self, points: &[Point]) -> Result<Vec<(usize, f64)>> {
        let extent = self.wire.bend.extent(self.wire.radius, 90.0)?;
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
        let pair = self.wire.pair;
        let Some(bumps) = Bumps::adding(added, room, self.wire.bend, self.wire.radius)? else {
            let least = self.length - added + Bumps::least(self.wire.bend, self.wire.radius)?;
            return Err(pair.missing("the length, which is more than that of the direct route,", self.length, least));
        };
        pair.check_room("the longest straight piece", room + ROUNDING, bumps.span())?;
        match self.max_height {
            Some(most) if bumps.height() > most => Err(pair.missing("`max_height`", most, bumps.height())),
            _ => Ok(bumps),
        }
    }

    /// The waypoints with bumps whose legs add what the corners of the drawn line lack.
    fn corrected(&self, mut bumps: Bumps, direct: &[Point], leg: usize, side: f64) -> Result<Vec<Point>> {
        bumps.lengthen(self.length - self.measured(&bumps.inserted(direct, leg, side))?);
        Ok(bumps.inserted(direct, leg, side))
    }

    fn no_side(&self) -> Error {
        let length = micrometers(self.length);
        self.wire.pair.error(format_args!("bumps for a length of {length} would run over the route on both sides"))
    }
}
