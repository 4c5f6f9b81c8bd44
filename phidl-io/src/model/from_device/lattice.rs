//! Arrays on the grid: the parts of a lattice that one array record states.
//!
//! An array record holds the first element and the ends of two rows of steps, all on the grid; readers divide the ends by
//! the counts. If a step is not on the grid (a pitch of 1/3 µm, a lattice turned by 30°), the elements of such a record
//! drift from their positions. So a record is written only where the rounded position of every element agrees with it.
//! Otherwise the lattice is cut into rows or columns that agree, and at last into single references. A record with rounded
//! steps would be shorter, and wrong by 30 µm after 100,000 elements.
//!
//! Columns and rows are swapped where that puts the steps along the axes of the array's own frame: gdspy, and with it
//! PHIDL, reads every lattice as rectangular there. A lattice that is skew in any case is written as an array unless
//! [`Rules::skew_arrays`](super::Rules) says otherwise.

use phidl_core::geom::Point;
use phidl_core::num::grid::{Grid, GridError};
use phidl_core::scene::{Array, Reference};

use super::convert::corner;
use crate::model::{Corner, Lattice};

/// The most columns and rows of a record: the manual has them as signed numbers.
const MOST_COUNT: u32 = 32_767;

/// The most references that an array is taken apart into: beyond, the file would have gigabytes.
pub(super) const MOST_BLOCKS: usize = 1 << 22;

/// A part of a lattice that one record states. One element is a single reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) columns: u16,
    pub(super) rows: u16,
    pub(super) first: Corner,
    /// `columns` column steps further than the first element.
    pub(super) column_end: Corner,
    /// `rows` row steps further than the first element.
    pub(super) row_end: Corner,
}

impl Block {
    /// The lattice of an array; `None` for a single reference.
    pub(super) fn lattice(&self) -> Option<Box<Lattice>> {
        let extent = |end: Corner| [0, 1].map(|axis| i64::from(end[axis]) - i64::from(self.first[axis]));
        (self.columns > 1 || self.rows > 1).then(|| {
            Box::new(Lattice {
                columns: self.columns.into(),
                rows: self.rows.into(),
                column_extent: extent(self.column_end),
                row_extent: extent(self.row_end),
            })
        })
    }
}

/// Why a lattice cannot be written.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LatticeError {
    OutOfRange(GridError),
    TooManyBlocks,
}

impl From<GridError> for LatticeError {
    fn from(error: GridError) -> Self {
        Self::OutOfRange(error)
    }
}

/// The records that place a reference: one for a single placement, as few as possible for an array. `skew_arrays`: whether
/// lattices that are not rectangular in their own frame are arrays in the file.
pub(super) fn blocks(reference: &Reference, grid: &Grid, skew_arrays: bool) -> Result<Vec<Block>, LatticeError> {
    let single = Array { columns: 1, rows: 1, column_step: Point::ORIGIN, row_step: Point::ORIGIN };
    let array = upright(*reference.array().unwrap_or(&single));
    let as_arrays = skew_arrays || is_rectangular(&array);
    let mut lattice = Cutter { reference, grid, array, as_arrays, blocks: Vec::new() };
    for (column, columns) in parts(array.columns) {
        for (row, rows) in parts(array.rows) {
            lattice.cut(Range { column, row, columns, rows })?;
        }
    }
    Ok(lattice.blocks)
}

/// The same lattice with columns and rows swapped if that makes it rectangular.
fn upright(array: Array) -> Array {
    let Array { columns, rows, column_step, row_step } = array;
    let swapped = Array { columns: rows, rows: columns, column_step: row_step, row_step: column_step };
    if !is_rectangular(&array) && is_rectangular(&swapped) { swapped } else { array }
}

/// Whether columns step along x and rows along y. The step of a single column or row does not matter.
fn is_rectangular(array: &Array) -> bool {
    (array.columns == 1 || array.column_step.y == 0.0) && (array.rows == 1 || array.row_step.x == 0.0)
}

/// A count in parts that a record can hold.
fn parts(count: u32) -> impl Iterator<Item = (u32, u32)> + Clone {
    (0..count).step_by(MOST_COUNT as usize).map(move |start| (start, MOST_COUNT.min(count - start)))
}

#[derive(Clone, Copy)]
struct Range {
    column: u32,
    row: u32,
    columns: u32,
    rows: u32,
}

