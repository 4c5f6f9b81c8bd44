//! [`Corner`]: a point of the grid, with exact predicates.

use phidl_core::geom::Point;
use phidl_core::num::grid::{Grid, whole};

/// A point of the grid, in steps.
pub(super) type Corner = [i64; 2];

/// A point of whole numbers as whole numbers.
pub(super) fn corner_of(p: Point) -> Corner {
    #[expect(clippy::cast_possible_truncation, reason = "rounded before; files refuse what is out of their range")]
    let corner = [p.x as i64, p.y as i64];
    corner
}

/// The grid point nearest to a point in steps.
pub(super) fn nearest(steps: Point) -> Corner {
    corner_of(rounded(steps))
}

/// A point in steps, on the grid.
pub(super) fn rounded(steps: Point) -> Point {
    Point::new(whole(steps.x), whole(steps.y))
}

/// A point in steps of the grid, not rounded.
pub(super) fn in_steps(grid: &Grid, p: Point) -> Point {
    Point::new(grid.scaled(p.x), grid.scaled(p.y))
}

/// Whether a grid point lies on a segment, exactly.
pub(super) fn is_on(a: Corner, b: Corner, p: Corner) -> bool {
    let between = |axis: usize| a[axis].min(b[axis]) <= p[axis] && p[axis] <= a[axis].max(b[axis]);
    cross(a, b, p) == 0 && between(0) && between(1)
}

/// Positive if `p` lies left of the line from `a` to `b`.
pub(super) fn cross(a: Corner, b: Corner, p: Corner) -> i128 {
    let (u, v) = (sub(b, a), sub(p, a));
    i128::from(u[0]) * i128::from(v[1]) - i128::from(u[1]) * i128::from(v[0])
}

pub(super) fn dot(u: Corner, v: Corner) -> i128 {
    i128::from(u[0]) * i128::from(v[0]) + i128::from(u[1]) * i128::from(v[1])
}

pub(super) fn sub(a: Corner, b: Corner) -> Corner {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn distance_squared(a: Corner, b: Corner) -> i128 {
    dot(sub(a, b), sub(a, b))
}
