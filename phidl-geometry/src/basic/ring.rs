//! Rings and parts of rings: [`ring`] and [`arc`].

use phidl_core::num::angle::directions;
use phidl_core::num::count::{self, linspace};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::directions::around;

/// Draws a closed ring around the origin.
///
/// ```text
///     ╭───────╮
///   ╭─┤       ├─╮
///   │ │   ·───┼─┤ radius to the middle of the ring
///   ╰─┤       ├─╯
///     ╰───────╯
/// ```
///
/// One outline with a seam at angle 0, since GDSII has no holes: the inner edge, then the outer edge backwards.
///
/// # Ports
/// None.
///
/// # Errors
/// A ring wider than its diameter has no inside: `width` must be at most `2 · radius`.
///
/// # Numerics
/// `round(360 / angle_resolution)` chords, halves to even. If that is not a multiple of four, the points miss the axes and the box is
/// smaller than the outer diameter.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let r = pg::ring(10, 0.5, 2.5, 1)?;
/// assert!((r.area() / (TAU * 10.0 * 0.5) - 1.0).abs() < 1e-3); // 2π · radius · width, less what chords lose
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `ring`.
#[device(picture = "docs/ring.svg")]
pub fn ring(
    /// Radius of the middle of the ring.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Radial width.
    #[default(0.5)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Angle between neighboring points.
    #[default(2.5)]
    #[param(unit = "deg", above = 0.0, max = 120.0)]
    angle_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check.at_most("width", width, ("twice the radius", 2.0 * radius))?;
    let chords = count::per_turn_nearest(angle_resolution);
    check.at_most("number of points", 2.0 * chords as f64, count::MOST as f64 - 2.0)?;

    let mut d = Device::builder("ring");
    d.add_polygon(band(Point::ORIGIN, radius, width, &around(chords)), layer)?;
    d.build()
}

/// Draws a part of a ring around the origin.
///
/// ```text
///        2
///      ╱╲
///     ╱  ╲   theta
///    ·────┴─ 1   start_angle
/// ```
///
/// # Ports
/// `1` at `start_angle` and `2` at `start_angle + theta`, at `radius` and `width` wide, facing along the ring and out of
/// it.
///
/// # Info
/// `length`: length of the middle line (µm).
///
/// # Errors
/// `theta` of 0 draws nothing and is refused; `width` must be at most `2 · radius`.
///
/// # Numerics
/// `⌈|theta| / angle_resolution⌉` points on each edge, both ends included, and at least two: the real step is a little
/// wider than `angle_resolution`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let bend = pg::arc(10, 0.5, 90, 0, 2.5, 1)?;
/// assert_eq!(bend.port("2")?.midpoint(), Point::new(0.0, 10.0));
/// assert_eq!(bend.port("2")?.orientation(), 180.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `arc`.
#[device(picture = "docs/arc.svg")]
pub fn arc(
    /// Radius of the middle of the arc.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Radial width.
    #[default(0.5)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    /// Extent, counter-clockwise if positive.
    #[default(45.0)]
    #[param(unit = "deg", min = -360.0, max = 360.0)]
    theta: f64,
    /// Where the arc begins, from the x axis.
    #[default(0.0)]
    #[param(unit = "deg")]
    start_angle: f64,
    /// Angle that decides the number of points.
    #[default(2.5)]
    #[param(unit = "deg", above = 0.0)]
    angle_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    open_arc(Point::ORIGIN, radius, width, theta, start_angle, angle_resolution, layer)?.build()
}

/// The body of [`arc()`] around any point.
pub(super) fn open_arc(
    center: Point,
    radius: f64,
    width: f64,
    theta: f64,
    start_angle: f64,
    angle_resolution: f64,
    layer: Layers,
) -> Result<DeviceBuilder> {
    let check = ArcParams::entry().check();
    check.at_most("width", width, ("twice the radius", 2.0 * radius))?;
    check.that("theta", format_args!("{theta}°"), theta != 0.0, "not be 0")?;
    let points = count::up(theta.abs() / angle_resolution).max(2);
    check.at_most("number of points", 2.0 * points as f64, count::MOST as f64 - 2.0)?;

    let end_angle = start_angle + theta;
    let out = 90.0 * theta.signum();
    let mut d = Device::builder("arc");
    let directions = directions(linspace(start_angle, end_angle, points));
    d.add_polygon(band(center, radius, width, &directions), layer)?;
    d.add_port("1", (center + Point::polar(radius, start_angle), width, start_angle - out))?;
    d.add_port("2", (center + Point::polar(radius, end_angle), width, end_angle + out))?;
    d.info("length", theta.abs().to_radians() * radius);
    Ok(d)
}

/// The inner edge along some directions, then the outer edge back.
fn band(center: Point, radius: f64, width: f64, directions: &[Point]) -> Vec<Point> {
    let (inner, outer) = (radius - width / 2.0, radius + width / 2.0);
    let edge = |radius: f64| directions.iter().map(move |direction| center + *direction * radius);
    edge(inner).chain(edge(outer).rev()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_negative_arc_turns_the_ports_round() {
        let d = arc(10, 0.5, -45, 0, 2.5, 0).unwrap();
        assert_eq!((d.port("1").unwrap().orientation(), d.port("2").unwrap().orientation()), (90.0, 225.0));
    }

    #[test]
    fn a_short_arc_has_two_points_on_each_edge() {
        let d = arc(10, 0.5, 1, 0, 2.5, 0).unwrap();
        assert_eq!(d.polygons().next().unwrap().points.len(), 4);
    }

    #[test]
    fn a_ring_misses_the_axes_if_its_chords_are_no_multiple_of_four() {
        let d = ring(5, 1.5, 7, 0).unwrap();
        assert!((d.xmin() + 5.739094).abs() < 1e-6 && d.xmax() == 5.75, "{:?}", d.bbox());
    }

    #[test]
    fn arcs_and_rings_without_an_inside_are_refused() {
        assert_eq!(
            ring(1, 3, 2.5, 0).unwrap_err().to_string(),
            "ring: width is 3 µm, but it must be at most twice the radius, 2 µm"
        );
        assert!(arc(1, 3, 45, 0, 2.5, 0).is_err());
        assert!(arc(10, 0.5, 0, 0, 2.5, 0).is_err());
    }
}
