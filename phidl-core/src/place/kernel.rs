//! The kernel on which the placement words stand.

use super::DeferredError;
use crate::geom::{Point, Rect, Size, Transform};

/// Something that can be moved, turned, mirrored and scaled as a whole.
pub trait Transformable {
    /// Puts the thing through a transform, which is finite.
    fn transform_mut(&mut self, by: &Transform);

    /// Turns the thing about a point (degrees, any finite number). A [`Transform`] keeps its angle within one turn, which
    /// can cost the last bit; whoever must not lose it (a path, whose directions are hashed) turns in its own way.
    fn rotate_mut(&mut self, degrees: f64, center: Point) {
        self.transform_mut(&Transform::rotation_about(degrees, center));
    }

    /// Mirrors the thing at the line through two different points; its own way for the same reason as with
    /// [`Transformable::rotate_mut`].
    fn mirror_mut(&mut self, p1: Point, p2: Point) {
        self.transform_mut(&Transform::reflection(p1, p2));
    }

    /// Keeps the first placement that was refused, until a fallible call can return it.
    ///
    /// Words chain, so they cannot fail in the middle; and a bad value must not pass for a place.
    fn refuse(&mut self, fault: DeferredError);
}

/// Something that may take up room. Of an empty thing, the readers give NaN.
pub trait Bounded {
    /// The tight box around it, or `None` if it is empty.
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
