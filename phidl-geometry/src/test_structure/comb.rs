//! [`test_comb`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::block::{Block, add_blocks, block, turned_bar};

/// Largest number of passes of a meander.
const MOST_PASSES: f64 = 1e6;

/// Draws a meander with a comb between its wires, over a second meander on another layer. A current between two pads shows a
/// short within the layer or between the layers.
///
/// ```text
///              ┌──────────┐
///              │ top pad  │ comb
///              └─┬──┬──┬──┘
///    ┌──────┐ ┌─┐│┌┐│┌┐│┌─┐ ┌───────┐
///    │ left ├─┘ └─┘└─┘└─┘ └─┤ right │  meander on comb_layer
///    └──────┘                └───────┘
///              ┌──────────┐
///              │  bottom  │ meander on overlap_zigzag_layer
///              └──────────┘
/// ```
///
/// The left pad begins at x = 0. The distance between pads is `pad_size.height / 5`. If pads are more than twice as high as
/// wide, some fingers lie beside the top pad and are not connected.
///
/// # Ports
/// None.
///
/// # Errors
/// The wires must fit: `wire_width` at most a tenth of the height of a pad, and `wire_gap` small enough for the comb.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let comb = pg::TestCombParams::default().wire_gap(5).build()?;
/// assert_eq!(comb.layers().len(), 5);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `test_comb`.
#[device(picture = "docs/test_comb.svg")]
pub fn test_comb(
    /// Width and height of the pads.
    #[default((200, 200))]
    #[param(unit = "um", above = 0.0)]
    pad_size: Size,
    /// Width of all wires.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    wire_width: f64,
    /// From the meander to the comb, edge to edge.
    #[default(3.0)]
    #[param(unit = "um", min = 0.0)]
    wire_gap: f64,
    /// Where the first meander and its comb are drawn, with their pads.
    #[default(0)]
    comb_layer: Layers,
    /// Where the second meander is drawn, with its pad.
    #[default(1)]
    overlap_zigzag_layer: Layers,
    /// Where the left and the top pad are covered.
    #[default(2)]
    comb_pad_layer: Layers,
    /// Where the right pad is covered.
    #[default(3)]
    comb_gnd_layer: Layers,
    /// Where the bottom pad is covered.
    #[default(4)]
    overlap_pad_layer: Layers,
) -> Result<Device> {
    let plan = CombLayout { check, px: pad_size.width, py: pad_size.height, width: wire_width, gap: wire_gap };
    let (meander, tail) = plan.first_meander()?;
    let second = plan.second_meander(tail)?;

    let mut d = Device::builder("test_comb");
    let [bottom, left, top, right] = plan.covers();
    add_blocks(&mut d, [bottom], &overlap_pad_layer)?;
    add_blocks(&mut d, [left, top], &comb_pad_layer)?;
    add_blocks(&mut d, [right], &comb_gnd_layer)?;
    add_blocks(&mut d, plan.pads(), &comb_layer)?;
    add_blocks(&mut d, meander, &comb_layer)?;
    add_blocks(&mut d, [plan.bottom_pad()], &overlap_zigzag_layer)?;
    add_blocks(&mut d, second, &overlap_zigzag_layer)?;
    d.build()
}

/// The measures of a structure (µm), and what follows from them.
#[derive(Debug, Clone, Copy)]
struct CombLayout<'a> {
    check: Check<'a>,
    px: f64,
    py: f64,
    width: f64,
    gap: f64,
}

