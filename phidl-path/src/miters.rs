//! [`Miters`]: where a path is widened, and in which direction.
//!
//! Parallel lines meet at their miter: at a corner between the normals n and n' a line at the distance d lies at
//! d (n + n') / (1 + n · n'). So one vector for each point serves every section of a cross-section, without an angle or
//! a trigonometric function. Three things keep it sound where a plain miter is not:
//! repeated points count once (they have no direction); beyond the miter limit, a corner has a station for each of its
//! two normals (a bevel); and so a path that doubles back ends in a square end instead of at infinity.

//!
//! Nearly every path has neither repeated points nor sharp corners, and then its points are the stations: nothing is
//! copied, and nothing is decided at a point. Others are gone through point by point.

use std::borrow::Cow;
use std::ops::Range;

use phidl_core::geom::Point;
use phidl_core::num::angle;

use crate::Path;
use crate::curve::Circle;

/// Points closer together than this (µm) are one: far below any grid, far above the noise of coordinates.
pub(crate) const REPEATED: f64 = 1e-9;

/// A miter longer than this many times the distance is cut off: a corner that turns by more than 168.5°.
const MITER_LIMIT: f64 = 10.0;

/// The distinct points of a path with the vectors along which a distance to the right is laid off.
#[derive(Debug, Clone)]
pub(crate) struct Miters<'a> {
    /// The points; twice where a corner is beveled.
    pub(crate) points: Cow<'a, [Point]>,
    /// What one micrometer to the right is there.
    pub(crate) vectors: Vec<Point>,
    /// Numbers of the points in the path, unless they are those of the stations.
    sources: Option<Vec<usize>>,
    /// Length of the path (µm).
    pub(crate) length: f64,
    /// Segments between points of a circle, neither at an end of it, and their [`Circle::bend`].
    pub(crate) arcs: Vec<(Range<usize>, f64)>,
}

impl<'a> Miters<'a> {
    /// The stations of a path of at least two points.
    pub(crate) fn of(path: &'a Path) -> Self {
        let ends = path.raw_angles();
        let ends = [right_of(ends.0), right_of(ends.1)];
        Self::at_all(path, ends).unwrap_or_else(|| Self::one_by_one(path, ends))
    }

    /// A station at every point; nothing if points repeat or corners are beveled.
    fn at_all(path: &'a Path, [start, end]: [Point; 2]) -> Option<Self> {
        let mut line = Line { vectors: Vec::with_capacity(path.points().len()), ..Line::default() };
        let mut before = None;
        line.vectors.push(start);
        for (part, points) in path.stretches() {
            let [first, last] = [0, points.len() - 2].map(|i| normal(points[i], points[i + 1]));
            if let Some(before) = before {
                line.push_miter(before, first);
            }
            match part.circle(points.len() - 1) {
                Some(circle) => line.extend_round(points, &circle),
                None => line.extend(points),
            }
            before = Some(last);
        }
        line.vectors.push(end);
        let Line { vectors, length, arcs, .. } = line;
        line.is_plain.then_some(Self { points: Cow::Borrowed(path.points()), vectors, sources: None, length, arcs })
    }

    /// Stations at the distinct points, two at sharp corners.
    fn one_by_one(path: &Path, [start, end]: [Point; 2]) -> Self {
        let points = path.points();
        let mut stations = Stations::default();
        stations.push(points[0], start, 0);
        // The distinct point before, and the normal of the segment to it.
        let (mut before, mut normal) = (points[0], None);
        for (source, &point) in points.iter().enumerate().skip(1) {
            let along = point - before;
            let length = along.dot(along).sqrt();
            if length <= REPEATED {
                continue;
            }
            let next = Point::new(along.y / length, -along.x / length);
            if let Some((normal, at)) = normal {
                stations.push_corner(before, normal, next, at);
            }
            (before, normal) = (point, Some((next, source)));
        }
        stations.push(path.end(), end, points.len() - 1);
        let Stations { points, vectors, sources } = stations;
        Self { points: points.into(), vectors, sources: Some(sources), length: path.length(), arcs: Vec::new() }
    }

