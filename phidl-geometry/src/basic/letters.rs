//! Wires with corners, named after letters: [`l`] and [`c`].
//!
//! Both outlines repeat their first corner at the end, as PHIDL's do.

use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws a wire with one corner, the letter L.
///
/// ```text
///    1
///   ┌┴┐ size.height
///   │ │
///   │·└───┐
///   └─────┤ 2    size.width
///   width
/// ```
///
/// The middle lines of the arms meet in the origin; `size` is measured from there.
///
/// # Ports
/// `1` above, facing 90°, and `2` to the right, facing 0°; both `width` wide.
///
/// # Errors
/// Both extents must be greater than minus half the width, and one of them at least half the width, or the outline would
/// cross itself.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let bend = pg::l(1, (10, 20), 3)?;
/// assert_eq!(bend.port("1")?.midpoint(), Point::new(0.0, 20.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `L`.
#[device(name = "L", picture = "docs/L.svg")]
pub fn l(
    /// Width of the wire.
    #[default(1.0)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    /// From the corner to the end of the lower and of the upright arm, along the middle lines.
    #[default((10, 20))]
    #[param(unit = "um")]
    size: Size,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (h, Size { width: right, height: top }) = (width / 2.0, size);
    check.greater("size.width", right, ("minus half the width", -h))?;
    check.greater("size.height", top, ("minus half the width", -h))?;
    // An arm may end inside the other one; where both do, nothing is left of the inner corner.
    check.unit("µm").at_least("the greater of size.width and size.height", right.max(top), ("half the width", h))?;
    let mut d = Device::builder("L");
    d.add_polygon([(-h, -h), (right, -h), (right, h), (h, h), (h, top), (-h, top), (-h, -h)], layer)?;
    d.add_port("1", ((0, top), width, 90))?;
    d.add_port("2", ((right, 0), width, 0))?;
    d.build()
}

/// Draws a wire with two corners, the letter C.
///
/// ```text
///   ┌─────┐
///   │ ┌───┤ 1    size.height
///   │ │
///   │·└───┐
///   └─────┤ 2    size.width
///   width
/// ```
///
/// The middle lines of the lower and the upright arm meet in the origin; `size` is measured from there, along the middle
/// lines.
///
/// # Ports
/// `1` at the end of the upper arm and `2` at that of the lower one, facing 0°; both `width` wide.
///
/// # Errors
/// `size.width` must be greater than minus half the width and `size.height` at least the width, or the outline would cross
/// itself.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let turn = pg::c(1, (10, 20), 3)?;
/// assert_eq!(turn.bbox(), Some(Rect::new((-0.5, -0.5), (10, 20.5))));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `C`.
#[device(name = "C", picture = "docs/C.svg")]
pub fn c(
    /// Width of the wire.
    #[default(1.0)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    /// Length of the level arms and their distance, along the middle lines.
    #[default((10, 20))]
    #[param(unit = "um")]
    size: Size,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (h, Size { width: right, height: top }) = (width / 2.0, size);
    let lower = [(-h, -h), (right, -h), (right, h), (h, h)];
    let upper = [(h, top - h), (right, top - h), (right, top + h), (-h, top + h), (-h, -h)];
    check.greater("size.width", right, ("minus half the width", -h))?;
    check.at_least("size.height", top, ("the width", width))?;
    let mut d = Device::builder("C");
    d.add_polygon([lower.as_slice(), upper.as_slice()].concat(), layer)?;
    d.add_port("1", ((right, top), width, 0))?;
    d.add_port("2", ((right, 0), width, 0))?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arms_have_the_area_of_their_middle_lines_times_the_width() {
        // The corner of an L belongs to one arm alone: width · (10 + 20), its outer quarter included, its inner one not.
        assert_eq!(l(2, (10, 20), 0).unwrap().area(), 2.0 * 30.0);
        assert_eq!(c(2, (10, 20), 0).unwrap().area(), 2.0 * (10.0 + 20.0 + 10.0));
    }

    #[test]
    fn an_arm_may_end_inside_the_other_one() {
        let d = l(4, (1, 9), 0).unwrap();
        assert_eq!(d.area(), 3.0 * 4.0 + 4.0 * 7.0);
        assert_eq!(d.port("2").unwrap().midpoint(), Point::new(1.0, 0.0));
        assert!(l(4, (1, 1), 0).is_err() && l(4, (-2, 9), 0).is_err() && c(4, (-2, 9), 0).is_err());
        assert_eq!(c(4, (0, 9), 0).unwrap().area(), 2.0 * 13.0 + 2.0 * 5.0);
    }

    #[test]
    fn a_negative_width_is_refused() {
        let error = l(-1, (10, 20), 0).unwrap_err().to_string();
        assert_eq!(error, "L: width is -1 µm, but it must be at least 0 µm");
        assert!(c(-1, (10, 20), 0).is_err());
    }
}
