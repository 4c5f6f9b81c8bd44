//! The double spiral: two Archimedean arms that meet in the middle.

use std::f64::consts::{FRAC_PI_2, PI};

use phidl_core::Result;
use phidl_core::geom::{Point, Transform};
use phidl_core::num::count;
use phidl_core::place::Movable as _;

use super::{Curve, CurveSegment};
use crate::sampling::ParamCurve;
use crate::{Path, direction, rule};

/// A double spiral: a path that winds in along one arm and out along the other, as in delay lines.
///
/// The arms are Archimedean, r = a + b φ, and two arcs of opposite curvature through the origin join them.
///
/// ```
/// # use phidl_path::Spiral;
/// let spiral = Spiral { num_turns: 3.0, gap: 2.0, inner_gap: 5.0, num_pts: 1000.0 }.path()?;
/// assert_eq!(spiral.points().len(), 993);
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spiral {
    /// Approximate number of turns of the first arm; more than 1. A fraction lengthens one arm or the other.
    pub num_turns: f64,
    /// Distance between neighboring turns (µm), center to center; more than 0.
    pub gap: f64,
    /// Distance between the innermost turns (µm); more than 0.
    pub inner_gap: f64,
    /// Approximate number of points of the whole path.
    pub num_pts: f64,
}

impl Default for Spiral {
    fn default() -> Self {
        Self { num_turns: 5.0, gap: 1.0, inner_gap: 2.0, num_pts: 10_000.0 }
    }
}

/// A stretch of an Archimedean spiral r = a + b φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arm {
    a: f64,
    b: f64,
    /// Angles about the center where it begins and ends (radians), in the direction of the path.
    from: f64,
    to: f64,
}

impl Spiral {
    /// The spiral as a path, its center at the origin.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the bounds of the fields hold and `num_pts` is enough for two points
    /// on each curve and at most [`count::MOST`].
    pub fn path(self) -> Result<Path> {
        self.check()?;
        let arm = self.arm();
        let (end_1, end_2) = self.ends();
        let [on_center, on_1, on_2] = self.shares(arm, end_1, end_2)?;
        let arm_1: Vec<f64> = count::linspace(FRAC_PI_2, end_1, on_1).collect();
        let mut arm_2 = arm_1.clone();
        arm_2.extend(count::linspace(end_1, end_2, on_2).skip(1));
        joined(arm, &arm_2, &self.center_arc(arm, on_center)?, &arm_1)
    }

    fn check(self) -> Result<()> {
        if !(self.num_turns > 1.0 && self.num_turns < 1e6) {
            return Err(rule::refused("spiral", "num_turns", self.num_turns, "be greater than 1 and less than 1e6"));
        }
        rule::positive_length("spiral", "gap", self.gap)?;
        rule::positive_length("spiral", "inner_gap", self.inner_gap)?;
        rule::point_count("spiral", self.num_pts, 360.0)
    }

    /// The angles at which the two arms end (radians); the second is at least the first.
    fn ends(self) -> (f64, f64) {
        let whole = self.num_turns.floor();
        let rest = self.num_turns - whole;
        let other = whole - 1.0 + 2.0 * rest;
        let half_turns = if rest < 0.5 { (other, whole) } else { (whole, whole.max(other)) };
        (PI * half_turns.0 + FRAC_PI_2, PI * half_turns.1 + FRAC_PI_2)
    }

    /// The radius law at the start of the arms.
    fn arm(self) -> Arm {
        Arm { a: (self.inner_gap - self.gap) / 2.0, b: self.gap / PI, from: FRAC_PI_2, to: FRAC_PI_2 }
    }

    /// Radius and sweep (degrees) of the central arcs.
    fn center_shape(self, arm: Arm) -> (f64, f64) {
        let slope = arm.b / (arm.a + arm.b * FRAC_PI_2);
        let radius = self.inner_gap * (1.0 + slope * slope).sqrt() / 4.0;
        let sweep = (2.0 * (self.inner_gap / (4.0 * radius)).asin()).to_degrees();
        (radius, sweep)
    }

    /// The numbers of points of the center arc, the first arm, and the rest of the second arm: roughly by length.
    fn shares(self, arm: Arm, end_1: f64, end_2: f64) -> Result<[usize; 3]> {
        let weight = |end: f64| {
            ((arm.a + end * arm.b).powi(2) + arm.b * arm.b).powf(1.5) / (3.0 * (arm.a * arm.b + end * arm.b * arm.b))
        };
        let (radius, sweep) = self.center_shape(arm);
        let center = radius * sweep.to_radians();
        let per_length = self.num_pts / (weight(end_1) + weight(end_2) + 2.0 * center);
        let share = |weight: f64| count::nearest((per_length * weight).floor());
        let on_1 = share(weight(end_1));
        let shares = [share(center), on_1, share(weight(end_2)).saturating_sub(on_1)];
        match shares[0] >= 2 && shares[1] >= 2 {
            true => Ok(shares),
            false => Err(rule::refused("spiral", "num_pts", self.num_pts, "be enough for two points on each curve")),
        }
    }

    /// The arc from the origin to the start of the first arm.
    fn center_arc(self, arm: Arm, points: usize) -> Result<Path> {
        let (radius, sweep) = self.center_shape(arm);
        let curve = super::Arc::new(radius, sweep)?;
        let mut arc = curve.path(360.0 * points as f64 / sweep)?;
        arc.rotate(90.0 - sweep / 2.0);
        let shift = arm.point(FRAC_PI_2) - arc.end();
        arc.move_by(shift);
        Ok(arc)
    }
}

