//! The curves that paths are made of, each with its formula, its source and the specification's sampling.
//!
//! A path keeps beside its points what each stretch of them is ([`Part`]): so it can be drawn anew with other points
//! (see [`Path::with_tolerance`](crate::Path::with_tolerance)), and an arc stays an arc. The alternative, a path made of
//! curves alone, would have to choose points anew in every extrusion, and two extrusions of one path would not share
//! their vertices.

mod arc;
mod euler;
mod spiral;
mod straight;

use phidl_core::geom::{Point, Transform};

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
            Self::Euler(euler) => sampling::between_ends(euler, tolerance),
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

#[cfg(test)]
impl Curve {
    pub(crate) fn arm(&self) -> Option<&Arm> {
        match self {
            Self::Arm(arm) => Some(arm),
            _ => None,
        }
    }
}
