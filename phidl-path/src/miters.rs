//! [`Miters`]: where a path is widened, and in which direction.
//!
//! Parallel lines meet at their miter: at a corner between the normals n and n' a line at the distance d lies at
//! d (n + n') / (1 + n · n'). So one vector for each point serves every section of a cross-section, without an angle or
//! a trigonometric function. Three things keep it sound where a plain miter is not:
//! repeated points count once (they have no direction); beyond the miter limit, a corner has a station for each of its
//! two normals (a bevel); and so a path that doubles back ends in a square end instead of at infinity.

use phidl_core::geom::Point;
use phidl_core::num::angle;

use crate::Path;

/// Points closer together than this (µm) are one: far below any grid, far above the noise of coordinates.
pub(crate) const REPEATED: f64 = 1e-9;

/// A miter longer than this many times the distance is cut off: a corner that turns by more than 168.5°.
const MITER_LIMIT: f64 = 10.0;

/// The distinct points of a path with the vectors along which a distance to the right is laid off.
#[derive(Debug, Clone)]
pub(crate) struct Miters {
    /// The points; twice where a corner is beveled.
    pub(crate) points: Vec<Point>,
    /// What one micrometer to the right is there.
    pub(crate) vectors: Vec<Point>,
    /// Numbers of the points in the path.
    pub(crate) sources: Vec<usize>,
}

impl Miters {
    /// The stations of a path of at least two points.
    pub(crate) fn of(path: &Path) -> Self {
        let n = path.points().len();
        let mut miters =
            Self { points: Vec::with_capacity(n), vectors: Vec::with_capacity(n), sources: Vec::with_capacity(n) };
        let (start, end) = path.raw_angles();
        miters.push(path.start(), right_of(start), 0);
        miters.push_inner(path.points());
        miters.push(path.end(), right_of(end), n - 1);
        miters
    }

    fn push(&mut self, point: Point, miter: Point, source: usize) {
        self.points.push(point);
        self.vectors.push(miter);
        self.sources.push(source);
    }

    /// The corners between the two ends.
    fn push_inner(&mut self, points: &[Point]) {
        // The distinct point before, and the normal of the segment to it.
        let (mut before, mut normal) = (points[0], None);
        for (source, &point) in points.iter().enumerate().skip(1) {
            let along = point - before;
            let length = (along.x * along.x + along.y * along.y).sqrt();
            if length <= REPEATED {
                continue;
            }
            let next = Point::new(along.y / length, -along.x / length);
            if let Some((normal, at)) = normal {
                self.push_corner(before, normal, next, at);
            }
            (before, normal) = (point, Some((next, source)));
        }
    }

    fn push_corner(&mut self, point: Point, before: Point, after: Point, source: usize) {
        let together = 1.0 + before.dot(after);
        if together * (MITER_LIMIT * MITER_LIMIT) >= 2.0 {
            self.push(point, (before + after) / together, source);
        } else {
            self.push(point, before, source);
            self.push(point, after, source);
        }
    }

    /// The same with the numbers of other points: those that the points of the path were made from.
    pub(crate) fn of_sources(mut self, sources: &[usize]) -> Self {
        self.sources.iter_mut().for_each(|source| *source = sources[*source]);
        self
    }

    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    /// The values that belong to the points of the path, by station.
    pub(crate) fn pick(&self, by_point: &[f64]) -> Vec<f64> {
        self.sources.iter().map(|source| by_point[*source]).collect()
    }
}

/// The unit vector to the right of a direction (degrees).
pub(crate) fn right_of(degrees: f64) -> Point {
    let (sin, cos) = angle::sin_cos(degrees);
    Point::new(sin, -cos)
}