struct Cutter<'a> {
    reference: &'a Reference,
    grid: &'a Grid,
    array: Array,
    /// Whether more than one element may be one record.
    as_arrays: bool,
    blocks: Vec<Block>,
}

impl Cutter<'_> {
    /// Adds the blocks of a part of the lattice: itself, its rows, its columns, or its elements.
    fn cut(&mut self, range: Range) -> Result<(), LatticeError> {
        if let Some(block) = self.block(range)? {
            if self.blocks.len() >= MOST_BLOCKS {
                return Err(LatticeError::TooManyBlocks);
            }
            self.blocks.push(block);
            return Ok(());
        }
        let (a_row, a_column) = (Range { rows: 1, ..range }, Range { columns: 1, ..range });
        if range.rows > 1 && range.columns > 1 && self.block(a_row)?.is_some() {
            return (0..range.rows).try_for_each(|row| self.cut(Range { row: range.row + row, ..a_row }));
        }
        let singles = range.columns as usize * range.rows as usize;
        if singles > MOST_BLOCKS && self.block(a_column)?.is_none() {
            return Err(LatticeError::TooManyBlocks);
        }
        // Columns, and within one column its elements.
        if range.columns > 1 {
            return (0..range.columns).try_for_each(|c| self.cut(Range { column: range.column + c, ..a_column }));
        }
        let element = Range { columns: 1, rows: 1, ..range };
        (0..range.rows).try_for_each(|row| self.cut(Range { row: range.row + row, ..element }))
    }

    /// The block for a part, if all its elements round to their positions in the block.
    ///
    /// The distance of an element from its position in the block grows evenly along columns and rows, and rounding keeps
    /// order: if the four corners agree, so do all elements between them.
    fn block(&self, range: Range) -> Result<Option<Block>, LatticeError> {
        let first = self.element(range.column, range.row)?;
        let (last_column, last_row) = (range.columns - 1, range.rows - 1);
        let single = range.columns == 1 && range.rows == 1;
        if !single && !self.as_arrays {
            return Ok(None);
        }
        let (column_step, row_step) = (self.step(self.array.column_step), self.step(self.array.row_step));
        let at = |columns: u32, rows: u32| -> Option<Corner> {
            let position = |axis: usize| {
                let steps = i64::from(columns) * column_step?[axis] + i64::from(rows) * row_step?[axis];
                i32::try_from(i64::from(first[axis]) + steps).ok()
            };
            Some([position(0)?, position(1)?])
        };
        for (column, row) in [(last_column, 0), (0, last_row), (last_column, last_row)] {
            let rounded = self.element(range.column + column, range.row + row)?;
            if !single && at(column, row) != Some(rounded) {
                return Ok(None);
            }
        }
        let count = |count: u32| u16::try_from(count).expect("invariant: parts have at most 32767 columns and rows");
        let (columns, rows) = (count(range.columns), count(range.rows));
        if single {
            return Ok(Some(Block { columns, rows, first, column_end: first, row_end: first }));
        }
        let ends = at(range.columns, 0).zip(at(0, range.rows));
        Ok(ends.map(|(column_end, row_end)| Block { columns, rows, first, column_end, row_end }))
    }

    fn element(&self, column: u32, row: u32) -> Result<Corner, GridError> {
        let step = self.reference.placed_step(self.array.step(column, row));
        corner(self.grid, self.reference.transform().origin + step)
    }

    /// A step in the frame of the parent, if it is within the grid's reach.
    fn step(&self, step: Point) -> Option<[i64; 2]> {
        let (x, y) = self.grid.point_steps(self.reference.placed_step(step)).ok()?;
        Some([x, y])
    }
}

#[cfg(test)]
mod tests {
    use phidl_core::geom::Transform;
    use phidl_core::place::Movable;
    use phidl_core::scene::Device;

    use super::*;

    fn grid() -> Grid {
        Grid::new(1e-3).unwrap()
    }

    fn dot() -> Device {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        d.build().unwrap()
    }

    /// The position of every element of every block, as a reader computes it.
    fn placed(blocks: &[Block]) -> Vec<Corner> {
        let mut positions = Vec::new();
        for b in blocks {
            for column in 0..i32::from(b.columns.cast_signed()) {
                for row in 0..i32::from(b.rows.cast_signed()) {
                    let axis = |axis: usize| {
                        b.first[axis]
                            + (b.column_end[axis] - b.first[axis]) / i32::from(b.columns.cast_signed()) * column
                            + (b.row_end[axis] - b.first[axis]) / i32::from(b.rows.cast_signed()) * row
                    };
                    positions.push([axis(0), axis(1)]);
                }
            }
        }
        positions.sort_unstable();
        positions
    }

