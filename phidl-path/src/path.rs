//! [`Path`]: a centerline.
//!
//! A path is a list of points with a direction at each end, and a list of the curves on which the points lie. The points
//! are measured, hashed and extruded; the curves serve to draw the same path with other points.

use std::collections::BTreeMap;

use phidl_core::error::{Error, Result};
use phidl_core::geom::{Outline, Point, Rect, Transform};
use phidl_core::num::{angle, count};
use phidl_core::param::Value;
use phidl_core::place::{Bounded, DeferredError, Transformable};

use crate::curve::{Curve, CurveSegment};
use crate::sampling::MOST_CHORDS;
use crate::{Piece, direction, rule};

/// A centerline: points from a start to an end, with a direction at both.
///
/// ```
/// # use phidl_path::Path;
/// # use phidl_core::prelude::*;
/// let mut path = Path::arc(10, 90)?;
/// path.append(Path::straight(10)?).append(Path::euler(3, -90)?);
/// path.movey(10).set_xmin(20);
/// assert_eq!((path.start(), path.end_angle()), (Point::new(20.0, 10.0), 0.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// It moves, rotates and mirrors with the methods of [`Movable`](phidl_core::place::Movable), and is drawn when it is
/// [extruded](Path::extrude).
///
/// # Deferred errors
/// Methods that chain do not fail. The first invalid value (a point that is not finite, a piece of one point) is kept in
/// the path and returned by the next fallible call, at the latest by the extrusion.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    points: Vec<Point>,
    /// Directions of the ends (degrees), not normalized to one turn: the geometry hash takes their bits.
    start_angle: f64,
    end_angle: f64,
    /// The curves on which the points lie, from start to end; none for a path of one point.
    segments: Vec<CurveSegment>,
    info: BTreeMap<String, Value>,
    deferred: Option<Box<Error>>,
}

/// Smallest accepted tolerance (µm): below any lithographic resolution.
const FINEST_TOLERANCE: f64 = 1e-6;

impl Path {
    /// A path of one point, the origin, heading right, to which pieces are appended.
    #[must_use]
    pub fn new() -> Self {
        Self::from_curve(vec![Point::ORIGIN], Vec::new(), 0.0, 0.0)
    }

    /// A path through points (pairs or two coordinate lists). Its ends have the directions of the first and the last
    /// segment.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let path = Path::from_points([(1, 0), (1, 5), (5, 7)])?;
    /// assert_eq!(path.start_angle(), 90.0);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Custom`] if there are fewer than two points, [`Error::Param`] if one is not finite.
    pub fn from_points(points: impl Outline) -> Result<Self> {
        let points = points.into_points();
        if let Some((i, p)) = points.iter().enumerate().find(|(_, p)| !p.is_finite()) {
            return Err(rule::refused("path", &format!("points[{i}]"), p, "be finite"));
        }
        let ([first, second, ..], [.., before, last]) = (&points[..], &points[..]) else {
            let given = if points.len() == 1 { "1 point is" } else { "no points are" };
            return Err(Error::custom("path", format!("a path needs at least 2 points, but {given} given")));
        };
        let (start, end) = (direction::of_segment(*first, *second), direction::of_segment(*before, *last));
        let part = CurveSegment::new(Curve::Points, points.len() - 1);
        Ok(Self::from_curve(points, vec![part], start, end))
    }

    /// The pieces one after another, from the origin to the right: a blank path to which they are appended.
    #[must_use]
    pub fn of(pieces: impl Piece) -> Self {
        let mut path = Self::new();
        path.append(pieces);
        path
    }

    pub(crate) fn from_curve(
        points: Vec<Point>,
        segments: Vec<CurveSegment>,
        start_angle: f64,
        end_angle: f64,
    ) -> Self {
        Self { points, start_angle, end_angle, segments, info: BTreeMap::new(), deferred: None }
    }

    /// Appends a piece, or several in a list. Each is rotated until its start has the direction of this path's end, and
    /// moved there.
    ///
    /// Points are a piece too, and are rotated and moved like any other. The info of a piece is not copied.
    pub fn append(&mut self, pieces: impl Piece) -> &mut Self {
        pieces.append_to(self);
        self
    }

