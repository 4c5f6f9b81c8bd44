//! [`PathPoint`]: points at given distances along a path, with the local direction.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::num::angle;
use phidl_core::place::Movable as _;
use phidl_core::port::Port;
use phidl_core::scene::{Device, Reference};

use crate::normals::right_of;
use crate::{Path, Profile, direction, rule};

/// Distance by which a position may lie beyond the ends of a path (µm): the rounding of sums.
const BEYOND: f64 = 1e-9;

/// A point on a path, with the direction of the path there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// The position.
    pub point: Point,
    /// Direction of the path there (degrees, in `[0, 360)`); at a vertex, that of the following segment.
    pub angle: f64,
}

impl PathPoint {
    /// A reference to a device with its origin at the point and its x axis along the path.
    #[must_use]
    pub fn place(&self, device: &Device) -> Reference {
        device.place().rotated(self.angle).moved_by(self.point)
    }

    /// A port at the point, facing along the path.
    #[must_use]
    pub fn port(&self, width: impl Into<f64>) -> Port {
        Port::new(self.point, width, self.angle)
    }
}

impl From<PathPoint> for Point {
    fn from(sample: PathPoint) -> Self {
        sample.point
    }
}

impl Path {
    /// The points at given distances along the [offset](Path::offset) path: for devices in an evenly spaced row beside a
    /// path.
    ///
    /// Distances (µm) are measured on the offset path, which is longer or shorter than this one in a bend. For distances
    /// on the path itself see [`Path::beside`].
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let path = Path::from_points([(20, 10), (30, 10), (40, 30)])?;
    /// let places = path.interpolate([0, 5, 15], 0)?;
    /// assert_eq!((places[1].point, places[1].angle), ((25, 10).into(), 0.0));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) if a distance is not on the offset path; and as for [`Path::offset`].
    pub fn interpolate<D: Into<f64>>(
        &self,
        distances: impl IntoIterator<Item = D>,
        offset: impl Into<Profile>,
    ) -> Result<Vec<PathPoint>> {
        let path = self.offset(offset)?;
        let ruler = Ruler::of(&path);
        distances.into_iter().map(|distance| Ok(ruler.place(distance.into())?.0)).collect()
    }

    /// The points at an offset (µm) to the right of given distances (µm) along the path itself.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) if a distance is not on the path, or an offset is not finite or is a
    /// list; and the deferred error.
    pub fn beside<D: Into<f64>>(
        &self,
        distances: impl IntoIterator<Item = D>,
        offset: impl Into<Profile>,
    ) -> Result<Vec<PathPoint>> {
        self.check_line("beside")?;
        let offset = offset.into();
        let ruler = Ruler::of(self);
        let place = |distance: D| {
            let (place, t) = ruler.place(distance.into())?;
            let lateral = offset.at(t).filter(|v| v.is_finite());
            let lateral = lateral.ok_or_else(|| {
                rule::refused(
                    "beside",
                    "offset",
                    format!("{offset:?}"),
                    format!("be a number or a function, and finite at t = {t}"),
                )
            })?;
            Ok(PathPoint { point: place.point + right_of(place.angle) * lateral, ..place })
        };
        distances.into_iter().map(place).collect()
    }
}

/// A path with the lengths up to its points.
struct Ruler<'a> {
    points: &'a [Point],
    lengths: Vec<f64>,
}

impl<'a> Ruler<'a> {
    fn of(path: &'a Path) -> Self {
        Self { points: path.points(), lengths: path.lengths() }
    }

    /// The point at a distance, and the fraction of the length before it.
    fn place(&self, distance: f64) -> Result<(PathPoint, f64)> {
        let last = self.lengths.len() - 1;
        let whole = self.lengths[last];
        if !(-BEYOND..=whole + BEYOND).contains(&distance) {
            let rule = format!("be from 0 µm to {whole} µm, the length of the path");
            return Err(rule::refused("interpolate", "distance", format!("{distance} µm"), rule));
        }
        let distance = distance.clamp(0.0, whole);
        // The segment after the last vertex that is not beyond the distance; at the end, the last segment.
        let segment = self.lengths.partition_point(|length| *length <= distance).clamp(1, last) - 1;
        let (from, to) = (self.points[segment], self.points[segment + 1]);
        let length = self.lengths[segment + 1] - self.lengths[segment];
        let part = if length > 0.0 { (distance - self.lengths[segment]) / length } else { 0.0 };
        let angle = angle::normalized(direction::of_segment(from, to));
        Ok((PathPoint { point: from + (to - from) * part, angle }, if whole > 0.0 { distance / whole } else { 0.0 }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stairs() -> Path {
        Path::from_points([(20, 10), (30, 10), (40, 30), (50, 30), (50, 20), (55, 20)]).unwrap()
    }

    #[test]
    fn points_are_those_of_the_reference() {
        let places = stairs().interpolate([0, 5, 10, 15], 0).unwrap();
        let expected =
            [((20., 10.), 0.), ((25., 10.), 0.), ((30., 10.), 63.434_949), ((32.236_068, 14.472_136), 63.434_949)];
        for (place, (point, angle)) in places.iter().zip(expected) {
            assert!(place.point.distance(point.into()) < 1e-6 && (place.angle - angle).abs() < 1e-6);
        }
    }

    #[test]
    fn the_end_has_the_direction_of_the_last_segment() {
        let path = stairs();
        let end = path.interpolate([path.length()], 0).unwrap()[0];
        assert_eq!((end.point, end.angle), (path.end(), 0.0));
    }

    #[test]
    fn distances_are_measured_on_the_offset_path_and_beside_on_the_path() {
        let corner = Path::from_points([(0, 0), (10, 0), (10, 10)]).unwrap();
        assert!(corner.interpolate([20], -1).is_err());
        assert_eq!(corner.interpolate([18], -1).unwrap()[0].point, Point::new(9.0, 10.0));
        assert_eq!(corner.beside([20], -1).unwrap()[0].point, Point::new(9.0, 10.0));
        assert_eq!(corner.beside([5], |t: f64| 4.0 * t).unwrap()[0].point, Point::new(5.0, -1.0));
    }

    #[test]
    fn a_distance_that_is_not_on_the_path_is_refused() {
        let error = stairs().interpolate([-1], 0).unwrap_err();
        assert!(error.to_string().starts_with("interpolate: distance is -1 µm, but it must be from 0 µm to"));
        assert!(stairs().interpolate([f64::NAN], 0).is_err() && stairs().beside([1e3], 0).is_err());
        assert!(stairs().beside([1], f64::NAN).is_err());
    }

    #[test]
    fn a_device_is_placed_along_the_path() {
        let mut d = Device::builder("via");
        d.add_polygon([(0, -1), (2, -1), (2, 1), (0, 1)], 1).unwrap();
        let via = d.build().unwrap();
        let path = Path::from_points([(0, 0), (0, 10)]).unwrap();
        let via = path.interpolate([4], 0).unwrap()[0].place(&via);
        let bbox = phidl_core::place::Bounded::bbox(&via).unwrap();
        assert_eq!((bbox.min, bbox.max), (Point::new(-1.0, 4.0), Point::new(1.0, 6.0)));
    }
}