    /// The position of every element, rounded on its own.
    fn wanted(reference: &Reference) -> Vec<Corner> {
        let mut positions: Vec<Corner> = reference.elements().map(|e| corner(&grid(), e.origin).unwrap()).collect();
        positions.sort_unstable();
        positions
    }

    fn check(reference: &Reference, records: usize) {
        let blocks = blocks(reference, &grid(), true).unwrap();
        assert_eq!(placed(&blocks), wanted(reference));
        assert_eq!(blocks.len(), records);
    }

    #[test]
    fn lattices_on_the_grid_are_one_record_in_all_orientations() {
        for quarter in 0..4 {
            let array = dot().array(5, 7, (10, 20.5)).rotated(90.0 * f64::from(quarter));
            check(&array, 1);
            check(&array.mirrored((0, 0), (1, 1)), 1);
        }
        check(&dot().place().moved_by((1, 2)), 1);
        check(&dot().array(1, 9, (0, 3)), 1);
        check(&dot().array(4, 4, (-3, 0)), 1);
    }

    #[test]
    fn a_pitch_off_the_grid_never_drifts() {
        let third = 1.0 / 3.0;
        check(&dot().array(100, 1, (third, 0.0)), 100);
        check(&dot().array(10, 20, (2.0, third)), 20);
        check(&dot().array(20, 10, (third, 2.0)), 20);
        check(&dot().array(9, 9, (third, third)), 81);
        check(&dot().array(6, 6, (10, 10)).rotated(30.0), 36);
    }

    #[test]
    fn noise_does_not_break_a_lattice() {
        check(&dot().array(300, 300, (0.1 + 0.2, 0.7 - 0.1)).moved_by((0.1, 1e-13)), 1);
    }

    fn lattice(columns: u32, rows: u32, column_step: (i32, i32), row_step: (i32, i32)) -> Array {
        Array { columns, rows, column_step: column_step.into(), row_step: row_step.into() }
    }

    #[test]
    fn skew_lattices_are_arrays_or_single_references_on_request() {
        let skew = dot().place().with_array(lattice(3, 2, (20, 5), (-3, 10)));
        check(&skew, 1);
        assert_eq!(blocks(&skew, &grid(), false).unwrap().len(), 6);
    }

    #[test]
    fn a_lattice_that_is_turned_by_a_quarter_against_its_angle_is_rectangular() {
        let turned = dot().place().with_array(lattice(3, 2, (0, 20), (10, 0)));
        check(&turned, 1);
        assert_eq!(blocks(&turned, &grid(), false).unwrap().len(), 1);
        assert_eq!(blocks(&turned, &grid(), false).unwrap()[0].columns, 2);
    }

    #[test]
    fn a_lattice_on_the_grid_is_an_array_at_any_angle_of_its_cell() {
        let frame = Transform::rotation(-30.0);
        let step = |x: f64, y: f64| frame.apply_vector(Point::new(x, y));
        let array = Array { columns: 4000, rows: 2000, column_step: step(2.0, 0.0), row_step: step(0.0, 3.0) };
        let reference = Reference::new(dot(), Transform::rotation(30.0)).with_array(array);
        assert_eq!(blocks(&reference, &grid(), true).unwrap().len(), 1);
    }

    #[test]
    fn lattices_beyond_the_limits_of_a_record_are_cut() {
        let blocks = blocks(&dot().array(40_000, 70_000, (0.002, 0.002)), &grid(), true).unwrap();
        assert_eq!(blocks.iter().map(|b| u64::from(b.columns) * u64::from(b.rows)).sum::<u64>(), 40_000 * 70_000);
        assert_eq!(blocks.len(), 6);
    }

    #[test]
    fn what_cannot_be_written_is_an_error_and_not_a_hang() {
        let far = dot().array(2, 2, (3e6, 1.0));
        assert!(matches!(blocks(&far, &grid(), true), Err(LatticeError::OutOfRange(_))));
        let huge = dot().array(5000, 5000, (0.3333, 0.3333));
        assert_eq!(blocks(&huge, &grid(), true), Err(LatticeError::TooManyBlocks));
    }
}
