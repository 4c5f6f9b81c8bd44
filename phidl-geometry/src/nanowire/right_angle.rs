//! [`optimal_90deg`]: a right angle without current crowding.

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws a nanowire bend of 90° without current crowding at its inner edge.
///
/// The outer corner is the origin; the arms run along x and y.
///
/// # Ports
/// `1` at the end of the upright lead, facing 90°; `2` at the end of the other, facing 0°; both `width` wide.
///
/// # Numerics
/// The inner edge is `x = w (1 + 2/π · asinh(1/v))`, `y = w (1 + 2/π · asinh v)`; its points stand evenly in the
/// logarithm of `v`. It ends a little outside the leads (by 6 % of the width with the default `length_adjust`), and a straight
/// line joins it to their ends.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let bend = pg::optimal_90deg(0.5, 15, 1, 2)?;
/// assert_eq!(bend.port("1")?.width(), 0.5);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// J. R. Clem and K. K. Berggren, "Geometry-dependent critical currents in superconducting nanocircuits", Phys. Rev. B
/// 84, 174510 (2011), <https://doi.org/10.1103/PhysRevB.84.174510>.
#[device(picture = "docs/optimal_90deg.svg")]
pub fn optimal_90deg(
    /// Width of the wire.
    #[default(100.0)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Number of points of the inner edge.
    #[default(15)]
    #[param(min = 2, max = 1000000)]
    num_pts: usize,
    /// How far the leads reach, a pure number: about 1.47 widths more for 1 more.
    #[default(1.0)]
    #[param(above = 0.0, max = 100.0)]
    length_adjust: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let edge = inner_edge(width, num_pts, length_adjust);
    let first = edge[0];
    let end = lead_end(&edge);
    let outer = [(width, end), (0.0, end), (0.0, 0.0), (end, 0.0), (end, width)].map(Point::from);

    let mut d = Device::builder("90deg");
    d.add_polygon(edge.into_iter().chain(outer).chain([first]).collect::<Vec<_>>(), layer)?;
    d.add_port("1", ((width / 2.0, end), width, 90))?;
    d.add_port("2", ((end, width / 2.0), width, 0))?;
    d.build()
}

/// The inner edge, from the lead along x to the upright one.
pub(super) fn inner_edge(width: f64, points: usize, length_adjust: f64) -> Vec<Point> {
    let away = |exponent: f64| width * (1.0 + 2.0 / PI * 10.0_f64.powf(exponent).asinh());
    // The exponents are those of 1/v backwards, so each distance is that of two points.
    let away: Vec<f64> = linspace(-length_adjust, length_adjust, points).map(away).collect();
    away.iter().rev().zip(&away).map(|(x, y)| Point::new(*x, *y)).collect()
}

/// How far the leads reach from the outer corner.
pub(super) fn lead_end(edge: &[Point]) -> f64 {
    2.0 * edge[0].x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn leads_reach_as_far_as_specified() {
        let d = Optimal90degParams::default().build().unwrap();
        assert!((d.port("2").unwrap().midpoint().x - 581.74560243).abs() < 1e-8);
        assert!((inner_edge(1.0, 15, 1.0)[0].y - 1.0636).abs() < 1e-4);
    }

    proptest! {
        #[test]
        fn bends_are_symmetric_about_the_diagonal(width in 0.05..100.0_f64, n in 2..60_usize, adjust in 0.1..4.0_f64) {
            let edge = inner_edge(width, n, adjust);
            for (p, q) in edge.iter().zip(edge.iter().rev()) {
                prop_assert_eq!(*p, Point::new(q.y, q.x));
            }
            for (p, exponent) in edge.iter().zip(linspace(-adjust, adjust, n)) {
                let x = width * (1.0 + 2.0 / PI * (1.0 / 10.0_f64.powf(exponent)).asinh());
                prop_assert!((p.x - x).abs() < 1e-12 * width);
            }
            prop_assert!(edge.iter().all(|p| p.x > width && p.y > width), "nowhere narrower than the leads");
            let d = optimal_90deg(width, n, adjust, 0).unwrap();
            prop_assert!(outlines_are_simple(&d));
            let end = lead_end(&edge);
            prop_assert_eq!(d.bbox(), Some(Rect::new((0, 0), (end, end))));
        }
    }
}