    pub(crate) fn append_path(&mut self, piece: &Self) {
        if let Some(deferred) = &piece.deferred {
            return self.defer((**deferred).clone());
        }
        let (first, joint) = (piece.points[0], self.end());
        let turn = Transform::rotation(self.end_angle - piece.start_angle);
        let by = Transform { origin: joint - turn.apply(first), ..turn };
        let (matrix, before) = (by.matrix(), self.points.len() - 1);
        self.points.extend(piece.points.iter().skip(1).map(|p| matrix.apply(*p)));
        self.segments.extend(piece.segments.iter().map(|segment| segment.moved(before, &by)));
        self.end_angle = direction::within_turn(piece.end_angle + self.end_angle - piece.start_angle);
    }

    /// The points, in order; at least one.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The first point.
    #[must_use]
    pub fn start(&self) -> Point {
        self.points[0]
    }

    /// The last point.
    #[must_use]
    pub fn end(&self) -> Point {
        self.points[self.points.len() - 1]
    }

    /// Direction in which the path starts (degrees, in `[0, 360)`).
    #[must_use]
    pub fn start_angle(&self) -> f64 {
        angle::normalized(self.start_angle)
    }

    /// Direction in which the path ends (degrees, in `[0, 360)`).
    #[must_use]
    pub fn end_angle(&self) -> f64 {
        angle::normalized(self.end_angle)
    }

    /// Sets the direction of the start (degrees): the face of an extrusion turns with it.
    pub fn set_start_angle(&mut self, degrees: impl Into<f64>) -> &mut Self {
        let degrees = degrees.into();
        self.check_finite("start_angle", degrees);
        self.start_angle = degrees;
        self
    }

    /// Sets the direction of the end (degrees): the next piece starts in it.
    pub fn set_end_angle(&mut self, degrees: impl Into<f64>) -> &mut Self {
        let degrees = degrees.into();
        self.check_finite("end_angle", degrees);
        self.end_angle = degrees;
        self
    }

    /// Turns the direction of the end (degrees, to the left if positive): a corner before the next piece.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let mut path = Path::line(10)?;
    /// path.turn(90).append(Path::line(5)?);
    /// assert_eq!(path.end(), (10, 5).into());
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    pub fn turn(&mut self, degrees: impl Into<f64>) -> &mut Self {
        self.set_end_angle(self.end_angle + degrees.into())
    }

    /// The info recorded on the path; an extrusion copies it.
    #[must_use]
    pub fn info(&self) -> &BTreeMap<String, Value> {
        &self.info
    }

    /// Records an info entry.
    pub fn set_info(&mut self, key: impl Into<String>, value: impl Into<Value>) -> &mut Self {
        self.info.insert(key.into(), value.into());
        self
    }

