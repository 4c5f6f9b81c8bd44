//! [`optimal_hairpin`]: a turn of 180° without current crowding.
//!
//! The inner edge is a streamline of the current around a sharp turn. It is integrated step by step. A closed form was
//! rejected: the steps define the points of PHIDL's masks.

use num_complex::Complex64;
use phidl_core::prelude::*;
use phidl_macros::device;

/// Largest number of steps of a streamline.
const MOST_STEPS: usize = 1_000_000;

/// Draws a nanowire turn of 180° without current crowding at its inner edge.
///
/// ```text
///   1 ━━━━━━━━━━━━━┓   ↑
///           ─╮     ┃   │ pitch
///           ─╯     ┃   │           symmetric about y = 0
///   2 ━━━━━━━━━━━━━┛   ↓
/// ```
///
/// # Ports
/// `1` above and `2` below, both `width` wide, facing 180°.
///
/// # Errors
/// `pitch` must be greater than `width`; `length` must hold the turn, which is about `pitch + turn_ratio · width` long.
///
/// # Numerics
/// The streamline is integrated in steps of about `width / (2 num_pts)`. Every n-th step is kept, so that slightly more
/// than `num_pts` points remain. The direction of a step is normalized approximately, as in PHIDL; with the default
/// parameters this moves the tip of the edge by 0.5 nm. The edge begins up to `width / 1000` inside the leads.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let turn = pg::OptimalHairpinParams::default().width(0.2).pitch(0.6).layer(2).build()?;
/// assert_eq!(turn.port("1")?.width(), 0.2);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// J. R. Clem and K. K. Berggren, "Geometry-dependent critical currents in superconducting nanocircuits", Phys. Rev. B
/// 84, 174510 (2011), <https://doi.org/10.1103/PhysRevB.84.174510>.
#[device(picture = "docs/optimal_hairpin.svg")]
pub fn optimal_hairpin(
    /// Width of the wire far from the turn.
    #[default(0.2)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Distance between the middles of the two wires; more than `width`.
    #[default(0.6)]
    #[param(unit = "um", above = 0.0)]
    pitch: f64,
    /// Length from the ports to the far side of the turn.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// Width of the wire in the turn, as a multiple of `width`.
    #[default(4.0)]
    #[param(above = 0.0)]
    turn_ratio: f64,
    /// About how many points the inner edge has on each side.
    #[default(50)]
    #[param(min = 2, max = 100000)]
    num_pts: usize,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check.greater("pitch", pitch, ("width", width))?;
    let edge = inner_edge(width, pitch, num_pts);
    let steps = format_args!("{num_pts} at a pitch of {} widths", pitch / width);
    check.that(
        "num_pts",
        steps,
        edge.last().is_some_and(|p| p.y == 0.0),
        "be smaller, since the inner edge would have more than a million points",
    )?;
    let (start, tip) = (edge[0], edge[edge.len() - 1]);
    let right = tip.x + turn_ratio * width;
    check.at_least("length", length, ("that of the turn", right - start.x))?;

    let (left, bottom) = (right - length, -(pitch + width) / 2.0);
    let corners = [(right, 0.0), (right, bottom), (start.x, bottom), (left, bottom), (left, bottom + width)];
    let lower: Vec<Point> = edge.iter().copied().chain(corners.map(Point::from)).chain([start]).collect();
    let upper: Vec<Point> = lower.iter().map(|p| Point::new(p.x, -p.y)).collect();

    let mut d = Device::builder("hairpin");
    d.add_polygon(lower, &layer)?;
    d.add_polygon(upper, &layer)?;
    d.add_port("1", ((left, pitch / 2.0), width, 180))?;
    d.add_port("2", ((left, -pitch / 2.0), width, 180))?;
    d.build()
}

/// The lower half of the inner edge, from the lead to the tip on y = 0; short of it if that takes too many steps.
fn inner_edge(width: f64, pitch: f64, num_pts: usize) -> Vec<Point> {
    let half_height = (pitch + width) / 2.0;
    let step = width / (2.0 * num_pts as f64);
    let mut at = Complex64::new(-pitch, -(pitch - width) / 2.0);
    let mut line = vec![at];
    while at.im < 0.0 && line.len() <= MOST_STEPS {
        let flow = (1.0 - (at * PI / half_height).exp()).sqrt();
        // The length of the vertical part is taken with an already normalized horizontal one.
        let along = flow.re / flow.norm();
        at += step * Complex64::new(along, flow.im / along.hypot(flow.im));
        line.push(at);
    }
    let every = (line.len() / num_pts).max(1);
    // The last step ends on the other side of y = 0 and is pulled back.
    let mut edge: Vec<Point> = line.iter().rev().step_by(every).map(|z| Point::new(z.re, z.im.min(0.0))).collect();
    edge.reverse();
    edge
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn the_inner_edge_is_that_of_the_specification() {
        let edge = inner_edge(0.2, 0.6, 50);
        assert_eq!(edge.len(), 56);
        for (i, x, y) in [
            (0, -0.590000, -0.199954),
            (20, -0.310059, -0.195034),
            (40, -0.034785, -0.151282),
            (50, 0.072415, -0.065124),
            (55, 0.090136, 0.0),
        ] {
            assert!(edge[i].distance(Point::new(x, y)) < 1e-6, "{i} {}", edge[i]);
        }
    }

    #[test]
    fn wires_that_touch_and_turns_that_are_too_long_are_refused() {
        assert_eq!(
            optimal_hairpin(0.6, 0.6, 10, 4, 50, 0).unwrap_err().to_string(),
            "optimal_hairpin: pitch is 0.6 µm, but it must be greater than width, 0.6 µm"
        );
        let error = optimal_hairpin(1, 2, 3, 4, 50, 0).unwrap_err().to_string();
        assert!(error.starts_with("optimal_hairpin: length is 3 µm, but it must be at least that of the turn, 6."));
        assert!(optimal_hairpin(1e-6, 100, 1000, 4, 50, 0).is_err());
    }

    proptest! {
        #[test]
        fn the_current_never_gets_less_room_than_in_the_leads(
            width in 0.05..1.0_f64, gap in 0.1..4.0_f64, ratio in 1.0..8.0_f64, num_pts in 10..80_usize,
        ) {
            let pitch = width * (1.0 + gap);
            let d = optimal_hairpin(width, pitch, 50, ratio, num_pts, 0).unwrap();
            let (bottom, edge) = (-(pitch + width) / 2.0, inner_edge(width, pitch, num_pts));
            prop_assert!((d.size().height - (pitch + width)).abs() < 1e-12);
            prop_assert!((d.size().width - 50.0).abs() < 1e-12);
            prop_assert!(outlines_are_simple(&d));
            prop_assert!(edge.iter().all(|p| p.y - bottom >= width * (1.0 - 1e-12)), "the wire only gets wider");
            prop_assert!(edge.windows(2).all(|p| p[0].y <= p[1].y && p[0].x <= p[1].x), "the edge does not turn back");
            for name in ["1", "2"] {
                prop_assert_eq!(d.port(name).unwrap().midpoint().x, d.xmin());
            }
        }
    }
}
