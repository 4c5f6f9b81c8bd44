//! [`path_xy`] and [`route_xy`]: staircases.

use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use crate::RouteWidth;
use crate::draw::{RouteDrawing, overlaps};
use crate::path_type::turns;
use crate::port_pair::{PortPair, refused};

/// Steps up to this length (µm) are skipped.
const SHORTEST: f64 = 1e-6;

/// A line in steps along x and y, in the order of `directions`: each `x` goes an equal part of the distance in x, each `y`
/// of the distance in y. Capitals are accepted.
///
/// ```
/// # use phidl_route::path_xy;
/// let path = path_xy((0, 0), (12, 8), "xxyx")?;
/// assert_eq!(path.points()[1..4], [(4, 0).into(), (8, 0).into(), (8, 8).into()]);
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Param`](phidl_core::Error::Param) for other letters, or if a needed letter is missing (PHIDL then ends at another
/// point); [`Error::Custom`] if the two points are one.
pub fn path_xy(port1: impl Into<Point>, port2: impl Into<Point>, directions: &str) -> Result<Path> {
    Path::from_points(steps("path_xy", port1.into(), port2.into(), directions)?)
}

/// Draws a wire in steps along x and y, for any orientation of the ports: for fans of parallel wires.
///
/// ```text
///                  ┌───┤ port2
///          ┌───────┘
///   port1 ├┘              xyxyx
/// ```
///
/// # Ports
/// `1` on `port1` and `2` on `port2`. With a width they face them, with their info; without one, they face along the
/// ends of the line. With a cross-section: those of its sections.
///
/// # Info
/// `length` (µm), `bends`, and `smallest_radius`: 0 µm, or null without a corner.
///
/// # Errors
/// As for [`path_xy`]; and for widths and overlaps as in [`route_sharp`](fn@crate::route_sharp).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::route_xy;
/// let wire = route_xy(((0, 0), 2, 90), ((6, 5), 2, 270), "yyyxy", 0.1, 2)?;
/// assert_eq!(wire.info()["length"].as_f64(), Some(11.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `route_xy`.
#[device(picture = "docs/route_xy.svg", example = RouteXyParams::new(((0, 0), 2, 0), ((30, 20), 4, 270)))]
pub fn route_xy(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// The steps, a letter for each.
    #[default("xxyx")]
    directions: String,
    /// Width: a number, a pair from start to end, or a cross-section; none for those of the ports.
    #[default(None)]
    #[param(unit = "um")]
    width: Option<RouteWidth>,
    /// Where it is drawn; to be left out with a cross-section, whose sections have layers of their own.
    #[default(0)]
    layer: Layers,
    /// Whether the wire may run over itself.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    const NAME: &str = "route_xy";
    let pair = PortPair::new(NAME, &port1, &port2)?;
    let points = steps(NAME, port1.midpoint(), port2.midpoint(), &directions)?;
    let bends = turns(&points).len();
    let drawing = RouteDrawing {
        what: NAME,
        path: &Path::from_points(points)?,
        finer: None,
        layer: &layer,
        width: width.as_ref(),
        bends,
        smallest_radius: (bends > 0).then_some(0.0),
        overlaps: overlaps(allow_crossings),
    };
    match width {
        None => drawing.on_its_own(&pair)?.build(),
        Some(_) => drawing.between_ports(&pair)?.build(),
    }
}

/// The waypoints, ends included.
fn steps(what: &str, from: Point, to: Point, directions: &str) -> Result<Vec<Point>> {
    let directions = directions.to_ascii_lowercase();
    if let Some(other) = directions.chars().find(|letter| !matches!(letter, 'x' | 'y')) {
        return Err(refused(
            what,
            "directions",
            format_args!("{directions:?}"),
            format!("have only x and y, not {other:?}"),
        ));
    }
    let count = |letter| directions.chars().filter(|other| *other == letter).count();
    let (columns, rows, distance) = (count('x'), count('y'), to - from);
    for (letter, count, way) in [('x', columns, distance.x), ('y', rows, distance.y)] {
        if count == 0 && way.abs() > SHORTEST {
            let rule = format!("contain {letter:?}, since the ports are {} µm apart in {letter}", way.abs());
            return Err(refused(what, "directions", format_args!("{directions:?}"), rule));
        }
    }
    let (along_x, along_y) = (Point::new(distance.x / columns as f64, 0.0), Point::new(0.0, distance.y / rows as f64));
    let mut points = vec![from];
    for letter in directions.chars() {
        let step = if letter == 'x' { along_x } else { along_y };
        if step.norm() > SHORTEST {
            points.push(points[points.len() - 1] + step);
        }
    }
    match points.as_mut_slice() {
        [_, .., last] => *last = to,
        _ => return Err(Error::custom(what, format!("both ports are at {to}, so there is nothing to draw"))),
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(to: (f64, f64), directions: &str) -> Vec<(f64, f64)> {
        path_xy((0, 0), to, directions).unwrap().points().iter().map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn steps_are_those_of_the_specification() {
        assert_eq!(corners((12., 8.), "xxyx"), [(0., 0.), (4., 0.), (8., 0.), (8., 8.), (12., 8.)]);
        assert_eq!(corners((12., 8.), "yyyxy"), [(0., 0.), (0., 2.), (0., 4.), (0., 6.), (12., 6.), (12., 8.)]);
        assert_eq!(corners((12., 8.), "yxy"), [(0., 0.), (0., 4.), (12., 4.), (12., 8.)]);
        assert_eq!(corners((12., 8.), "YX"), [(0., 0.), (0., 8.), (12., 8.)]);
    }

    #[test]
    fn steps_of_no_length_are_skipped() {
        assert_eq!(corners((12., 0.), "xyx"), [(0., 0.), (6., 0.), (12., 0.)]);
        assert_eq!(corners((12., 0.), "xx"), [(0., 0.), (6., 0.), (12., 0.)]);
    }

    #[test]
    fn lines_that_would_end_elsewhere_are_refused() {
        let error = path_xy((0, 0), (12, 8), "x").unwrap_err();
        assert_eq!(
            error.to_string(),
            "path_xy: directions is \"x\", but it must contain 'y', since the ports are 8 µm apart in y"
        );
        assert!(path_xy((0, 0), (12, 8), "").is_err() && path_xy((0, 0), (12, 8), "xz").is_err());
        assert!(path_xy((1, 1), (1, 1), "xy").is_err());
    }
}
