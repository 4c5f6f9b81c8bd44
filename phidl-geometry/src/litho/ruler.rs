//! [`litho_ruler`].

use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws a ruler: marks at one pitch whose heights repeat.
///
/// ```text
///   █              █
///   █      █       █
///   █ █ █ █ █ █ █ █ █    scale · height; the first mark begins at the origin
///   width
///   ├─┤ spacing
/// ```
///
/// # Ports
/// None.
///
/// # Errors
/// `scale` is empty, or a mark has no height.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let tens = pg::LithoRulerParams::default().width(0.25).spacing(1).build()?;
/// assert_eq!(tens.size(), Size::new(20.25, 6.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `litho_ruler`.
#[device(picture = "docs/litho_ruler.svg")]
pub fn litho_ruler(
    /// Height that `scale` multiplies. Marks of negative height are drawn downward, and all marks stand on the lowest foot.
    #[default(2.0)]
    #[param(unit = "um")]
    height: f64,
    /// Width of the marks.
    #[default(0.5)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// From the left edge of one mark to that of the next.
    #[default(1.2)]
    #[param(unit = "um")]
    spacing: f64,
    /// Heights of the marks in units of `height`, repeated from the first mark on.
    #[default([3, 1, 1, 1, 1, 2, 1, 1, 1, 1])]
    scale: Vec<f64>,
    /// Number of marks; 0 draws nothing.
    #[default(21)]
    #[param(max = 1000000)]
    num_marks: usize,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    check.that("scale", "empty", !scale.is_empty(), "name at least one height")?;
    check.that("height", format_args!("{height} µm"), height != 0.0, "not be 0")?;
    for (i, scale) in scale.iter().enumerate() {
        check.that(&format!("scale[{i}]"), *scale, *scale != 0.0, "not be 0")?;
    }
    let heights = || scale.iter().cycle().take(num_marks).map(|scale| height * scale);
    let lowest = heights().fold(0.0, f64::min);
    let mut d = Device::builder("litho_ruler");
    for (i, height) in heights().enumerate() {
        let (x, y) = (spacing * i as f64, lowest - height.min(0.0));
        d.add_polygon([(x + width, y + height), (x + width, y), (x, y), (x, y + height)], &layer)?;
    }
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_repeat_from_the_first_mark_on() {
        let d = litho_ruler(2, 0.5, 1, [3, 1, 2], 5, 0).unwrap();
        let heights: Vec<f64> = d.polygons().map(|p| Rect::around(p.points.to_vec()).unwrap().max.y).collect();
        assert_eq!(heights, [6.0, 2.0, 4.0, 6.0, 2.0]);
    }

    #[test]
    fn no_marks_draw_nothing_and_no_heights_are_refused() {
        assert!(litho_ruler(2, 0.5, 1, [3], 0, 0).unwrap().is_empty());
        assert!(litho_ruler(2, 0.5, 1, [0.0; 0], 5, 0).is_err());
        assert!(litho_ruler(0, 0.5, 1, [3], 5, 0).is_err());
        let error = litho_ruler(2, 0.5, 1, [3, 0], 5, 0).unwrap_err();
        assert_eq!(error.to_string(), "litho_ruler: scale[1] is 0, but it must not be 0");
    }

    #[test]
    fn all_marks_stand_on_the_lowest_foot() {
        assert_eq!(litho_ruler(-2, 0.5, 1.2, [3, 1], 21, 0).unwrap().bbox(), Some(Rect::new((0, -6), (24.5, 0))));
        let both = litho_ruler(2, 0.5, 1.2, [2, -1], 21, 0).unwrap();
        assert_eq!(both.bbox(), Some(Rect::new((0, -2), (24.5, 2))));
        assert!(both.polygons().all(|p| Rect::around(p.points.to_vec()).unwrap().min.y == -2.0));
        // What is not drawn moves nothing.
        assert_eq!(litho_ruler(2, 0.5, 1.2, [1, 2, -3], 2, 0).unwrap().bbox().unwrap().min.y, 0.0);
    }
}
