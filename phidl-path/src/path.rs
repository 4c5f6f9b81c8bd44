//! [`Path`]: a centerline.
//!
//! A path is a list of points with a direction at each end, and beside it what curve each stretch of points lies on. The
//! points are what is measured, hashed and extruded; the curves are there to draw the same path with other points.

use std::collections::BTreeMap;

use phidl_core::error::{Error, Result};
use phidl_core::geom::{Outline, Point, Rect, Transform};
use phidl_core::num::angle;
use phidl_core::param::Value;
use phidl_core::place::{Bounded, DeferredError, Transformable};

use crate::curve::{Curve, Part};
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
/// It moves, turns and mirrors with the words of [`Movable`](phidl_core::place::Movable). It is not drawn until it is
/// [extruded](Path::extrude).
///
/// # Bad values
/// Words that chain do not fail. The first bad value (a point that is not finite, a piece of one point) is kept and
/// comes back as the error of the next fallible call, at the latest of the extrusion.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    points: Vec<Point>,
    /// Directions of the ends in degrees, not brought within one turn: the geometry hash takes their bits.
    start_angle: f64,
    end_angle: f64,
    /// What the points lie on; they cover all of them, except that a path of one point has none.
    parts: Vec<Part>,
    info: BTreeMap<String, Value>,
    fault: Option<Box<Error>>,
}

/// No process sees less than this (µm), and a smaller tolerance asks for more points than there is memory.
const FINEST_TOLERANCE: f64 = 1e-6;

impl Path {
    /// A path of one point, the origin, heading right: what pieces are appended to.
    #[must_use]
    pub fn new() -> Self {
        Self::from_curve(vec![Point::ORIGIN], Vec::new(), 0.0, 0.0)
    }

    /// A path through points (pairs or two coordinate lists), at the places where they are. Its ends have the
    /// directions of the first and the last segment.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let path = Path::from_points([(1, 0), (1, 5), (5, 7)])?;
    /// assert_eq!(path.start_angle(), 90.0);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`] if there are fewer than two points, or one is not finite.
    pub fn from_points(points: impl Outline) -> Result<Self> {
        let points = points.into_points();
        if let Some((i, p)) = points.iter().enumerate().find(|(_, p)| !p.is_finite()) {
            return Err(rule::refused("path", &format!("points[{i}]"), p, "be finite"));
        }
        let ([first, second, ..], [.., before, last]) = (&points[..], &points[..]) else {
            let given = if points.len() == 1 { "1 point" } else { "no points" };
            return Err(rule::refused("path", "points", given, "be at least 2 points"));
        };
        let (start, end) = (direction::of_segment(*first, *second), direction::of_segment(*before, *last));
        let part = Part::new(Curve::Points, points.len() - 1);
        Ok(Self::from_curve(points, vec![part], start, end))
    }

    /// The pieces one after the other, from the origin to the right: a blank path to which they are appended.
    #[must_use]
    pub fn of(pieces: impl Piece) -> Self {
        let mut path = Self::new();
        path.append(pieces);
        path
    }

    pub(crate) fn from_curve(points: Vec<Point>, parts: Vec<Part>, start_angle: f64, end_angle: f64) -> Self {
        Self { points, start_angle, end_angle, parts, info: BTreeMap::new(), fault: None }
    }

    /// Appends a piece, or several in a list: each is turned until it starts in the direction in which this path ends,
    /// and moved to its end.
    ///
    /// Points are a piece too, and are turned and moved like any other. The info of a piece is not taken over.
    pub fn append(&mut self, pieces: impl Piece) -> &mut Self {
        pieces.append_to(self);
        self
    }

