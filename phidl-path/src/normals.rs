//! [`OffsetNormals`]: the vectors along which a path is widened.
//!
//! Parallel lines meet at their miter: at a corner between the normals n and n', a line at the distance d lies at
//! d (n + n') / (1 + n · n'). So one vector for each point serves every section of a cross-section, without an angle or
//! a trigonometric function. Three rules keep it valid where a miter is not: repeated points count once (they have no
//! direction); beyond the miter limit a corner has a sample for each of its two normals (a bevel); and so a path that
//! doubles back ends square instead of at infinity.
//!
//! Nearly every path has neither repeated points nor sharp corners. Its points are the samples then: nothing is copied, and
//! no point needs a decision. Other paths are handled point by point.

use std::borrow::Cow;
use std::ops::Range;

use phidl_core::geom::Point;
use phidl_core::num::angle;

use crate::Path;
use crate::curve::Circle;

/// Points closer together than this (µm) are one: far below any grid, far above the rounding of coordinates.
pub(crate) const REPEATED: f64 = 1e-9;

/// A miter longer than this many times the distance is beveled: a corner that turns by more than 168.5°.
const MITER_LIMIT: f64 = 10.0;

/// The distinct points of a path (the samples), with the vectors along which a distance to the right is measured.
#[derive(Debug, Clone)]
pub(crate) struct OffsetNormals<'a> {
    /// The points; twice where a corner is beveled.
    pub(crate) points: Cow<'a, [Point]>,
    /// The displacement of one micrometer to the right at each sample.
    pub(crate) vectors: Vec<Point>,
    /// Index of each sample's point in the path, unless all indices agree.
    sources: Option<Vec<usize>>,
    /// Length of the path (µm).
    pub(crate) length: f64,
    /// Segments between points of a circle, neither at an end of it, and their [`Circle::bend`].
    pub(crate) arcs: Vec<(Range<usize>, f64)>,
}

impl<'a> OffsetNormals<'a> {
    /// The samples of a path of at least two points.
    pub(crate) fn of(path: &'a Path) -> Self {
        let ends = path.raw_angles();
        let ends = [right_of(ends.0), right_of(ends.1)];
        Self::of_regular(path, ends).unwrap_or_else(|| Self::of_any(path, ends))
    }

    /// One sample for each point; `None` if points repeat or corners are beveled.
    fn of_regular(path: &'a Path, [start, end]: [Point; 2]) -> Option<Self> {
        let mut line = NormalsBuilder { vectors: Vec::with_capacity(path.points().len()), ..NormalsBuilder::default() };
        let mut before = None;
        line.vectors.push(start);
        for (segment, points) in path.segments_with_points() {
            let [first, last] = [0, points.len() - 2].map(|i| normal(points[i], points[i + 1]));
            if let Some(before) = before {
                line.push_miter(before, first);
            }
            match segment.circle(points.len() - 1) {
                Some(circle) => line.extend_round(points, &circle),
                None => line.extend(points),
            }
            before = Some(last);
        }
        line.vectors.push(end);
        let NormalsBuilder { vectors, length, arcs, .. } = line;
        line.is_regular.then_some(Self { points: Cow::Borrowed(path.points()), vectors, sources: None, length, arcs })
    }

    /// Samples at the distinct points, two at sharp corners.
    fn of_any(path: &Path, [start, end]: [Point; 2]) -> Self {
        let points = path.points();
        let mut samples = Samples::default();
        samples.push(points[0], start, 0);
        // The previous distinct point, and the normal of the segment to it.
        let (mut before, mut normal) = (points[0], None);
        for (source, &point) in points.iter().enumerate().skip(1) {
            let along = point - before;
            let length = along.dot(along).sqrt();
            if length <= REPEATED {
                continue;
            }
            let next = Point::new(along.y / length, -along.x / length);
            if let Some((normal, at)) = normal {
                samples.push_corner(before, normal, next, at);
            }
            (before, normal) = (point, Some((next, source)));
        }
        samples.push(path.end(), end, points.len() - 1);
        let Samples { points, vectors, sources } = samples;
        Self { points: points.into(), vectors, sources: Some(sources), length: path.length(), arcs: Vec::new() }
    }

