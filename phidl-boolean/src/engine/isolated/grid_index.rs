//! [`GridIndex`]: which contours have no edge of another contour in their bounding box?
//!
//! A uniform grid has about one cell per contour. Small contours are entered by their box, large ones edge by edge, and
//! entries of one cell are compared box by box. Contours in crowded cells count as touched, and so do large contours.
//!
//! The candidate search of [`snap`](crate::engine::snap) is not used here: it looks at every segment, and a field of dots
//! is decided by one box per contour.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::point::GridPoint;

/// Contours over more cells than this are large.
const MOST_CELLS: usize = 16;

/// Cells with more entries than this are too crowded to compare.
const MOST_ENTRIES: usize = 48;

/// The search is given up if there are more entries than this for each edge: many long lines.
const ENTRIES_PER_EDGE: usize = 4;

/// The grid has at most this many cells along each side.
const MOST_COLUMNS: f64 = 4096.0;

/// Cells compared by one parallel job at least.
const CELLS_PER_JOB: usize = 1024;

/// A box on the grid, its borders included.
#[derive(Debug, Clone, Copy)]
struct Box2 {
    low: GridPoint,
    high: GridPoint,
}

impl Box2 {
    const NOWHERE: Self = Self { low: GridPoint::new(i64::MAX, i64::MAX), high: GridPoint::new(i64::MIN, i64::MIN) };

    fn around(points: &[GridPoint]) -> Self {
        points.iter().fold(Self::NOWHERE, |b, &p| b.joined(Self { low: p, high: p }))
    }

    fn joined(self, other: Self) -> Self {
        Self {
            low: GridPoint::new(self.low.x.min(other.low.x), self.low.y.min(other.low.y)),
            high: GridPoint::new(self.high.x.max(other.high.x), self.high.y.max(other.high.y)),
        }
    }

    fn is_empty(self) -> bool {
        self.low.x > self.high.x
    }

    fn touches(self, other: Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
}

/// A small contour, or an edge of a large one.
#[derive(Clone, Copy)]
struct Item {
    bounds: Box2,
    cells: Cells,
    contour: u32,
    is_small: bool,
}

/// Whether each contour is known to have no edge of another one in its bounding box.
pub(super) fn without_neighbors<T: Sync>(contours: &[(&[GridPoint], T)]) -> Vec<bool> {
    let boxes: Vec<Box2> =
        contours.par_iter().with_min_len(CELLS_PER_JOB).map(|(points, _)| Box2::around(points)).collect();
    let whole = boxes.iter().fold(Box2::NOWHERE, |all, &b| all.joined(b));
    if whole.is_empty() {
        return vec![false; contours.len()];
    }
    let grid = GridIndex::new(whole, contours.len());
    let mut items = Vec::with_capacity(contours.len());
    let mut is_small = vec![false; contours.len()];
    for (contour, ((points, _), &bounds)) in (0u32..).zip(contours.iter().zip(&boxes)) {
        let cells = grid.cells(bounds);
        is_small[contour as usize] = !bounds.is_empty() && cells.count() <= MOST_CELLS;
        if is_small[contour as usize] {
            items.push(Item { bounds, cells, contour, is_small: true });
        } else {
            let item = |bounds| Item { bounds, cells: grid.cells(bounds), contour, is_small: false };
            items.extend(edge_boxes(points).map(item));
        }
    }
    let most = ENTRIES_PER_EDGE * contours.iter().map(|(points, _)| points.len()).sum::<usize>().max(MOST_CELLS);
    let Some(entries) = Entries::new(&grid, &items, most) else { return vec![false; contours.len()] };
    let touched: Vec<AtomicBool> = is_small.iter().map(|&small| AtomicBool::new(!small)).collect();
    entries.cells().for_each(|cell| compare(cell, &items, &touched));
    touched.into_iter().map(|touched| !touched.into_inner()).collect()
}

fn edge_boxes(points: &[GridPoint]) -> impl Iterator<Item = Box2> {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| Box2::around(&[a, b]))
}

/// Marks the small contours of a cell whose box is touched.
fn compare(cell: &[u32], items: &[Item], touched: &[AtomicBool]) {
    let mark = |item: &Item| {
        if item.is_small {
            touched[item.contour as usize].store(true, Ordering::Relaxed);
        }
    };
    if cell.len() > MOST_ENTRIES {
        cell.iter().for_each(|&item| mark(&items[item as usize]));
        return;
    }
    for (position, &a) in cell.iter().enumerate() {
        let a = &items[a as usize];
        for &b in &cell[..position] {
            let b = &items[b as usize];
            if (a.is_small || b.is_small) && a.bounds.touches(b.bounds) {
                mark(a);
                mark(b);
            }
        }
    }
}

/// A uniform grid over the bounding box of all contours.
struct GridIndex {
    low: GridPoint,
    /// Cells per grid step.
    scale: (f64, f64),
    columns: usize,
    rows: usize,
}

