//! The Euler bend: curvature that rises and falls linearly, with an optional circular arc between.
//!
//! F. Vogelbacher, S. Nevlacsil, M. Sagmeister, J. Kraft, K. Unterrainer, R. Hainberger, "Analysis of silicon nitride
//! partial Euler waveguide bends", Optics Express 27, 31394 (2019).

use phidl_core::Result;
use phidl_core::geom::{Matrix, Point, Transform};
use phidl_core::num::{angle, count};

use super::fresnel::Clothoid;
use super::{Curve, CurveSegment, arc};
use crate::sampling::ParamCurve;
use crate::{EulerBend, Path, rule};

/// Largest angle with an effective radius (degrees): tan(angle / 2) changes its sign at a half turn.
const MOST_EFFECTIVE: f64 = 190.0;

/// Largest angle (degrees): beyond it the Fresnel series of both halves loses more than four digits to cancellation.
const MOST_DEGREES: f64 = 1440.0;

/// Distance from a half turn within which the effective radius is taken from its limit (degrees).
const HALF_TURN: f64 = 1e-3;

/// An Euler bend from the origin heading right. Its own unit of length is that of a clothoid whose curvature equals the
/// length from its start; `scale` converts it to micrometers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Euler {
    degrees: f64,
    /// Fraction of the turn in the clothoids.
    p: f64,
    /// Length of each clothoid.
    clothoid: f64,
    /// Where the first clothoid ends.
    joint: Point,
    curve: Clothoid,
    /// Length of the whole bend.
    length: f64,
    /// The reflection that maps the first half to the reversed second half.
    second_half: Matrix,
    scale: f64,
}

impl Path {
    /// An Euler bend of clothoids alone, from the origin heading right, with 720 points per full turn; `radius` is the
    /// smallest radius of curvature. For partial Euler bends, an effective radius, and other numbers of points see
    /// [`EulerBend`].
    ///
    /// Records the smallest radius as `Rmin`, and up to 190° the radius of the arc with the same ends as `Reff`.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let bend = Path::euler(3, 90)?;
    /// assert!((bend.end().x - 5.610_287_54).abs() < 1e-8);
    /// assert_eq!(bend.info()["Rmin"].as_f64(), Some(3.0));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the radius (µm) is greater than 0, and the angle not 0° and
    /// within ±1440°.
    pub fn euler(radius: impl Into<f64>, angle: impl Into<f64>) -> Result<Self> {
        EulerBend::new().path(radius, angle)
    }
}

impl Euler {
    /// The bend of a radius (µm): the smallest one, or with `use_eff` that of the arc with the same ends. `p` is
    /// greater than 0.
    pub(crate) fn new(radius: f64, degrees: f64, p: f64, use_eff: bool) -> Result<Self> {
        check(radius, degrees, p, use_eff)?;
        let unit = Self::of_unit(degrees, p);
        let scale = radius / if use_eff { unit.effective_radius() } else { unit.smallest_radius() };
        Ok(Self { scale, ..unit })
    }

    fn of_unit(degrees: f64, p: f64) -> Self {
        let turn = degrees.abs().to_radians();
        let clothoid = (p * turn).sqrt();
        let length = 2.0 * clothoid + 1.0 / clothoid * turn * (1.0 - p);
        let curve = Clothoid::up_to(clothoid);
        let (joint, second_half) = (curve.at(clothoid), Transform::IDENTITY.matrix());
        let mut bend = Self { degrees, p, clothoid, joint, curve, length, second_half, scale: 1.0 };
        let middle = bend.first_half(length / 2.0);
        let turned = Transform { x_reflection: true, ..Transform::rotation(degrees.abs() - 180.0) }.matrix();
        bend.second_half = turned.shifted(middle - turned.apply(middle));
        bend
    }

    /// The turn (degrees), to the left if positive.
    pub(crate) fn degrees(self) -> f64 {
        self.degrees
    }

    /// The bend as PHIDL samples it, with its info.
    pub(crate) fn path(self, num_pts: f64) -> Result<Path> {
        rule::point_count("euler", num_pts, self.degrees)?;
        let half = self.half_points(arc::count_of(num_pts, self.degrees));
        let second = half.iter().rev().map(|p| self.second_half.apply(*p));
        let points: Vec<Point> =
            half[..half.len() - 1].iter().copied().chain(second).map(|p| self.in_micrometers(p)).collect();
        // PHIDL normalizes the end direction of a right turn here, but not that of an arc.
        let end = if self.degrees < 0.0 { (360.0 + self.degrees).rem_euclid(360.0) } else { self.degrees };
        let part = CurveSegment::new(Curve::Euler(self), points.len() - 1);
        let mut path = Path::from_curve(points, vec![part], 0.0, end);
        if self.degrees.abs() <= MOST_EFFECTIVE {
            path.set_info("Reff", self.effective_radius() * self.scale);
        }
        path.set_info("Rmin", self.smallest_radius() * self.scale);
        Ok(path)
    }

