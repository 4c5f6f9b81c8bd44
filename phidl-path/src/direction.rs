//! Directions as PHIDL computes them, to the last bit.
//!
//! A path keeps the angles of its ends as these formulas give them, because its geometry hash takes their bits; getters
//! normalize them to one turn. The order of operations matters: `t / π · 180` and `t · 180 / π` differ.

use std::f64::consts::PI;

use phidl_core::geom::Point;

/// Direction of a segment of a point list (degrees, in `(-180, 180]`).
pub(crate) fn of_segment(from: Point, to: Point) -> f64 {
    let along = to - from;
    along.y.atan2(along.x) / PI * 180.0
}

/// Direction of a mirror line.
pub(crate) fn of_mirror_line(p1: Point, p2: Point) -> f64 {
    let along = p2 - p1;
    along.y.atan2(along.x) * 180.0 / PI
}

/// Direction of a leg between waypoints.
pub(crate) fn of_leg(along: Point) -> f64 {
    along.y.atan2(along.x) * (180.0 / PI)
}

/// An angle reduced to one turn as PHIDL does it: a tiny negative angle may become 360.
pub(crate) fn within_turn(degrees: f64) -> f64 {
    degrees.rem_euclid(360.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_and_diagonals_are_exact_in_all_formulas() {
        for (x, y, degrees) in [(1.0, 0.0, 0.0), (0.0, 2.0, 90.0), (-3.0, 0.0, 180.0), (0.0, -1.0, -90.0)] {
            let to = Point::new(x, y);
            assert_eq!(of_segment(Point::ORIGIN, to), degrees);
            assert_eq!(of_mirror_line(Point::ORIGIN, to), degrees);
            assert_eq!(of_leg(to), degrees);
        }
        assert_eq!(of_leg(Point::new(2.0, 2.0)), 45.0);
    }
}