    pub(crate) fn append_path(&mut self, piece: &Self) {
        if let Some(fault) = &piece.fault {
            return self.keep((**fault).clone());
        }
        let (first, joint) = (piece.points[0], self.end());
        let turn = Transform::rotation(self.end_angle - piece.start_angle);
        let by = Transform { origin: joint - turn.apply(first), ..turn };
        let (matrix, before) = (by.matrix(), self.points.len() - 1);
        self.points.extend(piece.points.iter().skip(1).map(|p| matrix.apply(*p)));
        self.parts.extend(piece.parts.iter().map(|part| part.moved(before, &by)));
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

    /// Makes the path start in another direction (degrees): the face of an extrusion turns with it.
    pub fn set_start_angle(&mut self, degrees: impl Into<f64>) -> &mut Self {
        let degrees = degrees.into();
        self.keep_finite("start_angle", degrees);
        self.start_angle = degrees;
        self
    }

    /// Makes the path end in another direction (degrees): the next piece goes there.
    pub fn set_end_angle(&mut self, degrees: impl Into<f64>) -> &mut Self {
        let degrees = degrees.into();
        self.keep_finite("end_angle", degrees);
        self.end_angle = degrees;
        self
    }

    /// Turns the direction in which the path ends (degrees, to the left if positive): a corner before the next piece.
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

    /// What was recorded about the path; an extrusion takes it over.
    #[must_use]
    pub fn info(&self) -> &BTreeMap<String, Value> {
        &self.info
    }

    /// Records something about the path.
    pub fn set_info(&mut self, key: impl Into<String>, value: impl Into<Value>) -> &mut Self {
        self.info.insert(key.into(), value.into());
        self
    }

    /// Its length: the sum over all segments (µm).
    #[must_use]
    pub fn length(&self) -> f64 {
        self.stretches().map(|(part, points)| part.length(points)).sum()
    }

    /// Its parts, each with its points; both ends of a part are its own.
    pub(crate) fn stretches(&self) -> impl Iterator<Item = (&Part, &[Point])> {
        let mut from = 0;
        self.parts.iter().map(move |part| (part, &self.points[std::mem::replace(&mut from, part.end)..=part.end]))
    }

    /// The stretches of which it was made (bends and straights, say), each where it is.
    #[must_use]
    pub fn pieces(&self) -> Vec<Self> {
        let piece = |(part, points): (&Part, &[Point])| {
            let (start, end) = part.directions(points);
            let part = Part { end: points.len() - 1, ..part.clone() };
            Self::from_curve(points.to_vec(), vec![part], start, end)
        };
        self.stretches().map(piece).collect()
    }

    /// The same path with the fewest points that keep every chord within `tolerance` (µm) of its curve.
    ///
    /// Arcs, Euler bends, spirals and straight pieces get new points; points that were given as points stay, and so do
    /// those of an offset path. No chord spans more than a third of a turn.
    ///
    /// ```
    /// # use phidl_path::{EulerBend, Path};
    /// let path = Path::arc(10, 90)?.with_tolerance(0.001)?;
    /// assert_eq!(path.points().len(), 57); // instead of 180
    /// // A bend that is drawn for this only need not have many points before.
    /// let bend = EulerBend::new().num_pts(1).path(10, 90)?.with_tolerance(0.001)?;
    /// assert_eq!(bend, Path::euler(10, 90)?.with_tolerance(0.001)?);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Param`] unless the tolerance is at least 1e-6 µm, finite, and enough for about a million chords on each
    /// piece; and what was kept before.
    pub fn with_tolerance(&self, tolerance: impl Into<f64>) -> Result<Self> {
        let tolerance = tolerance.into();
        self.check()?;
        if !(FINEST_TOLERANCE..f64::INFINITY).contains(&tolerance) {
            let rule = format!("be at least {FINEST_TOLERANCE} µm and finite");
            return Err(rule::refused("with_tolerance", "tolerance", format!("{tolerance} µm"), rule));
        }
        let mut path = Self { points: vec![self.start()], parts: Vec::new(), ..self.clone() };
        for (part, points) in self.stretches() {
            let between = part.between_ends(&points[1..points.len() - 1], tolerance).ok_or_else(|| {
                let rule = format!("be enough for at most {MOST_CHORDS} chords on a piece");
                rule::refused("with_tolerance", "tolerance", format!("{tolerance} µm"), rule)
            })?;
            path.points.extend(between);
            path.points.push(self.points[part.end]);
            path.parts.push(Part { end: path.points.len() - 1, ..part.clone() });
        }
        Ok(path)
    }

    /// The error that was kept, if any.
    pub(crate) fn check(&self) -> Result<()> {
        match &self.fault {
            Some(fault) => Err((**fault).clone()),
            None => Ok(()),
        }
    }

    /// Refuses a path that leads nowhere.
    pub(crate) fn check_line(&self, what: &str) -> Result<()> {
        self.check()?;
        match self.points.len() {
            1 => Err(rule::refused(what, "path", "1 point", "have at least 2 points")),
            _ => Ok(()),
        }
    }

    pub(crate) fn keep(&mut self, error: Error) {
        self.fault.get_or_insert(Box::new(error));
    }

    fn keep_finite(&mut self, what: &str, degrees: f64) {
        if !degrees.is_finite() {
            self.keep(rule::refused("path", what, format!("{degrees}°"), "be finite"));
        }
    }

    pub(crate) fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The directions of the ends as they are kept.
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

    fn refuse(&mut self, fault: DeferredError) {
        self.keep(fault.into_error("path", "the path"));
    }
}

impl Path {
    fn move_points(&mut self, by: &Transform) {
        let matrix = by.matrix();
        self.points.iter_mut().for_each(|p| *p = matrix.apply(*p));
        self.parts.iter_mut().for_each(|part| part.place = part.place.then(by));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Spiral, Station};
    use phidl_core::place::Movable as _;