impl CombLayout<'_> {
    /// From one wire of a meander to the next, edge to edge: room for a finger of the comb.
    fn spacing(&self) -> f64 {
        self.width + 2.0 * self.gap
    }

    /// Length of the wire between a pad and the first corner.
    fn head(&self) -> f64 {
        self.px / 12.0
    }

    /// Lower and upper edge of the first meander.
    fn rows(&self) -> (f64, f64) {
        (0.2 * self.py, 0.7 * self.py)
    }

    /// Pads covered on other layers: bottom, left, top, right.
    fn covers(&self) -> [Block; 4] {
        let Self { px, py, .. } = *self;
        let (x0, x1) = (0.9 * px + 0.2 * py, 1.8 * px + 0.2 * py);
        [
            block(x0, -0.9 * py, x1, 0.0),
            block(0.0, 0.0, 0.9 * px, 0.9 * py),
            block(x0, 0.9 * py, x1, 1.8 * py),
            block(1.8 * px + 0.4 * py, 0.0, 2.7 * px + 0.4 * py, 0.9 * py),
        ]
    }

    /// Pads of the first meander: left, top, right; and the nubs that its wire begins and ends at.
    fn pads(&self) -> [Block; 5] {
        let Self { px, py, .. } = *self;
        [
            block(0.0, -0.05 * py, px, 0.95 * py),
            block(0.85 * px + 0.2 * py, 0.8 * py, 1.85 * px + 0.2 * py, 1.8 * py),
            block(1.7 * px + 0.4 * py, -0.05 * py, 2.7 * px + 0.4 * py, 0.95 * py),
            block(px, 0.2 * py, 1.25 * px, 0.7 * py),
            block(1.45 * px + 0.4 * py, 0.2 * py, 1.7 * px + 0.4 * py, 0.7 * py),
        ]
    }

    /// Pad of the second meander.
    fn bottom_pad(&self) -> Block {
        let Self { px, py, .. } = *self;
        block(0.85 * px + 0.2 * py, -0.9 * py, 1.85 * px + 0.2 * py, 0.1 * py)
    }

    /// The meander between the left and the right pad with the fingers of its comb, and the left end of its last wire.
    fn first_meander(&self) -> Result<(Vec<Block>, f64)> {
        let (w, spacing, (low, high)) = (self.width, self.spacing(), self.rows());
        let end = 1.45 * self.px + 0.4 * self.py;
        let passes = (end - 1.25 * self.px) / (w + spacing);
        self.check.at_most("number of passes of the meander", passes, MOST_PASSES)?;

        let mut x = 1.25 * self.px + self.head();
        let mut blocks = vec![block(1.25 * self.px, high - w, x, high), block(x, high - w, x + w, high)];
        let mut top = true;
        while x + w + self.head() < end {
            let turn = if top { 270.0 } else { 90.0 };
            blocks.push(turned_bar((x + w / 2.0, (low + high) / 2.0), self.py / 2.0 - 2.0 * w, w, turn));
            top = !top;
            let row = if top { high - w } else { low };
            blocks.push(block(x, row, x + w, row + w));
            if top {
                blocks.push(self.finger(x + w)?);
            }
            x += w + spacing;
            blocks.push(block(x - spacing, row, x, row + w));
            blocks.push(block(x, row, x + w, row + w));
        }
        let row = if top { high - w } else { low };
        let tail_end = if end > x + w { end } else { x + 2.0 * w };
        blocks.push(block(x + w, row, tail_end, row + w));
        Ok((blocks, x + w))
    }

    /// A finger of the comb, down from the top pad, on the left of the wire that ends at `right`.
    fn finger(&self, right: f64) -> Result<Block> {
        let (w, py, (_, high)) = (self.width, self.py, self.rows());
        let indent = (self.spacing() + w) / 2.0;
        let length = 0.8 * py - high + py / 2.0 - indent;
        let gap = format_args!("{} µm", self.gap);
        self.check.that("wire_gap", gap, length >= 0.0, "leave room for the fingers of the comb")?;
        let center = Point::new(right - indent - w / 2.0, 0.8 * py - length / 2.0);
        Ok(turned_bar(center, length, w, 90.0))
    }

    /// The meander on the other layer, up from the bottom pad; `tail` is where the last wire of the first one begins.
    fn second_meander(&self, tail: f64) -> Result<Vec<Block>> {
        let (w, spacing, (_, high)) = (self.width, self.spacing(), self.rows());
        let tenth = 0.1 * self.py;
        self.check.at_most("wire_width", w, ("a tenth of pad_size.height", tenth))?;
        self.check.at_most("number of passes of the meander", (high - tenth) / (w + spacing), MOST_PASSES)?;
        let right = tail - (spacing + w) / 2.0 - w;
        // Positive: the first meander makes at least one pass, which moves `right` out by more than is taken off here.
        let length = right - (2.5 * self.px + self.head() + w) / 2.0;
        let left = right - length - w;

        let mut y = tenth + (tenth - w);
        let mut blocks = vec![
            turned_bar((right + w / 2.0, (tenth + y) / 2.0), tenth - w, w, 90.0),
            block(right, y, right + w, y + w),
        ];
        let (mut column, mut other, mut turn) = (right, left, 0.0);
        while y + w + spacing + w < high {
            let corner = |x: f64, y: f64| turned_bar((x + w / 2.0, y + w / 2.0), w, w, 90.0 + turn);
            blocks.push(turned_bar((column + w / 2.0, y + w + spacing / 2.0), spacing, w, 90.0));
            y += w + spacing;
            blocks.push(corner(column, y));
            blocks.push(turned_bar((left + w + length / 2.0, y + w / 2.0), length, w, turn));
            blocks.push(corner(other, y));
            std::mem::swap(&mut column, &mut other);
            turn = 180.0 - turn;
        }
        Ok(blocks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAN: CombLayout<'_> =
        CombLayout { check: Check::new("test_comb"), px: 200.0, py: 200.0, width: 1.0, gap: 3.0 };

    fn boxes(blocks: &[Block]) -> Vec<Rect> {
        blocks.iter().map(|b| Rect::around(*b).unwrap()).collect()
    }

    /// Whether every box shares an edge or a part of one with the box before it.
    fn is_one_wire(wire: &[Rect]) -> bool {
        wire.windows(2).all(|pair| pair[0].grown(1e-9).touches(&pair[1]))
    }

    #[test]
    fn meanders_are_single_wires_of_one_width() {
        let (first, tail) = PLAN.first_meander().unwrap();
        let (_, high) = PLAN.rows();
        let wire: Vec<Rect> = boxes(&first).into_iter().filter(|b| b.max.y <= high + 1e-9).collect();
        let second = boxes(&PLAN.second_meander(tail).unwrap());
        for wire in [wire, second] {
            assert!(is_one_wire(&wire));
            assert!(wire.iter().all(|b| (b.size().width.min(b.size().height) - 1.0).abs() < 1e-9));
        }
    }

    #[test]
    fn fingers_keep_the_gap_to_the_meander() {
        let (first, _) = PLAN.first_meander().unwrap();
        let (low, high) = PLAN.rows();
        let (fingers, wire): (Vec<Rect>, Vec<Rect>) = boxes(&first).into_iter().partition(|b| b.max.y > high + 1e-9);
        assert!(!fingers.is_empty());
        for finger in fingers {
            assert!(!wire.iter().any(|b| b.touches(&finger.grown(PLAN.gap - 1e-9))), "{finger:?}");
            assert!(finger.min.y > low);
        }
    }

    #[test]
    fn wires_that_do_not_fit_are_refused() {
        let error = TestCombParams::default().wire_width(21).build().unwrap_err().to_string();
        assert_eq!(error, "test_comb: wire_width is 21 µm, but it must be at most a tenth of pad_size.height, 20 µm");
        let error = TestCombParams::default().pad_size((800, 20)).wire_gap(15).build().unwrap_err().to_string();
        assert_eq!(error, "test_comb: wire_gap is 15 µm, but it must leave room for the fingers of the comb");
    }
}