/// The second arm inwards, the center arc backwards, the center arc, and the first arm outwards, with each joint once.
fn joined(arm: Arm, arm_2: &[f64], center: &Path, arm_1: &[f64]) -> Result<Path> {
    let mut points: Vec<Point> = arm_2.iter().rev().map(|angle| -arm.point(*angle)).collect();
    let mut ends = vec![points.len() - 1];
    points.extend(center.points().iter().rev().skip(1).map(|p| -*p));
    ends.push(points.len() - 1);
    points.extend(&center.points()[1..]);
    ends.push(points.len() - 1);
    points.extend(arm_1.iter().skip(1).map(|angle| arm.point(*angle)));
    ends.push(points.len() - 1);

    let last = |angles: &[f64]| angles.last().copied().unwrap_or(FRAC_PI_2);
    let [(first_arc, first_place), (second_arc, second_place)] = center_parts(center)?;
    let inwards = Arm { from: last(arm_2), ..arm };
    let outwards = Arm { to: last(arm_1), ..arm };
    let curves = [
        (Curve::Arm(inwards), Transform::rotation(180.0)),
        (first_arc, first_place),
        (second_arc, second_place),
        (Curve::Arm(outwards), Transform::IDENTITY),
    ];
    let segments =
        curves.into_iter().zip(ends).map(|((curve, place), end)| CurveSegment { curve, place, end }).collect();
    let n = points.len();
    let start = direction::of_segment(points[0], points[1]);
    let end = direction::of_segment(points[n - 2], points[n - 1]);
    Ok(Path::from_curve(points, segments, start, end))
}

/// The two central arcs with their transforms. The first is the second one rotated by half a turn and reversed: an arc
/// that turns the other way.
fn center_parts(center: &Path) -> Result<[(Curve, Transform); 2]> {
    let (end, degrees) = (center.end(), center.end_angle() - center.start_angle());
    let radius = center.end().norm() / 2.0 / (degrees / 2.0 * PI / 180.0).sin();
    let place = |origin, degrees| Transform { origin, ..Transform::rotation(degrees) };
    Ok([
        (Curve::Arc(super::Arc::new(radius, -degrees)?), place(-end, center.end_angle())),
        (Curve::Arc(super::Arc::new(radius, degrees)?), place(center.start(), center.start_angle())),
    ])
}

impl Arm {
    /// The point at an angle about the center (radians).
    fn point(self, angle: f64) -> Point {
        let (sin, cos) = angle.sin_cos();
        Point::new(cos, sin) * (self.a + self.b * angle)
    }

    fn angle(self, t: f64) -> f64 {
        self.from + t * (self.to - self.from).signum()
    }
}

impl ParamCurve for Arm {
    fn span(&self) -> f64 {
        (self.to - self.from).abs()
    }

    fn at(&self, t: f64) -> Point {
        self.point(self.angle(t))
    }

    fn heading(&self, t: f64) -> f64 {
        let angle = self.angle(t);
        let outwards = angle + (self.a + self.b * angle).atan2(self.b);
        if self.to >= self.from { outwards } else { outwards + PI }
    }

    fn speed(&self, t: f64) -> f64 {
        (self.a + self.b * self.angle(t)).hypot(self.b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spiral(num_turns: f64, gap: f64, inner_gap: f64, num_pts: f64) -> Path {
        Spiral { num_turns, gap, inner_gap, num_pts }.path().unwrap()
    }

    #[test]
    fn spirals_are_those_of_the_reference() {
        let cases = [
            (Spiral::default().path().unwrap(), 9995, (0.010_945_25, 5.999_409_296), (0.0, 5.0), 95.864_549_448),
            (spiral(1.5, 1., 2., 100.), 95, (0.167_319_797, 1.965_865_315), (0.0, -2.0), 12.282_384_28),
            (
                spiral(2.2, 1., 2., 200.),
                195,
                (-0.156_135_603, -2.979_244_779),
                (2.282_535_639, -0.741_640_786),
                22.996_493_545,
            ),
            (spiral(2.7, 1., 2., 200.), 194, (3.147_239_817, -1.235_200_606), (0.0, 3.0), 32.153_407_315),
            (spiral(3., 2., 5., 1000.), 993, (0.114_981_205, 8.490_600_798), (0.0, 6.5), 87.616_022_052),
        ];
        for (path, points, second, last, length) in cases {
            assert_eq!(path.points().len(), points);
            assert!(path.points()[1].distance(second.into()) < 1e-8, "{}", path.points()[1]);
            assert!(path.end().distance(last.into()) < 1e-8, "{}", path.end());
            assert!((path.length() - length).abs() < 1e-7, "{}", path.length());
        }
    }

    #[test]
    fn too_few_points_or_turns_are_refused() {
        assert!(Spiral { num_pts: 20.0, ..Spiral::default() }.path().is_err());
        assert!(Spiral { num_turns: 1.0, ..Spiral::default() }.path().is_err());
        assert!(Spiral { gap: f64::NAN, ..Spiral::default() }.path().is_err());
    }

    #[test]
    fn headings_are_the_directions_of_both_arms() {
        let arm = Arm { a: 0.5, b: 0.3, from: 9.0, to: 2.0 };
        for arm in [arm, Arm { from: 2.0, to: 9.0, ..arm }] {
            for i in 1..50 {
                let t = arm.span() * f64::from(i) / 50.0;
                let step = arm.at(t + 1e-6) - arm.at(t - 1e-6);
                let off = step.y.atan2(step.x) - arm.heading(t);
                assert!((off / (2.0 * PI) - (off / (2.0 * PI)).round()).abs() < 1e-6);
            }
        }
    }
}
