//! [`Movable`]: the placement methods.

use super::{Bounded, DeferredError, Reason, Transformable};
use crate::geom::{Point, Rect, Transform};

/// The placement methods: move, rotate, mirror, scale, and set an edge or the center of the bounding box. Lengths in µm,
/// angles in degrees counter-clockwise.
///
/// Each method changes the element in place and chains. Its participle (`rotated`) takes the element and returns it. A
/// setter moves the element until the edge or the center has the given coordinate.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut outline = Polygon::new([(0, 0), (4, 0), (4, 2), (0, 2)], 1);
/// outline.rotate(90).set_xmin(10).set_y(0);
/// assert_eq!(outline.center(), Point::new(11.0, 0.0));
/// assert_eq!(outline.clone().moved_by((1, 0)).xmin(), 11.0);
/// ```
///
/// # Invalid arguments
/// A number that is not finite, a mirror line of one point, or a setter on an empty element changes nothing. The element
/// keeps the first such call as a [`DeferredError`]. The next fallible call on that element returns it: adding it to a
/// cell, `connect`, or for an open cell `build` and `check`. No call on another element does.
///
/// # Empty elements
/// [`Bounded::bbox`] is `None`; see [`Bounded`] for the readers.
pub trait Movable: Transformable + Bounded {
    /// Moves by a vector.
    fn move_by(&mut self, by: impl Into<Point>) -> &mut Self {
        let by = by.into();
        match finite_point("move_by", by) {
            Ok(()) => self.transform_mut(&Transform::translation(by)),
            Err(error) => self.defer(error),
        }
        self
    }

