//! [`litho_steps`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;
use crate::text::{Justify, text};

/// Draws lines of decreasing width above bars with gaps of the same widths: each width in both tones.
///
/// ```text
///    16  ████        ███        ██         height / 2    line_widths, from the last one
///     ──────────────────────────────────── y = 0
///     ███    ███    ███   ███   ███   ███  height / 2    bars of line_spacing, gaps of line_widths
/// ```
///
/// The first bar begins at the origin. Each line stands above the gap between two bars and is as wide as that gap. A label
/// on the left names the last width.
///
/// # Ports
/// None.
///
/// # Errors
/// `line_widths` is empty.
///
/// # Numerics
/// Lines and bars are polygons of one cell with equal coordinates where their corners meet, so that no grid moves them
/// against each other.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let steps = pg::litho_steps([3, 4], 2, 10, 1)?;
/// assert_eq!(steps.xmax(), 2.0 + 4.0 + 2.0 + 3.0 + 2.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `litho_steps`.
#[device(picture = "docs/litho_steps.svg")]
pub fn litho_steps(
    /// Widths of the lines; the last one is drawn first.
    #[default([1, 2, 4, 8, 16])]
    #[param(unit = "um", above = 0.0)]
    line_widths: Vec<f64>,
    /// From one line to the next, edge to edge, and width of the bars.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    line_spacing: f64,
    /// Height of lines and bars together.
    #[default(100.0)]
    #[param(unit = "um", above = 0.0)]
    height: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let last = line_widths.last();
    check.that("line_widths", "empty", last.is_some(), "name at least one width")?;
    let half = height / 2.0;
    let label = last.map_or_else(String::new, f64::to_string);
    let bar = rectangle((line_spacing, half), &layer)?;

    let mut d = Device::builder("litho_steps");
    d.add(text(label, half, Justify::Center, &layer, "DEPLOF")?.place().rotated(90).moved_by((-half / 10.0, 0)));
    d.add(bar.place().moved_by((0, -half)));
    let mut x = 0.0;
    for width in line_widths.into_iter().rev() {
        x += line_spacing + width;
        d.add(bar.place().moved_by((x, -half)));
        d.add(rectangle((width, half), &layer)?.place().moved_by((x - width, 0)));
    }
    d.flatten()?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Left and right ends of what is drawn above or below y = 0, from left to right.
    fn spans(d: &Device, above: bool) -> Vec<(f64, f64)> {
        let boxes = d.flat_polygons().map(|p| Rect::around(p.points()).unwrap());
        // The label stands left of the first bar.
        let rows = boxes.filter(|b| b.min.x >= 0.0);
        let mut spans: Vec<_> = rows.filter(|b| (b.max.y > 0.0) == above).map(|b| (b.min.x, b.max.x)).collect();
        spans.sort_by(|a, b| a.0.total_cmp(&b.0));
        spans
    }

    #[test]
    fn lines_and_bars_are_where_the_specification_has_them() {
        let d = litho_steps([3.0, 0.5], 2, 10, 0).unwrap();
        assert_eq!(spans(&d, true), [(2.0, 2.5), (4.5, 7.5)]);
        assert_eq!(spans(&d, false), [(0.0, 2.0), (2.5, 4.5), (7.5, 9.5)]);
        assert_eq!(
            (d.xmin(), d.ysize()),
            (-5.5, 10.0),
            "the label, as high as the upper row, ends half a micrometer left of it"
        );
    }

    #[test]
    fn no_widths_are_refused() {
        let error = litho_steps([0.0; 0], 2, 10, 0).unwrap_err().to_string();
        assert_eq!(error, "litho_steps: line_widths is empty, but it must name at least one width");
    }
}
