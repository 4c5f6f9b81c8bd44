//! The curves of paths, each with its formula, its source and PHIDL's sampling.
//!
//! A path keeps its points and the curves on which they lie ([`CurveSegment`]). So it can be sampled again with other
//! points (see [`Path::with_tolerance`](crate::Path::with_tolerance)), and an arc stays an arc. The alternative, a path of
//! curves alone, would choose its points in every extrusion, and two extrusions of one path would not share vertices.

mod arc;
mod euler;
mod even_chords;
mod fresnel;
mod spiral;
mod straight;

use phidl_core::geom::{Point, Transform};
use phidl_core::num::angle;

pub(crate) use arc::Arc;
pub(crate) use euler::Euler;
pub(crate) use spiral::Arm;
pub use spiral::Spiral;

use crate::direction;
use crate::sampling::{self, ParamCurve as _};

/// The curve on which points of a path lie, in coordinates of its own.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Curve {
    /// A list of points.
    Points,
    /// A straight line with any number of points on it.
    Line,
    /// A circular arc.
    Arc(Arc),
    /// A clothoid bend.
    Euler(Euler),
    /// An arm of a spiral.
    Arm(Arm),
}

impl Curve {
    /// The fewest points strictly between the ends that keep every chord within `tolerance` of the curve, in its own
    /// coordinates; `None` if there are too many.
    fn inner_points(&self, tolerance: f64) -> Option<Vec<Point>> {
        match self {
            Self::Points | Self::Line => Some(Vec::new()),
            Self::Arc(arc) => arc.inner_points(tolerance),
            Self::Euler(euler) => {
                even_chords::inner_points(euler, tolerance).or_else(|| sampling::inner_points(euler, tolerance))
            }
            Self::Arm(arm) => sampling::inner_points(arm, tolerance),
        }
    }

    /// The directions of the start and the end (degrees); `None` for a list of points.
    fn directions(&self) -> Option<(f64, f64)> {
        match self {
            Self::Points => None,
            Self::Line => Some((0.0, 0.0)),
            Self::Arc(arc) => Some((0.0, arc.degrees())),
            Self::Euler(euler) => Some((0.0, euler.degrees())),
            Self::Arm(arm) => Some((arm.heading(0.0).to_degrees(), arm.heading(arm.span()).to_degrees())),
        }
    }
}

/// A run of points of a path on one curve: from the end of the previous segment to `end`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CurveSegment {
    /// The curve of the points.
    pub(crate) curve: Curve,
    /// From the coordinates of the curve to those of the path.
    pub(crate) place: Transform,
    /// Index of the last point.
    pub(crate) end: usize,
}

impl CurveSegment {
    pub(crate) fn new(curve: Curve, end: usize) -> Self {
        Self { curve, place: Transform::IDENTITY, end }
    }

    /// The fewest points strictly between the ends that keep the tolerance; `None` if there are too many. The points
    /// `given` are kept if the curve is a list of points.
    pub(crate) fn inner_points(&self, given: &[Point], tolerance: f64) -> Option<Vec<Point>> {
        if self.curve == Curve::Points {
            return Some(given.to_vec());
        }
        let matrix = self.place.matrix();
        let own = self.curve.inner_points(tolerance / self.place.magnification)?;
        Some(own.into_iter().map(|p| matrix.apply(p)).collect())
    }

    /// The circle on which its points lie evenly, if it is an arc of `chords` chords that are fine enough for miters.
    pub(crate) fn circle(&self, chords: usize) -> Option<Circle> {
        /// With wider chords (degrees) a miter no longer follows from the radius.
        const WIDEST: f64 = 90.0;
        let Curve::Arc(arc) = &self.curve else { return None };
        let step = arc.degrees().abs() / chords as f64;
        let to_the_left = (arc.degrees() > 0.0) != self.place.x_reflection;
        (step <= WIDEST).then(|| Circle {
            center: self.place.apply(arc.center()),
            radius: arc.radius() * self.place.magnification,
            step,
            to_the_left,
        })
    }

    /// Sum of its chords (µm).
    pub(crate) fn length(&self, points: &[Point]) -> f64 {
        let chords = points.len() - 1;
        match self.circle(chords) {
            Some(circle) => circle.chord() * chords as f64,
            None => points.windows(2).map(|segment| segment[0].distance(segment[1])).sum(),
        }
    }

    /// The same segment, transformed, behind other points of a path.
    pub(crate) fn moved(&self, points_before: usize, by: &Transform) -> Self {
        Self { curve: self.curve.clone(), place: self.place.then(by), end: self.end + points_before }
    }

    /// The directions of its start and end (degrees); `points` are its points, at least two.
    pub(crate) fn directions(&self, points: &[Point]) -> (f64, f64) {
        match (self.curve.directions(), points) {
            (Some((start, end)), _) => (self.place.apply_direction(start), self.place.apply_direction(end)),
            (None, points) => {
                let n = points.len();
                (direction::of_segment(points[0], points[1]), direction::of_segment(points[n - 2], points[n - 1]))
            }
        }
    }
}

/// A circle with evenly spaced points of a path on it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Circle {
    center: Point,
    radius: f64,
    /// Angle between neighboring points (degrees).
    step: f64,
    to_the_left: bool,
}

impl Circle {
    /// Distance between neighboring points (µm).
    pub(crate) fn chord(&self) -> f64 {
        2.0 * self.radius * angle::sin_cos(self.step / 2.0).0
    }

    /// The relative growth in length of a parallel per micrometer to the right: the curvature of the chords.
    pub(crate) fn bend(&self) -> f64 {
        let bend = 1.0 / (self.radius * angle::sin_cos(self.step / 2.0).1);
        if self.to_the_left { bend } else { -bend }
    }

    /// The miter at one of the points: along the radius, with the length that the chords require.
    pub(crate) fn miter(&self) -> impl Fn(&Point) -> Point + use<> {
        let (center, bend) = (self.center, self.bend());
        move |p| (*p - center) * bend
    }
}

#[cfg(test)]
impl Curve {
    pub(crate) fn arm(&self) -> Option<&Arm> {
        match self {
            Self::Arm(arm) => Some(arm),
            _ => None,
        }
    }
}
