//! Positions on the grid, gathered into arrays.

use std::collections::BTreeMap;

use crate::point::GridPoint;

/// Regular positions: `columns` × `rows`, with their steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Lattice {
    pub(super) at: GridPoint,
    pub(super) columns: u32,
    pub(super) rows: u32,
    pub(super) column_step: GridPoint,
    pub(super) row_step: GridPoint,
}

impl Lattice {
    pub(super) fn is_single(&self) -> bool {
        self.columns == 1 && self.rows == 1
    }
}

/// All positions, each once, in axis-parallel arrays as far as they are regular: first rows, then stacks of equal rows.
pub(super) fn gathered(mut positions: Vec<GridPoint>) -> Vec<Lattice> {
    positions.sort_unstable_by_key(|p| (p.y, p.x));
    let mut rows: BTreeMap<(i64, u32, i64), Vec<i64>> = BTreeMap::new();
    let mut rest = &positions[..];
    while let [first, ..] = rest {
        let line = rest.iter().take_while(|p| p.y == first.y).map(|p| p.x);
        let (count, step) = leading_run(line);
        rows.entry((first.x, count, step)).or_default().push(first.y);
        rest = &rest[count as usize..];
    }
    let mut lattices: Vec<Lattice> = rows.into_iter().flat_map(|(row, heights)| stacked(row, &heights)).collect();
    lattices.sort_unstable_by_key(|lattice| (lattice.at.y, lattice.at.x));
    lattices
}

/// Equal rows at ascending heights.
fn stacked((x, columns, step): (i64, u32, i64), mut heights: &[i64]) -> Vec<Lattice> {
    let mut lattices = Vec::new();
    while let [y, ..] = *heights {
        let (rows, row_step) = leading_run(heights.iter().copied());
        heights = &heights[rows as usize..];
        let (column_step, row_step) = (GridPoint::new(step, 0), GridPoint::new(0, row_step));
        lattices.push(Lattice { at: GridPoint::new(x, y), columns, rows, column_step, row_step });
    }
    lattices
}

/// The length of the leading arithmetic sequence and its step. A pair is no sequence: its second number may begin a longer
/// one.
fn leading_run(mut numbers: impl Iterator<Item = i64>) -> (u32, i64) {
    let (Some(first), Some(second)) = (numbers.next(), numbers.next()) else { return (1, 0) };
    let step = second - first;
    let mut last = second;
    let following = numbers.take_while(|&next| {
        let follows = next - last == step;
        last = next;
        follows
    });
    match following.zip(0_u32..u32::MAX - 2).count() {
        0 => (1, 0),
        #[expect(clippy::cast_possible_truncation, reason = "fewer than u32::MAX were taken")]
        more => (more as u32 + 2, step),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_field_with_a_gap_becomes_few_arrays() {
        let field = (0..30).flat_map(|x| (0..20).map(move |y| (7 * x, 9 * y)));
        let positions: Vec<GridPoint> = field.filter(|&p| p != (70, 90)).map(GridPoint::from).collect();
        let lattices = gathered(positions);
        assert_eq!(lattices.len(), 4);
        assert!(lattices.contains(&Lattice {
            at: GridPoint::new(0, 0),
            columns: 30,
            rows: 10,
            column_step: GridPoint::new(7, 0),
            row_step: GridPoint::new(0, 9),
        }));
    }

    proptest! {
        #[test]
        fn every_position_is_in_one_array(positions in prop::collection::btree_set((0..12i64, 0..12i64), 0..80)) {
            let positions: Vec<GridPoint> = positions.into_iter().map(GridPoint::from).collect();
            let mut again: Vec<GridPoint> = gathered(positions.clone()).iter().flat_map(|l| {
                let cells = (0..i64::from(l.columns)).flat_map(|c| (0..i64::from(l.rows)).map(move |r| (c, r)));
                cells.map(|(c, r)| GridPoint::new(l.at.x + c * l.column_step.x, l.at.y + r * l.row_step.y)).collect::<Vec<_>>()
            }).collect();
            again.sort_unstable();
            prop_assert_eq!(again, positions);
        }
    }
}
