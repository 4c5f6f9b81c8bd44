//! Elements that are equal up to a shift: from their positions to repetitions.
//!
//! Rows of equal distance are found first, then rows that stack to lattices, then columns in what is left; the rest is one
//! list. Short rows are left to the list: a record of its own costs about as much as six of its vectors.

use super::super::repetition::Repetition;

/// A row or column of fewer elements is left to the list.
const SHORTEST_RUN: usize = 6;

/// Calls `emit` with the first position and the repetition of each record that the positions need. Every position is in
/// exactly one record. The order of the positions does not matter.
pub(super) fn each(mut positions: Vec<[i32; 2]>, mut emit: impl FnMut([i32; 2], Option<&Repetition>)) {
    positions.sort_unstable_by_key(|[x, y]| [*y, *x]);
    let mut again = Vec::new();
    while !positions.is_empty() {
        // A distance of 0 is legal but read differently by different tools.
        let distinct = distinct(positions, &mut again);
        records(distinct, &mut emit);
        positions = std::mem::take(&mut again);
    }
}

/// As [`each`], but with lists alone: what reads them keeps single elements single.
pub(super) fn lists(mut positions: Vec<[i32; 2]>, mut emit: impl FnMut([i32; 2], Option<&Repetition>)) {
    positions.sort_by_key(|[x, y]| [*y, *x]);
    let mut again = Vec::new();
    while !positions.is_empty() {
        match &distinct(positions, &mut again)[..] {
            [single] => emit(*single, None),
            several => list(several, &mut emit),
        }
        positions = std::mem::take(&mut again);
    }
}

/// Takes out what repeats the position before it.
fn distinct(positions: Vec<[i32; 2]>, again: &mut Vec<[i32; 2]>) -> Vec<[i32; 2]> {
    let mut last = None;
    let mut keep = positions;
    keep.retain(|position| {
        let new = last != Some(*position);
        if !new {
            again.push(*position);
        }
        last = Some(*position);
        new
    });
    keep
}

fn records(positions: Vec<[i32; 2]>, emit: &mut impl FnMut([i32; 2], Option<&Repetition>)) {
    if let [first] = positions[..] {
        return emit(first, None);
    }
    if let Some(lattice) = whole_lattice(&positions) {
        return emit(positions[0], Some(&lattice));
    }
    if positions.len() < SHORTEST_RUN {
        return list(&positions, emit);
    }
    let (rows, singles) = runs(&positions, 0);
    let (lattices, short) = stack(rows);
    for Lattice { first, columns, rows, column_step, row_step } in lattices {
        emit(first, Some(&Repetition::Lattice { columns, rows, column_step, row_step }));
    }
    let mut rest = singles;
    rest.extend(short);
    rest.sort_unstable();
    let (columns, mut rest) = runs(&rest, 1);
    for run in columns {
        if run.count < SHORTEST_RUN {
            rest.extend(run.positions());
        } else {
            let (column_step, row_step) = ([0, 0], run.step());
            emit(run.first, Some(&Repetition::Lattice { columns: 1, rows: run.count as u64, column_step, row_step }));
        }
    }
    rest.sort_unstable_by_key(|[x, y]| [*y, *x]);
    match rest[..] {
        [] => {}
        [single] => emit(single, None),
        _ => list(&rest, emit),
    }
}

fn list(positions: &[[i32; 2]], emit: &mut impl FnMut([i32; 2], Option<&Repetition>)) {
    let first = positions[0];
    let vectors = positions.iter().map(|position| difference(first, *position)).collect();
    emit(first, Some(&Repetition::List(vectors)));
}

fn difference(from: [i32; 2], to: [i32; 2]) -> [i64; 2] {
    [i64::from(to[0]) - i64::from(from[0]), i64::from(to[1]) - i64::from(from[1])]
}

/// The lattice, if the positions, sorted by rows, are all of one whose rows are horizontal, or of one slanted row.
fn whole_lattice(positions: &[[i32; 2]]) -> Option<Repetition> {
    let first = positions[0];
    let vector = |index: usize| difference(first, positions[index]);
    let step = vector(1);
    let columns = if step[1] == 0 {
        (1..positions.len()).find(|i| vector(*i) != [step[0] * i64::try_from(*i).ok().unwrap_or(0), 0])
    } else {
        Some(1)
    };
    let columns = columns.unwrap_or(positions.len());
    let rows = positions.len() / columns;
    if columns * rows != positions.len() {
        return None;
    }
    let row_step = if rows > 1 { vector(columns) } else { [0, 0] };
    let column_step = if columns > 1 { step } else { [0, 0] };
    let regular = positions.iter().enumerate().all(|(i, position)| {
        let at = |axis: usize| column_step[axis] * whole(i % columns) + row_step[axis] * whole(i / columns);
        difference(first, *position) == [at(0), at(1)]
    });
    regular.then_some(Repetition::Lattice { columns: columns as u64, rows: rows as u64, column_step, row_step })
}

/// A number of elements, of which memory holds fewer than 2⁶³.
fn whole(count: usize) -> i64 {
    i64::try_from(count).expect("invariant: a list has fewer than 2⁶³ elements")
}

/// Positions at equal distances along an axis.
#[derive(Debug, Clone, Copy)]
struct Run {
    first: [i32; 2],
    axis: usize,
    distance: i64,
    count: usize,
}

impl Run {
    fn step(&self) -> [i64; 2] {
        if self.axis == 0 { [self.distance, 0] } else { [0, self.distance] }
    }

