//! [`PathType`]: the rule for the waypoints of a smooth or sharp route.

use phidl_core::geom::Point;
use phidl_core::num::angle;
use phidl_core::{Error, Result};
use phidl_macros::Choice;

use crate::manhattan::{self, Detour};
use crate::port_pair::{PortPair, refused};

/// The shape of a route.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum PathType {
    /// Straight on.
    Straight,
    /// One corner between ports at a right angle.
    #[choice("L")]
    L,
    /// Forwards, across, and back or on: `length1`.
    #[choice("U")]
    U,
    /// Forwards, across, and into a port at a right angle: `length1`, `length2`.
    #[choice("J")]
    J,
    /// Forwards, to the left, along, and back in: `length1`, `left1`, `length2`.
    #[choice("C")]
    C,
    /// One corner where the axes of the ports meet.
    #[choice("V")]
    V,
    /// Forwards, straight across at any angle, and in: `length1`, `length2`.
    #[choice("Z")]
    Z,
    /// The first of straight, L, U, J and C with room for the bends.
    #[default]
    Manhattan,
    /// The points of `manual_path`.
    Manual,
}

/// Smallest turn of a corner (degrees).
const STRAIGHT_ON: f64 = 1e-6;
/// Points that are this close (µm) are one.
const REPEATED: f64 = 1e-9;

/// A path type with its parameters.
pub(crate) struct WaypointRule<'a> {
    pub(crate) what: &'a str,
    pub(crate) path_type: PathType,
    pub(crate) manual_path: Option<&'a [Point]>,
    pub(crate) length1: Option<f64>,
    pub(crate) length2: Option<f64>,
    pub(crate) left1: Option<f64>,
    /// Radius for which a Manhattan route has room (µm).
    pub(crate) radius: f64,
}

impl WaypointRule<'_> {
    /// The waypoints, from port to port, and the detour that they make.
    pub(crate) fn points(&self, pair: &PortPair<'_>) -> Result<(Vec<Point>, Option<Detour>)> {
        self.check_options()?;
        let (length1, length2) = (self.length1, self.length2);
        let points = match self.path_type {
            PathType::Straight => manhattan::straight(pair),
            PathType::L => manhattan::l(pair),
            PathType::U => manhattan::u(pair, length1.unwrap_or(200.0)),
            PathType::J => manhattan::j(pair, length1.unwrap_or(200.0), length2.unwrap_or(200.0)),
            PathType::C => {
                let left1 = self.left1.unwrap_or(100.0);
                manhattan::c(pair, length1.unwrap_or(100.0), left1, length2.unwrap_or(100.0))
            }
            PathType::V => manhattan::v(pair),
            PathType::Z => manhattan::z(pair, length1.unwrap_or(100.0), length2.unwrap_or(100.0)),
            PathType::Manhattan => manhattan::manhattan(pair, self.radius),
            PathType::Manual => self.manual(),
        }?;
        pair.check_waypoints(&points)?;
        let manhattan = self.path_type == PathType::Manhattan;
        let detour = if manhattan { Detour::of_waypoints(pair, self.radius, &points) } else { None };
        Ok((points, detour))
    }

    fn manual(&self) -> Result<Vec<Point>> {
        match self.manual_path {
            Some(points) if points.len() >= 2 => Ok(points.to_vec()),
            Some(points) => {
                Err(Error::custom(self.what, format!("manual_path needs at least 2 points, but has {}", points.len())))
            }
            None => Err(refused(self.what, "manual_path", "left out", "be given for path_type manual")),
        }
    }

    /// Refuses options that the path type does not have. (PHIDL ignores them.)
    fn check_options(&self) -> Result<()> {
        use PathType::{C, J, Manual, U, Z};
        let path_type = self.path_type;
        let options = [
            ("length1", self.length1.is_some(), matches!(path_type, U | J | C | Z)),
            ("length2", self.length2.is_some(), matches!(path_type, J | C | Z)),
            ("left1", self.left1.is_some(), path_type == C),
            ("manual_path", self.manual_path.is_some(), path_type == Manual),
        ];
        match options.into_iter().find(|(_, given, taken)| *given && !taken) {
            None => Ok(()),
            Some((name, ..)) => {
                let rule = format!("be left out, since path_type {path_type:?} does not use it");
                Err(refused(self.what, name, "given", rule))
            }
        }
    }
}

/// The turn of a line at each of its corners (degrees, to the left if positive).
pub(crate) fn turns(points: &[Point]) -> Vec<f64> {
    let legs: Vec<Point> = points.windows(2).map(|leg| leg[1] - leg[0]).filter(|leg| leg.norm() > REPEATED).collect();
    let turn = |pair: &[Point]| {
        let turn = angle::normalized(pair[1].direction() - pair[0].direction());
        if turn > 180.0 { turn - 360.0 } else { turn }
    };
    legs.windows(2).map(turn).filter(|turn| turn.abs() >= STRAIGHT_ON).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_counted_without_repeated_and_straight_points() {
        let points = [(0, 0), (5, 0), (5, 0), (9, 0), (9, 4), (5, 0), (5, -2)].map(Point::from);
        let turns = turns(&points);
        assert_eq!(turns.len(), 3);
        assert!((turns[0] - 90.0).abs() < 1e-9 && (turns[1] - 135.0).abs() < 1e-9 && (turns[2] - 45.0).abs() < 1e-9);
    }
}
