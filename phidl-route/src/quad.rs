//! [`route_quad`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::port_pair::{PortPair, left_of};

/// Draws the quadrilateral between two ports.
///
/// ```text
///   port1 ┌──────────┐
///         │          │ port2
///         │   ───────┘
///         └──
/// ```
///
/// Its corners are the ends of the ports, clockwise about their mean, the first one after the direction straight down.
/// The ports may have any position and orientation.
///
/// # Ports
/// `1` on `port1`, `width1` wide, and `2` on `port2`, `width2` wide, facing them.
///
/// # Info
/// `length`: the distance of the ports (µm); `bends`: 0; `smallest_radius`: null.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::route_quad;
/// let joint = route_quad(((0, 0), 2, 0), ((10, 5), 4, 180), None, None, 1)?;
/// assert_eq!(joint.polygons().next().unwrap().points[0], Point::new(0.0, -1.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `route_quad`.
#[device(picture = "docs/route_quad.svg", example = RouteQuadParams::new(((0, 0), 2, 0), ((10, 5), 4, 180)))]
pub fn route_quad(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Width at the start, that of `port1` if not given.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width1: Option<f64>,
    /// Width at the end, that of `port2` if not given.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width2: Option<f64>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let pair = PortPair::new("route_quad", &port1, &port2)?;
    let widths = [width1.unwrap_or(port1.width()), width2.unwrap_or(port2.width())];
    let mut d = Device::builder("route_quad");
    d.add_polygon(corners([&port1, &port2], widths), layer)?;
    d.add_port("1", port1.flipped().with_width(widths[0]))?;
    d.add_port("2", port2.flipped().with_width(widths[1]))?;
    d.info("length", pair.span().norm()).info("bends", 0).info("smallest_radius", Value::Null);
    d.build()
}

/// The ends of the ports, clockwise about their mean.
fn corners(ports: [&Port; 2], widths: [f64; 2]) -> Vec<Point> {
    let ends = |(port, width): (&Port, f64)| {
        let half = left_of(port.normal()) * (width / 2.0);
        [port.midpoint() + half, port.midpoint() - half]
    };
    let mut corners: Vec<Point> = ports.into_iter().zip(widths).flat_map(ends).collect();
    let mean = corners.iter().fold(Point::ORIGIN, |sum, p| sum + *p) / 4.0;
    // From the y axis clockwise; corners in the same direction keep their order.
    corners.sort_by(|a, b| f64::total_cmp(&bearing(*a - mean), &bearing(*b - mean)));
    corners
}

fn bearing(from_mean: Point) -> f64 {
    from_mean.x.atan2(from_mean.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(port1: impl Into<Port>, port2: impl Into<Port>) -> Vec<(f64, f64)> {
        let d = route_quad(port1, port2, None, None, 0).unwrap();
        d.polygons().next().unwrap().points.iter().map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn corners_go_clockwise_from_straight_down() {
        assert_eq!(outline(((0, 0), 2, 0), ((10, 5), 4, 180)), [(0., -1.), (0., 1.), (10., 7.), (10., 3.)]);
        assert_eq!(outline(((0, 0), 20, 0), ((1, 0), 2, 90)), [(0., -10.), (0., 0.), (0., 10.), (2., 0.)]);
    }

    #[test]
    fn ports_face_those_that_are_joined_and_no_layer_draws_nothing() {
        let (a, b) = (Port::new((0, 0), 2, 30).with_info("loss", 0.5), Port::new((10, 5), 4, 180));
        let d = route_quad(&a, &b, 1, None, Layers::NONE).unwrap();
        let port = d.port("1").unwrap();
        assert_eq!((port.midpoint(), port.width(), port.orientation()), (Point::ORIGIN, 1.0, 210.0));
        assert_eq!(port.info()["loss"].as_f64(), Some(0.5));
        assert_eq!((d.port("2").unwrap().width(), d.polygons().len()), (4.0, 0));
        assert_eq!(d.info()["length"].as_f64(), Some(125.0_f64.sqrt()));
    }
}
