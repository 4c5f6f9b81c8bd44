//! [`Point`] and [`Size`], and the types that convert into them.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::num::angle;

/// A position or a displacement in the plane, in micrometers; x to the right, y up.
///
/// Functions take points as `impl Into<Point>`: a pair of numbers (`(1, 2.5)`, `[1.0, 2.5]`), a [`Point`],
/// a [`Port`](crate::port::Port) (its midpoint) or a `geo_types::Coord`.
///
/// ```
/// # use phidl_core::geom::Point;
/// assert_eq!(Point::from((3, 0.5)), Point::new(3.0, 0.5));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// To the right (µm).
    pub x: f64,
    /// Up (µm).
    pub y: f64,
}

/// The squares of lengths that keep all their digits.
const SQUARES: std::ops::RangeInclusive<f64> = 1e-290..=1e300;

impl Point {
    /// The origin of the coordinates.
    pub const ORIGIN: Self = Self { x: 0.0, y: 0.0 };

    /// A point from its coordinates (µm).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The point at a distance (µm) and a direction (degrees) from the origin; exact at multiples of 90°.
    #[must_use]
    #[inline]
    pub fn polar(radius: f64, degrees: f64) -> Self {
        let (sin, cos) = angle::sin_cos(degrees);
        Self { x: radius * cos, y: radius * sin }
    }

    /// Whether all coordinates of many points are finite numbers: eight points at a time, without a branch for each.
    pub(crate) fn all_finite(points: &[Self]) -> bool {
        // Zero times a number that is not finite is NaN, and NaN stays NaN in a sum.
        let sum = |points: &[Self]| points.iter().fold(Self::ORIGIN, |sum, p| sum + *p * 0.0);
        points.chunks(8).all(|points| sum(points).is_finite())
    }

    /// Distance from the origin (µm).
    #[must_use]
    #[inline]
    pub fn norm(self) -> f64 {
        let square = self.x * self.x + self.y * self.y;
        // `hypot` costs five times as much. It is needed only if the square leaves the range of an `f64`.
        if SQUARES.contains(&square) { square.sqrt() } else { self.x.hypot(self.y) }
    }

    /// Distance to another point (µm).
    #[must_use]
    #[inline]
    pub fn distance(self, other: Self) -> f64 {
        (other - self).norm()
    }

    /// Direction from the origin in degrees, in `[0, 360)`.
    #[must_use]
    pub fn direction(self) -> f64 {
        angle::direction(self.x, self.y)
    }

    /// Scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The third component of the vector product: positive if `other` lies to the left.
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Whether both coordinates are finite numbers.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl std::fmt::Display for Point {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "({}, {})", self.x, self.y)
    }
}

impl<X: Into<f64>, Y: Into<f64>> From<(X, Y)> for Point {
    fn from((x, y): (X, Y)) -> Self {
        Self { x: x.into(), y: y.into() }
    }
}

impl<N: Into<f64>> From<[N; 2]> for Point {
    fn from([x, y]: [N; 2]) -> Self {
        Self { x: x.into(), y: y.into() }
    }
}

impl From<&Point> for Point {
    fn from(point: &Point) -> Self {
        *point
    }
}

impl From<geo_types::Coord<f64>> for Point {
    fn from(coord: geo_types::Coord<f64>) -> Self {
        Self { x: coord.x, y: coord.y }
    }
}

impl From<Point> for geo_types::Coord<f64> {
    fn from(point: Point) -> Self {
        Self { x: point.x, y: point.y }
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl AddAssign for Point {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Point {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Neg for Point {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

impl Mul<Point> for f64 {
    type Output = Point;
    fn mul(self, point: Point) -> Point {
        point * self
    }
}

impl Div<f64> for Point {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor }
    }
}

/// An extent: how wide and how high (µm). Given as a pair like a [`Point`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Size {
    /// Extent along x (µm).
    pub width: f64,
    /// Extent along y (µm).
    pub height: f64,
}

impl Size {
    /// An extent from its two lengths (µm).
    #[must_use]
    pub const fn new(width: f64, height: f64) -> Self {
        Self { width, height }
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} × {}", self.width, self.height)
    }
}

impl<W: Into<f64>, H: Into<f64>> From<(W, H)> for Size {
    fn from((width, height): (W, H)) -> Self {
        Self { width: width.into(), height: height.into() }
    }
}

impl<N: Into<f64>> From<[N; 2]> for Size {
    fn from([width, height]: [N; 2]) -> Self {
        Self { width: width.into(), height: height.into() }
    }
}

impl From<&Size> for Size {
    fn from(size: &Size) -> Self {
        *size
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_coordinate_that_is_not_finite_is_found_among_many() {
        for n in [1, 7, 8, 9, 100] {
            let sound: Vec<Point> = (0..n).map(|i| Point::new(f64::from(i) * 1e300, -f64::MAX)).collect();
            assert!(Point::all_finite(&sound));
            for (i, bad) in (0..sound.len()).zip([f64::NAN, f64::INFINITY, -f64::INFINITY].into_iter().cycle()) {
                let (mut in_x, mut in_y) = (sound.clone(), sound.clone());
                (in_x[i].x, in_y[i].y) = (bad, bad);
                assert!(!Point::all_finite(&in_x) && !Point::all_finite(&in_y), "{i} of {n}");
            }
        }
    }

    #[test]
    fn polar_points_lie_exactly_on_the_axes() {
        assert_eq!(Point::polar(8000.0, 90.0), Point::new(0.0, 8000.0));
        assert_eq!(Point::polar(2.0, -180.0), Point::new(-2.0, 0.0));
    }

    #[test]
    fn mixed_pairs_are_points() {
        assert_eq!(Point::from((1u8, 2.5f32)), Point::new(1.0, 2.5));
        assert_eq!(Point::from([3, 4]).norm(), 5.0);
    }
}
