//! [`ytron_round`].

use phidl_core::num::angle::directions;
use phidl_core::num::count::{self, linspace};
use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

/// A quantity of both arms of a [`ytron_round`](fn@ytron_round); given as a pair, the left arm first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arms {
    /// That of the left arm.
    pub left: f64,
    /// That of the right arm.
    pub right: f64,
}

impl<L: Into<f64>, R: Into<f64>> From<(L, R)> for Arms {
    fn from((left, right): (L, R)) -> Self {
        Self { left: left.into(), right: right.into() }
    }
}

impl<N: Into<f64>> From<[N; 2]> for Arms {
    fn from([left, right]: [N; 2]) -> Self {
        Self { left: left.into(), right: right.into() }
    }
}

impl Param for Arms {
    fn param_type() -> ParamType {
        ParamType::Other("two numbers, left and right")
    }

    fn to_value(&self) -> Value {
        vec![self.left, self.right].into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match Vec::<f64>::from_value(value)?[..] {
            [left, right] => Ok(Self { left, right }),
            _ => Err(ConversionError::new(value, "be two numbers, left and right")),
        }
    }
}

/// Draws a Y of two superconducting arms that meet at a rounded tip: a current in one arm changes how much the other
/// carries.
///
/// ```text
///   left        right
///   ╲   ╲      ╱   ╱
///    ╲   ╲    ╱   ╱     theta: from the upright to each arm
///     ╲   ╲__╱   ╱      rho: radius of the tip between them
///      │        │
///      │ source │
/// ```
///
/// # Ports
/// `left` and `right` at the ends of the arms, facing 90°; `source` at the bottom, facing 270°.
///
/// # Info
/// `rho`, `left_width`, `right_width`, `source_width` (µm).
///
/// # Errors
/// `theta` must be at least 0 and less than 90: it is the tilt of one arm, half of the angle between both. The source must
/// be longer than the tip reaches below its corners, `rho sin theta`, or the tip would cut it in two. Beyond a `theta` of
/// 30° the inner edge of an arm begins below the outer one, and must not have crossed over where that begins: arms must be
/// wide enough.
///
/// # Numerics
/// The tip is an arc of `⌊(180 − 2 theta) / theta_resolution⌋ + 2` points. Widths of arms are measured along x.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let y = pg::YtronRoundParams::default().arm_widths((200, 250)).build()?;
/// assert_eq!(y.port("right")?.width(), 250.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// A. N. McCaughan, N. S. Abebe, Q.-Y. Zhao and K. K. Berggren, "Using geometry to sense current", Nano Letters 16, 7626
/// (2016).
#[device(picture = "docs/ytron_round.svg")]
pub fn ytron_round(
    /// Radius of the tip between the arms.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    rho: f64,
    /// Length of the arms, left and right.
    #[default((500, 300))]
    #[param(unit = "um", above = 0.0)]
    arm_lengths: Arms,
    /// Length of the common part.
    #[default(500.0)]
    #[param(unit = "um", above = 0.0)]
    source_length: f64,
    /// Width of the arms, left and right.
    #[default((200, 200))]
    #[param(unit = "um", above = 0.0)]
    arm_widths: Arms,
    /// Tilt of each arm from the upright.
    #[default(2.5)]
    #[param(unit = "deg", min = 0.0, below = 90.0)]
    theta: f64,
    /// Angle between neighboring points of the tip.
    #[default(10.0)]
    #[param(unit = "deg", above = 0.0)]
    theta_resolution: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let tip = tip(check, rho, theta, theta_resolution)?;
    let corner = Point::polar(rho, theta);
    // The common part is measured from the corners, and the tip stands on the origin.
    let depth = corner.y;
    check.greater("source_length", source_length, ("the depth of the tip", depth))?;
    let along = |length: f64| Point::polar(length, 90.0 - theta);
    let (left_arm, right_arm) = (along(arm_lengths.left), along(arm_lengths.right));
    // How far the inner edges begin below the outer ones: from the end of the tip to the corner.
    let below = 2.0 * corner.y - rho;
    for (name, width, arm) in
        [("arm_widths.left", arm_widths.left, left_arm), ("arm_widths.right", arm_widths.right, right_arm)]
    {
        let taken = if below > 0.0 { arm.x * below / (arm.y + below) } else { 0.0 };
        check.greater(name, width, ("what the inner edge takes of it", taken))?;
    }
    let (left, right) = (corner.x + arm_widths.left, corner.x + arm_widths.right);
    let bottom = corner.y - source_length;
    let sides = [
        corner + right_arm,
        corner + right_arm + Point::new(arm_widths.right, 0.0),
        Point::new(right, corner.y),
        Point::new(right, bottom),
        Point::new(0.0, bottom),
        Point::new(-left, bottom),
        Point::new(-left, corner.y),
        Point::new(-(left + left_arm.x), corner.y + left_arm.y),
        Point::new(-(corner.x + left_arm.x), corner.y + left_arm.y),
    ];
    let source_width = left + right;

    let mut d = Device::builder("ytron");
    d.add_polygon(tip.into_iter().chain(sides).collect::<Vec<_>>(), layer)?;
    let left_end = (-(corner.x + left_arm.x + arm_widths.left / 2.0), corner.y + left_arm.y);
    let right_end = (corner.x + right_arm.x + arm_widths.right / 2.0, corner.y + right_arm.y);
    d.add_port("left", (left_end, arm_widths.left, 90))?;
    d.add_port("right", (right_end, arm_widths.right, 90))?;
    d.add_port("source", (((right - left) / 2.0, bottom), source_width, 270))?;
    d.info("rho", rho).info("left_width", arm_widths.left).info("right_width", arm_widths.right);
    d.info("source_width", source_width);
    d.build()
}