    fn positions(self) -> impl Iterator<Item = [i32; 2]> {
        (0..self.count).map(move |i| {
            let mut at = self.first;
            let moved = i64::from(at[self.axis]) + self.distance * whole(i);
            at[self.axis] = i32::try_from(moved).expect("invariant: a run goes through positions of 32 bits");
            at
        })
    }
}

/// The longest runs along an axis of at least three positions, and the positions that are in none. The positions are
/// sorted by the other axis first.
fn runs(positions: &[[i32; 2]], axis: usize) -> (Vec<Run>, Vec<[i32; 2]>) {
    let (mut found, mut singles) = (Vec::new(), Vec::new());
    let distance = |i: usize| -> Option<i64> {
        let (here, next) = (positions[i], positions.get(i + 1)?);
        (here[1 - axis] == next[1 - axis]).then(|| i64::from(next[axis]) - i64::from(here[axis]))
    };
    let mut i = 0;
    while i < positions.len() {
        let step = distance(i);
        let mut end = i + 1;
        if step.is_some() {
            while end < positions.len() && distance(end - 1) == step {
                end += 1;
            }
        }
        match step {
            Some(distance) if end - i > 2 => {
                found.push(Run { first: positions[i], axis, distance, count: end - i });
                i = end;
            }
            _ => {
                singles.push(positions[i]);
                i += 1;
            }
        }
    }
    (found, singles)
}

/// Equal runs at equal distances across their direction.
struct Lattice {
    first: [i32; 2],
    columns: u64,
    rows: u64,
    column_step: [i64; 2],
    row_step: [i64; 2],
}

/// Stacks rows to lattices. What stays a short row is returned as positions.
fn stack(mut rows: Vec<Run>) -> (Vec<Lattice>, Vec<[i32; 2]>) {
    rows.sort_unstable_by_key(|row| (row.first[0], row.distance, row.count, row.first[1]));
    let (mut lattices, mut short) = (Vec::new(), Vec::new());
    let same = |a: &Run, b: &Run| (a.first[0], a.distance, a.count) == (b.first[0], b.distance, b.count);
    let mut i = 0;
    while i < rows.len() {
        let row = rows[i];
        let up = |k: usize| -> Option<i64> {
            let next = rows.get(k + 1)?;
            same(&rows[k], next).then(|| i64::from(next.first[1]) - i64::from(rows[k].first[1]))
        };
        let step = up(i);
        let mut end = i + 1;
        if step.is_some() {
            while end < rows.len() && up(end - 1) == step {
                end += 1;
            }
        }
        let stacked = end - i;
        if row.count * stacked < SHORTEST_RUN {
            short.extend(row.positions());
            i += 1;
            continue;
        }
        lattices.push(Lattice {
            first: row.first,
            columns: row.count as u64,
            rows: stacked as u64,
            column_step: row.step(),
            row_step: [0, step.filter(|_| stacked > 1).unwrap_or(0)],
        });
        i = end;
    }
    lattices.sort_unstable_by_key(|lattice| [lattice.first[1], lattice.first[0]]);
    (lattices, short)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All positions of all records, sorted, and how many records there are.
    fn placed(positions: &[[i32; 2]]) -> (Vec<[i32; 2]>, usize) {
        let (mut all, mut records) = (Vec::new(), 0);
        each(positions.to_vec(), |first, repetition| {
            records += 1;
            let Some(repetition) = repetition else { return all.push(first) };
            let outcome = repetition.each(|vector| {
                let vector = vector.unwrap();
                let at = |axis: usize| i32::try_from(i64::from(first[axis]) + vector[axis]).unwrap();
                all.push([at(0), at(1)]);
                Ok(())
            });
            outcome.unwrap();
        });
        all.sort_unstable();
        (all, records)
    }

    fn check(mut positions: Vec<[i32; 2]>, records: usize) {
        let (all, found) = placed(&positions);
        positions.sort_unstable();
        assert_eq!(all, positions);
        assert_eq!(found, records, "{positions:?}");
    }

    fn lattice(columns: i32, rows: i32, column: [i32; 2], row: [i32; 2]) -> Vec<[i32; 2]> {
        let at = |c: i32, r: i32| [c * column[0] + r * row[0], c * column[1] + r * row[1]];
        (0..columns).flat_map(|c| (0..rows).map(move |r| at(c, r))).collect()
    }

    #[test]
    fn lattices_are_one_record() {
        check(lattice(5, 7, [10, 0], [0, 20]), 1);
        check(lattice(5, 7, [10, 0], [3, 20]), 1);
        check(lattice(5, 7, [-10, 0], [-30, 20]), 1);
        check(lattice(2, 1, [10, 7], [0, 0]), 1);
        check(lattice(9, 1, [10, 7], [0, 0]), 1);
        check(lattice(1, 9, [0, 0], [0, 7]), 1);
        check(vec![[i32::MIN, i32::MIN], [i32::MAX, i32::MAX]], 1);
        check(vec![[3, 4]], 1);
    }

    #[test]
    fn lattices_with_gaps_are_a_few_records() {
        let mut holes = lattice(40, 40, [10, 0], [0, 10]);
        holes.retain(|position| *position != [200, 200]);
        check(holes, 4);
        let two = [lattice(10, 10, [10, 0], [0, 10]), lattice(10, 10, [7, 0], [0, 7])].concat();
        let (all, records) = placed(&two);
        assert_eq!((all.len(), records < 60), (200, true));
    }

    #[test]
    fn positions_at_random_are_one_list_and_repeated_ones_come_again() {
        let mut state = 1_u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            i32::try_from(state >> 12).unwrap()
        };
        let random: Vec<[i32; 2]> = (0..500).map(|_| [next(), next()]).collect();
        check(random.clone(), 1);
        check([&random[..], &random, &random[..1]].concat(), 3);
    }
}
