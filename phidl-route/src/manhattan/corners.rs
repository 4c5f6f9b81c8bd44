//! Waypoints with at most two corners: straight, L, Z and V.
//!
//! Waypoints are what PHIDL's formulas give, even where the line leaves a port backwards. Whether a line can be a route is
//! decided when it is drawn.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::port::Port;
use phidl_path::Path;

use crate::port_pair::{PortPair, check_finite, micrometers, round3};

/// Sine of the angle between two ports (absolute) below which a V has no corner.
const PARALLEL: f64 = 1e-9;

/// The straight line between two ports that face each other.
///
/// ```
/// # use phidl_route::path_straight;
/// assert_eq!(path_straight(((0, 0), 1, 0), ((10, 0), 1, 180))?.length(), 10.0);
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) unless the ports are turned by 180° or 0° against each other, the second
/// one in front of the first on its axis (to 0.5 nm).
pub fn path_straight(port1: impl Into<Port>, port2: impl Into<Port>) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    straight(&PortPair::new("path_straight", &port1, &port2)?).and_then(Path::from_points)
}

/// One corner, on the axis of the first port: between ports at a right angle.
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) unless the ports are turned by 90° or 270° against each other.
#[doc(alias = "path_L")]
pub fn path_l(port1: impl Into<Port>, port2: impl Into<Port>) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    l(&PortPair::new("path_L", &port1, &port2)?).and_then(Path::from_points)
}

/// Two corners, each at a length (µm) in front of its port, and a straight line between them at any angle.
///
/// # Errors
/// [`Error::Param`](phidl_core::Error::Param) if a length is not finite.
#[doc(alias = "path_Z")]
pub fn path_z(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    length1: impl Into<f64>,
    length2: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    z(&PortPair::new("path_Z", &port1, &port2)?, length1.into(), length2.into()).and_then(Path::from_points)
}

/// One corner, where the axes of the two ports meet.
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) if the ports are parallel: their axes do not meet. (PHIDL fails without a
/// message, or goes through a point 4·10¹⁷ µm away.)
#[doc(alias = "path_V")]
pub fn path_v(port1: impl Into<Port>, port2: impl Into<Port>) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    v(&PortPair::new("path_V", &port1, &port2)?).and_then(Path::from_points)
}

pub(crate) fn straight(pair: &PortPair<'_>) -> Result<Vec<Point>> {
    pair.check_turn(&[0.0, 180.0], "turned by 180°")?;
    let lateral = pair.lateral_distance();
    if round3(lateral) != 0.0 {
        return Err(
            pair.error(format_args!("port2 must lie straight ahead, but is {} to the side", micrometers(lateral)))
        );
    }
    if round3(pair.forward_distance()) <= 0.0 {
        return Err(pair.missing("the distance of port2 ahead of port1", pair.forward_distance(), 1e-3));
    }
    Ok(vec![pair.port1.midpoint(), pair.port2.midpoint()])
}

pub(crate) fn l(pair: &PortPair<'_>) -> Result<Vec<Point>> {
    pair.check_turn(&[90.0, 270.0], "turned by 90° or 270°")?;
    let start = pair.port1.midpoint();
    Ok(vec![start, start + pair.forward1 * pair.forward_distance(), pair.port2.midpoint()])
}

pub(crate) fn z(pair: &PortPair<'_>, length1: f64, length2: f64) -> Result<Vec<Point>> {
    check_finite("path_Z", "length1", length1)?;
    check_finite("path_Z", "length2", length2)?;
    let (start, end) = (pair.port1.midpoint(), pair.port2.midpoint());
    Ok(vec![start, start + pair.forward1 * length1, end + pair.forward2 * length2, end])
}

pub(crate) fn v(pair: &PortPair<'_>) -> Result<Vec<Point>> {
    let sine = pair.forward1.cross(pair.forward2);
    if sine.abs() < PARALLEL {
        return Err(pair.error("the ports are parallel, so their axes do not meet"));
    }
    let ahead = pair.span().cross(pair.forward2) / sine;
    let start = pair.port1.midpoint();
    Ok(vec![start, start + pair.forward1 * ahead, pair.port2.midpoint()])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(path: Result<Path>) -> Vec<(f64, f64)> {
        path.unwrap().points().iter().map(|p| (round3(p.x), round3(p.y))).collect()
    }

    #[test]
    fn straight_lines_have_the_tolerances_of_the_reference() {
        let to = |x: f64, y: f64, orientation: f64| path_straight(((0, 0), 1, 0), ((x, y), 1, orientation));
        assert_eq!(points(to(10.0, 0.0, 180.0)), [(0., 0.), (10., 0.)]);
        assert!(to(10.0, 0.0, 0.0).is_ok() && to(10.0, 0.0004, 180.0).is_ok() && to(10.0, 0.0, 180.0004).is_ok());
        assert!(to(10.0, 0.0006, 180.0).is_err() && to(10.0, 0.0, 180.0006).is_err());
        assert!(to(-10.0, 0.0, 180.0).unwrap_err().to_string().contains("10.001 µm are missing"));
    }

    #[test]
    fn corners_are_those_of_the_reference() {
        let origin = || Port::new((0, 0), 1, 0);
        assert_eq!(points(path_l(origin(), ((10, 5), 1, 270))), [(0., 0.), (10., 0.), (10., 5.)]);
        assert_eq!(points(path_l(origin(), ((-10, -5), 1, 270))), [(0., 0.), (-10., 0.), (-10., -5.)]);
        let z = path_z(origin(), ((30, 50), 1, 180), 100, 100);
        assert_eq!(points(z), [(0., 0.), (100., 0.), (-70., 50.), (30., 50.)]);
        assert!(path_l(origin(), ((10, 5), 1, 180)).is_err() && path_z(origin(), origin(), f64::NAN, 1).is_err());
    }

    #[test]
    fn a_v_has_its_corner_where_the_axes_meet_and_none_if_they_do_not() {
        let path = path_v(((0, 50), 1, 290), ((30, 50), 1, 250)).unwrap();
        assert!(path.points()[1].distance(Point::new(15.0, 8.787_839)) < 1e-6);
        assert!(
            path_v(((0, 0), 1, 30), ((5, 9), 1, 30)).is_err() && path_v(((0, 0), 1, 30), ((5, 9), 1, 210)).is_err()
        );
    }
}
