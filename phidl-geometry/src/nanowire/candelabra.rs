//! [`snspd_candelabra`]: a detector that fills its area to the edge of what can be drawn.
//!
//! Its turns stand outside the rhombus that the rows fill, each a hairpin of ample pitch on two bends. The standard bend
//! is the outline between an [`optimal_90deg`](super::optimal_90deg) edge and its shifted copy, written down point by
//! point; PHIDL subtracts the two and thereby rounds to 1e-4 µm, which is coarse for narrow wires.

use std::f64::consts::SQRT_2;

use phidl_core::param::{Check, Kind, Mismatch, Param};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::right_angle::{inner_edge, lead_end};
use super::{OptimalHairpinParams, optimal_90deg};
use crate::{arc, compass};

/// Pitch of a turn's hairpin in wire widths.
const PIN_PITCH: f64 = 10.0 / 3.0;
/// Length of a turn's hairpin in wire widths: standard, and with `xwing`.
const PIN_LENGTH: f64 = 8.0;
const XWING_PIN_LENGTH: f64 = 15.0;
/// Radius of the bends with `xwing` in wire widths, and their angular resolution in degrees.
const XWING_RADIUS: f64 = 3.0;
const XWING_RESOLUTION: f64 = 2.5;
/// Points and length of the bends at the terminals and of the standard turns.
const BEND_POINTS: usize = 15;
const BEND_LENGTH: f64 = 1.0;
/// More rows than this are taken for a mistake.
const MOST_ROWS: f64 = 1e5;
/// A gap that is not filled (µm): the noise of placing things.
const SMALLEST_GAP: f64 = 1e-9;

/// How much of the differences in length between rows is made up for in the turns: 0 to 1, or `true` for all.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Equalization(pub f64);

impl From<bool> for Equalization {
    fn from(all: bool) -> Self {
        Self(f64::from(u8::from(all)))
    }
}

impl From<f64> for Equalization {
    fn from(part: f64) -> Self {
        Self(part)
    }
}

impl Param for Equalization {
    fn kind() -> Kind {
        Kind::Other("true, false, or a number from 0 to 1")
    }

    fn to_value(&self) -> Value {
        self.0.into()
    }

    fn from_value(value: &Value) -> Result<Self, Mismatch> {
        match value {
            Value::Bool(all) => Ok((*all).into()),
            number => f64::from_value(number).map(Self),
        }
    }
}

/// Draws a meander whose turns stand outside of its rhombic area, so that the rows can be as close as can be.
///
/// ```text
///            1
///      ╭──╮  ┃  ╭──╮
///   ╭──╯ ━━━━┻━━╯  ╰──╮         rows wire_pitch apart,
///   ╰─╮━━━━━━━━━━━━━╭──╯         longest in the middle
///      ╰──╯  ┃   ╰──╯
///            2
/// ```
///
/// It is symmetric under half a turn about its center, the origin.
///
/// # Ports
/// `1` above, facing 90°; `2` below, facing 270°; both `wire_width` wide.
///
/// # Errors
/// `wire_pitch` must be greater than `wire_width`. There must be room for two full rows: `haxis` must hold the turns on
/// both sides and rows that differ by a step, and `vaxis` must not ask for fewer.
///
/// # Numerics
/// Bends have the 15 points of [`optimal_90deg`](fn@crate::optimal_90deg), or with `xwing` one every 2.5°. The height
/// follows from the number of rows and is close to `vaxis` only.
///
/// # Differences from PHIDL
/// Coordinates of bends are not rounded to 1e-4.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let d = pg::SnspdCandelabraParams::default().haxis(40).vaxis(20).xwing(true).build()?;
/// assert_eq!(d.port("1")?.orientation(), 90.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// D. V. Reddy et al., APL Photonics 7, 051302 (2022), <https://doi.org/10.1063/5.0088007>.
#[device]
pub fn snspd_candelabra(
    /// Width of the wire.
    #[default(0.52)]
    #[param(unit = "um", above = 0.0)]
    wire_width: f64,
    /// Distance between the middles of neighboring rows; more than `wire_width`.
    #[default(0.56)]
    #[param(unit = "um", above = 0.0)]
    wire_pitch: f64,
    /// Width, the turns included.
    #[default(90.0)]
    #[param(unit = "um", above = 0.0)]
    haxis: f64,
    /// Height that is aimed at.
    #[default(50.0)]
    #[param(unit = "um", above = 0.0)]
    vaxis: f64,
    /// Lengthen the turns so that all rows and turns take the same way: all of the way, or a part of it.
    #[default(false)]
    #[param(min = 0.0, max = 1.0)]
    equalize_path_lengths: Equalization,
    /// Turns that stand at 45°, on round bends.
    #[default(false)]
    xwing: bool,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    Check::device("snspd_candelabra").greater("wire_pitch", wire_pitch, ("wire_width", wire_width))?;
    let wire = Wire { width: wire_width, pitch: wire_pitch, layer, xwing };
    let half = wire.half(haxis, vaxis, equalize_path_lengths.0)?;

    let mut d = Device::builder("snspd_candelabra");
    let upper = d.add(&half);
    let lower = d.add(half.place().rotated(180));
    let (end, other) = (d[upper].port("2")?, d[lower].port("2")?);
    let gap = end.midpoint().x - other.midpoint().x;
    if gap != 0.0 {
        let mut bridge = wire.bar(gap.abs())?;
        bridge.connect(if gap > 0.0 { "E" } else { "W" }, &end)?;
        d.add(bridge);
    }
    d.add_port("1", d[upper].port("1")?)?;
    d.add_port("2", d[lower].port("1")?)?;
    d.build()
}

