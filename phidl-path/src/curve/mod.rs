//! The curves that paths are made of, each with its formula, its source and the specification's sampling.
//!
//! A path keeps beside its points what each stretch of them is ([`Part`]): so it can be drawn anew with other points
//! (see [`Path::with_tolerance`](crate::Path::with_tolerance)), and an arc stays an arc. The alternative, a path made of
//! curves alone, would have to choose points anew in every extrusion, and two extrusions of one path would not share
//! their vertices.

mod arc;
mod euler;
mod even_chords;
mod fresnel;
mod spiral;
mod straight;

use phidl_core::geom::{Point, Transform};
use phidl_core::num::angle;

pub(crate) use arc::{Arc, WIDEST_CHORD};
pub(crate) use euler::Euler;
pub(crate) use spiral::Arm;
pub use spiral::Spiral;

use crate::direction;
use crate::sampling::{self, Turning as _};

/// What a stretch of a path's points lies on, in coordinates of its own.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Curve {
    /// Nothing but its points.
    Points,
    /// A straight line, whatever number of points is on it.
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
    /// coordinates; nothing if that is too many. A list of points has none but its own.
    fn between_ends(&self, tolerance: f64) -> Option<Vec<Point>> {
        match self {
            Self::Points | Self::Line => Some(Vec::new()),
            Self::Arc(arc) => arc.between_ends(tolerance),
            Self::Euler(euler) => euler.between_ends(tolerance),
            Self::Arm(arm) => sampling::between_ends(arm, tolerance),
        }
    }

    /// The directions in which the curve starts and ends (degrees), if it says so itself.
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

/// A stretch of a path's points: from the end of the part before to `end`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Part {
    /// What the points lie on.
    pub(crate) curve: Curve,
    /// Where the curve is.
    pub(crate) place: Transform,
    /// Number of the last point.
    pub(crate) end: usize,
}

impl Part {
    pub(crate) fn new(curve: Curve, end: usize) -> Self {
        Self { curve, place: Transform::IDENTITY, end }
    }

    /// The fewest points strictly between the ends that keep the tolerance; those that are `given` stay if the part is
    /// nothing but its points. Nothing if that is too many.
    pub(crate) fn between_ends(&self, given: &[Point], tolerance: f64) -> Option<Vec<Point>> {
        if self.curve == Curve::Points {
            return Some(given.to_vec());
        }
        let matrix = self.place.matrix();
        let own = self.curve.between_ends(tolerance / self.place.magnification)?;
        Some(own.into_iter().map(|p| matrix.apply(p)).collect())
    }

    /// The circle on which its points lie evenly, if it is an arc of `chords` chords that are not too coarse for a miter.
    pub(crate) fn circle(&self, chords: usize) -> Option<Circle> {
        /// With wider chords (degrees) a miter is no matter of a radius any more.
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

    /// Sum of its chords (µm); `points` are its points.
    pub(crate) fn length(&self, points: &[Point]) -> f64 {
        let chords = points.len() - 1;
        match self.circle(chords) {
            Some(circle) => circle.chord() * chords as f64,
            None => points.windows(2).map(|segment| segment[0].distance(segment[1])).sum(),
        }
    }

    /// The same part further on in a path, put through a transform.
    pub(crate) fn moved(&self, points_before: usize, by: &Transform) -> Self {
        Self { curve: self.curve.clone(), place: self.place.then(by), end: self.end + points_before }
    }

    /// The directions in which the stretch starts and ends (degrees); `points` are its points, at least two.
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

/// What evenly spaced points of a path lie on.
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

    /// By how much longer per micrometer a parallel to the right is: the curvature of the chords.
    pub(crate) fn bend(&self) -> f64 {
        let bend = 1.0 / (self.radius * angle::sin_cos(self.step / 2.0).1);
        if self.to_the_left { bend } else { -bend }
    }

    /// The miter at one of the points: along the radius, as long as the chords call for.
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
