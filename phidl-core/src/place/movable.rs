//! [`Movable`]: the placement words.

use super::{Bounded, DeferredError, Refusal, Transformable};
use crate::geom::{Point, Rect, Transform};

/// Moves, turns, mirrors and relates things. Lengths in µm, angles in degrees counter-clockwise.
///
/// Each verb changes in place and chains; its participle (`rotated`) returns the changed thing. A setter moves the
/// thing until the edge or the center is where it was asked to be.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut outline = Polygon::new([(0, 0), (4, 0), (4, 2), (0, 2)], 1);
/// outline.rotate(90).set_xmin(10).set_y(0);
/// assert_eq!(outline.center(), Point::new(11.0, 0.0));
/// assert_eq!(outline.clone().moved_by((1, 0)).xmin(), 11.0);
/// ```
///
/// # Bad values
/// A number that is not finite, a mirror line of one point, or a setter on something empty changes nothing: the first
/// such fault is kept and comes back as the error of the next fallible call (adding the thing to a cell, `build`).
///
/// # Empty things
/// [`Bounded::bbox`] is `None`, and its readers (`x`, `xmin`, `size` …) give NaN, which no setter takes.
pub trait Movable: Transformable + Bounded {
    /// Moves by a vector.
    fn move_by(&mut self, by: impl Into<Point>) -> &mut Self {
        let by = by.into();
        match finite_point("move_by", by) {
            Ok(()) => self.transform_mut(&Transform::translation(by)),
            Err(fault) => self.refuse(fault),
        }
        self
    }

    /// Moves such that `origin`, a place anywhere, comes to `destination`.
    fn move_to(&mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> &mut Self {
        let by = destination.into() - origin.into();
        match finite_point("move_to", by) {
            Ok(()) => self.transform_mut(&Transform::translation(by)),
            Err(fault) => self.refuse(fault),
        }
        self
    }

    /// Moves to the right.
    fn movex(&mut self, by: impl Into<f64>) -> &mut Self {
        self.move_by((by, 0))
    }

    /// Moves up.
    fn movey(&mut self, by: impl Into<f64>) -> &mut Self {
        self.move_by((0, by))
    }

    /// Turns about the origin.
    fn rotate(&mut self, degrees: impl Into<f64>) -> &mut Self {
        self.rotate_about(degrees, Point::ORIGIN)
    }

    /// Turns about a point.
    fn rotate_about(&mut self, degrees: impl Into<f64>, center: impl Into<Point>) -> &mut Self {
        let (degrees, center) = (degrees.into(), center.into());
        match finite("rotate", degrees).and(finite_point("rotate", center)) {
            Ok(()) => self.rotate_mut(degrees, center),
            Err(fault) => self.refuse(fault),
        }
        self
    }

    /// Mirrors at the line through two points.
    fn mirror(&mut self, p1: impl Into<Point>, p2: impl Into<Point>) -> &mut Self {
        let (p1, p2) = (p1.into(), p2.into());
        let line = match p1 == p2 {
            true => Err(DeferredError { word: "mirror", refusal: Refusal::LineOfOnePoint(p1) }),
            false => Ok(()),
        };
        match finite_point("mirror", p1).and(finite_point("mirror", p2)).and(line) {
            Ok(()) => self.mirror_mut(p1, p2),
            Err(fault) => self.refuse(fault),
        }
        self
    }

    /// Scales all lengths about the origin; the factor is positive.
    fn scale(&mut self, factor: impl Into<f64>) -> &mut Self {
        let factor = factor.into();
        let positive = match factor <= 0.0 {
            true => Err(DeferredError { word: "scale", refusal: Refusal::FactorNotPositive(factor) }),
            false => Ok(()),
        };
        match finite("scale", factor).and(positive) {
            Ok(()) => self.transform_mut(&Transform::scaling(factor)),
            Err(fault) => self.refuse(fault),
        }
        self
    }

    /// The thing moved by a vector.
    #[must_use]
    fn moved_by(mut self, by: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.move_by(by);
        self
    }

    /// The thing moved such that `origin` comes to `destination`.
    #[must_use]
    fn moved_to(mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.move_to(origin, destination);
        self
    }

    /// The thing turned about the origin.
    #[must_use]
    fn rotated(mut self, degrees: impl Into<f64>) -> Self
    where
        Self: Sized,
    {
        self.rotate(degrees);
        self
    }

    /// The thing turned about a point.
    #[must_use]
    fn rotated_about(mut self, degrees: impl Into<f64>, center: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.rotate_about(degrees, center);
        self
    }

    /// The thing mirrored at the line through two points.
    #[must_use]
    fn mirrored(mut self, p1: impl Into<Point>, p2: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.mirror(p1, p2);
        self
    }

    /// The thing scaled about the origin.
    #[must_use]
    fn scaled(mut self, factor: impl Into<f64>) -> Self
    where
        Self: Sized,
    {
        self.scale(factor);
        self
    }

    /// The thing moved until its center is at a point.
    #[must_use]
    fn centered(mut self, at: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.set_center(at);
        self
    }

    /// Moves the middle to a point.
    fn set_center(&mut self, to: impl Into<Point>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_center", |b| to - b.center())
    }

    /// Moves along x until the middle is there.
    fn set_x(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_x", |b| Point::new(to - b.center().x, 0.0))
    }

    /// Moves along y until the middle is there.
    fn set_y(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_y", |b| Point::new(0.0, to - b.center().y))
    }

    /// Moves along x until the left edge is there.
    fn set_xmin(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_xmin", |b| Point::new(to - b.min.x, 0.0))
    }

    /// Moves along x until the right edge is there.
    fn set_xmax(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_xmax", |b| Point::new(to - b.max.x, 0.0))
    }

    /// Moves along y until the lower edge is there.
    fn set_ymin(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_ymin", |b| Point::new(0.0, to - b.min.y))
    }

    /// Moves along y until the upper edge is there.
    fn set_ymax(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_ymax", |b| Point::new(0.0, to - b.max.y))
    }
}

impl<T: Transformable + Bounded + ?Sized> Movable for T {}

fn relocate<'a, T: Movable + ?Sized>(
    thing: &'a mut T,
    word: &'static str,
    displacement: impl FnOnce(Rect) -> Point,
) -> &'a mut T {
    let by = match thing.bbox() {
        Some(bbox) => displacement(bbox),
        None => {
            thing.refuse(DeferredError { word, refusal: Refusal::Empty });
            return thing;
        }
    };
    match finite_point(word, by) {
        Ok(()) => thing.transform_mut(&Transform::translation(by)),
        Err(fault) => thing.refuse(fault),
    }
    thing
}

fn finite(word: &'static str, v: f64) -> Result<(), DeferredError> {
    if v.is_finite() { Ok(()) } else { Err(DeferredError { word, refusal: Refusal::NumberNotFinite(v) }) }
}

fn finite_point(word: &'static str, p: Point) -> Result<(), DeferredError> {
    if p.is_finite() { Ok(()) } else { Err(DeferredError { word, refusal: Refusal::PointNotFinite(p) }) }
}