    /// The same without the path.
    pub(crate) fn into_owned(self) -> Miters<'static> {
        Miters { points: self.points.into_owned().into(), ..self }
    }

    /// The same with the numbers of other points: those that the points of the path were made from.
    pub(crate) fn of_sources(self, sources: Vec<usize>) -> Self {
        let sources = match self.sources {
            None => sources,
            Some(own) => own.into_iter().map(|source| sources[source]).collect(),
        };
        Self { sources: Some(sources), ..self }
    }

    pub(crate) fn len(&self) -> usize {
        self.vectors.len()
    }

    /// The number of the point of the path at a station.
    pub(crate) fn source(&self, station: usize) -> usize {
        self.sources.as_ref().map_or(station, |sources| sources[station])
    }

    /// The numbers of all points, by station.
    pub(crate) fn sources(&self) -> Vec<usize> {
        self.sources.clone().unwrap_or_else(|| (0..self.len()).collect())
    }

    /// The values that belong to the points of the path, by station.
    pub(crate) fn pick(&self, by_point: Vec<f64>) -> Vec<f64> {
        match &self.sources {
            None => by_point,
            Some(sources) => sources.iter().map(|source| by_point[*source]).collect(),
        }
    }
}

/// The normal of a segment: a unit vector to its right.
fn normal(from: Point, to: Point) -> Point {
    let along = to - from;
    let length = along.dot(along).sqrt();
    Point::new(along.y / length, -along.x / length)
}

/// Whether the normals before and after a corner, with 1 + n · n', are beyond the miter limit.
fn is_sharp(together: f64) -> bool {
    together * (MITER_LIMIT * MITER_LIMIT) < 2.0
}

/// Stations that are found stretch by stretch.
struct Line {
    vectors: Vec<Point>,
    length: f64,
    arcs: Vec<(Range<usize>, f64)>,
    /// Whether no point repeats the one before, and no corner is sharp.
    is_plain: bool,
}

impl Default for Line {
    fn default() -> Self {
        Self { vectors: Vec::new(), length: 0.0, arcs: Vec::new(), is_plain: true }
    }
}

impl Line {
    fn push_miter(&mut self, before: Point, after: Point) {
        let together = 1.0 + before.dot(after);
        self.is_plain &= !is_sharp(together);
        self.vectors.push((before + after) / together);
    }

    /// The miters between the ends of a stretch of any shape.
    fn extend(&mut self, points: &[Point]) {
        let (mut shortest, mut length, from) = (f64::INFINITY, 0.0, self.vectors.len());
        self.vectors.resize(from + points.len() - 1, Point::ORIGIN);
        // The normals of the segments first, and in their places the miters.
        for (vector, segment) in self.vectors[from..].iter_mut().zip(points.windows(2)) {
            let along = segment[1] - segment[0];
            let own = along.dot(along).sqrt();
            shortest = if own < shortest { own } else { shortest };
            length += own;
            *vector = Point::new(along.y / own, -along.x / own);
        }
        let (own, mut sharpest) = (&mut self.vectors[from..], f64::INFINITY);
        for i in 0..own.len() - 1 {
            let together = 1.0 + own[i].dot(own[i + 1]);
            sharpest = if together < sharpest { together } else { sharpest };
            own[i] = (own[i] + own[i + 1]) / together;
        }
        self.vectors.pop();
        self.length += length;
        self.is_plain &= shortest > REPEATED && !is_sharp(sharpest);
    }

