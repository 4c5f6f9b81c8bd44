//! [`snspd`] and [`snspd_expanded`]: meandering nanowires that detect single photons.

use phidl_core::error::ParamError;
use phidl_core::num::count;
use phidl_core::prelude::*;
use phidl_macros::device;

use super::{OptimalHairpinParams, OptimalStepParams};
use crate::arguments::PartialSize;
use crate::compass;

/// Points of the inner edge of a turn.
const TURN_POINTS: usize = 20;
/// By how much of a row a height may exceed whole rows without one more being drawn: the noise of a division.
const ROW_NOISE: f64 = 1e-9;
/// More rows than this are taken for a mistake.
const MOST_ROWS: usize = 1_000_000;

/// Draws a meander of [`optimal_hairpin`](fn@crate::optimal_hairpin)s: a superconducting nanowire single-photon
/// detector.
///
/// ```text
///   1 ━━━━━━━━━━━━━━━━━━╮
///   ╭───────────────────╯      ↕ wire_pitch
///   ╰───────────────────╮
///                ━━━━━━━━━━ 2   (or on the left, with terminals_same_side)
/// ```
///
/// Two of width, height and number of squares are given, or the number of squares alone, which makes a square area.
///
/// # Ports
/// `1` at the upper left, at (−width/4, 0), facing 180°; `2` at the lower right, facing 0°, or with
/// `terminals_same_side` at the lower left, facing 180°.
///
/// # Info
/// `num_squares`: of the drawn rows, without what the turns add. `area` (µm²) and `size` (µm): as asked for; the rows stand
/// `(rows − 1) · wire_pitch + wire_width` high.
///
/// # Errors
/// Exactly two of width, height and number of squares (or that one alone) must be given. There must be 3 rows, or 4
/// with both terminals on one side, and the width must hold two turns.
///
/// # Numerics
/// `⌈height / wire_pitch⌉` rows, and one more where the terminals ask for it. A quotient that exceeds a whole number by
/// the noise of the division only counts as that number. Rows and turns are polygons of one cell with shared corners, so that
/// no grid opens a gap between them.
///
/// # Differences from PHIDL
/// There such noise draws two more rows: 9 instead of 7 for a height of 4.2 and a pitch of 0.6.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let meander = pg::SnspdParams::default().size((10, None)).num_squares(1000).build()?;
/// assert_eq!(meander.port("1")?.width(), 0.2);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `snspd`; for the turns see [`optimal_hairpin`](fn@crate::optimal_hairpin).
#[device(picture = "docs/snspd.svg")]
pub fn snspd(
    /// Width of the wire.
    #[default(0.2)]
    #[param(unit = "um", above = 0.0)]
    wire_width: f64,
    /// Distance between the middles of neighboring rows; more than `wire_width`.
    #[default(0.6)]
    #[param(unit = "um", above = 0.0)]
    wire_pitch: f64,
    /// Width and height of the meander.
    #[default((10, 8))]
    #[param(unit = "um", above = 0.0)]
    size: PartialSize,
    /// Length over width of the whole wire.
    #[default(None)]
    #[param(above = 0.0)]
    num_squares: Option<f64>,
    /// Width of the wire in the turns, a multiple of `wire_width`.
    #[default(4.0)]
    #[param(above = 0.0)]
    turn_ratio: f64,
    /// Both terminals on the left.
    #[default(false)]
    terminals_same_side: bool,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let params = SnspdParams { wire_width, wire_pitch, size, num_squares, turn_ratio, terminals_same_side, layer };
    let mut d = params.assembled()?;
    d.flatten()?;
    d.build()
}

