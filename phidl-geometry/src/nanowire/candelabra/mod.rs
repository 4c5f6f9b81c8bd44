//! [`snspd_candelabra`]: a detector that fills its area to the edge of what can be drawn.
//!
//! Its turns stand outside the rhombus that the rows fill, each a hairpin of ample pitch on two bends. The standard bend
//! is the outline between an [`optimal_90deg`](fn@super::optimal_90deg) edge and its shifted copy, written down point by
//! point; PHIDL subtracts the two and thereby rounds to 1e-4 µm, which is coarse for narrow wires.

mod equalization;
mod parts;
mod rows;

use phidl_core::prelude::*;
use phidl_macros::device;

pub use equalization::Equalization;
use parts::Wire;

/// Draws a meander whose turns lie outside its rhombic area, so that `wire_pitch` may be as small as fabrication allows.
///
/// The rows have the pitch `wire_pitch` and fill the rhombus, the longest in the middle.
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
/// follows from the number of rows and is close to `vaxis` only. All parts are polygons of one cell with shared corners, so
/// that no grid opens a gap between them.
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
#[device(picture = "docs/snspd_candelabra.svg")]
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
    /// Lengthen the turns until all paths of a row and its turn are equally long: fully (`true`, 1) or by a factor.
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
    check.greater("wire_pitch", wire_pitch, ("wire_width", wire_width))?;
    let wire = Wire { width: wire_width, pitch: wire_pitch, layer, xwing };
    let mut d = assembled(&wire, &wire.half(check, haxis, vaxis, equalize_path_lengths.0)?)?;
    d.flatten()?;
    d.build()
}

/// Both halves of the detector, as references.
fn assembled(wire: &Wire, half: &Device) -> Result<DeviceBuilder> {
    let mut d = Device::builder("snspd_candelabra");
    let upper = d.add(half);
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
    Ok(d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use testkit::golden::merged_area;

    #[test]
    fn the_default_has_the_rows_of_the_specification() {
        let d = SnspdCandelabraParams::default().build().unwrap();
        assert_eq!((d.polygons().len(), d.references().len()), (401, 0));
        let wire = Wire { width: 0.52, pitch: 0.56, layer: 0.into(), xwing: false };
        let half = wire.half(SnspdCandelabraParams::entry().check(), 90.0, 50.0, 0.0).unwrap();
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
