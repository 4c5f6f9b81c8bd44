//! [`path_manhattan`]: waypoints with right angles between two ports.
//!
//! The rules are PHIDL's, whose legs are always long enough. Where the line crosses itself, the shortest line that does not
//! is taken instead, if there is one (see [`detour`](super::detour)).

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::port::Port;
use phidl_path::Path;

use super::footprint::Wire;
use super::{corners, crossing, detour, loops};
use crate::port_pair::{PortPair, check_positive, round3};

/// Margin beyond the radius of a bend (µm), as in PHIDL.
pub(crate) const MARGIN: f64 = 0.1;

/// Waypoints at right angles between two ports that are turned by a multiple of 90° against each other, with room for a bend
/// of a radius (µm) at every corner: straight, L, U, J or C, depending on the positions of the ports.
///
/// Legs between corners are at least `2 · (radius + 0.1)` long, those at the ports `radius + 0.1`. Where the line would
/// cross itself, the shortest line of up to six corners that does not is taken; there is none where, for instance, the last
/// leg must cross the first. Widths are ignored here; [`route_manhattan`](fn@crate::route_manhattan) takes its own into
/// account.
///
/// ```
/// # use phidl_route::path_manhattan;
/// let path = path_manhattan(((0, 0), 1, 0), ((30, 20), 1, 270), 5)?; // an L
/// assert_eq!(path.points(), [(0, 0).into(), (30, 0).into(), (30, 20).into()]);
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) if the ports are at another angle (to 0.0005°),
/// [`Error::Param`](phidl_core::Error::Param) if the radius is not greater than 0.
pub fn path_manhattan(port1: impl Into<Port>, port2: impl Into<Port>, radius: impl Into<f64>) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    manhattan(&PortPair::new("path_manhattan", &port1, &port2)?, radius.into()).and_then(Path::from_points)
}

pub(crate) fn manhattan(pair: &PortPair<'_>, radius: f64) -> Result<Vec<Point>> {
    check_positive("path_manhattan", "radius", radius)?;
    check_right_angles(pair)?;
    let extent = radius + MARGIN;
    let points = ordinary(pair, extent)?;
    if crossing::crossings(&points) == 0 {
        return Ok(points);
    }
    Ok(detour::shortest(pair, extent, &mut Wire::sharp(), &[])?.unwrap_or(points))
}

pub(crate) fn check_right_angles(pair: &PortPair<'_>) -> Result<()> {
    pair.check_turn(&[0.0, 90.0, 180.0, 270.0], "turned by a multiple of 90°")
}

/// The ordinary waypoints, with a length on both legs of every corner for its bend (µm).
pub(crate) fn ordinary(pair: &PortPair<'_>, extent: f64) -> Result<Vec<Point>> {
    match pair.turn() {
        90.0 | 270.0 => orthogonal(pair, extent),
        _ => parallel(pair, extent),
    }
}

/// Between ports at a right angle.
fn orthogonal(pair: &PortPair<'_>, extent: f64) -> Result<Vec<Point>> {
    let (x, y) = (round3(pair.forward_distance()), round3(pair.lateral_distance()));
    let side = if pair.turn() == 270.0 { -1.0 } else { 1.0 };
    if x > extent && -side * y > extent {
        return corners::l(pair);
    }
    let length1 = if (extent - x).abs() < 2.0 * extent { 2.0 * extent + x } else { extent };
    let length2 = if (extent + side * y).abs() < 2.0 * extent { 2.0 * extent - side * y } else { extent };
    loops::j(pair, length1, length2)
}

