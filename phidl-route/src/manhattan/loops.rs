//! Waypoints with three or more legs at right angles: U, J and C.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::port::Port;
use phidl_path::Path;

use crate::port_pair::{PortPair, check_finite};

/// Forwards by `length1` (µm), across to the axis of the second port, and along it: between parallel ports.
///
/// ```
/// # use phidl_route::path_u;
/// let path = path_u(((0, 0), 1, 0), ((100, 50), 1, 180), 20)?;
/// assert_eq!(path.points()[2], (20, 50).into());
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) unless the ports are turned by 0° or 180° against each other and the
/// length is finite.
#[doc(alias = "path_U")]
pub fn path_u(port1: impl Into<Port>, port2: impl Into<Port>, length1: impl Into<f64>) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    u(&PortPair::new("path_U", &port1, &port2)?, length1.into()).and_then(Path::from_points)
}

/// Forwards by `length1`, across, and into the second port over its last `length2` (µm): between ports at a right angle.
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) unless the ports are turned by 90° or 270° against each other and the
/// lengths are finite.
#[doc(alias = "path_J")]
pub fn path_j(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    length1: impl Into<f64>,
    length2: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    j(&PortPair::new("path_J", &port1, &port2)?, length1.into(), length2.into()).and_then(Path::from_points)
}

/// Forwards by `length1`, to the left by `left1` (to the right if negative), along, and into the second port over its
/// last `length2` (µm): between parallel ports.
///
/// # Errors
/// [`Error::Custom`](phidl_core::Error::Custom) unless the ports are turned by 0° or 180° against each other and the
/// lengths are finite.
#[doc(alias = "path_C")]
pub fn path_c(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    length1: impl Into<f64>,
    left1: impl Into<f64>,
    length2: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2) = (port1.into(), port2.into());
    let pair = PortPair::new("path_C", &port1, &port2)?;
    c(&pair, length1.into(), left1.into(), length2.into()).and_then(Path::from_points)
}

pub(crate) fn u(pair: &PortPair<'_>, length1: f64) -> Result<Vec<Point>> {
    check_parallel(pair)?;
    check_finite("path_U", "length1", length1)?;
    let (start, end) = (pair.port1.midpoint(), pair.port2.midpoint());
    let a = start + pair.forward1 * length1;
    Ok(vec![start, a, a + pair.left1 * (end - a).dot(pair.left1), end])
}

pub(crate) fn j(pair: &PortPair<'_>, length1: f64, length2: f64) -> Result<Vec<Point>> {
    pair.check_turn(&[90.0, 270.0], "turned by 90° or 270°")?;
    check_finite("path_J", "length1", length1)?;
    check_finite("path_J", "length2", length2)?;
    let (start, end) = (pair.port1.midpoint(), pair.port2.midpoint());
    let a = start + pair.forward1 * length1;
    let b = end + pair.forward2 * length2;
    Ok(vec![start, a, a + pair.forward2 * (b - a).dot(pair.forward2), b, end])
}

pub(crate) fn c(pair: &PortPair<'_>, length1: f64, left1: f64, length2: f64) -> Result<Vec<Point>> {
    check_parallel(pair)?;
    for (name, length) in [("length1", length1), ("left1", left1), ("length2", length2)] {
        check_finite("path_C", name, length)?;
    }
    let (start, end) = (pair.port1.midpoint(), pair.port2.midpoint());
    let a = start + pair.forward1 * length1;
    let b = a + pair.left1 * left1;
    let e = end + pair.forward2 * length2;
    Ok(vec![start, a, b, b + pair.forward1 * (e - b).dot(pair.forward1), e, end])
}

fn check_parallel(pair: &PortPair<'_>) -> Result<()> {
    pair.check_turn(&[0.0, 180.0], "turned by 0° or 180°")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::port_pair::round3;

    fn points(path: Result<Path>) -> Vec<(f64, f64)> {
        path.unwrap().points()[1..].iter().map(|p| (round3(p.x), round3(p.y))).collect()
    }

    fn origin() -> Port {
        Port::new((0, 0), 1, 0)
    }

    #[test]
    fn loops_are_those_of_the_reference() {
        let u = path_u(origin(), ((10, 50), 1, 0), 200);
        assert_eq!(points(u), [(200., 0.), (200., 50.), (10., 50.)]);
        let j = path_j(origin(), ((10, 50), 1, 90), 200, 200);
        assert_eq!(points(j), [(200., 0.), (200., 250.), (10., 250.), (10., 50.)]);
        let j = path_j(origin(), ((10, 50), 1, 270), 25, 10);
        assert_eq!(points(j), [(25., 0.), (25., 40.), (10., 40.), (10., 50.)]);
        let c = path_c(origin(), ((-50, 10), 1, 180), 100, 100, 100);
        assert_eq!(points(c), [(100., 0.), (100., 100.), (-150., 100.), (-150., 10.), (-50., 10.)]);
        let c = path_c(origin(), ((-50, 10), 1, 180), 10, -30, 15);
        assert_eq!(points(c), [(10., 0.), (10., -30.), (-65., -30.), (-65., 10.), (-50., 10.)]);
    }

    #[test]
    fn ports_at_other_angles_are_refused() {
        assert!(
            path_u(origin(), ((10, 50), 1, 90), 20).is_err() && path_c(origin(), ((9, 9), 1, 45), 1, 1, 1).is_err()
        );
        let error = path_j(origin(), ((10, 50), 1, 180), 25, 10).unwrap_err();
        assert!(
            error.to_string().contains("the ports are turned by 180° against each other, but must be turned by 90°")
        );
        assert!(path_u(origin(), ((10, 50), 1, 0), f64::INFINITY).is_err());
    }
}