/// What all parts have in common.
struct Wire {
    width: f64,
    pitch: f64,
    layer: Layers,
    xwing: bool,
}

/// Where a turn has the straight piece that sets its ports one pitch apart.
#[derive(Clone, Copy, PartialEq)]
enum Pass {
    BeforePin,
    AfterPin,
}

impl Wire {
    /// The upper half: from the terminal down to half of the longest row, which lies on y = 0.
    fn half(&self, haxis: f64, vaxis: f64, equalize: f64) -> Result<Device> {
        let turn = self.turn(0.0)?;
        let longest = haxis - 2.0 * turn.size().width;
        let growth = (turn.port("1")?.midpoint().x - turn.port("2")?.midpoint().x).abs() + self.pitch;
        let check = Check::device("snspd_candelabra");
        check.greater("haxis", haxis, ("two turns and a step of the rows", haxis - longest + growth))?;
        check.at_most("number of rows", longest / growth, MOST_ROWS)?;
        let first = self.first_bar_length(longest, growth, vaxis);

        let mut d = Device::builder("snspd_candelabra");
        let mut bend = self.terminal_bend()?;
        let to_axis = -bend.port("1")?.midpoint().x;
        bend.move_by((to_axis, 0.0));
        let mut bar = self.bar(first)?;
        bar.connect("W", &bend.port("2")?)?;
        let (bend, bar) = (d.add(bend), d.add(bar));

        // Each row ends in a turn that leads to the next one, longer and one pitch further down.
        let mut length = 2.0 * d.size().width - self.width;
        let least = ("the shortest one and a step (a larger haxis or vaxis)", length + growth);
        check.unit("um").greater("longest row", longest, least)?;
        let mut pad = longest - length - growth;
        let mut end = d[bar].port("E")?;
        let mut left = false;
        loop {
            let turn = if equalize > 0.0 { self.turn(pad * equalize)? } else { turn.clone() };
            let mut turn = if left { turn.place().mirrored((0, 0), (0, 1)) } else { turn.place() };
            turn.connect("1", &end)?;
            end = turn.port("2")?;
            d.add(turn);
            left = !left;
            pad -= growth;
            if length >= longest - growth {
                break;
            }
            length += growth;
            end = self.add_row(&mut d, length, left, &end)?;
        }
        let end = self.add_row(&mut d, length / 2.0, left, &end)?;
        d.add_port("2", end)?;
        self.center(&mut d, bend, bar)?;
        d.build()
    }

    /// Adds a row that begins at `start`, from the right to the left if the last turn was on the right.
    fn add_row(&self, d: &mut DeviceBuilder, length: f64, left: bool, start: &Port) -> Result<Port> {
        let (near, far) = if left { ("E", "W") } else { ("W", "E") };
        let mut row = self.bar(length)?;
        row.connect(near, start)?;
        let end = row.port(far)?;
        d.add(row);
        Ok(end)
    }

    /// Half of what is left for the first row when as many rows as wanted, or as fit, grow by their steps.
    fn first_bar_length(&self, longest: f64, growth: f64, vaxis: f64) -> f64 {
        let wanted = (vaxis / (2.0 * self.pitch)).ceil() + 2.0;
        let mut steps = wanted.min((longest / growth).floor() + 1.0);
        while longest - growth * steps <= 0.0 {
            steps -= 1.0;
        }
        (longest - growth * steps) / 2.0
    }

