//! [`route_custom`]: routes with bends and cross-sections that are functions.
//!
//! It is no generator: functions cannot be compared, and the cache of generators compares parameters.

use phidl_core::geom::Outline;
use phidl_core::layer::Layers;
use phidl_core::port::Port;
use phidl_core::scene::Device;
use phidl_core::{Error, Result};
use phidl_path::{Bend, CrossSection, Overlaps, Path};

use crate::draw::RouteDrawing;
use crate::path_type::turns;
use crate::port_pair::PortPair;

/// Draws a cross-section of any kind along waypoints between two ports, with bends of any kind at the corners.
///
/// The ports are those of the sections; the info is `length`, `bends` and `smallest_radius` (null, since it is unknown).
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_path::{ArcBend, Path, Section};
/// # use phidl_route::{path_u, route_custom};
/// let (a, b) = (Port::new((0, 0), 1, 0), Port::new((100, 50), 1, 180));
/// let waypoints = path_u(&a, &b, 20)?;
/// let chamfer = |radius: f64, angle: f64| {
///     let mut path = Path::from_points([Point::ORIGIN, Point::polar(radius, angle / 2.0)])?;
///     path.set_start_angle(0).set_end_angle(angle);
///     Ok(path)
/// };
/// let wavy = Section::new(|t: f64| 1.0 + 0.2 * (60.0 * t).sin()).layer(1).ports("1", "2");
/// let wire = route_custom(&a, &b, waypoints.points(), 5, chamfer, &wavy.into())?;
/// assert_eq!(wire.port("1")?.midpoint(), a.midpoint());
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Custom`] if the waypoints do not start at `port1`, end at `port2` and run along the axes of the ports there, or
/// if the wire runs over itself; as for [`Path::smooth`] and [`Path::extrude`].
pub fn route_custom(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    waypoints: impl Outline,
    radius: impl Into<f64>,
    bend: impl Bend,
    cross_section: &CrossSection,
) -> Result<Device> {
    let (port1, port2) = (port1.into(), port2.into());
    let pair = PortPair::new("route_custom", &port1, &port2)?;
    let waypoints = waypoints.into_points();
    if waypoints.len() < 2 {
        return Err(Error::custom("route_custom", format!("at least 2 waypoints are needed, not {}", waypoints.len())));
    }
    pair.check_waypoints(&waypoints)?;
    let path = Path::smooth(&waypoints, radius, bend)
        .map_err(|error| error.within(format!("the route {}", pair.between())))?;
    let drawing = RouteDrawing {
        what: pair.what(),
        path: &path,
        finer: None,
        layer: &Layers::default(),
        width: None,
        bends: turns(&waypoints).len(),
        smallest_radius: None,
        overlaps: Overlaps::RefuseAll,
    };
    drawing.extruded(cross_section, &pair)?.build()
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_path::{ArcBend, Section};

    #[test]
    fn functions_and_custom_bends_are_drawn_and_wrong_waypoints_refused() {
        let (a, b) = (Port::new((0, 0), 1, 0), Port::new((50, 50), 1, 270));
        let x = CrossSection::from(Section::new(|t: f64| 1.0 + t).offset(|t: f64| t * (1.0 - t)));
        let bend = |radius: f64, angle: f64| ArcBend::new().num_pts(100).path(radius, angle);
        let wire = route_custom(&a, &b, [(0, 0), (50, 0), (50, 50)], 10, bend, &x).unwrap();
        assert_eq!(wire.info()["bends"].as_f64(), Some(1.0));
        assert!(route_custom(&a, &b, [(0, 0), (0, 50), (50, 50)], 10, bend, &x).is_err());
        assert!(route_custom(&a, &b, [(0, 0)], 10, bend, &x).is_err());
    }
}
