//! Exact tests on a segment and a point.
//!
//! The test whether a segment passes through the half-open pixel of a grid point is cheap. With `d` twice the area
//! between segment and point, the line of a segment `(dx, dy)` passes through the interior of the pixel if
//! `2 |d| < |dx| + |dy|`. It touches the one corner that belongs to the pixel if `dy < 0` and `2 d = |dx| + |dy|`.

use super::segment::Segment;
use crate::point::GridPoint;

/// Whether a point is in the bounding box of a segment.
#[inline]
pub(super) fn in_box(segment: &Segment, p: GridPoint) -> bool {
    p.x >= segment.l.x
        && p.x <= segment.r.x
        && p.y >= segment.l.y.min(segment.r.y)
        && p.y <= segment.l.y.max(segment.r.y)
}

/// The sum of the side lengths of the bounding box, which bounds `2 |d|` for the pixels that a segment crosses.
#[inline]
pub(super) fn reach(segment: &Segment) -> i128 {
    i128::from((segment.r.x - segment.l.x) + (segment.r.y - segment.l.y).abs())
}

/// Whether a segment passes through the pixel of a point in its bounding box; `d` is `segment.cross(point)`.
#[inline]
pub(super) fn crosses_pixel(segment: &Segment, d: i128) -> bool {
    let (twice, reach) = (2 * d, reach(segment));
    twice.abs() < reach || (twice == reach && segment.r.y < segment.l.y)
}

/// Whether one number is positive and the other one negative.
#[inline]
pub(super) fn have_opposite_signs(a: i128, b: i128) -> bool {
    (a > 0 && b < 0) || (a < 0 && b > 0)
}
