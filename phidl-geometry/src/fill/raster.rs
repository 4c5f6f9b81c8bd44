//! [`Raster`]: which cells of a regular raster are too near to an area.
//!
//! A cell is taken if any part of it lies inside the area or nearer than the margin. The points nearer than the margin to
//! an edge of the area form an ellipse swept along that edge: a convex shape. In one row of cells it takes one run, from
//! its leftmost to its rightmost point in that row; both are computed in closed form. Rasterizing the area and dilating
//! pixels was rejected: it can lose half a cell of the margin.

use phidl_core::num::count;
use phidl_core::prelude::*;

use super::avoided::{AvoidedArea, Edge, Outline, crossing};
use crate::arguments::PerAxis;

/// Cells are looked at without a rim of this width (µm), so that noise in coordinates does not take a cell that just
/// keeps the margin. Coordinates of meters have noise of that size.
const NOISE: f64 = 1e-9;

/// Cells in rows from the bottom, each from the left.
#[derive(Debug)]
pub(super) struct Raster {
    origin: Point,
    pitch: Size,
    columns: usize,
    rows: usize,
    taken: Vec<bool>,
}

/// A rectangle of free cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct FreeBlock {
    pub(super) column: usize,
    pub(super) row: usize,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl FreeBlock {
    /// Its cells, row by row.
    pub(super) fn cells(&self) -> impl Iterator<Item = Self> {
        let Self { column, row, columns, rows } = *self;
        let one = move |column, row| Self { column, row, columns: 1, rows: 1 };
        (row..row + rows).flat_map(move |row| (column..column + columns).map(move |column| one(column, row)))
    }
}

impl Raster {
    /// A raster of free cells, aligned with the lower left corner of a box: the whole cells inside the box.
    pub(super) fn new(within: Rect, pitch: Size, columns: usize, rows: usize) -> Self {
        Self { origin: within.min, pitch, columns, rows, taken: vec![false; columns * rows] }
    }

    /// Number of whole cells of an extent in a length, up to floating-point noise.
    pub(super) fn cells_in(length: f64, extent: f64) -> usize {
        count::up(((length + NOISE) / extent).floor())
    }

    /// The corners of a cell or of several, from their column and row lines. Neighbors share these to the last bit.
    pub(super) fn bounds(&self, block: &FreeBlock) -> Rect {
        let line = |column: usize, row: usize| {
            self.origin + Point::new(column as f64 * self.pitch.width, row as f64 * self.pitch.height)
        };
        let (column, row) = (block.column, block.row);
        Rect::new(line(column, row), line(column + block.columns, row + block.rows))
    }

    /// The middle of a cell.
    pub(super) fn center(&self, column: usize, row: usize) -> Point {
        let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
        self.origin + Point::new(x * self.pitch.width, y * self.pitch.height)
    }

    /// Takes every cell that lies inside a region or nearer to it than the margin, which is a radius along either axis.
    pub(super) fn take_near(&mut self, region: &AvoidedArea, margin: PerAxis) {
        let mut inside = vec![false; self.taken.len()];
        region.solid.iter().for_each(|outline| self.set_inside(&mut inside, outline, true));
        region.open.iter().for_each(|outline| self.set_inside(&mut inside, outline, false));
        self.taken.iter_mut().zip(inside).for_each(|(taken, inside)| *taken |= inside);
        region.edges.iter().for_each(|edge| self.take_near_edge(*edge, margin));
    }

    /// The free cells as few rectangles: runs of a row, merged with equal runs of the rows above.
    pub(super) fn free_blocks(&self) -> Vec<FreeBlock> {
        let mut blocks: Vec<FreeBlock> = Vec::new();
        let mut below: Vec<usize> = Vec::new();
        for row in 0..self.rows {
            let runs = self.free_runs(row);
            below = runs
                .map(|(column, columns)| {
                    let same = |block: &&usize| (blocks[**block].column, blocks[**block].columns) == (column, columns);
                    let block = below.iter().find(same).copied();
                    match block {
                        Some(block) => blocks[block].rows += 1,
                        None => blocks.push(FreeBlock { column, row, columns, rows: 1 }),
                    }
                    block.unwrap_or(blocks.len() - 1)
                })
                .collect();
        }
        blocks
    }