    /// The same without the path.
    pub(crate) fn into_owned(self) -> OffsetNormals<'static> {
        OffsetNormals { points: self.points.into_owned().into(), ..self }
    }

    /// The same with the indices of other points: those from which the points of the path were made.
    pub(crate) fn with_sources(self, sources: Vec<usize>) -> Self {
        let sources = match self.sources {
            None => sources,
            Some(own) => own.into_iter().map(|source| sources[source]).collect(),
        };
        Self { sources: Some(sources), ..self }
    }

    pub(crate) fn len(&self) -> usize {
        self.vectors.len()
    }

    /// The index of the path's point at a sample.
    pub(crate) fn source(&self, sample: usize) -> usize {
        self.sources.as_ref().map_or(sample, |sources| sources[sample])
    }

    /// The indices of all points, by sample.
    pub(crate) fn sources(&self) -> Vec<usize> {
        self.sources.clone().unwrap_or_else(|| (0..self.len()).collect())
    }

    /// Values that belong to the points of the path, by sample.
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

/// Normals of a path without repeated points and sharp corners, curve by curve.
struct NormalsBuilder {
    vectors: Vec<Point>,
    length: f64,
    arcs: Vec<(Range<usize>, f64)>,
    /// Whether no point repeats the previous one and no corner is sharp.
    is_regular: bool,
}

impl Default for NormalsBuilder {
    fn default() -> Self {
        Self { vectors: Vec::new(), length: 0.0, arcs: Vec::new(), is_regular: true }
    }
}

impl NormalsBuilder {
    fn push_miter(&mut self, before: Point, after: Point) {
        let together = 1.0 + before.dot(after);
        self.is_regular &= !is_sharp(together);
        self.vectors.push((before + after) / together);
    }

    /// The miters between the ends of any curve.
    fn extend(&mut self, points: &[Point]) {
        let (mut shortest, mut length, from) = (f64::INFINITY, 0.0, self.vectors.len());
        self.vectors.resize(from + points.len() - 1, Point::ORIGIN);
        // First the normals of the chords, then the miters in the same memory.
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
        self.is_regular &= shortest > REPEATED && !is_sharp(sharpest);
    }

    /// The miters between the ends of an arc.
    fn extend_round(&mut self, points: &[Point], circle: &Circle) {
        let (from, last) = (self.vectors.len(), points.len() - 1);
        self.vectors.extend(points[1..last].iter().map(circle.miter()));
        self.length += circle.chord() * last as f64;
        self.is_regular &= circle.chord() > REPEATED;
        if last > 2 {
            self.arcs.push((from..from + last - 2, circle.bend()));
        }
    }
}

/// Samples collected point by point.
#[derive(Default)]
struct Samples {
    points: Vec<Point>,
    vectors: Vec<Point>,
    sources: Vec<usize>,
}

impl Samples {
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
            let (round, each) = (OffsetNormals::of_regular(&path, ends).unwrap(), OffsetNormals::of_any(&path, ends));
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
            let normals = OffsetNormals::of(&path);
            for (segments, bend) in normals.arcs.clone() {
                for i in segments {
                    let (along, apart) =
                        (normals.points[i + 1] - normals.points[i], normals.vectors[i + 1] - normals.vectors[i]);
                    assert!((apart.dot(along) / along.dot(along) - bend).abs() < 1e-9 / along.norm());
                }
            }
        }
    }

    #[test]
    fn repeated_points_have_one_sample_and_sharp_corners_two() {
        let repeated = Path::from_points([(0, 0), (4, 0), (4, 0), (9, 0)]).unwrap();
        assert_eq!(OffsetNormals::of(&repeated).sources(), [0, 1, 3]);
        let sharp = Path::from_points([(0, 0), (9, 0), (0, 1)]).unwrap();
        assert_eq!(OffsetNormals::of(&sharp).sources(), [0, 1, 1, 2]);
    }
}