    /// Centers the rows on x = 0 and puts the terminal there, and the last row on y = 0.
    fn center(&self, d: &mut DeviceBuilder, bend: ReferenceKey, bar: ReferenceKey) -> Result<()> {
        d.set_x(0.0);
        if !self.xwing {
            let off = d[bend].port("1")?.midpoint().x;
            d[bend].movex(-off);
        }
        let bar = d[bar].port("W")?;
        let gap = bar.midpoint().x - d[bend].port("2")?.midpoint().x;
        if gap > SMALLEST_GAP {
            let mut filler = self.bar(gap)?;
            filler.connect("E", &bar)?;
            d.add(filler);
        }
        let shift = (-d.x(), -d.ymin() - self.width / 2.0);
        d.move_by(shift);
        d.add_port("1", d[bend].port("1")?)?;
        Ok(())
    }

    /// From the left at port 1 around and back to the left at port 2, one pitch lower; its hairpin stands `pad / 2`
    /// further out.
    fn turn(&self, pad: f64) -> Result<Device> {
        let (bend, angle) = if self.xwing { (self.round_bend(45.0)?, 270) } else { (self.bend()?, 90) };
        let pin = self.pin()?;
        let (at, length) = self.pass();
        let pass = self.upright(length)?;
        let chain = match at {
            Pass::BeforePin => [(&pass, "S", "N"), (&pin, "1", "2")],
            Pass::AfterPin => [(&pin, "1", "2"), (&pass, "N", "S")],
        };

        let mut d = Device::builder("candelabra_turn");
        let first = bend.place().rotated(angle);
        let outward = first.port("2")?;
        let mut end = outward.clone();
        d.add_port("1", first.port("1")?)?;
        d.add(first);
        for (part, near, far) in chain.into_iter().chain([(&bend, "2", "1")]) {
            let mut part = part.place();
            part.connect(near, &end)?;
            end = part.port(far)?;
            if pad > 0.0 && part.device().same_cell(&pin) {
                self.lengthen(&mut d, &mut part, outward.normal() * (pad / 2.0))?;
            }
            d.add(part);
        }
        d.add_port("2", end)?;
        d.build()
    }

    /// Moves a hairpin outwards and adds the two legs that it then stands on.
    fn lengthen(&self, d: &mut DeviceBuilder, pin: &mut Reference, by: Point) -> Result<()> {
        pin.move_by(by);
        let leg = self.upright(by.norm())?;
        for name in ["1", "2"] {
            let mut leg = leg.place();
            leg.connect("N", &pin.port(name)?)?;
            d.add(leg);
        }
        Ok(())
    }

    fn pin(&self) -> Result<Device> {
        let length = if self.xwing { XWING_PIN_LENGTH } else { PIN_LENGTH };
        OptimalHairpinParams {
            width: self.width,
            pitch: PIN_PITCH * self.width,
            length: length * self.width,
            layer: self.layer.clone(),
            ..Default::default()
        }
        .build()
    }

    /// The straight piece that sets the ports of a turn one pitch apart, and its length.
    fn pass(&self) -> (Pass, f64) {
        if !self.xwing {
            return (Pass::AfterPin, self.pitch);
        }
        let excess = PIN_PITCH * self.width - SQRT_2 * self.pitch;
        (if excess > 0.0 { Pass::BeforePin } else { Pass::AfterPin }, excess.abs())
    }

    /// The bend at the terminal: port 1 facing up, port 2 facing right.
    fn terminal_bend(&self) -> Result<Reference> {
        if self.xwing {
            return Ok(self.round_bend(90.0)?.place().rotated(180));
        }
        Ok(optimal_90deg(self.width, BEND_POINTS, BEND_LENGTH, self.layer.clone())?.place())
    }

    fn round_bend(&self, angle: f64) -> Result<Device> {
        arc(XWING_RADIUS * self.width, self.width, angle, 0, XWING_RESOLUTION, self.layer.clone())
    }

    /// A bend of a standard turn: what the edge of an optimal right angle covers more than the same edge shifted by one
    /// wire width towards the corner.
    fn bend(&self) -> Result<Device> {
        let w = self.width;
        let outer = inner_edge(w, BEND_POINTS, BEND_LENGTH);
        let end = lead_end(&outer);
        let inner = outer.iter().rev().map(|p| *p - Point::new(w, w));
        let mut outline = vec![Point::new(end, w)];
        outline.extend(&outer);
        outline.extend([(w, end), (0.0, end), (0.0, end - w)].map(Point::from));
        outline.extend(inner);
        outline.extend([(end - w, 0.0), (end, 0.0)].map(Point::from));

        let mut d = Device::builder("candelabra_bend");
        d.add_polygon(outline, &self.layer)?;
        d.add_port("1", ((w / 2.0, end), w, 90))?;
        d.add_port("2", ((end, w / 2.0), w, 0))?;
        d.build()
    }