impl SnspdParams {
    /// Rows and turns, connected, as references.
    fn assembled(&self) -> Result<DeviceBuilder> {
        let &Self { wire_width, wire_pitch, size, num_squares, turn_ratio, terminals_same_side, ref layer } = self;
        let check = Self::entry().check();
        let size = closed(size, num_squares, wire_width * wire_pitch)?;
        let rows = rows(check, size.height / wire_pitch, terminals_same_side)?;
        let turn = OptimalHairpinParams {
            width: wire_width,
            pitch: wire_pitch,
            length: size.width / 2.0,
            turn_ratio,
            num_pts: TURN_POINTS,
            layer: layer.clone(),
        }
        .build()?;
        let bar = compass((size.width / 2.0, wire_width), layer)?;

        let mut d = Device::builder("snspd");
        let start = d.add(&bar);
        let ports_at = turn.port("1")?.midpoint().x;
        for row in 0..rows - 1 {
            let (angle, x) = if row % 2 == 0 { (0, -ports_at) } else { (180, ports_at) };
            let y = -(row as f64) * wire_pitch - wire_pitch / 2.0;
            d.add(turn.place().rotated(angle).moved_by((size.width / 4.0 + x, y)));
        }
        let bottom = -((rows - 1) as f64) * wire_pitch;
        let (angle, x) = if terminals_same_side { (0, 0.0) } else { (180, size.width / 2.0) };
        let finish = d.add(bar.place().rotated(angle).moved_by((x, bottom)));
        d.add_port("1", d[start].port("W")?)?;
        d.add_port("2", d[finish].port("W")?)?;
        d.info("num_squares", rows as f64 * size.width / wire_width);
        d.info("area", size.width * size.height).info("size", size);
        Ok(d)
    }
}

/// The size with what was open computed from the number of squares; `unit` is the area of one.
fn closed(size: PartialSize, num_squares: Option<f64>, unit: f64) -> Result<Size> {
    match (size.width, size.height, num_squares) {
        (Some(width), Some(height), None) => Ok(Size { width, height }),
        (Some(width), None, Some(n)) => Ok(Size { width, height: n * unit / width }),
        (None, Some(height), Some(n)) => Ok(Size { width: n * unit / height, height }),
        (None, None, Some(n)) => Ok(Size { width: (n * unit).sqrt(), height: (n * unit).sqrt() }),
        (width, height, n) => {
            let given = [width, height, n].iter().flatten().count();
            Err(ParamError {
                device: "snspd".to_owned(),
                param: "number of values among size and num_squares".to_owned(),
                value: given.to_string(),
                rule: "be two, or num_squares alone".to_owned(),
            }
            .into())
        }
    }
}

/// The number of rows: odd for terminals on both sides, even for one.
fn rows(check: Check<'_>, quotient: f64, terminals_same_side: bool) -> Result<usize> {
    let fitting = count::up(quotient - ROW_NOISE);
    let rows = if fitting.is_multiple_of(2) == terminals_same_side { fitting } else { fitting + 1 };
    let fewest = if terminals_same_side { 4_usize } else { 3 };
    check.between("number of rows (height / wire_pitch)", rows, fewest, MOST_ROWS)?;
    Ok(rows)
}

