//! [`litho_calipers`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;

/// Draws a vernier of two layers: the pair of notches in line shows the displacement of one layer against the other.
///
/// ```text
///            █
///    █  █  █  █  █  █     layer1: notches at one pitch
///    █  █  █  █  █  █     layer2: the same, offset_per_notch closer
///            █
/// ```
///
/// There are `num_notches` on either side of the middle notch, which has twice the height. The upper row stands on y = 0,
/// the lower row hangs `row_spacing` below. The pitch of `layer2` is smaller by `offset_per_notch`: if the `n`-th notches
/// from the middle are in line, the layers are displaced by `n · offset_per_notch`.
///
/// # Ports
/// None.
///
/// # Numerics
/// Notches are polygons of one cell with equal coordinates where they meet, so that no grid opens a gap between them.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let vernier = pg::LithoCalipersParams::default().num_notches(7).offset_per_notch(0.05).build()?;
/// assert_eq!(vernier.layers().len(), 2);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `litho_calipers`.
#[device(picture = "docs/litho_calipers.svg")]
pub fn litho_calipers(
    /// Width and height of a notch.
    #[default((2, 5))]
    #[param(unit = "um", above = 0.0)]
    notch_size: Size,
    /// From one notch of `layer1` to the next, edge to edge.
    #[default(2.0)]
    #[param(unit = "um", min = 0.0)]
    notch_spacing: f64,
    /// How many notches there are on either side of the middle one.
    #[default(11)]
    #[param(max = 1000000)]
    num_notches: usize,
    /// How much the pitch of `layer2` is smaller.
    #[default(0.1)]
    #[param(unit = "um")]
    offset_per_notch: f64,
    /// From one row to the other, edge to edge.
    #[default(0.0)]
    #[param(unit = "um")]
    row_spacing: f64,
    /// Where the upper row is drawn.
    #[default(1)]
    layer1: Layers,
    /// Where the lower row is drawn.
    #[default(2)]
    layer2: Layers,
) -> Result<Device> {
    let Size { width, height } = notch_size;
    let pitch = width + notch_spacing;
    let (upper, lower) = (rectangle(notch_size, layer1)?, rectangle(notch_size, layer2)?);
    let below = -height - row_spacing;

    let mut d = Device::builder("litho_calipers");
    for i in 0..=2 * num_notches {
        let x = pitch * i as f64;
        let offset = offset_per_notch * (num_notches as f64 - i as f64);
        if i == num_notches {
            d.add(upper.place().moved_by((x, height)));
            d.add(lower.place().moved_by((x, below - height)));
        }
        d.add(upper.place().moved_by((x, 0)));
        d.add(lower.place().moved_by((x + offset, below)));
    }
    d.flatten()?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nth_notches_are_in_line_at_n_offsets() {
        let d = litho_calipers((2, 5), 2, 3, 0.25, 1, 1, 2).unwrap();
        let row = |layer: u16, y: f64| -> Vec<f64> {
            let boxes = d.flat_polygons().filter(|p| p.layer == Some(layer.into()));
            let boxes = boxes.map(|p| Rect::around(p.points()).unwrap());
            boxes.filter(|b| b.min.y == y).map(|b| b.min.x).collect()
        };
        let offsets: Vec<f64> = row(1, 0.0).iter().zip(row(2, -6.0)).map(|(a, b)| b - a).collect();
        assert_eq!(offsets, [0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75]);
        assert_eq!((row(1, 5.0), row(2, -11.0)), (vec![12.0], vec![12.0]));
    }
}
