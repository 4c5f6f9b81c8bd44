//! [`Transform`]: the placement of a cell in GDSII, and [`Matrix`]: the same in the form that applies fastest.
//!
//! A transform is stored as its parts (mirror, magnification, angle in degrees, shift), not as a matrix: composing adds
//! angles in degrees, so a quarter turn after a quarter turn is exactly a half turn at any depth of a hierarchy.
//! The angle of a matrix would have to be recovered, with noise in the last digits.

use super::{Point, Rect};
use crate::num::angle;

/// Mirror across the x axis, then magnify, then rotate, then shift: the order of GDSII.
///
/// ```
/// # use phidl_core::geom::{Point, Transform};
/// let t = Transform::rotation(90.0).then(&Transform::translation((10, 0)));
/// assert_eq!(t.apply(Point::new(1.0, 0.0)), Point::new(10.0, 1.0));
/// assert_eq!(t.inverse().apply(Point::new(10.0, 1.0)), Point::new(1.0, 0.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    /// Whether y becomes −y first.
    pub x_reflection: bool,
    /// Factor on all lengths; positive.
    pub magnification: f64,
    /// Counter-clockwise turn in degrees, in `[0, 360)`.
    pub rotation: f64,
    /// Shift at the end (µm).
    pub origin: Point,
}

impl Transform {
    /// The identity.
    pub const IDENTITY: Self = Self { x_reflection: false, magnification: 1.0, rotation: 0.0, origin: Point::ORIGIN };

    /// A shift (µm).
    #[must_use]
    pub fn translation(by: impl Into<Point>) -> Self {
        Self { origin: by.into(), ..Self::IDENTITY }
    }

    /// A turn about the origin (degrees).
    #[must_use]
    pub fn rotation(degrees: f64) -> Self {
        Self { rotation: angle::normalized(degrees), ..Self::IDENTITY }
    }

    /// A turn about a point (degrees).
    #[must_use]
    pub fn rotation_about(degrees: f64, center: impl Into<Point>) -> Self {
        let center = center.into();
        let turn = Self::rotation(degrees);
        Self { origin: center - turn.apply(center), ..turn }
    }

    /// A magnification about the origin.
    #[must_use]
    pub fn scaling(factor: f64) -> Self {
        Self { magnification: factor, ..Self::IDENTITY }
    }

    /// A reflection across the line through two points. Equal points give a transform that is not finite.
    #[must_use]
    pub fn reflection(p1: impl Into<Point>, p2: impl Into<Point>) -> Self {
        let (p1, p2) = (p1.into(), p2.into());
        let along = p2 - p1;
        let rotation = if along == Point::ORIGIN { f64::NAN } else { angle::normalized(2.0 * along.direction()) };
        let flip = Self { x_reflection: true, rotation, ..Self::IDENTITY };
        Self { origin: p1 - flip.apply(p1), ..flip }
    }

    /// This transform, then another one.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let turn = if next.x_reflection { -self.rotation } else { self.rotation };
        Self {
            x_reflection: self.x_reflection != next.x_reflection,
            magnification: self.magnification * next.magnification,
            rotation: angle::normalized(turn + next.rotation),
            origin: next.apply(self.origin),
        }
    }

    /// The transform that undoes this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = if self.x_reflection { self.rotation } else { -self.rotation };
        let linear = Self {
            x_reflection: self.x_reflection,
            magnification: 1.0 / self.magnification,
            rotation: angle::normalized(rotation),
            origin: Point::ORIGIN,
        };
        Self { origin: -linear.apply(self.origin), ..linear }
    }

    /// The image of a point. For many points take [`Transform::matrix`] once.
    #[must_use]
    pub fn apply(&self, point: Point) -> Point {
        self.matrix().apply(point)
    }

    /// The image of a displacement: everything but the shift.
    #[must_use]
    pub fn apply_vector(&self, vector: Point) -> Point {
        self.matrix().apply_vector(vector)
    }

    /// The image of a direction (degrees), in `[0, 360)`.
    #[must_use]
    pub fn apply_direction(&self, degrees: f64) -> f64 {
        angle::normalized(if self.x_reflection { self.rotation - degrees } else { self.rotation + degrees })
    }

    /// The tight box around the image of a box, if axes stay axes; `None` at other angles.
    #[must_use]
    pub fn apply_rect(&self, rect: Rect) -> Option<Rect> {
        angle::quarter_turns(self.rotation)?;
        Some(Rect::new(self.apply(rect.min), self.apply(rect.max)))
    }

    /// The same as a matrix, which applies faster.
    #[must_use]
    pub fn matrix(&self) -> Matrix {
        let (sin, cos) = angle::sin_cos(self.rotation);
        let (sin, cos) = (sin * self.magnification, cos * self.magnification);
        let flip = if self.x_reflection { -1.0 } else { 1.0 };
        Matrix { a: cos, b: -sin * flip, c: sin, d: cos * flip, shift: self.origin }
    }

    /// Whether all numbers are finite and the magnification is positive.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.origin.is_finite()
            && self.rotation.is_finite()
            && self.magnification.is_finite()
            && self.magnification > 0.0
    }
}