    #[test]
    fn appended_points_are_turned_into_the_direction_of_the_path() {
        let mut path = Path::new();
        path.append([(1, 0), (1, 5), (5, 7)]);
        let expected = [(0., 0.), (5., 0.), (7., -4.)];
        assert!(path.points().iter().zip(expected).all(|(p, q)| p.distance(q.into()) < 1e-12));
        assert!((path.end_angle() - 296.565_051).abs() < 1e-6);
    }

    #[test]
    fn appending_leaves_the_piece_as_it_was() {
        let mut path = Path::of([(0, 0), (5, 0)]);
        let piece = Path::from_points([(0, 0), (3, 0)]).unwrap();
        path.append(&piece);
        assert_eq!(piece.end(), Point::new(3.0, 0.0));
        assert_eq!(path.end(), Point::new(8.0, 0.0));
    }

    #[test]
    fn turning_and_walking_draws_the_path_of_the_specification() {
        let mut path = Path::new();
        path.append(Path::line(10).unwrap()).turn(90).append(Path::line(10).unwrap()).turn(-135);
        path.append(Path::line(15).unwrap()).set_end_angle(0).append(Path::line(10).unwrap());
        assert_eq!(path.hash_geometry(1e-4).unwrap(), "4b50341ff845d892a558dd80aa7ae67d4f2bdc64");
    }

    #[test]
    fn the_first_bad_value_comes_back_from_what_can_fail() {
        let mut path = Path::new();
        path.append([(0, 0), (9, 0)]).rotate(f64::NAN).append([(0, 0)]).set_end_angle(f64::INFINITY);
        let error = path.extrude_width(1, 0).unwrap_err();
        assert_eq!(error.to_string(), "path: rotate of the path is NaN, but it must be finite");
        assert_eq!(Path::new().append(&path).hash_geometry(1e-4).unwrap_err(), error);
        assert!(Path::from_points([(0.0, 0.0), (f64::NAN, 1.0)]).is_err());
        assert!(Path::from_points([(0, 0)]).is_err());
    }

    #[test]
    fn a_path_can_be_drawn_anew_with_other_points_wherever_it_is() {
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
        // All pieces still meet: a joint that went wrong would leave a jump as long as a piece.
        let longest = fine.points().windows(2).skip(1).map(|s| s[0].distance(s[1])).fold(0.0, f64::max);
        assert!(longest < 3.0, "{longest}");
    }

    #[test]
    fn a_tolerance_that_asks_for_all_memory_is_refused() {
        let path = Path::euler(1000, 90).unwrap();
        assert!(path.with_tolerance(0).is_err() && path.with_tolerance(1e-300).is_err());
        assert!(path.with_tolerance(f64::NAN).is_err());
        for huge in [Path::euler(1e12, 90), Path::arc(1e12, 90)] {
            let error = huge.unwrap().with_tolerance(1e-6).unwrap_err();
            assert!(error.to_string().ends_with("be enough for at most 1048576 chords on a piece"));
        }
    }

    #[test]
    fn a_place_on_the_path_is_a_point() {
        let path = Path::line(4).unwrap();
        let station: Station = path.interpolate([2], 0).unwrap()[0];
        assert_eq!(Point::from(station), Point::new(2.0, 0.0));
    }
}
