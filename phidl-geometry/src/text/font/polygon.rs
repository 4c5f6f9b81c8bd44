//! Questions about contours.

use phidl_core::geom::Point;

/// Whether a point lies inside a contour, by the parity of the edges to its right.
pub(super) fn contains(contour: &[Point], p: Point) -> bool {
    edges(contour).filter(|(a, b)| (a.y > p.y) != (b.y > p.y) && (*b - *a).cross(p - *a) * (b.y - a.y) > 0.0).count()
        % 2
        == 1
}

/// Whether two segments cross, each ending on both sides of the other; touching is not crossing.
pub(super) fn segments_cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |from: Point, to: Point, p: Point| (to - from).cross(p - from);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// The edges of a contour, the closing one included.
pub(super) fn edges(contour: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    contour.iter().copied().zip(contour.iter().copied().cycle().skip(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_inside_where_an_odd_number_of_edges_is_to_its_right() {
        let l = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)].map(Point::from);
        for (x, y, inside) in [(1, 3, true), (3, 1, true), (3, 3, false), (-1, 1, false), (5, 1, false)] {
            assert_eq!(contains(&l, Point::from((x, y))), inside, "({x}, {y})");
            let backwards: Vec<Point> = l.iter().rev().copied().collect();
            assert_eq!(contains(&backwards, Point::from((x, y))), inside, "({x}, {y})");
        }
    }

    #[test]
    fn touching_segments_do_not_cross() {
        let p = |x: i32, y: i32| Point::from((x, y));
        assert!(segments_cross(p(0, 0), p(2, 2), p(0, 2), p(2, 0)));
        assert!(!segments_cross(p(0, 0), p(2, 2), p(2, 2), p(3, 0)));
        assert!(!segments_cross(p(0, 0), p(2, 0), p(1, 0), p(1, 2)));
        assert!(!segments_cross(p(0, 0), p(1, 0), p(2, -1), p(2, 1)));
    }
}
