//! [`tee`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::PoleTaper;
use crate::polygon::filleted;

/// Draws a bar with a stub below, the letter T.
///
/// ```text
///     ┌───────────┐
///   2 ┤           ├ 1    size
///     └───┐ · ┌───┘
///      ╲  │   │  ╱       taper
///         └─┬─┘          stub_size
///           3
/// ```
///
/// The origin is where the stub leaves the bar, in the middle.
///
/// # Ports
/// `1` and `2` at the right and left ends of the bar, as wide as it is high; `3` at the end of the stub, as wide as it.
///
/// # Errors
/// With a taper, the stub must be narrower than the bar or as wide.
///
/// # Numerics
/// Fillets are arcs of 32 points whose radius is `min(size.width − stub.width, stub.height)`, limited to 49 % of the
/// edges at their corner. Other corners stay one point, and nothing is cut or rounded to a grid.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// # use pg::connect::PoleTaper;
/// let branch = pg::tee((40, 20), (10, 5), PoleTaper::Straight, 1)?;
/// assert_eq!(branch.area(), 40.0 * 20.0 + 10.0 * 5.0 + 15.0 * 5.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `tee`.
#[device(picture = "docs/tee.svg")]
pub fn tee(
    /// Width and height of the bar.
    #[default((4, 2))]
    #[param(unit = "um", min = 0.0)]
    size: Size,
    /// Width and length of the stub.
    #[default((2, 1))]
    #[param(unit = "um", min = 0.0)]
    stub_size: Size,
    /// What is drawn in the inner corners; none leaves them sharp.
    #[default(None)]
    taper_type: Option<PoleTaper>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    if taper_type.is_some() {
        check.at_most("stub_size.width", stub_size.width, ("size.width", size.width))?;
    }
    let (x, top) = (size.width / 2.0, size.height);
    let (sx, bottom) = (stub_size.width / 2.0, -stub_size.height);
    let outline = [(x, top), (x, 0.0), (sx, 0.0), (sx, bottom), (-sx, bottom), (-sx, 0.0), (-x, 0.0), (-x, top)];
    let outline = outline.map(Point::from);
    /// Where the bar and the stub meet.
    const INNER_CORNERS: [usize; 2] = [2, 5];

    let mut d = Device::builder("tee");
    match taper_type {
        None => drop(d.add_polygon(outline, &layer)?),
        Some(PoleTaper::Straight) => {
            d.add_polygon(outline, &layer)?;
            d.add_polygon([(x, 0.0), (sx, 0.0), (sx, bottom)], &layer)?;
            d.add_polygon([(-sx, bottom), (-sx, 0.0), (-x, 0.0)], &layer)?;
        }
        Some(PoleTaper::Fillet) => {
            let radius = (size.width - stub_size.width).min(stub_size.height);
            d.add_polygon(filleted(&outline, |i| if INNER_CORNERS.contains(&i) { radius } else { 0.0 }), &layer)?;
        }
    }
    d.add_port("1", ((x, top / 2.0), size.height, 0))?;
    d.add_port("2", ((-x, top / 2.0), size.height, 180))?;
    d.add_port("3", ((0, bottom), stub_size.width, 270))?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fillets_add_what_is_between_their_arcs_and_the_corners() {
        let sharp = tee((4, 2), (2, 1), None, 0).unwrap().area();
        let filleted = tee((4, 2), (2, 1), PoleTaper::Fillet, 0).unwrap();
        // Radius 0.49, limited by the edges of length 1; the corner lies outside the arc: (1 − π/4) r² each.
        let added = 2.0 * (1.0 - PI / 4.0) * 0.49 * 0.49;
        assert!((filleted.area() - sharp - added).abs() < 2e-4, "{} {}", filleted.area(), sharp + added);
        assert_eq!(filleted.polygons().next().unwrap().points.len(), 6 + 2 * 32);
    }

    #[test]
    fn a_stub_wider_than_its_bar_has_no_taper() {
        assert!(tee((2, 2), (4, 1), PoleTaper::Straight, 0).is_err());
        assert!(tee((2, 2), (4, 1), None, 0).is_ok());
    }
}
