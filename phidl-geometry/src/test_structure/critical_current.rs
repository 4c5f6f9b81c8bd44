//! [`test_ic`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;
use crate::nanowire::OptimalStepParams;

/// Part of a pad that its cover takes, in both directions.
const COVERED: f64 = 0.9;
/// From one wire to the next, in widths of a pad.
const PITCH: f64 = 1.2;

/// Draws a row of wires with a constriction, between a common pad and one pad for each, to measure critical currents.
///
/// ```text
///   ┌─────┐ ┌─────┐ ┌─────┐
///   │     │ │     │ │     │   pads, pad_size
///   └──┬──┘ └──┬──┘ └──┬──┘
///      │       ║       ┃      wire_widths_wide at the pads,
///      ·       │       ║      wire_widths in the middle   pad_gap
///      │       ║       ┃
///   ┌──┴───────┴───────┴──────┐
///   │        common pad       │
///   └─────────────────────────┘
/// ```
///
/// The common pad has its lower left corner at the origin. Each constriction consists of four quarters, drawn by
/// [`optimal_step`](fn@crate::optimal_step). Pads are covered, except for a margin, on `pad_layer` and `gnd_layer`.
///
/// # Ports
/// None.
///
/// # Errors
/// The two lists of widths must be equally long, and no wire narrower at its pads than in the middle.
///
/// # Numerics
/// All parts are polygons of one cell with equal coordinates where they meet, so that no grid opens a gap between them.
///
/// The length of a constriction follows from its curves: about 6.6 times the wide width for a ratio of widths of 3. If it
/// is longer than `pad_gap`, it runs into the pads.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let wires = pg::TestIcParams::default().wire_widths([1, 2]).wire_widths_wide([3, 4]).build()?;
/// assert_eq!(wires.size(), Size::new(480.0, 475.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `test_ic`.
#[device(picture = "docs/test_ic.svg")]
pub fn test_ic(
    /// Width of each wire in the middle.
    #[default([0.25, 0.5, 1.0, 2.0, 4.0])]
    #[param(unit = "um", above = 0.0)]
    wire_widths: Vec<f64>,
    /// Width of each wire at its pads.
    #[default([0.75, 1.5, 3.0, 4.0, 6.0])]
    #[param(unit = "um", above = 0.0)]
    wire_widths_wide: Vec<f64>,
    /// Width and height of the pads.
    #[default((200, 200))]
    #[param(unit = "um", above = 0.0)]
    pad_size: Size,
    /// From the common pad to the others, edge to edge.
    #[default(75.0)]
    #[param(unit = "um", min = 0.0)]
    pad_gap: f64,
    /// Where wires and pads are drawn.
    #[default(0)]
    wire_layer: Layers,
    /// Where the single pads are covered.
    #[default(1)]
    pad_layer: Layers,
    /// Where the common pad is covered.
    #[default(1)]
    gnd_layer: Layers,
) -> Result<Device> {
    check_widths(check, &wire_widths, &wire_widths_wide)?;
    let Size { width: px, height: py } = pad_size;
    let cover = Size::new(COVERED * px, COVERED * py);
    let top = py + pad_gap;

    let mut d = Device::builder("test_ic");
    let common = PITCH * px * wire_widths.len() as f64;
    let uncovered = (1.0 - COVERED) / 2.0;
    d.add(rectangle((common, py), &wire_layer)?);
    d.add(rectangle((COVERED * common, cover.height), gnd_layer)?.place().moved_by((uncovered * common, 0)));
    for (i, (narrow, wide)) in wire_widths.into_iter().zip(wire_widths_wide).enumerate() {
        let x = PITCH * px * i as f64;
        d.add(rectangle(pad_size, &wire_layer)?.place().moved_by((x, top)));
        let covered = (x + uncovered * px, top + py - cover.height);
        d.add(rectangle(cover, &pad_layer)?.place().moved_by(covered));
        let middle = Point::new(x + px / 2.0, py + pad_gap / 2.0);
        for part in wire(narrow, wide, pad_gap, &wire_layer)? {
            d.add(part.moved_by(middle));
        }
    }
    d.flatten()?;
    d.build()
}