    /// A straight piece along x.
    fn bar(&self, length: f64) -> Result<Reference> {
        Ok(compass((length, self.width), self.layer.clone())?.place())
    }

    /// A straight piece along y.
    fn upright(&self, length: f64) -> Result<Device> {
        compass((self.width, length), self.layer.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use testkit::golden::merged_area;

    #[test]
    fn the_default_has_the_rows_of_the_specification() {
        let d = SnspdCandelabraParams::default().build().unwrap();
        assert_eq!(d.flat_polygons().count(), 401);
        let half = d.references()[0].device();
        let mut rows: Vec<f64> = half
            .references()
            .iter()
            .filter(|r| r.device().name() == "compass")
            .map(|r| r.size().width)
            .filter(|length| *length > 5.0)
            .collect();
        rows.sort_by(f64::total_cmp);
        // 33 rows, and half of the last one again. The measured lengths come from bends rounded to 1e-4.
        let halved = rows.iter().position(|l| (l - 79.13328760 / 2.0).abs() < 1e-4).unwrap();
        rows.remove(halved);
        assert_eq!(rows.len(), 32, "the shortest row is the first bar and its mirror image");
        assert!((rows[31] - 79.13328760).abs() < 1e-4, "{rows:?}");
        assert!(d.port("1").unwrap().midpoint().distance(Point::new(0.0, 21.24507713)) < 1e-7);
    }

    #[test]
    fn rows_that_touch_and_areas_without_a_row_are_refused() {
        assert_eq!(
            SnspdCandelabraParams::default().wire_pitch(0.5).build().unwrap_err().to_string(),
            "snspd_candelabra: wire_pitch is 0.5 µm, but it must be greater than wire_width, 0.52 µm"
        );
        let error = SnspdCandelabraParams::default().haxis(10).vaxis(20).build().unwrap_err();
        assert!(
            error.to_string().starts_with("snspd_candelabra: haxis is 10 µm, but it must be greater than"),
            "{error}"
        );
    }

    #[test]
    fn a_single_row_is_refused() {
        let error = SnspdCandelabraParams::default().wire_width(1).wire_pitch(2.91).haxis(36.87).vaxis(32).build();
        let error = error.unwrap_err().to_string();
        assert!(error.starts_with("snspd_candelabra: longest row is 18.5"), "{error}");
        assert!(SnspdCandelabraParams::default().vaxis(1).build().is_err());
    }

    #[test]
    fn equalization_is_a_part_or_all() {
        assert_eq!(Equalization::from_value(&true.into()).unwrap(), Equalization(1.0));
        assert_eq!(Equalization::from_value(&0.5.into()).unwrap(), Equalization(0.5));
        assert!(Equalization::from_value(&"all".into()).is_err());
        assert!(SnspdCandelabraParams::default().equalize_path_lengths(1.5).build().is_err());
    }

    #[test]
    fn half_a_turn_about_the_center_changes_nothing() {
        let d = SnspdCandelabraParams::default().haxis(40).vaxis(20).xwing(true).build().unwrap();
        let bbox = d.bbox().unwrap();
        assert!((bbox.min + bbox.max).norm() < 1e-9);
        let (one, two) = (d.port("1").unwrap(), d.port("2").unwrap());
        assert!((one.midpoint() + two.midpoint()).norm() < 1e-9);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn no_part_lies_on_another(
            width in 0.1..1.0_f64, gap in 0.03..2.0_f64, haxis in 40.0..80.0_f64, vaxis in 15.0..50.0_f64,
            equalize in prop_oneof![Just(0.0), 0.0..1.0], xwing in any::<bool>(),
        ) {
            let params = SnspdCandelabraParams::default().wire_width(width).wire_pitch(width * (1.0 + gap)).xwing(xwing);
            let params = params.haxis(haxis * width).vaxis(vaxis * width).equalize_path_lengths(equalize);
            let built = params.build();
            prop_assume!(built.is_ok());
            let d = built.unwrap();
            let outlines: Vec<Vec<Point>> = d.flat_polygons().map(|p| p.points().collect()).collect();
            let drawn: f64 = outlines.iter().map(|p| phidl_core::geom::signed_area(p).abs()).sum();
            // Only the lead of the bend at each terminal may lie on the first row.
            let leads = 2.0 * 5.9 * width * width;
            prop_assert!(drawn - merged_area(&outlines) <= leads, "{drawn} {}", merged_area(&outlines));
            prop_assert!(d.size().width <= haxis * width + 1e-9);
        }
    }
}
