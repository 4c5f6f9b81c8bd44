//! Waypoints with bends at their corners.

use std::collections::BTreeMap;

use phidl_core::geom::{Outline, Point, Transform};
use phidl_core::num::{angle, count};
use phidl_core::{Error, Result};

use crate::bend::{self, Bend};
use crate::curve::{Curve, CurveSegment};
use crate::normals::REPEATED;
use crate::{Path, direction, rule};

/// Smallest turn of a corner (degrees).
const STRAIGHT_ON: f64 = 1e-6;

/// Overlap (µm) of two bends on a leg that is accepted as rounding.
const ROOM: f64 = 1e-9;

impl Path {
    /// A path through waypoints (pairs, two coordinate lists, or the points of a path) with a bend of a radius (µm) at
    /// every corner: [`ArcBend`](crate::ArcBend), [`EulerBend`](crate::EulerBend), or a function from radius and angle
    /// to a path.
    ///
    /// Repeated waypoints and waypoints on a straight line are skipped. A straight has no points except the ends of the
    /// bends and the first and the last waypoint.
    ///
    /// The number of points of a bend is its angle times the points per degree, truncated. At some orientations rounding
    /// makes a corner of 90° slightly smaller, and its bend has one point less. [`Path::with_tolerance`] has no such jumps.
    ///
    /// ```
    /// # use phidl_path::{EulerBend, Path};
    /// let path = Path::smooth([(20, 10), (40, 10), (20, 40), (50, 40)], 2, EulerBend::new())?;
    /// assert_eq!((path.start(), path.end()), ((20, 10).into(), (50, 40).into()));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Custom`] if there are fewer than two different waypoints, if the line doubles back, if a leg has no room for
    /// its bends, or if there would be more than [`count::MOST`] points; and the error of the bend.
    pub fn smooth(waypoints: impl Outline, radius: impl Into<f64>, bend: impl Bend) -> Result<Self> {
        let given = Self::from_points(waypoints)?;
        let mut points = given.points().to_vec();
        points.dedup_by(|next, before| next.distance(*before) <= REPEATED);
        if points.len() < 2 {
            return Err(Error::custom(
                "smooth",
                "all waypoints are one point, but at least two different ones are needed",
            ));
        }
        let (points, legs) = corners_only(points);
        match points.len() {
            2 => Self::from_points(points),
            _ => smoothed(&points, &legs, radius.into(), &bend),
        }
    }

    /// This path, taken as waypoints, with a bend at every corner; see [`Path::smooth`].
    ///
    /// # Errors
    /// As for [`Path::smooth`]; and the deferred error.
    pub fn smoothed(&self, radius: impl Into<f64>, bend: impl Bend) -> Result<Self> {
        self.check()?;
        Self::smooth(self.points(), radius, bend)
    }
}

/// The legs between waypoints.
struct Legs {
    /// Unit vectors.
    along: Vec<Point>,
    lengths: Vec<f64>,
    /// Directions (degrees).
    directions: Vec<f64>,
    /// Turn of each corner (degrees, in `[-180, 180)`).
    turns: Vec<f64>,
}

impl Legs {
    fn of(points: &[Point]) -> Self {
        let legs: Vec<Point> = points.windows(2).map(|leg| leg[1] - leg[0]).collect();
        let lengths: Vec<f64> = legs.iter().map(|leg| leg.norm()).collect();
        let directions: Vec<f64> = legs.iter().map(|leg| direction::of_leg(*leg)).collect();
        let turn = |pair: &[f64]| {
            let turn = pair[1] - pair[0];
            turn - 360.0 * ((turn + 180.0) / 360.0).floor()
        };
        Self {
            along: legs.iter().zip(&lengths).map(|(leg, length)| *leg / *length).collect(),
            turns: directions.windows(2).map(turn).collect(),
            lengths,
            directions,
        }
    }
}

/// The waypoints without those on a straight line between their neighbors, and the legs between them.
fn corners_only(points: Vec<Point>) -> (Vec<Point>, Legs) {
    let legs = Legs::of(&points);
    if legs.turns.iter().all(|turn| turn.abs() >= STRAIGHT_ON) {
        return (points, legs);
    }
    let last = points.len() - 1;
    let is_corner = |i: usize| i == 0 || i == last || legs.turns[i - 1].abs() >= STRAIGHT_ON;
    let corners: Vec<Point> = points.iter().enumerate().filter(|(i, _)| is_corner(*i)).map(|(_, p)| *p).collect();
    let legs = Legs::of(&corners);
    (corners, legs)
}

fn smoothed(points: &[Point], legs: &Legs, radius: f64, bend: &impl Bend) -> Result<Path> {
    let bends = CornerBends::of(points, legs, radius, bend)?;
    bends.check_room(points, legs)?;
    bends.check_count()?;
    Ok(bends.assembled(points, legs))
}