    /// Moves by the vector from `origin`, any point, to `destination`.
    fn move_to(&mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> &mut Self {
        let by = destination.into() - origin.into();
        match finite_point("move_to", by) {
            Ok(()) => self.transform_mut(&Transform::translation(by)),
            Err(error) => self.defer(error),
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

    /// Moves along x only, by the distance from `origin` to `destination`: points, ports, or pairs.
    fn movex_to(&mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> &mut Self {
        let by = destination.into() - origin.into();
        self.movex(by.x)
    }

    /// Moves along y only, by the distance from `origin` to `destination`: points, ports, or pairs.
    fn movey_to(&mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> &mut Self {
        let by = destination.into() - origin.into();
        self.movey(by.y)
    }

    /// Rotates about the origin; a port, which is a point with a direction, about its midpoint.
    fn rotate(&mut self, degrees: impl Into<f64>) -> &mut Self {
        let pivot = self.pivot();
        self.rotate_about(degrees, pivot)
    }

    /// Rotates about a point.
    fn rotate_about(&mut self, degrees: impl Into<f64>, center: impl Into<Point>) -> &mut Self {
        let (degrees, center) = (degrees.into(), center.into());
        match finite("rotate", degrees).and(finite_point("rotate", center)) {
            Ok(()) => self.rotate_mut(degrees, center),
            Err(error) => self.defer(error),
        }
        self
    }

    /// Mirrors across the line through two points.
    fn mirror(&mut self, p1: impl Into<Point>, p2: impl Into<Point>) -> &mut Self {
        let (p1, p2) = (p1.into(), p2.into());
        let line = match p1 == p2 {
            true => Err(DeferredError { method: "mirror", reason: Reason::MirrorLineOfOnePoint(p1) }),
            false => Ok(()),
        };
        match finite_point("mirror", p1).and(finite_point("mirror", p2)).and(line) {
            Ok(()) => self.mirror_mut(p1, p2),
            Err(error) => self.defer(error),
        }
        self
    }

    /// Scales all lengths about the origin; the factor is positive.
    fn scale(&mut self, factor: impl Into<f64>) -> &mut Self {
        let factor = factor.into();
        let positive = match factor <= 0.0 {
            true => Err(DeferredError { method: "scale", reason: Reason::FactorNotPositive(factor) }),
            false => Ok(()),
        };
        match finite("scale", factor).and(positive) {
            Ok(()) => self.transform_mut(&Transform::scaling(factor)),
            Err(error) => self.defer(error),
        }
        self
    }

    /// Moved by a vector.
    #[must_use]
    fn moved_by(mut self, by: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.move_by(by);
        self
    }

    /// Moved by the vector from `origin` to `destination`.
    #[must_use]
    fn moved_to(mut self, origin: impl Into<Point>, destination: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.move_to(origin, destination);
        self
    }

    /// Rotated about the origin; a port about its midpoint.
    #[must_use]
    fn rotated(mut self, degrees: impl Into<f64>) -> Self
    where
        Self: Sized,
    {
        self.rotate(degrees);
        self
    }

    /// Rotated about a point.
    #[must_use]
    fn rotated_about(mut self, degrees: impl Into<f64>, center: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.rotate_about(degrees, center);
        self
    }

    /// Mirrored across the line through two points.
    #[must_use]
    fn mirrored(mut self, p1: impl Into<Point>, p2: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.mirror(p1, p2);
        self
    }

    /// Scaled about the origin.
    #[must_use]
    fn scaled(mut self, factor: impl Into<f64>) -> Self
    where
        Self: Sized,
    {
        self.scale(factor);
        self
    }

    /// Moved until the center is at a point.
    #[must_use]
    fn centered(mut self, at: impl Into<Point>) -> Self
    where
        Self: Sized,
    {
        self.set_center(at);
        self
    }

    /// Moves the center to a point.
    fn set_center(&mut self, to: impl Into<Point>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_center", to, |b| b.center())
    }

    /// Moves along x until the center has this coordinate.
    fn set_x(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_x", (to, 0.0), |b| Point::new(b.center().x, 0.0))
    }

    /// Moves along y until the center has this coordinate.
    fn set_y(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_y", (0.0, to), |b| Point::new(0.0, b.center().y))
    }

    /// Moves along x until the left edge has this coordinate.
    fn set_xmin(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_xmin", (to, 0.0), |b| Point::new(b.min.x, 0.0))
    }

    /// Moves along x until the right edge has this coordinate.
    fn set_xmax(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_xmax", (to, 0.0), |b| Point::new(b.max.x, 0.0))
    }

    /// Moves along y until the lower edge has this coordinate.
    fn set_ymin(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_ymin", (0.0, to), |b| Point::new(0.0, b.min.y))
    }

    /// Moves along y until the upper edge has this coordinate.
    fn set_ymax(&mut self, to: impl Into<f64>) -> &mut Self {
        let to = to.into();
        relocate(self, "set_ymax", (0.0, to), |b| Point::new(0.0, b.max.y))
    }
}

impl<T: Transformable + Bounded + ?Sized> Movable for T {}

/// Moves the element by the vector from a point of its box to a target.
fn relocate<'a, T: Movable + ?Sized>(
    element: &'a mut T,
    method: &'static str,
    target: impl Into<Point>,
    of_box: impl FnOnce(Rect) -> Point,
) -> &'a mut T {
    let target = target.into();
    let by = match (finite_point(method, target), element.bbox()) {
        (Err(error), _) => Err(error),
        (Ok(()), None) => Err(DeferredError { method, reason: Reason::Empty }),
        (Ok(()), Some(bbox)) => Ok(target - of_box(bbox)),
    };
    match by.and_then(|by| finite_point(method, by).map(|()| by)) {
        Ok(by) => element.transform_mut(&Transform::translation(by)),
        Err(error) => element.defer(error),
    }
    element
}

fn finite(method: &'static str, v: f64) -> Result<(), DeferredError> {
    if v.is_finite() { Ok(()) } else { Err(DeferredError { method, reason: Reason::NumberNotFinite(v) }) }
}

/// A point of which one coordinate is 0, as setters of one coordinate give it, is reported as that coordinate alone.
fn finite_point(method: &'static str, p: Point) -> Result<(), DeferredError> {
    match (p.is_finite(), p.x == 0.0, p.y == 0.0) {
        (true, ..) => Ok(()),
        (false, true, _) => finite(method, p.y),
        (false, _, true) => finite(method, p.x),
        (false, false, false) => Err(DeferredError { method, reason: Reason::PointNotFinite(p) }),
    }
}