impl std::fmt::Display for Transform {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mirrored = if self.x_reflection { "mirrored, " } else { "" };
        let Self { magnification, rotation, origin, .. } = self;
        write!(f, "{mirrored}magnified by {magnification}, rotated by {rotation}° and moved to {origin}")
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// A [`Transform`] as numbers: `x' = a x + b y + shift.x`, `y' = c x + d y + shift.y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Matrix {
    /// How x' grows with x.
    pub a: f64,
    /// How x' grows with y.
    pub b: f64,
    /// How y' grows with x.
    pub c: f64,
    /// How y' grows with y.
    pub d: f64,
    /// What is added (µm).
    pub shift: Point,
}

impl Matrix {
    /// The image of a point.
    #[must_use]
    pub fn apply(&self, p: Point) -> Point {
        Point::new(self.a * p.x + self.b * p.y + self.shift.x, self.c * p.x + self.d * p.y + self.shift.y)
    }

    /// The image of a displacement: everything but the shift.
    #[must_use]
    pub fn apply_vector(&self, v: Point) -> Point {
        Point::new(self.a * v.x + self.b * v.y, self.c * v.x + self.d * v.y)
    }

    /// The same, shifted further (µm).
    #[must_use]
    pub fn shifted(self, by: Point) -> Self {
        Self { shift: self.shift + by, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn eight_orientations() -> impl Iterator<Item = Transform> {
        (0..8).map(|i| Transform {
            x_reflection: i >= 4,
            magnification: 2.0,
            rotation: 90.0 * f64::from(i % 4),
            origin: Point::new(3.0, -7.0),
        })
    }

    #[test]
    fn the_inverse_undoes_all_eight_orientations_exactly() {
        let p = Point::new(1.25, -0.5);
        for t in eight_orientations() {
            assert_eq!(t.inverse().apply(t.apply(p)), p, "{t:?}");
            assert_eq!(t.then(&t.inverse()), Transform::IDENTITY, "{t:?}");
        }
    }

    #[test]
    fn one_after_the_other_is_the_composition() {
        let p = Point::new(0.25, 0.75);
        for s in eight_orientations() {
            for t in eight_orientations() {
                assert_eq!(s.then(&t).apply(p), t.apply(s.apply(p)));
            }
        }
    }

    #[test]
    fn a_reflection_keeps_its_line_and_swaps_its_sides() {
        let t = Transform::reflection((1, 1), (3, 3));
        assert_eq!(t.apply(Point::new(5.0, 2.0)), Point::new(2.0, 5.0));
        let t = Transform::reflection((0, 1), (0, 0));
        assert_eq!(t.apply(Point::new(5.0, 2.0)), Point::new(-5.0, 2.0));
        assert!(!Transform::reflection((1, 1), (1, 1)).is_finite());
    }

    #[test]
    fn directions_follow_the_points() {
        let t = Transform { x_reflection: true, rotation: 90.0, origin: Point::new(10.0, 20.0), ..Transform::IDENTITY };
        assert_eq!(t.apply(Point::new(1.0, 2.0)), Point::new(12.0, 21.0));
        assert_eq!(t.apply_direction(30.0), 60.0);
    }
}