    /// First cell and length of every run of free cells in a row.
    fn free_runs(&self, row: usize) -> impl Iterator<Item = (usize, usize)> {
        let cells = &self.taken[row * self.columns..][..self.columns];
        let mut from = 0;
        cells.chunk_by(|a, b| a == b).filter_map(move |run| {
            let first = from;
            from += run.len();
            (!run[0]).then_some((first, run.len()))
        })
    }

    /// Sets the cells whose middle lies inside a polygon, even-odd.
    fn set_inside(&self, cells: &mut [bool], outline: &Outline, to: bool) {
        let (y, height) = (self.origin.y, self.pitch.height);
        let middles = |low: f64, high: f64| range((low - y) / height - 0.5, (high - y) / height - 0.5, self.rows);
        let mut crossings: Vec<(usize, f64)> = Vec::new();
        for (a, b) in outline.edges() {
            for row in middles(a.y.min(b.y), a.y.max(b.y)) {
                let middle = self.center(0, row).y;
                if (a.y <= middle) != (b.y <= middle) {
                    crossings.push((row, crossing(a, b, middle)));
                }
            }
        }
        crossings.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let column = |x: f64| (x - self.origin.x) / self.pitch.width - 0.5;
        // A row crosses an outline an even number of times.
        for pair in crossings.chunks_exact(2) {
            let columns = range(column(pair[0].1), column(pair[1].1), self.columns);
            cells[pair[0].0 * self.columns..][..self.columns][columns].fill(to);
        }
    }

    fn take_near_edge(&mut self, edge: Edge, margin: PerAxis) {
        let swept = Swept::new(edge, margin);
        let (low, high) = (swept.low.y - margin.y, swept.high.y + margin.y);
        let Size { width, height } = self.pitch;
        let rows = range((low - self.origin.y) / height - 1.0, (high - self.origin.y) / height, self.rows);
        for row in rows {
            let bottom = self.origin.y + row as f64 * height;
            let Some((left, right)) = swept.reach(bottom + NOISE, bottom + height - NOISE) else { continue };
            // The first cell that ends behind `left`, and the last one that begins before `right`.
            let from = (left + NOISE - self.origin.x) / width - 1.0;
            let columns = range(from, (right - NOISE - self.origin.x) / width, self.columns);
            self.taken[row * self.columns..][..self.columns][columns].fill(true);
        }
    }
}

/// The whole numbers from `low` to `high` among the first `limit`.
fn range(low: f64, high: f64, limit: usize) -> std::ops::Range<usize> {
    let from = count::up(low).min(limit);
    let to = if high < 0.0 { 0 } else { count::up(high.floor() + 1.0).min(limit) };
    from..to.max(from)
}

/// An edge with an ellipse around every point of it.
struct Swept {
    /// The lower end.
    low: Point,
    /// The upper end.
    high: Point,
    /// Half axes of the ellipse.
    radius: PerAxis,
    /// From the edge to one of the two lines that the ellipse draws beside it; the other one is opposite.
    side: Point,
}

impl Swept {
    fn new((a, b): Edge, radius: PerAxis) -> Self {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        // The point of the ellipse that is furthest out across the edge.
        let normal = Point::new(low.y - high.y, high.x - low.x);
        let (x, y) = (radius.x * normal.x, radius.y * normal.y);
        let norm = x.hypot(y);
        let side = if norm > 0.0 { Point::new(radius.x * x, radius.y * y) / norm } else { Point::ORIGIN };
        Self { low, high, radius, side }
    }

