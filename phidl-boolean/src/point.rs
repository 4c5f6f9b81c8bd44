//! Points of the integer grid and the orientation predicate.
//!
//! Coordinates are kept within ±2⁴⁰ steps ([`MAX_COORDINATE`]; ±110 m at the default step of 10⁻⁴ µm). The bound
//! makes the arithmetic *exact*: the largest product that rounding a
//! crossing needs is 2 · 2⁸³ · 2⁴¹ = 2¹²⁵, which an `i128` holds. The alternative, 32-bit coordinates with a 64-bit
//! second engine for large ones, saves memory but needs the range rule twice.

use std::cmp::Ordering;

/// Largest absolute coordinate that the engine accepts, in grid steps: 2⁴⁰.
pub const MAX_COORDINATE: i64 = 1 << 40;

/// A point of the grid, in steps. Points are ordered by `x`, then by `y`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct GridPoint {
    /// Steps to the right.
    pub x: i64,
    /// Steps upward.
    pub y: i64,
}

impl GridPoint {
    /// The point at `(x, y)`.
    pub const fn new(x: i64, y: i64) -> Self {
        Self { x, y }
    }

    /// True if both coordinates are within ±[`MAX_COORDINATE`].
    pub const fn is_in_range(self) -> bool {
        self.x.unsigned_abs() <= MAX_COORDINATE.unsigned_abs() && self.y.unsigned_abs() <= MAX_COORDINATE.unsigned_abs()
    }
}

impl From<(i64, i64)> for GridPoint {
    fn from((x, y): (i64, i64)) -> Self {
        Self { x, y }
    }
}

/// Twice the signed area of the triangle `a b c`: positive if `c` lies to the left of the line from `a` to `b`.
#[inline]
pub(crate) fn cross(a: GridPoint, b: GridPoint, c: GridPoint) -> i128 {
    i128::from(b.x - a.x) * i128::from(c.y - a.y) - i128::from(b.y - a.y) * i128::from(c.x - a.x)
}

/// On which side of the directed line from `a` to `b` the point `c` lies: `Greater` is left.
#[inline]
pub(crate) fn side(a: GridPoint, b: GridPoint, c: GridPoint) -> Ordering {
    cross(a, b, c).cmp(&0)
}

/// Twice the signed area of a closed contour; positive if it runs counter-clockwise.
///
/// # Examples
/// ```
/// use phidl_boolean::grid::{GridPoint, signed_area2};
/// let triangle = [GridPoint::new(0, 0), GridPoint::new(4, 0), GridPoint::new(0, 3)];
/// assert_eq!(signed_area2(&triangle), 12);
/// ```
pub fn signed_area2(contour: &[GridPoint]) -> i128 {
    let Some(&origin) = contour.first() else { return 0 };
    contour.windows(2).map(|edge| cross(origin, edge[0], edge[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_is_exact_at_the_corners_of_the_range() {
        let m = MAX_COORDINATE;
        let (a, b) = (GridPoint::new(-m, -m), GridPoint::new(m, m));
        assert_eq!(side(a, b, GridPoint::new(m - 1, m)), Ordering::Greater);
        assert_eq!(side(a, b, GridPoint::new(m, m - 1)), Ordering::Less);
        assert_eq!(side(a, b, GridPoint::new(1, 1)), Ordering::Equal);
    }

    #[test]
    fn area_changes_sign_with_the_direction() {
        let mut square = [(0, 0), (2, 0), (2, 2), (0, 2)].map(GridPoint::from);
        assert_eq!(signed_area2(&square), 8);
        square.reverse();
        assert_eq!(signed_area2(&square), -8);
        assert_eq!(signed_area2(&[]), 0);
    }
}
