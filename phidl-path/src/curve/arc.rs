//! The circular arc.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::num::{angle, count};

use super::{Curve, CurveSegment};
use crate::sampling::{MOST_CHORDS, WIDEST_CHORD};
use crate::{ArcBend, Path, rule};

/// An arc from the origin heading right; it turns left if its angle is positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arc {
    radius: f64,
    degrees: f64,
}

impl Path {
    /// A circular arc from the origin heading right, with 720 points per full turn; a negative angle turns right.
    /// For other numbers of points see [`ArcBend`].
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let quarter = Path::arc(10, 90)?;
    /// assert_eq!((quarter.points().len(), quarter.end_angle()), (180, 90.0));
    /// assert!(quarter.end().distance((10, 10).into()) < 1e-12);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the radius (µm) is greater than 0 and the angle (degrees) is
    /// not 0, both finite.
    pub fn arc(radius: impl Into<f64>, angle: impl Into<f64>) -> Result<Self> {
        ArcBend::new().path(radius, angle)
    }
}

impl Arc {
    pub(crate) fn new(radius: f64, degrees: f64) -> Result<Self> {
        rule::positive_length("arc", "radius", radius)?;
        rule::turn("arc", degrees)?;
        Ok(Self { radius, degrees })
    }

    /// The turn (degrees), to the left if positive.
    pub(crate) fn degrees(self) -> f64 {
        self.degrees
    }

    pub(crate) fn radius(self) -> f64 {
        self.radius
    }

    pub(crate) fn center(self) -> Point {
        Point::new(0.0, self.radius * self.degrees.signum())
    }

    /// The arc as PHIDL samples it: `num_pts` per full turn, truncated to a whole number, and at least the two ends (of
    /// which PHIDL omits one or both at small angles).
    pub(crate) fn path(self, num_pts: f64) -> Result<Path> {
        rule::point_count("arc", num_pts, self.degrees)?;
        let points = self.evenly(count_of(num_pts, self.degrees).max(2));
        let part = CurveSegment::new(Curve::Arc(self), points.len() - 1);
        Ok(Path::from_curve(points, vec![part], 0.0, self.degrees))
    }

    /// The fewest points between the ends, evenly spaced; `None` if there are too many.
    pub(crate) fn inner_points(self, tolerance: f64) -> Option<Vec<Point>> {
        let fewest = count::up(self.degrees.abs() / WIDEST_CHORD);
        let chords = count::for_tolerance(self.radius, self.degrees, tolerance).max(fewest);
        (chords <= MOST_CHORDS).then(|| {
            let mut points = self.evenly(chords + 1);
            points.truncate(chords);
            points.remove(0);
            points
        })
    }

    /// `count` points at even angles, both ends included.
    ///
    /// Every sixteenth point and the last are computed from their angles. The others are rotated by one to fifteen steps
    /// from there, which costs a fifth of a sine and a cosine and half of the last bit.
    fn evenly(self, count: usize) -> Vec<Point> {
        const STRIDE: usize = 16;
        let (from, turn, last) = (-90.0, self.degrees.abs(), (count - 1) as f64);
        let (radius, side) = (self.radius, self.degrees.signum());
        let steps: [(f64, f64); STRIDE] = std::array::from_fn(|i| angle::sin_cos(turn * (i as f64 / last)));
        let mut points = Vec::with_capacity(count.next_multiple_of(STRIDE));
        let mut block = [Point::ORIGIN; STRIDE];
        for first in (0..count).step_by(STRIDE) {
            let (sin, cos) = angle::sin_cos(from + turn * (first as f64 / last));
            let (up, right) = (radius * sin, radius * cos);
            for (p, (s, c)) in block.iter_mut().zip(&steps) {
                *p = Point::new(right * c - up * s, side * (up * c + right * s + radius));
            }
            points.extend_from_slice(&block);
        }
        points.truncate(count);
        let (sin, cos) = angle::sin_cos(from + turn);
        points[count - 1] = self.at(sin, cos);
        points
    }

    /// The point at an angle about the center, by its sine and cosine; at −90° it is the start.
    fn at(self, sin: f64, cos: f64) -> Point {
        Point::new(self.radius * cos, self.degrees.signum() * self.radius * (sin + 1.0))
    }
}

/// The number of points of a bend at `num_pts` per full turn, truncated.
pub(crate) fn count_of(num_pts: f64, degrees: f64) -> usize {
    // The order of operations is PHIDL's: 720 · 89.99999999999999 / 360 is truncated to 179.
    count::nearest((num_pts * degrees / 360.0).abs().floor())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_has_the_radius_and_the_last_one_the_angle() {
        for (radius, degrees) in [(10.0, 90.0), (3.0, -250.0), (0.5, 450.0)] {
            let path = Path::arc(radius, degrees).unwrap();
            let center = Point::new(0.0, if degrees > 0.0 { radius } else { -radius });
            assert!(path.points().iter().all(|p| (p.distance(center) - radius).abs() < 1e-12));
            let out = (path.end() - center).direction();
            let expected = if degrees > 0.0 { degrees - 90.0 } else { degrees + 90.0 };
            assert!(angle::between(out, expected) < 1e-9, "{out} {expected}");
        }
    }

    #[test]
    fn a_small_angle_still_has_both_ends() {
        let path = Path::arc(10, 0.4).unwrap();
        assert_eq!(path.points().len(), 2);
        assert!(path.end().distance(Point::new(0.069_812_6, 0.000_243_69)) < 1e-7);
    }

    #[test]
    fn an_arc_of_no_radius_or_no_angle_is_refused() {
        assert_eq!(
            Path::arc(-2, 90).unwrap_err().to_string(),
            "arc: radius is -2 µm, but it must be greater than 0 µm and finite"
        );
        assert!(Path::arc(0, 90).is_err() && Path::arc(1, 0).is_err() && Path::arc(1, f64::INFINITY).is_err());
    }

    #[test]
    fn quarter_turns_end_exactly_on_the_axes() {
        assert_eq!(Path::arc(10, 90).unwrap().end(), Point::new(10.0, 10.0));
        assert_eq!(Path::arc(10, -180).unwrap().end(), Point::new(0.0, -20.0));
    }
}