    /// The points of the first half, both ends included: `n` distributed over clothoid and arc.
    fn half_points(&self, n: usize) -> Vec<Point> {
        let middle = self.length / 2.0;
        // With this order of operations halves are rounded as in PHIDL.
        let on_clothoid = if n <= 2 { 0 } else { count::nearest(n as f64 * (self.clothoid / middle)) };
        let on_arc = n.saturating_sub(on_clothoid);
        // PHIDL omits a piece with too few points, and misplaces what follows.
        let on_clothoid = on_clothoid.max(2);
        let on_arc = if self.p < 1.0 { on_arc.max(2) } else { on_arc };
        let lengths: Vec<f64> = count::linspace(0.0, self.clothoid, on_clothoid).collect();
        let mut points = self.curve.at_each(&lengths);
        points.extend(count::linspace(self.clothoid, middle, on_arc).skip(1).map(|s| self.on_arc(s)));
        points
    }

    /// Micrometers per unit of length of its own.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    /// Length of each clothoid, and so the largest curvature, in the bend's own unit.
    pub(super) fn clothoid_length(&self) -> f64 {
        self.clothoid
    }

    /// Length of the arc between the clothoids.
    pub(super) fn arc_length(&self) -> f64 {
        self.length - 2.0 * self.clothoid
    }

    /// The points at lengths from the start, up to the middle and in rising order, for a left turn in its own unit.
    pub(super) fn first_half_at(&self, lengths: &[f64]) -> Vec<Point> {
        let on_clothoid = lengths.partition_point(|s| *s <= self.clothoid);
        let mut points = self.curve.at_each(&lengths[..on_clothoid]);
        points.extend(lengths[on_clothoid..].iter().map(|s| self.on_arc(*s)));
        points
    }

    /// The point as far before the end as the given point is after the start.
    pub(super) fn mirrored(&self, p: Point) -> Point {
        self.second_half.apply(p)
    }

    pub(super) fn middle(&self) -> Point {
        self.first_half(self.length / 2.0)
    }

    /// The point at a length from the start, up to the middle, in the bend's own unit, turning left.
    fn first_half(&self, s: f64) -> Point {
        if s <= self.clothoid { self.curve.at(s) } else { self.on_arc(s) }
    }

    /// The same behind the clothoid.
    fn on_arc(&self, s: f64) -> Point {
        let radius = self.smallest_radius();
        let joint = self.clothoid * self.clothoid / 2.0;
        let turned = joint + (s - self.clothoid) / radius;
        self.joint + Point::new(turned.sin() - joint.sin(), joint.cos() - turned.cos()) * radius
    }

    fn smallest_radius(&self) -> f64 {
        1.0 / self.clothoid
    }

    /// Radius of the arc whose ends and end directions are those of the bend.
    fn effective_radius(&self) -> f64 {
        let end = self.second_half.apply(Point::ORIGIN);
        let degrees = self.degrees.abs();
        if (180.0 - degrees).abs() < HALF_TURN {
            return end.y / 2.0;
        }
        let (sin, cos) = angle::sin_cos(degrees - 90.0);
        end.y - sin / cos * end.x
    }

    pub(super) fn in_micrometers(&self, unit: Point) -> Point {
        Point::new(unit.x * self.scale, unit.y * self.scale * self.degrees.signum())
    }
}

