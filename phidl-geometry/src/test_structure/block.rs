//! Rectangles with a known first corner: the parts of meanders.

use phidl_core::num::angle;
use phidl_core::prelude::*;

/// The corners of a rectangle in the order in which they are drawn.
pub(super) type Block = [Point; 4];

/// A rectangle as every shape draws it: from the upper right corner clockwise.
pub(super) fn block(x0: f64, y0: f64, x1: f64, y1: f64) -> Block {
    [(x1, y1), (x1, y0), (x0, y0), (x0, y1)].map(Point::from)
}

/// A level bar around the origin, turned about it and moved to a center. Only the first corner tells that it was turned.
pub(super) fn turned_bar(center: impl Into<Point>, length: f64, width: f64, degrees: f64) -> Block {
    let center = center.into();
    let (sin, cos) = angle::sin_cos(degrees);
    let (x, y) = (length / 2.0, width / 2.0);
    block(-x, -y, x, y).map(|p| center + Point::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos))
}

/// Draws some blocks on the same layers.
pub(super) fn add_blocks(d: &mut DeviceBuilder, blocks: impl IntoIterator<Item = Block>, layer: &Layers) -> Result<()> {
    blocks.into_iter().try_for_each(|block| d.add_polygon(block, layer).map(drop))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_bar_starts_at_the_image_of_its_upper_right_corner() {
        assert_eq!(turned_bar((10, 20), 4.0, 2.0, 0.0), block(8.0, 19.0, 12.0, 21.0));
        let up = turned_bar((10, 20), 4.0, 2.0, 90.0);
        assert_eq!((up[0], up[2]), (Point::new(9.0, 22.0), Point::new(11.0, 18.0)));
    }
}
