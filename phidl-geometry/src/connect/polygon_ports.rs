//! [`polygon_ports`].

use phidl_core::geom::signed_area;
use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws any outline with a port on every edge.
///
/// # Ports
/// `1`, `2` … on the edges in the order of the points, the last one on the edge back to the first point: in the middle
/// of the edge, as wide as the edge is long, looking outwards.
///
/// # Errors
/// The lists must be equally long and enclose an area, since nothing else has an outside.
///
/// # Numerics
/// A last point that repeats the first one closes the outline as any outline is closed, and does not count.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let triangle = pg::polygon_ports([0, 4, 0], [0, 0, 3], 1)?;
/// assert_eq!((triangle.port("2")?.midpoint(), triangle.port("2")?.width()), (Point::new(2.0, 1.5), 5.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `polygon_ports`.
#[device(picture = "docs/polygon_ports.svg")]
pub fn polygon_ports(
    /// x of the points.
    #[default([-1, -1, 0, 0])]
    #[param(unit = "um")]
    xpts: Vec<f64>,
    /// y of the points.
    #[default([0, 1, 1, 0])]
    #[param(unit = "um")]
    ypts: Vec<f64>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let rule = format!("be {}, the number of xpts", xpts.len());
    check.that("number of ypts", ypts.len(), xpts.len() == ypts.len(), &rule)?;
    let mut outline: Vec<Point> = xpts.into_iter().zip(ypts).map(Point::from).collect();
    if outline.len() > 1 && outline.first() == outline.last() {
        outline.pop();
    }
    let area = signed_area(&outline);
    check.that("area of the outline", format_args!("{area} µm²"), area != 0.0, "not be 0 µm²")?;

    let mut d = Device::builder("polygon");
    d.add_polygon(&outline, layer)?;
    for (i, port) in edge_ports(&outline, area > 0.0).enumerate() {
        d.add_port((i + 1).to_string(), port)?;
    }
    d.build()
}

/// A port on every edge. Going round counter-clockwise, the outside is on the right.
fn edge_ports(outline: &[Point], counter_clockwise: bool) -> impl Iterator<Item = Port> {
    outline.iter().zip(outline.iter().cycle().skip(1)).map(move |(from, to)| {
        let (left, right) = if counter_clockwise { (to, from) } else { (from, to) };
        Port::between(*left, *right)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Midpoint, width and orientation of the ports.
    fn ports(d: &Device) -> Vec<(Point, f64, f64)> {
        d.ports().map(|port| (port.midpoint(), port.width(), port.orientation())).collect()
    }

    #[test]
    fn ports_face_outwards_for_both_directions_of_the_outline() {
        for xs in [[0, 4, 4, 0], [0, 0, 4, 4]] {
            let ys = if xs[1] == 4 { [0, 0, 2, 2] } else { [0, 2, 2, 0] };
            for (midpoint, _, orientation) in ports(&polygon_ports(xs, ys, 0).unwrap()) {
                let outside = midpoint + Point::polar(0.1, orientation);
                assert!(!Rect::new((0, 0), (4, 2)).contains(outside), "{midpoint} looks to {orientation}");
            }
        }
    }

    #[test]
    fn ports_of_a_slanted_triangle_are_those_of_the_specification() {
        let d = polygon_ports([0, 4, 1], [0, 1, 3], 0).unwrap();
        let expected = [(4.123_105_63, 284.036_243), (3.605_551_28, 56.309_932), (3.162_277_66, 161.565_051)];
        for ((_, width, orientation), (w, o)) in ports(&d).into_iter().zip(expected) {
            assert!((width - w).abs() < 1e-8 && (orientation - o).abs() < 1e-6, "{width} {orientation}");
        }
    }

    #[test]
    fn a_repeated_first_point_closes_the_outline_and_no_more() {
        let (open, closed) = (polygon_ports([0, 4, 1], [0, 1, 3], 0), polygon_ports([0, 4, 1, 0], [0, 1, 3, 0], 0));
        assert_eq!(ports(&open.unwrap()), ports(&closed.unwrap()));
    }

    #[test]
    fn lists_that_make_no_outline_are_refused() {
        let error = polygon_ports([0, 4, 1], [0, 1], 0).unwrap_err().to_string();
        assert_eq!(error, "polygon_ports: number of ypts is 2, but it must be 3, the number of xpts");
        assert!(polygon_ports([0, 1, 2], [0, 0, 0], 0).is_err());
        assert!(polygon_ports([0; 0], [0; 0], 0).is_err());
    }
}
