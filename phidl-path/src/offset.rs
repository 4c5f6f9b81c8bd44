//! The parallel curve of a path.

use phidl_core::geom::Point;
use phidl_core::{Error, Result};

use crate::curve::{Curve, CurveSegment};
use crate::normals::OffsetNormals;
use crate::{Path, Profile};

/// Length over which the slope of a changing offset is measured at the ends (µm).
const SLOPE_STEP: f64 = 1e-6;

/// Directions that follow from such a slope are rounded to this many parts of a degree.
const DIRECTION_PARTS: f64 = 1e6;

impl Path {
    /// The path at a distance (µm) to the right of this one, to the left if negative. The distance may change along the
    /// path; the directions of the ends then follow its slope.
    ///
    /// Corners are mitered, or beveled if they turn by more than 168.5°. Where the path bends more tightly than the
    /// distance, the result runs backwards and crosses itself: nothing is trimmed. [Resampling](Path::with_tolerance)
    /// keeps its points.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let path = Path::from_points([(0, 0), (10, 0), (10, 10)])?;
    /// assert_eq!(path.offset(1)?.points(), Path::from_points([(0, -1), (11, -1), (11, 10)])?.points());
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Custom`](phidl_core::Error::Custom) if the path has one point, [`Error::Param`](phidl_core::Error::Param)
    /// if a distance is not finite or missing; and the deferred error.
    pub fn offset(&self, offset: impl Into<Profile>) -> Result<Self> {
        let offset = offset.into();
        self.check_line("offset")?;
        let (path, _) = self.offset_with_sources(&offset)?;
        Ok(path)
    }

    /// The offset path, with the number of the point of this path for each of its points.
    pub(crate) fn offset_with_sources(&self, offset: &Profile) -> Result<(Self, Vec<usize>)> {
        offset.check("path", "offset")?;
        let normals = OffsetNormals::of(self);
        let distances = match offset.constant() {
            Some(distance) => vec![distance; normals.len()],
            None => normals.pick(offset.sampled("path", "offset", &self.fractions())?),
        };
        let sides = normals.points.iter().zip(&normals.vectors).zip(&distances);
        let points: Vec<Point> = sides.map(|((p, miter), distance)| *p + *miter * *distance).collect();
        let (start, end) = self.offset_angles(offset)?;
        let part = CurveSegment::new(Curve::Points, points.len() - 1);
        let mut path = Self::from_curve(points, vec![part], start, end);
        for (key, value) in self.info() {
            path.set_info(key, value.clone());
        }
        Ok((path, normals.sources()))
    }

    /// The directions of the ends of an offset path, rotated by the slope of the offset.
    fn offset_angles(&self, offset: &Profile) -> Result<(f64, f64)> {
        let (start, end) = self.raw_angles();
        let step = SLOPE_STEP / self.length();
        let slopes = match offset {
            Profile::Constant(_) => return Ok((start, end)),
            Profile::Samples(values) => self.sampled_slopes(values),
            _ => {
                let at = |t| offset.at(t).unwrap_or(0.0);
                ((at(step) - at(0.0)) / SLOPE_STEP, (at(1.0) - at(1.0 - step)) / SLOPE_STEP)
            }
        };
        // Rounded, because the slope of a function is known to a few digits only.
        let turned = |angle: f64, slope: f64| {
            ((angle + (-slope).atan().to_degrees()) * DIRECTION_PARTS).round_ties_even() / DIRECTION_PARTS
        };
        match slopes.0.is_finite() && slopes.1.is_finite() {
            true => Ok((turned(start, slopes.0), turned(end, slopes.1))),
            false => Err(Error::custom("path", "the offset has no finite slope at an end of the path")),
        }
    }

    /// The slopes of a list of offsets along the first and the last segment.
    fn sampled_slopes(&self, values: &[f64]) -> (f64, f64) {
        let (points, n) = (self.points(), values.len());
        let slope = |i: usize| (values[i + 1] - values[i]) / points[i].distance(points[i + 1]);
        (slope(0), slope(n - 2))
    }

    /// The fraction (0 to 1) of the length before each point. On a path of no length the points are spaced evenly.
    pub(crate) fn fractions(&self) -> Vec<f64> {
        let lengths = self.lengths();
        let whole = lengths[lengths.len() - 1];
        let by_count = (lengths.len() - 1).max(1) as f64;
        let part = |(i, length): (usize, &f64)| if whole > 0.0 { length / whole } else { i as f64 / by_count };
        lengths.iter().enumerate().map(part).collect()
    }

    /// The length up to each point (µm).
    pub(crate) fn lengths(&self) -> Vec<f64> {
        let segments = self.points().windows(2).scan(0.0, |sum, segment| {
            *sum += segment[0].distance(segment[1]);
            Some(*sum)
        });
        std::iter::once(0.0).chain(segments).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(path: &Path) -> Vec<(f64, f64)> {
        path.points().iter().map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn a_constant_offset_goes_around_the_corner() {
        let path = Path::from_points([(0, 0), (10, 0), (10, 10)]).unwrap();
        assert_eq!(points(&path.offset(1).unwrap()), [(0., -1.), (11., -1.), (11., 10.)]);
        assert_eq!(points(&path.offset(-1).unwrap()), [(0., 1.), (9., 1.), (9., 10.)]);
    }

    #[test]
    fn an_offset_that_grows_turns_the_ends() {
        let path = Path::from_points([(0, 0), (5, 0), (10, 0)]).unwrap();
        let path = path.offset(|t: f64| 2.0 * t).unwrap();
        assert_eq!(points(&path), [(0., 0.), (5., -1.), (10., -2.)]);
        assert_eq!(path.raw_angles(), (-11.309_932, -11.309_932));
        let listed = Path::from_points([(0, 0), (5, 0), (10, 0)]).unwrap().offset(vec![0.0, 1.0, 2.0]).unwrap();
        assert_eq!(listed.raw_angles(), path.raw_angles());
    }

    #[test]
    fn parallels_of_an_arc_are_arcs_of_the_other_radius() {
        // A miter lies outside the circle by the factor 1 / cos(step / 2); the ends do not.
        let arc = Path::arc(10, 90).unwrap();
        for (distance, radius) in [(2.0, 12.0), (-3.0, 7.0)] {
            let offset = arc.offset(distance).unwrap();
            assert!((offset.length() - radius * std::f64::consts::FRAC_PI_2).abs() < 1e-3);
            assert!(offset.points().iter().all(|p| (p.distance(Point::new(0.0, 10.0)) - radius).abs() < 1e-4));
        }
    }

    #[test]
    fn repeated_points_leave_no_notch_and_half_turns_no_spike() {
        let path = Path::from_points([(0, 0), (0, 10), (0, 10), (0, 20)]).unwrap();
        assert_eq!(points(&path.offset(1).unwrap()), [(1., 0.), (1., 10.), (1., 20.)]);
        let back = Path::from_points([(0, 0), (10, 0), (0, 0)]).unwrap();
        assert_eq!(points(&back.offset(1).unwrap()), [(0., -1.), (10., -1.), (10., 1.), (0., 1.)]);
    }

    #[test]
    fn invalid_offsets_are_refused() {
        let path = Path::straight(10).unwrap();
        assert!(path.offset(f64::NAN).is_err());
        assert!(path.offset(|t: f64| 1.0 / t).is_err());
        assert!(path.offset(vec![1.0]).is_err());
        assert!(Path::new().offset(1).is_err());
    }
}