    /// The length (µm): the sum over the chords between its points.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segments_with_points().map(|(segment, points)| segment.length(points)).sum()
    }

    /// The curve segments, each with its points, both ends included.
    pub(crate) fn segments_with_points(&self) -> impl Iterator<Item = (&CurveSegment, &[Point])> {
        let mut from = 0;
        self.segments
            .iter()
            .map(move |segment| (segment, &self.points[std::mem::replace(&mut from, segment.end)..=segment.end]))
    }

    /// The pieces of which it was made (bends and straights, for instance), at their positions.
    #[must_use]
    pub fn pieces(&self) -> Vec<Self> {
        let piece = |(segment, points): (&CurveSegment, &[Point])| {
            let (start, end) = segment.directions(points);
            let part = CurveSegment { end: points.len() - 1, ..segment.clone() };
            Self::from_curve(points.to_vec(), vec![part], start, end)
        };
        self.segments_with_points().map(piece).collect()
    }

    /// The same path with the fewest points that keep every chord within `tolerance` (µm) of its curve.
    ///
    /// Arcs, Euler bends, spirals and straight pieces get new points. Points that were given as points, and those of an
    /// offset path, are kept. No chord spans more than a third of a turn.
    ///
    /// ```
    /// # use phidl_path::{EulerBend, Path};
    /// let path = Path::arc(10, 90)?.with_tolerance(0.001)?;
    /// assert_eq!(path.points().len(), 57); // instead of 180
    /// // A bend that is resampled anyway needs few points before.
    /// let bend = EulerBend::new().num_pts(1).path(10, 90)?.with_tolerance(0.001)?;
    /// assert_eq!(bend, Path::euler(10, 90)?.with_tolerance(0.001)?);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`] unless the tolerance is at least 1e-6 µm and finite, and needs at most about a million chords on each
    /// piece and [`count::MOST`] points in all; and the deferred error.
    pub fn with_tolerance(&self, tolerance: impl Into<f64>) -> Result<Self> {
        let tolerance = tolerance.into();
        self.check()?;
        if !(FINEST_TOLERANCE..f64::INFINITY).contains(&tolerance) {
            let rule = format!("be at least {FINEST_TOLERANCE} µm and finite");
            return Err(rule::refused("with_tolerance", "tolerance", format!("{tolerance} µm"), rule));
        }
        let mut path = Self { points: vec![self.start()], segments: Vec::new(), ..self.clone() };
        for (segment, points) in self.segments_with_points() {
            let too_fine = |rule: String| rule::refused("with_tolerance", "tolerance", format!("{tolerance} µm"), rule);
            let between = segment.inner_points(&points[1..points.len() - 1], tolerance);
            let between = between
                .ok_or_else(|| too_fine(format!("be large enough for at most {MOST_CHORDS} chords on each piece")))?;
            if path.points.len() + between.len() >= count::MOST {
                return Err(too_fine(format!("be large enough for at most {} points in all", count::MOST)));
            }
            path.points.extend(between);
            path.points.push(self.points[segment.end]);
            path.segments.push(CurveSegment { end: path.points.len() - 1, ..segment.clone() });
        }
        Ok(path)
    }

    /// Returns the deferred error.
    pub(crate) fn check(&self) -> Result<()> {
        match &self.deferred {
            Some(deferred) => Err((**deferred).clone()),
            None => Ok(()),
        }
    }

    /// Refuses a path of one point.
    pub(crate) fn check_line(&self, what: &str) -> Result<()> {
        self.check()?;
        match self.points.len() {
            1 => Err(Error::custom(what, "the path has 1 point, but needs at least 2")),
            _ => Ok(()),
        }
    }

    /// Keeps the first error of a chain.
    pub(crate) fn defer(&mut self, error: Error) {
        self.deferred.get_or_insert(Box::new(error));
    }

    fn check_finite(&mut self, what: &str, degrees: f64) {
        if !degrees.is_finite() {
            self.defer(rule::refused("path", what, format!("{degrees}°"), "be finite"));
        }
    }

    pub(crate) fn segments(&self) -> &[CurveSegment] {
        &self.segments
    }

    /// The directions of the ends, not normalized.
    pub(crate) fn raw_angles(&self) -> (f64, f64) {
        (self.start_angle, self.end_angle)
    }
}

impl Default for Path {
    fn default() -> Self {
        Self::new()
    }
}

impl<P: Piece> std::ops::Add<P> for Path {
    type Output = Self;
    /// The path with a piece appended.
    fn add(mut self, piece: P) -> Self {
        self.append(piece);
        self
    }
}

impl Bounded for Path {
    /// The box around the points.
    fn bbox(&self) -> Option<Rect> {
        Rect::around(self.points.iter().copied())
    }
}

impl Transformable for Path {
    fn transform_mut(&mut self, by: &Transform) {
        self.move_points(by);
        self.start_angle = by.apply_direction(self.start_angle);
        self.end_angle = by.apply_direction(self.end_angle);
    }

    fn rotate_mut(&mut self, degrees: f64, center: Point) {
        if degrees != 0.0 {
            self.move_points(&Transform::rotation_about(degrees, center));
            self.start_angle = direction::within_turn(self.start_angle + degrees);
            self.end_angle = direction::within_turn(self.end_angle + degrees);
        }
    }

    fn mirror_mut(&mut self, p1: Point, p2: Point) {
        self.move_points(&Transform::reflection(p1, p2));
        let twice = 2.0 * direction::of_mirror_line(p1, p2);
        self.start_angle = direction::within_turn(twice - self.start_angle);
        self.end_angle = direction::within_turn(twice - self.end_angle);
    }

    fn defer(&mut self, deferred: DeferredError) {
        self.defer(deferred.into_error("path", "the path"));
    }
}

impl Path {
    fn move_points(&mut self, by: &Transform) {
        let matrix = by.matrix();
        self.points.iter_mut().for_each(|p| *p = matrix.apply(*p));
        self.segments.iter_mut().for_each(|segment| segment.place = segment.place.then(by));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PathPoint, Spiral};
    use phidl_core::place::Movable as _;