/// The bends at the corners of a line. Corners with the same turn, to the last bit, share one.
struct CornerBends {
    /// The different bends, each with the distance before its corner at which it starts (µm).
    drawn: Vec<(Path, f64)>,
    /// The bend of each corner: an index into `drawn`.
    at_corners: Vec<usize>,
}

impl CornerBends {
    fn of(points: &[Point], legs: &Legs, radius: f64, bend: &impl Bend) -> Result<Self> {
        let mut drawn = Vec::new();
        let mut by_turn: BTreeMap<u64, usize> = BTreeMap::new();
        let mut at_corners = Vec::with_capacity(legs.turns.len());
        for (turn, corner) in legs.turns.iter().zip(&points[1..]) {
            if (turn.abs() - 180.0).abs() < STRAIGHT_ON {
                return Err(Error::custom("smooth", format!("the line doubles back at {corner}, where no bend fits")));
            }
            let number = *by_turn.entry(turn.to_bits()).or_insert(drawn.len());
            if number == drawn.len() {
                let path = bend::checked(bend, radius, *turn)?;
                let setback = setback(&path, *turn);
                drawn.push((path, setback));
            }
            at_corners.push(number);
        }
        Ok(Self { drawn, at_corners })
    }

    /// Refuses legs that are shorter than the setbacks of the bends at both ends.
    fn check_room(&self, points: &[Point], legs: &Legs) -> Result<()> {
        let taken = |corner: Option<&usize>| corner.map_or(0.0, |number| self.drawn[*number].1);
        for (i, length) in legs.lengths.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|before| self.at_corners.get(before));
            let needed = taken(before) + taken(self.at_corners.get(i));
            if needed > length + ROOM {
                let (from, to) = (points[i], points[i + 1]);
                let (length, needed) = (rule::um(*length), rule::um(needed));
                let message = format!("the leg from {from} to {to} is {length} long, but its bends need {needed}");
                return Err(Error::custom("smooth", message));
            }
        }
        Ok(())
    }

    /// Refuses more points than fit into memory.
    fn check_count(&self) -> Result<()> {
        let points: usize = self.at_corners.iter().map(|number| self.drawn[*number].0.points().len()).sum();
        match points <= count::MOST {
            true => Ok(()),
            false => {
                let message = format!("the bends have {points} points together, but at most {} are drawn", count::MOST);
                Err(Error::custom("smooth", message))
            }
        }
    }

    /// The first waypoint, all bends in position, and the last waypoint, as one path.
    fn assembled(&self, points: &[Point], legs: &Legs) -> Path {
        let bends = || self.at_corners.iter().map(|number| &self.drawn[*number]);
        let mut line = Vec::with_capacity(2 + bends().map(|(bend, _)| bend.points().len()).sum::<usize>());
        let mut segments = Vec::with_capacity(1 + bends().map(|(bend, _)| 1 + bend.segments().len()).sum::<usize>());
        line.push(points[0]);
        for (i, (bend, setback)) in bends().enumerate() {
            let start = points[i + 1] - legs.along[i] * *setback;
            let place = Transform { origin: start, ..Transform::rotation(legs.directions[i]) };
            let matrix = place.matrix();
            segments.push(CurveSegment { curve: Curve::Line, place, end: line.len() });
            segments.extend(bend.segments().iter().map(|segment| segment.moved(line.len(), &place)));
            line.extend(bend.points().iter().map(|p| matrix.apply(*p)));
        }
        let last = legs.directions.len() - 1;
        segments.push(CurveSegment {
            curve: Curve::Line,
            place: Transform::rotation(legs.directions[last]),
            end: line.len(),
        });
        line.push(points[points.len() - 1]);
        let (start, end) = end_directions(&line, legs);
        Path::from_curve(line, segments, start, end)
    }
}

/// The directions of both ends, computed as PHIDL does, to the last bit: as those of a piece that is appended to a blank
/// path with the direction of the first leg.
fn end_directions(line: &[Point], legs: &Legs) -> (f64, f64) {
    let (n, last) = (line.len(), legs.directions.len() - 1);
    let first_leg = legs.directions[0];
    let blank = if first_leg == 0.0 { 0.0 } else { direction::within_turn(first_leg) };
    let start = leg_direction(line[0], line[1], first_leg);
    let end = leg_direction(line[n - 2], line[n - 1], legs.directions[last]);
    (angle::normalized(blank), angle::normalized(direction::within_turn(end + blank - start)))
}

/// The distance before its corner at which a bend starts (µm).
fn setback(bend: &Path, turn: f64) -> f64 {
    let chord = bend.start().distance(bend.end());
    let radius = (chord / 2.0 / (turn / 2.0).to_radians().sin()).abs();
    (radius / ((180.0 - turn) / 2.0).to_radians().tan()).abs()
}