/// Between ports with the same or opposite orientations.
fn parallel(pair: &PortPair<'_>, extent: f64) -> Result<Vec<Point>> {
    let (x, y) = (round3(pair.forward_distance()), round3(pair.lateral_distance()));
    let facing = pair.turn() == 180.0;
    if facing && y == 0.0 && x > 0.0 {
        return corners::straight(pair);
    }
    if !(facing && x <= 2.0 * extent || y.abs() < 2.0 * extent) {
        let length1 = if !facing && x > 0.0 { extent + x } else { extent };
        return loops::u(pair, length1);
    }
    let left1 = if y.abs() < 4.0 * extent { y.abs() + 2.0 * extent } else { 2.0 * extent };
    let beyond = if facing { x - extent } else { x + extent };
    let length1 = if (beyond - extent).abs() < 2.0 * extent { beyond + 2.0 * extent } else { extent };
    loops::c(pair, length1, if y < 0.0 { -left1 } else { left1 }, extent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manhattan::crossing::crossings;

    fn points(x: f64, y: f64, orientation: f64) -> Vec<(f64, f64)> {
        let path = path_manhattan(((0, 0), 1, 0), ((x, y), 1, orientation), 5).unwrap();
        path.points()[1..].iter().map(|p| (round3(p.x), round3(p.y))).collect()
    }

    #[test]
    fn waypoints_are_those_of_the_reference() {
        assert_eq!(points(30., 0., 180.), [(30., 0.)]);
        assert_eq!(points(30., 20., 270.), [(30., 0.), (30., 20.)]);
        assert_eq!(points(30., -20., 90.), [(30., 0.), (30., -20.)]);
        assert_eq!(points(30., -20., 270.), [(5.1, 0.), (5.1, -25.1), (30., -25.1), (30., -20.)]);
        assert_eq!(points(30., 20., 90.), [(5.1, 0.), (5.1, 25.1), (30., 25.1), (30., 20.)]);
        assert_eq!(points(-30., 20., 270.), [(5.1, 0.), (5.1, 14.9), (-30., 14.9), (-30., 20.)]);
        assert_eq!(points(30., 3., 270.), [(5.1, 0.), (5.1, -10.2), (30., -10.2), (30., 3.)]);
        assert_eq!(points(3., 30., 270.), [(13.2, 0.), (13.2, 24.9), (3., 24.9), (3., 30.)]);
        assert_eq!(points(50., 30., 180.), [(5.1, 0.), (5.1, 30.), (50., 30.)]);
        assert_eq!(points(10., 30., 180.), [(15.1, 0.), (15.1, 10.2), (4.9, 10.2), (4.9, 30.), (10., 30.)]);
        assert_eq!(points(-50., 30., 180.), [(5.1, 0.), (5.1, 10.2), (-55.1, 10.2), (-55.1, 30.), (-50., 30.)]);
        assert_eq!(points(-50., -30., 180.), [(5.1, 0.), (5.1, -10.2), (-55.1, -10.2), (-55.1, -30.), (-50., -30.)]);
        assert_eq!(points(-50., 0., 180.), [(5.1, 0.), (5.1, 10.2), (-55.1, 10.2), (-55.1, 0.), (-50., 0.)]);
        assert_eq!(points(50., 3., 180.), [(5.1, 0.), (5.1, 13.2), (44.9, 13.2), (44.9, 3.), (50., 3.)]);
        assert_eq!(points(50., -3., 180.), [(5.1, 0.), (5.1, -13.2), (44.9, -13.2), (44.9, -3.), (50., -3.)]);
        assert_eq!(points(20., 30., 0.), [(25.1, 0.), (25.1, 30.), (20., 30.)]);
        assert_eq!(points(-20., 30., 0.), [(5.1, 0.), (5.1, 30.), (-20., 30.)]);
        assert_eq!(points(50., 0., 0.), [(5.1, 0.), (5.1, 10.2), (55.1, 10.2), (55.1, 0.), (50., 0.)]);
        assert_eq!(points(-50., 0., 0.), [(5.1, 0.), (5.1, 10.2), (-44.9, 10.2), (-44.9, 0.), (-50., 0.)]);
        assert_eq!(points(10., 3., 0.), [(25.3, 0.), (25.3, 13.2), (15.1, 13.2), (15.1, 3.), (10., 3.)]);
        assert_eq!(points(0., 0., 180.), [(5.1, 0.), (5.1, 10.2), (-5.1, 10.2), (-5.1, 0.), (0., 0.)]);
        assert_eq!(points(0., 0., 0.), [(15.3, 0.), (15.3, 10.2), (5.1, 10.2), (5.1, 0.), (0., 0.)]);
    }

    #[test]
    fn the_sweep_of_the_tutorial_is_that_of_the_reference() {
        let j = |x: f64, y: f64, a: f64, b: f64| vec![(a, 0.), (a, b), (x, b), (x, y)];
        for (x, a) in [(-20., 5.1), (-10., 5.1), (0., 10.2)] {
            assert_eq!(points(x, -20., 90.), j(x, -20., a, -14.9));
        }
        for x in [10., 20.] {
            assert_eq!(points(x, -20., 90.), [(x, 0.), (x, -20.)]);
        }
        for (x, a) in [(-20., 5.1), (-10., 5.1), (0., 10.2), (10., 20.2), (20., 5.1)] {
            assert_eq!(points(x, 0., 90.), j(x, 0., a, 10.2));
            assert_eq!(points(x, 20., 90.), j(x, 20., a, 25.1));
        }
    }

    #[test]
    fn a_full_turn_up_to_rounding_enters_the_port_from_the_front() {
        assert_eq!(points(20., 30., 359.999_999_9), points(20., 30., 0.));
    }

    #[test]
    fn a_line_crosses_itself_only_where_it_must() {
        // PHIDL's lines cross themselves in both.
        assert_eq!(points(5.1, -5.1, 90.), [(5.1, 0.), (5.1, -5.1)]);
        let path = path_manhattan(((0, 0), 1, 0), ((9, 4), 1, 270), 5).unwrap();
        assert_eq!(crossings(path.points()), 0);
        // Here the last leg must cross the first: it starts below the axis, and the first leg reaches further than 5 µm.
        let path = path_manhattan(((0, 0), 1, 0), ((5, 4), 1, 270), 5).unwrap();
        assert_eq!(crossings(path.points()), 1);
    }

    #[test]
    fn other_angles_are_refused_and_rounding_is_not() {
        let to = |orientation: f64| path_manhattan(((0, 0), 1, 0), ((10, 10), 1, orientation), 5);
        assert!(to(45.0).is_err() && to(89.999).is_err() && to(89.9996).is_ok());
        assert!(path_manhattan(((0, 0), 1, 0), ((10, 10), 1, 0), 0).is_err());
    }
}