    #[test]
    fn appended_points_are_rotated_into_the_direction_of_the_path() {
        let mut path = Path::new();
        path.append([(1, 0), (1, 5), (5, 7)]);
        let expected = [(0., 0.), (5., 0.), (7., -4.)];
        assert!(path.points().iter().zip(expected).all(|(p, q)| p.distance(q.into()) < 1e-12));
        assert!((path.end_angle() - 296.565_051).abs() < 1e-6);
    }

    #[test]
    fn appending_does_not_change_the_piece() {
        let mut path = Path::of([(0, 0), (5, 0)]);
        let piece = Path::from_points([(0, 0), (3, 0)]).unwrap();
        path.append(&piece);
        assert_eq!(piece.end(), Point::new(3.0, 0.0));
        assert_eq!(path.end(), Point::new(8.0, 0.0));
    }

    #[test]
    fn turns_between_pieces_draw_the_path_of_the_reference() {
        let mut path = Path::new();
        path.append(Path::line(10).unwrap()).turn(90).append(Path::line(10).unwrap()).turn(-135);
        path.append(Path::line(15).unwrap()).set_end_angle(0).append(Path::line(10).unwrap());
        assert_eq!(path.hash_geometry(1e-4).unwrap(), "4b50341ff845d892a558dd80aa7ae67d4f2bdc64");
    }

    #[test]
    fn the_first_invalid_value_is_the_error_of_the_next_fallible_call() {
        let mut path = Path::new();
        path.append([(0, 0), (9, 0)]).rotate(f64::NAN).append([(0, 0)]).set_end_angle(f64::INFINITY);
        let error = path.extrude_width(1, 0).unwrap_err();
        assert!(["path:", "rotate", "NaN"].iter().all(|part| error.to_string().contains(part)), "{error}");
        assert_eq!(Path::new().append(&path).hash_geometry(1e-4).unwrap_err(), error);
        assert!(Path::from_points([(0.0, 0.0), (f64::NAN, 1.0)]).is_err());
        assert!(Path::from_points([(0, 0)]).is_err());
    }

    #[test]
    fn a_transformed_path_can_be_resampled() {
        let spiral = Spiral { num_turns: 3.0, gap: 2.0, inner_gap: 5.0, num_pts: 1000.0 }.path().unwrap();
        let mut path = Path::of([Path::straight(4).unwrap(), Path::euler(6, -70).unwrap(), Path::arc(5, 200).unwrap()]);
        path.append(&spiral).append([(0, 0), (1, 1), (2, 0)]).rotate(33).mirror((0, 0), (1, 3)).scale(1.5);
        let fine = path.with_tolerance(1e-4).unwrap();
        let coarse = fine.with_tolerance(0.01).unwrap();
        for drawn in [&fine, &coarse] {
            assert_eq!((drawn.start(), drawn.end()), (path.start(), path.end()));
            assert_eq!((drawn.start_angle(), drawn.end_angle()), (path.start_angle(), path.end_angle()));
            // The spiral was drawn with few points, which make it shorter by about its chords' share.
            assert!((drawn.length() / path.length() - 1.0).abs() < 1e-3);
        }
        assert!(coarse.points().len() < fine.points().len() / 5);
        assert_eq!(coarse.with_tolerance(1e-4).unwrap().points().len(), fine.points().len());
        // All pieces still meet: a wrong joint would leave a jump as long as a piece.
        let longest = fine.points().windows(2).skip(1).map(|s| s[0].distance(s[1])).fold(0.0, f64::max);
        assert!(longest < 3.0, "{longest}");
    }

    #[test]
    fn a_tolerance_that_needs_too_many_points_is_refused() {
        let path = Path::euler(1000, 90).unwrap();
        assert!(path.with_tolerance(0).is_err() && path.with_tolerance(1e-300).is_err());
        assert!(path.with_tolerance(f64::NAN).is_err());
        for huge in [Path::euler(1e12, 90), Path::arc(1e12, 90)] {
            let error = huge.unwrap().with_tolerance(1e-6).unwrap_err();
            assert!(error.to_string().ends_with("be large enough for at most 1048576 chords on each piece"));
        }
    }

    #[test]
    fn a_path_point_converts_to_its_position() {
        let path = Path::line(4).unwrap();
        let sample: PathPoint = path.interpolate([2], 0).unwrap()[0];
        assert_eq!(Point::from(sample), Point::new(2.0, 0.0));
    }
}
