//! The two traits that a type implements to get the placement methods.

use super::DeferredError;
use crate::geom::{Point, Rect, Size, Transform};

/// What can be moved, rotated, mirrored and scaled as a whole.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be moved",
    note = "a finished cell is placed first: `device.place().moved_by((1, 0))`",
    note = "if this is a `Result`, add `?` to take the value out of it"
)]
pub trait Transformable {
    /// Applies a finite transform.
    fn transform_mut(&mut self, by: &Transform);

    /// Rotates about a point (degrees, any finite number). A [`Transform`] keeps its angle within one turn, which can
    /// cost the last bit. A type that must keep it (a path, whose directions are hashed) overrides this.
    fn rotate_mut(&mut self, degrees: f64, center: Point) {
        self.transform_mut(&Transform::rotation_about(degrees, center));
    }

    /// The point about which `rotate` rotates: the origin.
    fn pivot(&self) -> Point {
        Point::ORIGIN
    }

    /// Mirrors across the line through two different points. Overridden for the same reason as
    /// [`Transformable::rotate_mut`].
    fn mirror_mut(&mut self, p1: Point, p2: Point) {
        self.transform_mut(&Transform::reflection(p1, p2));
    }

    /// Keeps the first invalid call until a fallible call on this value can return it.
    ///
    /// Placement methods chain, so they cannot return a `Result`; and an invalid argument must not become a coordinate.
    fn defer(&mut self, error: DeferredError);
}

/// What may have a bounding box.
///
/// # Empty elements
/// `bbox()` is `None`. The other readers give NaN, and nothing accepts a NaN: setters, outlines, ports, labels, info and
/// parameters refuse it with an error. Zero, as in PHIDL, would place silently wrong; a panic would end the program
/// on a shape that a caller drew on no layer; an `Option` would cost a `?` in every relation between two elements.
pub trait Bounded {
    /// The tight bounding box, or `None` for an empty element.
    fn bbox(&self) -> Option<Rect>;

    /// The middle of the bounding box.
    fn center(&self) -> Point {
        self.bbox().map_or(Point::new(f64::NAN, f64::NAN), |b| b.center())
    }

    /// Width and height of the bounding box.
    fn size(&self) -> Size {
        self.bbox().map_or(Size::new(f64::NAN, f64::NAN), |b| b.size())
    }

    /// Width of the bounding box.
    fn xsize(&self) -> f64 {
        self.size().width
    }

    /// Height of the bounding box.
    fn ysize(&self) -> f64 {
        self.size().height
    }

    /// The middle, along x.
    fn x(&self) -> f64 {
        self.center().x
    }

    /// The middle, along y.
    fn y(&self) -> f64 {
        self.center().y
    }

    /// The left edge.
    fn xmin(&self) -> f64 {
        self.bbox().map_or(f64::NAN, |b| b.min.x)
    }

    /// The right edge.
    fn xmax(&self) -> f64 {
        self.bbox().map_or(f64::NAN, |b| b.max.x)
    }

    /// The lower edge.
    fn ymin(&self) -> f64 {
        self.bbox().map_or(f64::NAN, |b| b.min.y)
    }

    /// The upper edge.
    fn ymax(&self) -> f64 {
        self.bbox().map_or(f64::NAN, |b| b.max.y)
    }
}