/// The direction of what the bends leave of the first or last leg. Where a bend takes the whole leg, nothing is left, and
/// the direction is that of the leg.
fn leg_direction(from: Point, to: Point, whole_leg: f64) -> f64 {
    let left = direction::of_segment(from, to);
    let same = angle::between(left, whole_leg) < STRAIGHT_ON && from.distance(to) > REPEATED;
    if same { left } else { whole_leg }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArcBend, EulerBend};

    const WAYPOINTS: [(f64, f64); 5] = [(20., 0.), (40., 0.), (80., 40.), (80., 10.), (100., 10.)];

    #[test]
    fn smoothed_paths_are_those_of_the_reference() {
        let cases = [
            (Path::smooth(WAYPOINTS, 2, EulerBend::new().use_eff()), 1079, 39.171_572_875, 121.798_912_206),
            (Path::smooth(WAYPOINTS, 4, ArcBend::new()), 542, 38.343_145_751, 114.790_620_936),
            (Path::smooth(WAYPOINTS, 4, EulerBend::new()), 1079, 36.738_038_622, 110.211_457_752),
        ];
        for (path, points, second, length) in cases {
            let path = path.unwrap();
            assert_eq!(path.points().len(), points);
            assert!((path.points()[1].x - second).abs() < 1e-8 && path.points()[1].y == 0.0);
            assert!((path.length() - length).abs() < 1e-8);
            assert_eq!(path.raw_angles(), (0.0, 0.0));
        }
    }

    #[test]
    fn few_points_per_turn_give_the_corner_of_the_reference() {
        let path = Path::smooth([(0, 0), (50, 0), (50, 50)], 5, ArcBend::new().num_pts(16)).unwrap();
        let expected = [(0., 0.), (45., 0.), (47.5, 0.669_873), (49.330_127, 2.5), (50., 5.), (50., 50.)];
        assert!(path.points().iter().zip(expected).all(|(p, q)| p.distance(q.into()) < 1e-6));
    }

    #[test]
    fn repeated_and_collinear_waypoints_are_skipped() {
        let direct = Path::smooth([(0, 0), (0, 100), (50, 100)], 5, ArcBend::new()).unwrap();
        let full = [(0, 0), (0, 50), (0, 50), (0, 100), (25, 100), (50, 100)];
        let passed = Path::smooth(full, 5, ArcBend::new()).unwrap();
        assert_eq!(direct.points(), passed.points());
    }

    #[test]
    fn a_bend_that_takes_up_both_legs_fits() {
        for radius in [1.0, 3.3, 7.0, 12.1, 50.0] {
            let path = Path::smooth([(0., 0.), (radius, 0.), (radius, radius)], radius, ArcBend::new()).unwrap();
            assert!((path.length() / radius - std::f64::consts::FRAC_PI_2).abs() < 1e-4);
            assert_eq!((path.start_angle(), path.end_angle()), (0.0, 90.0));
        }
    }

    #[test]
    fn a_function_can_be_the_bend() {
        let chamfer = |radius: f64, angle: f64| {
            Path::from_points([(0, 0).into(), Point::polar(radius, angle / 2.0)]).map(|mut path| {
                path.set_start_angle(0).set_end_angle(angle);
                path
            })
        };
        let path = Path::smooth([(0, 0), (10, 0), (10, 10)], 2, chamfer).unwrap();
        assert_eq!(path.points().len(), 4);
        assert!((path.points()[2].y - 2.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn lines_without_room_and_lines_that_double_back_are_refused() {
        let error = Path::smooth([(0, 0), (3, 0), (3, 9)], 5, ArcBend::new()).unwrap_err();
        let expected = "smooth: the leg from (0, 0) to (3, 0) is 3 µm long, but its bends need 5 µm";
        assert_eq!(error.to_string(), expected);
        assert!(Path::smooth([(0, 0), (9, 0), (1, 0)], 1, ArcBend::new()).is_err());
        assert!(Path::smooth([(1, 1), (1, 1)], 1, ArcBend::new()).is_err());
    }

    #[test]
    fn bends_and_straights_come_as_pieces() {
        let pieces = Path::smooth([(0, 0), (50, 0), (50, 50)], 5, ArcBend::new()).unwrap().pieces();
        let lengths: Vec<f64> = pieces.iter().map(Path::length).collect();
        assert_eq!(pieces.len(), 3);
        assert!((lengths[0] - 45.0).abs() < 1e-9 && (lengths[1] - 7.854).abs() < 1e-3);
        assert_eq!(pieces[2].start_angle(), 90.0);
    }
}