impl ParamCurve for Euler {
    fn span(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> Point {
        let unit = match s <= self.length / 2.0 {
            true => self.first_half(s),
            false => self.second_half.apply(self.first_half((self.length - s).max(0.0))),
        };
        self.in_micrometers(unit)
    }

    fn heading(&self, s: f64) -> f64 {
        let risen = |s: f64| match s <= self.clothoid {
            true => s * s / 2.0,
            false => self.clothoid * self.clothoid / 2.0 + (s - self.clothoid) * self.clothoid,
        };
        let left = match s <= self.length / 2.0 {
            true => risen(s),
            false => self.degrees.abs().to_radians() - risen(self.length - s),
        };
        left * self.degrees.signum()
    }

    fn speed(&self, _: f64) -> f64 {
        self.scale
    }

    fn parameter_of(&self, heading: f64, from: f64, to: f64) -> f64 {
        let joint = self.clothoid * self.clothoid / 2.0;
        let after = |turned: f64| match turned <= joint {
            true => (2.0 * turned.max(0.0)).sqrt(),
            false => self.clothoid + (turned - joint) / self.clothoid,
        };
        let (turned, whole) = (heading * self.degrees.signum(), self.degrees.abs().to_radians());
        let place = if turned <= whole / 2.0 { after(turned) } else { self.length - after(whole - turned) };
        place.clamp(from, to)
    }
}

fn check(radius: f64, degrees: f64, p: f64, use_eff: bool) -> Result<()> {
    rule::positive_length("euler", "radius", radius)?;
    rule::turn("euler", degrees)?;
    let bound = |most: f64, with: &str| match degrees.abs() <= most {
        true => Ok(()),
        false => {
            Err(rule::refused("euler", "angle", format!("{degrees}°"), format!("be from -{most}° to {most}°{with}")))
        }
    };
    bound(MOST_DEGREES, "")?;
    if use_eff {
        bound(MOST_EFFECTIVE, " for use_eff")?;
    }
    // Smaller clothoids underflow.
    match p > 0.0 && p <= 1.0 && (p * degrees.abs()).is_normal() {
        true => Ok(()),
        false => Err(rule::refused("euler", "p", p, "be from 0 to 1")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bends_end_where_those_of_the_reference_do() {
        let bends = [
            (EulerBend::new().path(3, 90), 359, (5.610_287_54, 5.610_287_54)),
            (EulerBend::new().p(0.5).path(3, 90), 357, (4.248_750_208, 4.248_750_208)),
            (EulerBend::new().p(0.5).use_eff().path(3, 90), 357, (3.0, 3.0)),
            (EulerBend::new().path(3, 180), 719, (0.0, 8.260_990_307)),
            (EulerBend::new().p(0.25).use_eff().path(10, 45), 177, (7.071_067_812, 2.928_932_188)),
            (EulerBend::new().p(0.5).num_pts(100).path(5, 30), 13, (3.727_748_645, 0.998_847_239)),
            (EulerBend::new().num_pts(12).path(3, 90), 5, (5.610_288, 5.610_288)),
        ];
        for (bend, points, end) in bends {
            let bend = bend.unwrap();
            assert_eq!(bend.points().len(), points);
            assert!(bend.end().distance(end.into()) < 1e-6, "{}", bend.end());
        }
    }

    #[test]
    fn few_points_move_neither_end() {
        for p in [0.001, 0.3, 0.95, 1.0] {
            let fine = EulerBend::new().p(p).path(10, 45).unwrap();
            for num_pts in [1, 8, 17, 40, 100] {
                let coarse = EulerBend::new().p(p).num_pts(num_pts).path(10, 45).unwrap();
                assert_eq!(coarse.start(), Point::ORIGIN);
                assert!(coarse.end().distance(fine.end()) < 1e-12, "{p} {num_pts}");
            }
        }
    }

    #[test]
    fn a_full_turn_of_clothoids_comes_back_to_its_axis_of_symmetry() {
        // Mirror symmetry about the bisector: the end lies on the line through the start that is parallel to it.
        let bend = Path::euler(1, 360).unwrap();
        assert!(bend.end().y.abs() < 1e-12, "{}", bend.end());
    }

    #[test]
    fn invalid_bends_are_refused() {
        assert!(Path::euler(3, 0).is_err() && Path::euler(-3, 90).is_err() && Path::euler(3, 2000).is_err());
        assert!(EulerBend::new().p(1.1).path(3, 90).is_err() && EulerBend::new().p(-0.1).path(3, 90).is_err());
        let error = EulerBend::new().use_eff().path(3, 270).unwrap_err();
        assert_eq!(error.to_string(), "euler: angle is 270°, but it must be from -190° to 190° for use_eff");
    }

    #[test]
    fn headings_are_the_directions_of_the_curve() {
        let bend = Euler::new(3.0, -130.0, 0.4, false).unwrap();
        for i in 1..100 {
            let s = bend.span() * f64::from(i) / 100.0;
            let step = bend.at(s + 1e-6) - bend.at(s - 1e-6);
            assert!((step.y.atan2(step.x) - bend.heading(s)).abs() < 1e-6);
        }
    }
}