    /// The miters between the ends of an arc.
    fn extend_round(&mut self, points: &[Point], circle: &Circle) {
        let (from, last) = (self.vectors.len(), points.len() - 1);
        self.vectors.extend(points[1..last].iter().map(circle.miter()));
        self.length += circle.chord() * last as f64;
        self.is_plain &= circle.chord() > REPEATED;
        if last > 2 {
            self.arcs.push((from..from + last - 2, circle.bend()));
        }
    }
}

/// Stations that are found one by one.
#[derive(Default)]
struct Stations {
    points: Vec<Point>,
    vectors: Vec<Point>,
    sources: Vec<usize>,
}

impl Stations {
    fn push(&mut self, point: Point, miter: Point, source: usize) {
        self.points.push(point);
        self.vectors.push(miter);
        self.sources.push(source);
    }

    fn push_corner(&mut self, point: Point, before: Point, after: Point, source: usize) {
        let together = 1.0 + before.dot(after);
        if is_sharp(together) {
            self.push(point, before, source);
            self.push(point, after, source);
        } else {
            self.push(point, (before + after) / together, source);
        }
    }
}

/// The unit vector to the right of a direction (degrees).
pub(crate) fn right_of(degrees: f64) -> Point {
    let (sin, cos) = angle::sin_cos(degrees);
    Point::new(sin, -cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArcBend, Spiral};
    use phidl_core::place::Movable as _;

    /// Some paths with arcs of all kinds, at odd places.
    fn round_paths() -> Vec<Path> {
        let mut path = Path::arc(10, 90).unwrap();
        path.append(Path::line(3).unwrap()).append(Path::euler(4, -70).unwrap()).append(Path::arc(3, -210).unwrap());
        let mut mirrored = path.clone();
        mirrored.mirror((1, 2), (7, -3)).rotate(33.3).move_by((1e3, -2e3));
        let spiral = Spiral { num_turns: 3.0, gap: 2.0, inner_gap: 5.0, num_pts: 1000.0 }.path().unwrap();
        let coarse = ArcBend::new().num_pts(7).path(5, 200).unwrap();
        let resampled = mirrored.with_tolerance(0.01).unwrap();
        vec![path, mirrored, spiral, coarse, resampled]
    }

    #[test]
    fn miters_and_lengths_of_arcs_are_those_of_their_points() {
        for path in round_paths() {
            let ends = [right_of(path.start_angle()), right_of(path.end_angle())];
            let (round, each) = (Miters::at_all(&path, ends).unwrap(), Miters::one_by_one(&path, ends));
            assert_eq!((&round.points, round.sources()), (&each.points, each.sources()));
            let by_points: f64 = path.points().windows(2).map(|segment| segment[0].distance(segment[1])).sum();
            assert!((round.length - by_points).abs() < 1e-9, "{} {by_points}", round.length);
            assert_eq!(round.length, path.length());
            for (i, (a, b)) in round.vectors.iter().zip(&each.vectors).enumerate() {
                assert!(a.distance(*b) < 1e-9, "{a} {b} at {i} of {}", round.len());
            }
        }
    }

    #[test]
    fn segments_of_arcs_bend_as_their_miters_do() {
        for path in round_paths() {
            let miters = Miters::of(&path);
            for (segments, bend) in miters.arcs.clone() {
                for i in segments {
                    let (along, apart) =
                        (miters.points[i + 1] - miters.points[i], miters.vectors[i + 1] - miters.vectors[i]);
                    assert!((apart.dot(along) / along.dot(along) - bend).abs() < 1e-9 / along.norm());
                }
            }
        }
    }

    #[test]
    fn repeated_points_and_sharp_corners_are_no_stations_of_their_own() {
        let repeated = Path::from_points([(0, 0), (4, 0), (4, 0), (9, 0)]).unwrap();
        assert_eq!(Miters::of(&repeated).sources(), [0, 1, 3]);
        let sharp = Path::from_points([(0, 0), (9, 0), (0, 1)]).unwrap();
        assert_eq!(Miters::of(&sharp).sources(), [0, 1, 1, 2]);
    }
}