    /// The leftmost and the rightmost point between two heights. A convex shape has each of them either at its own
    /// leftmost and rightmost points or at one of the two heights.
    fn reach(&self, bottom: f64, top: f64) -> Option<(f64, f64)> {
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |x: f64, half: f64| (left, right) = (left.min(x - half), right.max(x + half));
        for end in [self.low, self.high] {
            if (bottom..=top).contains(&end.y) {
                add(end.x, self.radius.x);
            }
            for half in [bottom, top].into_iter().filter_map(|y| self.half_chord(y - end.y)) {
                add(end.x, half);
            }
        }
        for side in [self.side, -self.side] {
            for x in [bottom, top].into_iter().filter_map(|y| self.side_at(side, y)) {
                add(x, 0.0);
            }
        }
        (left <= right).then_some((left, right))
    }

    /// Half the width of the ellipse at a height over its middle.
    fn half_chord(&self, height: f64) -> Option<f64> {
        if height.abs() > self.radius.y {
            return None;
        }
        let part = if self.radius.y > 0.0 { height / self.radius.y } else { 0.0 };
        Some(self.radius.x * (1.0 - part * part).sqrt())
    }

    /// Where one of the lines beside the edge has a height.
    fn side_at(&self, side: Point, y: f64) -> Option<f64> {
        let (low, high) = (self.low + side, self.high + side);
        (low.y < high.y && low.y <= y && y <= high.y).then(|| crossing(low, high, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swept(a: (f64, f64), b: (f64, f64), x: f64, y: f64) -> Swept {
        Swept::new((a.into(), b.into()), PerAxis { x, y })
    }

    #[test]
    fn an_edge_reaches_as_far_as_its_round_end() {
        let s = swept((0.0, 0.0), (10.0, 0.0), 5.0, 5.0);
        assert_eq!(s.reach(-1.0, 1.0), Some((-5.0, 15.0)));
        assert_eq!(s.reach(3.0, 9.0), Some((-4.0, 14.0))); // 3, 4, 5
        assert_eq!(s.reach(6.0, 9.0), None);
    }

    #[test]
    fn a_slanted_edge_reaches_as_far_as_the_line_beside_it() {
        // At 45° the line beside it is √2 further out than the margin, measured along x.
        let (left, right) = swept((0.0, 0.0), (100.0, 100.0), 1.0, 1.0).reach(50.0, 50.0).unwrap();
        assert!((left - (50.0 - 2.0_f64.sqrt())).abs() < 1e-12 && (right - (50.0 + 2.0_f64.sqrt())).abs() < 1e-12);
    }

    #[test]
    fn a_margin_along_one_axis_only_does_not_reach_along_the_other() {
        assert_eq!(swept((0.0, 0.0), (10.0, 0.0), 0.0, 2.0).reach(1.0, 3.0), Some((0.0, 10.0)));
        assert_eq!(swept((0.0, 0.0), (10.0, 0.0), 2.0, 0.0).reach(-1.0, 1.0), Some((-2.0, 12.0)));
        assert_eq!(swept((0.0, 0.0), (10.0, 0.0), 2.0, 0.0).reach(0.5, 1.0), None);
        assert_eq!(swept((3.0, 0.0), (3.0, 10.0), 0.0, 2.0).reach(11.0, 14.0), Some((3.0, 3.0)));
    }

    #[test]
    fn equal_runs_in_rows_that_follow_each_other_are_one_block() {
        let mut raster = Raster::new(Rect::new((0, 0), (4, 3)), Size::new(1.0, 1.0), 4, 3);
        raster.taken[1] = true;
        raster.taken[5] = true;
        let block = |column, row, columns, rows| FreeBlock { column, row, columns, rows };
        assert_eq!(raster.free_blocks(), [block(0, 0, 1, 2), block(2, 0, 2, 2), block(0, 2, 4, 1)]);
    }

    #[test]
    fn whole_cells_are_counted_without_noise() {
        assert_eq!(Raster::cells_in(50.0, 5.0), 10);
        assert_eq!(Raster::cells_in(0.3, 0.1), 3); // 0.3 / 0.1 is 2.9999999999999996
        assert_eq!(Raster::cells_in(10.2, 3.0), 3);
        assert_eq!(Raster::cells_in(2.9, 3.0), 0);
    }
}
