//! [`test_res`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::block::{Block, add_blocks, block};

/// How far the ground stays inside the pad (µm).
const GROUND_INSET: f64 = 5.0;
/// Largest number of rows of a wire.
const MOST_ROWS: f64 = 1e6;

/// Draws a meandering wire of a number of squares between two pads, to measure a sheet resistance.
///
/// ```text
///   ┌──────┐                  ┌──────┐
///   │      ├────────────────┐ │      │
///   │ pad  │ ┌──────────────┘ │      │  pad_size
///   │      │ └────────────────┤      │
///   └──────┘                  └──────┘
/// ```
///
/// The wire has its first square at the origin's left and fills the height of the pads as well as it can: rows of one
/// length with gaps of one width, one above the other. A corner counts as one square.
///
/// # Ports
/// None.
///
/// # Info
/// `num_squares`: squares of the wire as drawn, the last ones on the pads included. It is the parameter unless there
/// are too few for a meander over the whole height: then the wire has half as many rows, of one square each.
///
/// # Errors
/// The wire must be at most as wide as a pad is high, a pad must have room for its ground, and `num_squares` must
/// suffice for at least one row.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let wire = pg::TestResParams::default().num_squares(2000).build()?;
/// // Only the wire is on layer 0. It is 1 µm wide and its blocks do not overlap, so its area is its number of squares.
/// assert!((wire.area_by_layer()[&0.into()] - 2000.0).abs() < 1e-6);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `test_res`.
#[device(picture = "docs/test_res.svg")]
pub fn test_res(
    /// Width and height of the pads.
    #[default((50, 50))]
    #[param(unit = "um", above = 10.0)]
    pad_size: Size,
    /// How many squares the wire has.
    #[default(1000.0)]
    #[param(above = 0.0)]
    num_squares: f64,
    /// Width of the wire.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Where the wire is drawn.
    #[default(0)]
    res_layer: Layers,
    /// Where the pads are drawn.
    #[default(1)]
    pad_layer: Layers,
    /// Where the ground is drawn.
    #[default(2)]
    gnd_layer: Layers,
) -> Result<Device> {
    check.at_most("width", width, ("pad_size.height", pad_size.height))?;
    check.at_most("number of rows", pad_size.height / (2.0 * width), MOST_ROWS)?;
    let meander = Meander::new(pad_size.height, num_squares, width);
    let enough = meander.rows >= 1.0 && meander.row > 0.0;
    check.that("num_squares", num_squares, enough, "suffice for a wire between the pads")?;

    let mut d = Device::builder("test_res");
    add_blocks(&mut d, meander.blocks(), &res_layer)?;
    let (left, right, top) = (-width, meander.row + width, pad_size.height);
    d.add_polygon(block(left - pad_size.width, 0.0, left, top), &pad_layer)?;
    d.add_polygon(block(right, 0.0, right + pad_size.width, top), &pad_layer)?;
    // Inside the left pad; at the right one flush with its outer edge.
    d.add_polygon(ground(left - pad_size.width + GROUND_INSET, left - GROUND_INSET, top), &gnd_layer)?;
    d.add_polygon(ground(right + GROUND_INSET, right + pad_size.width, top), &gnd_layer)?;
    d.info("num_squares", meander.squares());
    d.build()
}

/// Upper right, upper left, lower left, lower right: counter-clockwise, unlike the other blocks.
fn ground(x0: f64, x1: f64, pad_height: f64) -> Block {
    let (y0, y1) = (GROUND_INSET, pad_height - GROUND_INSET);
    [(x1, y1), (x0, y1), (x0, y0), (x1, y0)].map(Point::from)
}

/// The wire: rows from the top down, joined at alternate ends.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Meander {
    /// Height that it is centered in (µm).
    height: f64,
    width: f64,
    /// Number of rows, odd, so that the wire ends on the other side; below one if there is no such wire.
    rows: f64,
    /// Length of a row (µm).
    row: f64,
}

impl Meander {
    /// As many rows as fit, and what is left of the squares shared by them.
    fn new(height: f64, squares: f64, width: f64) -> Self {
        let fit = (height / (2.0 * width)).floor();
        let mut rows = if fit % 2.0 == 0.0 { fit - 1.0 } else { fit };
        let corners = rows - 1.0;
        let mut squares_per_row = (squares - corners - 2.0) / rows;
        if squares_per_row < 1.0 {
            rows = (rows / 2.0).round_ties_even() - 2.0;
            squares_per_row = 1.0;
        }
        if 2.0 * width > height {
            rows = 1.0;
            squares_per_row = squares - 2.0;
        }
        Self { height, width, rows, row: squares_per_row * width }
    }

    /// Squares of all rows, of the links between them, and of both ends.
    fn squares(&self) -> f64 {
        self.rows * self.row / self.width + (self.rows - 1.0) + 2.0
    }

    /// All rectangles, centered in the height.
    fn blocks(self) -> impl Iterator<Item = Block> {
        let (w, length) = (self.width, self.row);
        let last = -2.0 * w * (self.rows - 1.0);
        let up = (self.height - w - last) / 2.0;
        let rows = std::iter::successors(Some(0.0), |i| Some(i + 1.0)).take_while(move |i| *i < self.rows);
        let rows = rows.flat_map(move |i| self.row_and_link(i));
        let ends = [block(-w, 0.0, 0.0, w), block(length, last, length + w, last + w)];
        rows.chain(ends).map(move |block| block.map(|p| p + Point::new(0.0, up)))
    }

    /// A row, and the link down to the next one: on the right after even rows, on the left after odd ones.
    fn row_and_link(&self, i: f64) -> impl Iterator<Item = Block> + use<> {
        let (w, length, y) = (self.width, self.row, -2.0 * self.width * i);
        let row = block(0.0, y, length, y + w);
        let link = block(length - w, y - w, length, y);
        let mirror = move |p: Point| if i % 2.0 == 0.0 { p } else { Point::new(length - p.x, p.y) };
        let link = (i + 1.0 < self.rows).then_some(link);
        [Some(row), link].into_iter().flatten().map(move |block| block.map(mirror))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_wire_has_the_rows_of_the_specification_and_all_its_squares() {
        let meander = Meander::new(50.0, 1000.0, 1.0);
        assert_eq!((meander.rows, meander.row), (25.0, 38.96));
        assert!((meander.squares() - 1000.0).abs() < 1e-9);
        assert_eq!(meander.blocks().count(), 51);
    }

    #[test]
    fn a_wire_more_than_half_as_wide_as_the_pad_is_one_row() {
        let meander = Meander::new(20.0, 7.0, 12.0);
        assert_eq!((meander.rows, meander.row, meander.squares()), (1.0, 60.0, 7.0));
    }

    #[test]
    fn too_few_squares_make_a_shorter_meander_that_tells_how_many_it_has() {
        let d = TestResParams::default().pad_size((50, 40)).num_squares(10).build().unwrap();
        // 19 rows would need 38 squares; half of them, less two, are eight rows with a square each and seven links.
        assert_eq!(d.info()["num_squares"], Value::from(8.0 + 7.0 + 2.0));
    }

    #[test]
    fn wires_that_cannot_be_drawn_are_refused() {
        let error = TestResParams::default().pad_size((20, 20)).num_squares(2).width(8).build().unwrap_err();
        assert_eq!(error.to_string(), "test_res: num_squares is 2, but it must suffice for a wire between the pads");
        assert!(TestResParams::default().pad_size((10, 50)).build().is_err(), "no room for the ground");
        assert!(TestResParams::default().width(51).build().is_err());
    }
}