/// Draws a [`snspd`](fn@snspd) with an [`optimal_step`](fn@crate::optimal_step) to a wider wire at both terminals.
///
/// # Ports
/// `1` and `2` at the ends of the steps, `connector_width` wide, facing as those of the snspd.
///
/// # Info
/// Those of the snspd, `num_squares`, `area` (µm²) and `size` (µm); the steps are not counted.
///
/// # Errors
/// Those of [`snspd`](fn@snspd) and [`optimal_step`](fn@crate::optimal_step).
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let d = pg::SnspdExpandedParams::default().connector_width(2).build()?;
/// assert_eq!(d.port("2")?.width(), 2.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `snspd_expanded`.
#[device(picture = "docs/snspd_expanded.svg")]
pub fn snspd_expanded(
    /// Width of the wire.
    #[default(0.2)]
    #[param(unit = "um", above = 0.0)]
    wire_width: f64,
    /// Distance between the middles of neighboring rows; more than `wire_width`.
    #[default(0.6)]
    #[param(unit = "um", above = 0.0)]
    wire_pitch: f64,
    /// Width and height of the meander.
    #[default((10, 8))]
    #[param(unit = "um", above = 0.0)]
    size: PartialSize,
    /// Length over width of the whole wire.
    #[default(None)]
    #[param(above = 0.0)]
    num_squares: Option<f64>,
    /// Width of the wire at the ports.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    connector_width: f64,
    /// Widen the wire on both sides.
    #[default(false)]
    connector_symmetric: bool,
    /// Width of the wire in the turns, a multiple of `wire_width`.
    #[default(4.0)]
    #[param(above = 0.0)]
    turn_ratio: f64,
    /// Both terminals on the left.
    #[default(false)]
    terminals_same_side: bool,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let meander = snspd(wire_width, wire_pitch, size, num_squares, turn_ratio, terminals_same_side, layer.clone())?;
    let step = OptimalStepParams {
        start_width: wire_width,
        end_width: connector_width,
        num_pts: 100,
        width_tol: 1e-3,
        anticrowding_factor: 2.0,
        symmetric: connector_symmetric,
        layer,
    }
    .build()?;

    let mut d = Device::builder("snspd_expanded");
    d.add(&meander);
    for name in ["1", "2"] {
        let mut step = step.place();
        step.connect("1", meander.port(name)?)?;
        d.add_port(name, step.port("2")?)?;
        d.add(step);
    }
    for (key, value) in meander.info() {
        d.info(key.as_str(), value.clone());
    }
    d.flatten()?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn two_of_three_or_the_squares_alone_fix_the_size() {
        let unit = 0.2 * 0.6;
        assert_eq!(closed((10, 8).into(), None, unit).unwrap(), Size::new(10.0, 8.0));
        assert!((closed((10, None).into(), Some(1000.0), unit).unwrap().height - 12.0).abs() < 1e-12);
        assert!((closed((None, 8).into(), Some(1000.0), unit).unwrap().width - 15.0).abs() < 1e-12);
        assert!((closed((None, None).into(), Some(1000.0), unit).unwrap().width - 120.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!(
            closed((10, 8).into(), Some(3.0), unit).unwrap_err().to_string(),
            "snspd: number of values among size and num_squares is 3, but it must be two, or num_squares alone"
        );
        assert!(closed((10, None).into(), None, unit).is_err() && closed(PartialSize::default(), None, unit).is_err());
    }

    #[test]
    fn rows_are_odd_between_two_sides_and_even_on_one() {
        assert_eq!(rows(Check::new("snspd"), 8.0 / 0.6, false).unwrap(), 15);
        assert_eq!(rows(Check::new("snspd"), 13.2, true).unwrap(), 14);
        assert_eq!(rows(Check::new("snspd"), 4.2 / 0.6, false).unwrap(), 7, "7.000000000000001 is noise");
        assert_eq!(rows(Check::new("snspd"), 2.0, false).unwrap(), 3);
    }

    #[test]
    fn meanders_of_too_few_rows_and_narrow_ones_are_refused() {
        assert_eq!(
            SnspdParams::default().size((10, 0.5)).build().unwrap_err().to_string(),
            "snspd: number of rows (height / wire_pitch) is 1, but it must be at least 3"
        );
        assert!(SnspdParams::default().size((10, 1.2)).terminals_same_side(true).build().is_err());
        let error = SnspdParams::default().size((1, 1.3)).build().unwrap_err().report();
        assert!(error.starts_with("in snspd: optimal_hairpin: length is 0.5 µm"), "{error}");
        assert!(SnspdParams::default().size((10, 1e9)).build().is_err());
    }

    #[test]
    fn ports_and_records_are_those_of_the_specification() {
        let d = SnspdParams::default().build().unwrap();
        assert_eq!(d.port("1").unwrap().midpoint(), Point::new(-2.5, 0.0));
        assert!(d.port("2").unwrap().midpoint().distance(Point::new(7.5, -8.4)) < 1e-12);
        assert_eq!((&d.info()["num_squares"], &d.info()["area"]), (&750.0.into(), &80.0.into()));
        let d = SnspdExpandedParams::default().build().unwrap();
        assert!(d.port("1").unwrap().midpoint().distance(Point::new(-12.80682781, -0.4)) < 1e-8);
        assert!(d.port("2").unwrap().midpoint().distance(Point::new(17.80682781, -8.0)) < 1e-8);
    }

    proptest! {
        #[test]
        fn the_wire_is_whole(
            width in 0.1..0.4_f64, gap in 0.5..3.0_f64, height in 4.0..12.0_f64, same in any::<bool>(),
        ) {
            let pitch = width * (1.0 + gap);
            let params = SnspdParams::default().wire_width(width).wire_pitch(pitch).size((20, height));
            let d = params.terminals_same_side(same).assembled().unwrap().build().unwrap();
            // Walking from port to port through the references visits them all.
            let mut at = d.port("1").unwrap().midpoint();
            for part in d.references() {
                let ports: Vec<Point> = part.ports().filter(|p| p.width() == width).map(|p| p.midpoint()).collect();
                let (near, far): (Vec<Point>, Vec<Point>) = ports.into_iter().partition(|p| p.distance(at) < 1e-9);
                prop_assert_eq!(near.len(), 1);
                at = far[0];
            }
            prop_assert!(at.distance(d.port("2").unwrap().midpoint()) < 1e-9);
            let rows = (d.references().len() - 1) as f64;
            prop_assert!((d.size().height - ((rows - 1.0) * pitch + width)).abs() < 1e-9);
        }
    }
}