/// The lower part of a circle that stands on the origin, from arm to arm.
fn tip(check: Check<'_>, rho: f64, theta: f64, resolution: f64) -> Result<Vec<Point>> {
    // In radians, as PHIDL counts: in degrees another quotient might be whole.
    let steps = (PI - 2.0 * theta.to_radians()) / resolution.to_radians();
    let points = count::up(steps.floor()) + 2;
    check.at_most("number of points", points, count::MOST - 16)?;
    let angles = linspace(-(180.0 - theta), -theta, points);
    Ok(directions(angles).into_iter().map(|direction| direction * rho + Point::new(0.0, rho)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn the_common_part_may_be_shorter_than_the_tip_is_high() {
        let d = YtronRoundParams::default().rho(100).theta(2).source_length(50).build().unwrap();
        assert!((d.ymin() - (100.0 * 2_f64.to_radians().sin() - 50.0)).abs() < 1e-9);
        let error = YtronRoundParams::default().rho(100).theta(2).source_length(3).build().unwrap_err();
        assert!(error.to_string().contains("greater than the depth of the tip, 3.48"), "{error}");
    }

    #[test]
    fn arms_that_the_inner_edge_would_cross_are_refused() {
        // At 80°, an arm of 120 µm starts 2·50·sin 80° - 50 = 48.5 µm below: the edge is displaced by 83 µm where the outer begins.
        let arms =
            |width: f64| YtronRoundParams::default().rho(50).theta(80).arm_lengths((120, 120)).arm_widths((200, width));
        let least =
            120.0 * 80_f64.to_radians().sin() * 48.480_775_301 / (120.0 * 80_f64.to_radians().cos() + 48.480_775_301);
        assert!(outlines_are_simple(&arms(least + 1e-3).build().unwrap()));
        let error = arms(least - 1e-3).build().unwrap_err().to_string();
        assert!(error.contains("arm_widths.right is") && error.contains("what the inner edge takes"), "{error}");
    }

    #[test]
    fn the_default_is_that_of_the_specification() {
        let d = YtronRoundParams::default().build().unwrap();
        assert_eq!(d.polygons().next().unwrap().points.len(), 28);
        assert!((d.info()["source_width"].as_f64().unwrap() - 401.99809644).abs() < 1e-8);
        let bbox = d.bbox().unwrap();
        assert!(bbox.min.distance(Point::new(-222.80874190, -499.95638061)) < 1e-7);
        assert!(bbox.max.distance(Point::new(214.08486443, 499.56773018)) < 1e-7);
    }

    #[test]
    fn tilts_beyond_the_horizontal_and_lists_of_three_arms_are_refused() {
        assert_eq!(
            YtronRoundParams::default().theta(90).build().unwrap_err().to_string(),
            "ytron_round: theta is 90°, but it must be less than 90°"
        );
        assert!(Arms::from_value(&vec![1.0, 2.0, 3.0].into()).is_err());
        assert_eq!(Arms::from_value(&Arms::from((1, 2.5)).to_value()).unwrap(), Arms { left: 1.0, right: 2.5 });
        assert!(YtronRoundParams::default().theta_resolution(1e-12).build().is_err());
    }

    proptest! {
        #[test]
        fn ports_are_edges_of_the_outline(
            rho in 0.1..5.0_f64, l in 10.0..500.0_f64, r in 10.0..500.0_f64, theta in 0.0..89.0_f64,
        ) {
            let d = YtronRoundParams::default().rho(rho).arm_lengths((l, r)).theta(theta).build().unwrap();
            prop_assert!(outlines_are_simple(&d));
            let points = d.polygons().next().unwrap().points.to_vec();
            for port in d.ports() {
                let (a, b) = port.endpoints();
                prop_assert!([a, b].iter().all(|end| points.iter().any(|p| p.distance(*end) < 1e-9)), "{port}");
            }
        }
    }
}
