//! [`turn`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::ring::open_arc;

/// Draws an [`arc`](fn@crate::arc) that continues a port.
///
/// ```text
///          2
///          │
///         ╱     radius to the middle of the wire
///   ━━━1─╯      angle: to the left if positive
///   port
/// ```
///
/// # Ports
/// `1` on the given port, facing it; `2` at the other end; both as wide as the port.
///
/// # Info
/// `length`: length of the middle line (µm).
///
/// # Errors
/// Those of [`arc`](fn@crate::arc).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let wire = pg::straight((2, 10), 1)?;
/// let bend = pg::turn(wire.port("1")?, 20, 90, 2.5, 1)?;
/// assert_eq!(bend.port("2")?.midpoint(), Point::new(-19.0, 30.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `turn`.
#[device(picture = "docs/turn.svg", example = TurnParams::new(Port::new((0, 0), 2, 90)))]
pub fn turn(
    /// Where it starts; its width is the width of the wire.
    port: Port,
    /// Radius of the middle of the wire.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Angle of the turn, to the left if positive.
    #[default(270.0)]
    #[param(unit = "deg", min = -360.0, max = 360.0)]
    angle: f64,
    /// Angle that decides the number of points.
    #[default(2.5)]
    #[param(unit = "deg", above = 0.0)]
    angle_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    // The center is to the left or right of the direction that the port faces.
    let side = 90.0 * angle.signum();
    let center = port.midpoint() + Point::polar(radius, port.orientation() + side);
    open_arc(center, radius, port.width(), angle, port.orientation() - side, angle_resolution, layer)?.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_to_both_sides_are_those_of_the_specification() {
        let port = Port::new((7.5, 6.7), 1, 47);
        let left = turn(&port, 10, 270, 2.5, 0).unwrap();
        let points = left.polygons().next().unwrap().points.to_vec();
        assert_eq!(points.len(), 216);
        assert!(points[0].distance(Point::new(7.134323, 7.040999)) < 1e-6);
        let end = left.port("2").unwrap();
        assert!(end.midpoint().distance(Point::new(-6.633521, 6.206447)) < 1e-6);
        assert!((left.port("1").unwrap().orientation() - 227.0).abs() < 1e-9);
        assert!((end.orientation() - 317.0).abs() < 1e-9);

        let right = turn(&port, 10, -90, 2.5, 0).unwrap();
        assert!(right.port("2").unwrap().midpoint().distance(Point::new(21.633521, 7.193553)) < 1e-6);
    }

    #[test]
    fn no_turn_at_all_is_refused() {
        assert!(turn(Port::new((0, 0), 1, 0), 10, 0, 2.5, 0).is_err());
    }
}