impl GridIndex {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an estimate of the cell size; columns and rows are from 1 to 4096"
    )]
    fn new(whole: Box2, contours: usize) -> Self {
        let width = (whole.high.x - whole.low.x + 1) as f64;
        let height = (whole.high.y - whole.low.y + 1) as f64;
        let side = (width * height / contours as f64).sqrt().max(1.0);
        let count = |length: f64| (length / side).ceil().clamp(1.0, MOST_COLUMNS);
        let (columns, rows) = (count(width), count(height));
        let scale = (columns / width, rows / height);
        Self { low: whole.low, scale, columns: columns as usize, rows: rows as usize }
    }

    fn cells(&self, bounds: Box2) -> Cells {
        if bounds.is_empty() {
            return Cells { columns: (0, 0), rows: (0, 0) };
        }
        let (low, high) = (bounds.low, bounds.high);
        Cells { columns: (self.column(low.x), self.column(high.x)), rows: (self.row(low.y), self.row(high.y)) }
    }

    fn column(&self, x: i64) -> u16 {
        cell_of(x - self.low.x, self.scale.0, self.columns)
    }

    fn row(&self, y: i64) -> u16 {
        cell_of(y - self.low.y, self.scale.1, self.rows)
    }
}

/// The column or row of an offset from the lower left corner; it never decreases as the offset grows.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "offsets are exact in an f64, and a grid has at most 4096 columns and rows"
)]
fn cell_of(offset: i64, scale: f64, count: usize) -> u16 {
    ((offset as f64 * scale) as u16).min(count as u16 - 1)
}

/// The cells that a box touches: first and last column, first and last row.
#[derive(Clone, Copy)]
struct Cells {
    columns: (u16, u16),
    rows: (u16, u16),
}

impl Cells {
    fn count(self) -> usize {
        usize::from(self.columns.1 - self.columns.0 + 1) * usize::from(self.rows.1 - self.rows.0 + 1)
    }

    /// Calls `visit` with the number of each cell, in a grid with `rows` rows.
    fn for_each(self, rows: usize, mut visit: impl FnMut(usize)) {
        for column in self.columns.0..=self.columns.1 {
            for row in self.rows.0..=self.rows.1 {
                visit(usize::from(column) * rows + usize::from(row));
            }
        }
    }
}

/// The items of each cell.
struct Entries {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Entries {
    /// `None` if there would be more than `most`.
    fn new(grid: &GridIndex, items: &[Item], most: usize) -> Option<Self> {
        let total: usize = items.iter().map(|item| item.cells.count()).sum();
        if total > most || u32::try_from(total).is_err() {
            return None;
        }
        let mut starts = vec![0; grid.columns * grid.rows + 1];
        for item in items {
            item.cells.for_each(grid.rows, |cell| starts[cell] += 1);
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut entries = vec![0; total];
        for (number, item) in (0u32..).zip(items) {
            item.cells.for_each(grid.rows, |cell| {
                starts[cell] -= 1;
                entries[starts[cell] as usize] = number;
            });
        }
        Some(Self { starts, items: entries })
    }

    fn cells(&self) -> impl ParallelIterator<Item = &[u32]> {
        self.starts
            .par_windows(2)
            .with_min_len(CELLS_PER_JOB)
            .map(|range| &self.items[range[0] as usize..range[1] as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: i64, y: i64, side: i64) -> Vec<GridPoint> {
        [(x, y), (x + side, y), (x + side, y + side), (x, y + side)].map(GridPoint::from).to_vec()
    }

    fn isolated_of(contours: &[Vec<GridPoint>]) -> Vec<bool> {
        let contours: Vec<(&[GridPoint], ())> = contours.iter().map(|c| (c.as_slice(), ())).collect();
        without_neighbors(&contours)
    }

    #[test]
    fn squares_of_a_field_are_isolated_until_a_neighbor_touches_them() {
        let mut field: Vec<_> = (0..20).flat_map(|x| (0..20).map(move |y| square(10 * x, 10 * y, 8))).collect();
        assert_eq!(isolated_of(&field), vec![true; 400]);
        field.push(square(198, 198, 5)); // shares a corner with the last square
        let found = isolated_of(&field);
        assert_eq!(found.iter().filter(|&&isolated| !isolated).count(), 2);
        assert!(!found[399] && !found[400]);
    }

    #[test]
    fn a_frame_around_a_field_touches_only_what_its_edges_meet() {
        let mut field: Vec<_> = (0..20).flat_map(|x| (0..20).map(move |y| square(10 * x, 10 * y, 8))).collect();
        field.push(square(-5, -5, 210));
        field.push(square(4, -100, 1000)); // its left edge runs through the first column
        let found = isolated_of(&field);
        assert_eq!(found.iter().filter(|&&isolated| isolated).count(), 380);
        assert!(found[20..400].iter().all(|&isolated| isolated));
    }

    #[test]
    fn contours_without_points_are_skipped() {
        assert_eq!(isolated_of(&[vec![], square(0, 0, 4), vec![]]), [false, true, false]);
        assert_eq!(isolated_of(&[]), Vec::<bool>::new());
    }
}
