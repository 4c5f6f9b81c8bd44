//! Closed curves around the origin: [`circle`] and [`ellipse`].
//!
//! Both have equal steps of the polar angle and repeat the first point at the end, as PHIDL does.

use phidl_core::num::count;
use phidl_core::prelude::*;
use phidl_macros::device;

use super::directions::around;

/// Draws a disc around the origin.
///
/// # Ports
/// None.
///
/// # Errors
/// More than 16,777,215 points.
///
/// # Numerics
/// `n = ⌈360 / angle_resolution⌉` chords, or the fewest that stay within `tolerance` where that is given; the first
/// point, on the x axis, is repeated at the end. At the default of 2.5° a chord leaves the circle by 2.4e-4 of the
/// radius.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let disc = pg::circle(10, 2.5, 1)?;
/// assert_eq!(disc.polygons().next().map(|p| p.points.len()), Some(145));
/// let smooth = pg::CircleParams::default().radius(100).tolerance(0.001).build()?;
/// assert!(smooth.area() > PI * 100.0 * 99.998);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `circle`.
#[device(picture = "docs/circle.svg")]
pub fn circle(
    /// Radius; a negative one starts on the left.
    #[default(10.0)]
    #[param(unit = "um")]
    radius: f64,
    /// Largest angle between neighboring points.
    #[default(2.5)]
    #[param(unit = "deg", above = 0.0, below = 180.0)]
    angle_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// Largest distance of a chord from the circle, instead of `angle_resolution`.
    #[default(None)]
    #[param(named, unit = "um", above = 0.0)]
    tolerance: Option<f64>,
) -> Result<Device> {
    let chords = match tolerance {
        Some(tolerance) => count::for_tolerance(radius.abs(), 360.0, tolerance).max(3),
        None => count::per_turn(angle_resolution),
    };
    closed_curve(check, "circle", chords, layer, |direction| direction * radius)
}

/// Draws an ellipse around the origin, its axes along x and y.
///
/// # Ports
/// None.
///
/// # Errors
/// A radius of 0. More than 16,777,215 points.
///
/// # Numerics
/// `⌈360 / angle_resolution⌉` chords at equal steps of the **polar angle** φ, not of the parameter of the ellipse:
/// `r(φ) = a b / √((b cos φ)² + (a sin φ)²)`. The first point, on the x axis, is repeated at the end.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let e = pg::ellipse((10, 5), 2.5, 1)?;
/// assert_eq!(e.size(), Size::new(20.0, 10.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `ellipse`.
#[device(picture = "docs/ellipse.svg")]
pub fn ellipse(
    /// Half axes along x and y; a negative one starts on the left.
    #[default((10, 5))]
    #[param(unit = "um")]
    radii: Size,
    /// Largest angle between neighboring points.
    #[default(2.5)]
    #[param(unit = "deg", above = 0.0, below = 180.0)]
    angle_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let Size { width: a, height: b } = radii;
    check.that("radii", format_args!("{radii} µm"), a != 0.0 && b != 0.0, "not be 0")?;
    let (flatness, a) = (a / b, a * b.signum());
    closed_curve(check, "ellipse", count::per_turn(angle_resolution), layer, |direction| {
        let (x, y) = (direction.x, flatness * direction.y);
        direction * (a / (x * x + y * y).sqrt())
    })
}

/// One outline from 0° to 360°, both ends included.
fn closed_curve(
    check: Check<'_>,
    name: &str,
    chords: usize,
    layer: Layers,
    at: impl Fn(Point) -> Point,
) -> Result<Device> {
    check.at_most("number of points", chords as f64, count::MOST as f64 - 1.0)?;
    let mut points = around(chords);
    points.iter_mut().for_each(|direction| *direction = at(*direction));
    let mut d = Device::builder(name);
    d.add_polygon(points, layer)?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipse_of_equal_radii_is_the_circle() {
        let (e, c) = (ellipse((7, 7), 3, 0).unwrap(), circle(7, 3, 0).unwrap());
        let far = |d: &Device| d.polygons().next().unwrap().points.to_vec();
        assert!(far(&e).iter().zip(far(&c)).all(|(p, q)| p.distance(q) < 1e-12));
    }

    #[test]
    fn one_negative_radius_turns_an_ellipse_by_half_and_two_do_not() {
        let first = |radii: (f64, f64)| ellipse(radii, 90, 0).unwrap().polygons().next().unwrap().points[0];
        assert_eq!(first((-3.0, 8.0)), Point::new(-3.0, 0.0));
        assert_eq!(first((3.0, -8.0)), Point::new(-3.0, 0.0));
        assert_eq!(first((-3.0, -8.0)), Point::new(3.0, 0.0));
        assert!(ellipse((3, 0), 2.5, 0).is_err() && ellipse((0, 3), 2.5, 0).is_err());
    }

    #[test]
    fn the_second_point_of_an_ellipse_is_at_its_polar_angle() {
        let e = ellipse((10, 5), 2.5, 0).unwrap();
        let second = e.polygons().next().unwrap().points[1];
        assert!(second.distance(Point::new(9.962091, 0.434954)) < 1e-6, "{second}");
    }
}