fn check_widths(check: Check<'_>, narrow: &[f64], wide: &[f64]) -> Result<()> {
    check.that("wire_widths", "empty", !narrow.is_empty(), "name at least one width")?;
    let rule = format!("be {}, the number of wire_widths", narrow.len());
    check.that("number of wire_widths_wide", wide.len(), narrow.len() == wide.len(), &rule)?;
    for (i, (narrow, wide)) in narrow.iter().zip(wide).enumerate() {
        let name = format!("wire_widths[{i}]");
        check.at_least(&format!("wire_widths_wide[{i}]"), *wide, (name.as_str(), *narrow))?;
    }
    Ok(())
}

/// A wire along y around the origin, `gap` long: the constriction and a lead on either side.
fn wire(narrow: f64, wide: f64, gap: f64, layer: &Layers) -> Result<[Reference; 3]> {
    let (constriction, half_length) = constriction(narrow, wide, layer)?;
    // Below zero if the constriction is longer than the gap: such leads lie on it.
    let length = gap / 2.0 - half_length;
    let lead = rectangle((wide, length), layer)?.place().moved_by((-wide / 2.0, 0));
    let upper = lead.clone().moved_by((0, gap / 2.0 - length.max(0.0)));
    let lower = lead.moved_by((0, -gap / 2.0 - length.min(0.0)));
    Ok([constriction.place().rotated(90), upper, lower])
}

/// Four quarters of a level wire around the origin, wide at its ends and narrow in the middle, and half its length (µm).
fn constriction(narrow: f64, wide: f64, layer: &Layers) -> Result<(Device, f64)> {
    let step = |from: f64, to: f64| {
        OptimalStepParams { start_width: from / 2.0, end_width: to / 2.0, layer: layer.clone(), ..Default::default() }
            .build()
    };
    // Both lie above y = 0. Their narrow ends come together at x = 0.
    let (closing, opening) = (step(wide, narrow)?, step(narrow, wide)?);
    let (wide_end, narrow_end) = (closing.port("1")?.midpoint().x, closing.port("2")?.midpoint().x);
    let closing = closing.place().moved_by((-narrow_end, 0));
    let opening = opening.place().moved_by((-opening.port("1")?.midpoint().x, 0));

    let mut d = Device::builder("test_ic_step");
    d.add(closing.clone());
    d.add(opening.clone().rotated(180));
    d.add(closing.rotated(180));
    d.add(opening);
    Ok((d.build()?, narrow_end - wide_end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constriction_is_as_long_and_as_wide_as_specified() {
        let (d, half_length) = constriction(0.25, 0.75, &0.into()).unwrap();
        // PHIDL draws the box (-1.98219460, -0.375)–(2.95046576, 0.375), about another origin.
        assert!((2.0 * half_length - (2.950_465_76 + 1.982_194_60)).abs() < 1e-7);
        let expected = Rect::new((-half_length, -0.375), (half_length, 0.375));
        let bbox = d.bbox().unwrap();
        assert!(bbox.min.distance(expected.min) < 1e-9 && bbox.max.distance(expected.max) < 1e-9, "{bbox:?}");
    }

    #[test]
    fn a_wire_reaches_from_pad_to_pad_and_no_further_if_there_is_room() {
        let parts = wire(0.5, 1.5, 75.0, &0.into()).unwrap();
        let all = Rect::union_all(parts.iter().map(Bounded::bbox)).unwrap();
        assert!(all.min.distance((-0.75, -37.5).into()) < 1e-9 && all.max.distance((0.75, 37.5).into()) < 1e-9);
    }

    #[test]
    fn widths_without_a_constriction_are_refused() {
        let ic = |narrow: &[f64], wide: &[f64]| {
            let params = TestIcParams::default().wire_widths(narrow.to_vec()).wire_widths_wide(wide.to_vec());
            params.build().unwrap_err().to_string()
        };
        assert_eq!(
            ic(&[1.0, 2.0], &[3.0, 1.5]),
            "test_ic: wire_widths_wide[1] is 1.5 µm, but it must be at least wire_widths[1], 2 µm"
        );
        assert_eq!(
            ic(&[1.0, 2.0], &[3.0]),
            "test_ic: number of wire_widths_wide is 1, but it must be 2, the number of wire_widths"
        );
        assert!(ic(&[], &[]).contains("at least one"));
    }
}
