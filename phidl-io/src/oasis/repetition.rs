//! Repetitions: where the copies of an element are, as vectors from the first one.
//!
//! A lattice is kept as its two steps and never expanded here: fifteen bytes may claim 2⁶⁴ copies.

use std::sync::Arc;

use super::cursor::{Cursor, Fault, Result};
use super::encode;

/// Where the copies of an element are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Repetition {
    /// Columns and rows at two constant steps.
    Lattice { columns: u64, rows: u64, column_step: [i64; 2], row_step: [i64; 2] },
    /// Vectors from the first element, which is one of them.
    List(Arc<[[i64; 2]]>),
}

impl Repetition {
    /// Reads a repetition; `last` is the one before, which type 0 repeats.
    pub(super) fn read(cursor: &mut Cursor<'_>, last: Option<&Self>) -> Result<Self> {
        let start = cursor.position();
        let row = |columns, column_step| Self::Lattice { columns, rows: 1, column_step, row_step: [0, 0] };
        Ok(match cursor.unsigned()? {
            0 => {
                let unknown = || Fault::new(start, "the modal variable \"repetition\" is used before it is set");
                last.cloned().ok_or_else(unknown)?
            }
            1 => {
                let (columns, rows) = (dimension(cursor)?, dimension(cursor)?);
                let (column_step, row_step) = ([distance(cursor)?, 0], [0, distance(cursor)?]);
                Self::Lattice { columns, rows, column_step, row_step }
            }
            2 => row(dimension(cursor)?, [distance(cursor)?, 0]),
            3 => row(dimension(cursor)?, [0, distance(cursor)?]),
            kind @ 4..=7 => {
                let count = listed(cursor)?;
                let grid = if kind % 2 == 1 { distance(cursor)? } else { 1 };
                let along = |distance| if kind < 6 { [distance, 0] } else { [0, distance] };
                Self::list(cursor, count, grid, |cursor| Ok(along(distance(cursor)?)))?
            }
            8 => {
                let (columns, rows) = (dimension(cursor)?, dimension(cursor)?);
                Self::Lattice { columns, rows, column_step: cursor.g_delta()?, row_step: cursor.g_delta()? }
            }
            9 => row(dimension(cursor)?, cursor.g_delta()?),
            kind @ (10 | 11) => {
                let count = listed(cursor)?;
                let grid = if kind == 11 { distance(cursor)? } else { 1 };
                Self::list(cursor, count, grid, Cursor::g_delta)?
            }
            other => return Err(Fault::new(start, format!("a repetition has type {other}, but types are 0 to 11"))),
        })
    }

    /// A list of `steps` vectors after the first, each from the one before, in multiples of `grid`.
    fn list<'a>(
        cursor: &mut Cursor<'a>,
        steps: usize,
        grid: i64,
        mut step: impl FnMut(&mut Cursor<'a>) -> Result<[i64; 2]>,
    ) -> Result<Self> {
        let mut vectors = Vec::with_capacity(steps + 1);
        let mut at = [0_i64; 2];
        vectors.push(at);
        for _ in 0..steps {
            let start = cursor.position();
            let step = step(cursor)?;
            for (at, step) in at.iter_mut().zip(step) {
                let next = step.checked_mul(grid).and_then(|step| at.checked_add(step));
                *at = next.ok_or_else(|| Fault::new(start, "a repetition reaches beyond 64 bits"))?;
            }
            vectors.push(at);
        }
        Ok(Self::List(vectors.into()))
    }

    /// How many elements there are, the first one included.
    pub(super) fn count(&self) -> u128 {
        match self {
            Self::Lattice { columns, rows, .. } => u128::from(*columns) * u128::from(*rows),
            Self::List(vectors) => vectors.len() as u128,
        }
    }

    /// Calls `each` with every vector, in the order of the standard: columns inside, rows outside. The caller has looked
    /// at the count. A vector beyond 64 bits is `None`.
    pub(super) fn each(&self, mut each: impl FnMut(Option<[i64; 2]>) -> Result<()>) -> Result<()> {
        match self {
            Self::List(vectors) => vectors.iter().try_for_each(|vector| each(Some(*vector))),
            Self::Lattice { columns, rows, column_step, row_step } => {
                let along = |step: &[i64; 2], number: u64| {
                    let number = i64::try_from(number).ok()?;
                    Some([step[0].checked_mul(number)?, step[1].checked_mul(number)?])
                };
                for row in 0..*rows {
                    let start = along(row_step, row);
                    for column in 0..*columns {
                        each(start.zip(along(column_step, column)).and_then(|(a, b)| sum(a, b)))?;
                    }
                }
                Ok(())
            }
        }
    }

    /// Writes the repetition in the shortest of its types.
    pub(super) fn write(&self, out: &mut Vec<u8>) {
        match self {
            Self::Lattice { columns, rows, column_step, row_step } => {
                lattice(*columns, *rows, *column_step, *row_step, out);
            }
            Self::List(vectors) => list(vectors, out),
        }
    }
}

fn sum(a: [i64; 2], b: [i64; 2]) -> Option<[i64; 2]> {
    Some([a[0].checked_add(b[0])?, a[1].checked_add(b[1])?])
}

/// A number of columns or rows, which is stored less two.
fn dimension(cursor: &mut Cursor<'_>) -> Result<u64> {
    let start = cursor.position();
    let stored = cursor.unsigned()?;
    stored.checked_add(2).ok_or_else(|| Fault::new(start, "a repetition has more than 2⁶⁴ columns or rows"))
}

/// The number of vectors after the first one: one more than is stored.
fn listed(cursor: &mut Cursor<'_>) -> Result<usize> {
    Ok(cursor.count("distances")? + 1)
}

fn distance(cursor: &mut Cursor<'_>) -> Result<i64> {
    let start = cursor.position();
    let distance = cursor.unsigned()?;
    i64::try_from(distance).map_err(|_| Fault::new(start, "a distance has more than 63 bits"))
}

fn lattice(columns: u64, rows: u64, column_step: [i64; 2], row_step: [i64; 2], out: &mut Vec<u8>) {
    let along = |step: [i64; 2], axis: usize| step[axis] >= 0 && step[1 - axis] == 0;
    match (columns, rows) {
        (1, rows) => lattice_row(rows, row_step, out),
        (columns, 1) => lattice_row(columns, column_step, out),
        _ if along(column_step, 0) && along(row_step, 1) => {
            out.push(1);
            encode::unsigned(columns - 2, out);
            encode::unsigned(rows - 2, out);
            encode::unsigned(column_step[0].unsigned_abs(), out);
            encode::unsigned(row_step[1].unsigned_abs(), out);
        }
        _ => {
            out.push(8);
            encode::unsigned(columns - 2, out);
            encode::unsigned(rows - 2, out);
            encode::g_delta(column_step, out);
            encode::g_delta(row_step, out);
        }
    }
}

fn lattice_row(count: u64, step: [i64; 2], out: &mut Vec<u8>) {
    let (kind, distance) = match step {
        [x, 0] if x >= 0 => (2, Some(x)),
        [0, y] if y >= 0 => (3, Some(y)),
        _ => (9, None),
    };
    out.push(kind);
    encode::unsigned(count - 2, out);
    match distance {
        Some(distance) => encode::unsigned(distance.unsigned_abs(), out),
        None => encode::g_delta(step, out),
    }
}

/// A list of vectors: along an axis where it is one, in multiples of a grid where all steps share one.
fn list(vectors: &[[i64; 2]], out: &mut Vec<u8>) {
    let steps = || vectors.windows(2).map(|pair| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]]);
    let along = |axis: usize| steps().all(|step| step[axis] >= 0 && step[1 - axis] == 0);
    let axis = [0, 1].into_iter().find(|axis| along(*axis));
    let grid = steps().flatten().fold(0, |grid, length| common_divisor(grid, length.unsigned_abs()));
    let scaled = grid > 1 && {
        let length = |grid: u64| steps().map(|step| step_length(step, grid, axis)).sum::<usize>();
        length(grid) + encode::unsigned_length(grid) < length(1)
    };
    let kind = match axis {
        Some(0) => 4,
        Some(_) => 6,
        None => 10,
    };
    out.push(kind + u8::from(scaled));
    encode::unsigned(vectors.len() as u64 - 2, out);
    let grid = if scaled { grid } else { 1 };
    if scaled {
        encode::unsigned(grid, out);
    }
    for step in steps() {
        let step = step.map(|length| length / grid.cast_signed());
        match axis {
            Some(axis) => encode::unsigned(step[axis].unsigned_abs(), out),
            None => encode::g_delta(step, out),
        }
    }
}

fn step_length(step: [i64; 2], grid: u64, axis: Option<usize>) -> usize {
    let step = step.map(|length| length / grid.cast_signed());
    match axis {
        Some(axis) => encode::unsigned_length(step[axis].unsigned_abs()),
        None => encode::g_delta_length(step),
    }
}

fn common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(repetition: &Repetition) -> Vec<[i64; 2]> {
        let mut all = Vec::new();
        let outcome: Result<()> = repetition.each(|vector| {
            all.push(vector.unwrap());
            Ok(())
        });
        outcome.unwrap();
        assert_eq!(repetition.count(), all.len() as u128);
        all
    }

    fn read(bytes: &[u8]) -> Vec<[i64; 2]> {
        let mut cursor = Cursor::of_file(bytes);
        let repetition = Repetition::read(&mut cursor, None).unwrap();
        assert_eq!(cursor.left(), 0);
        vectors(&repetition)
    }

    /// By hand, from the rules of section 7.6 of SEMI P39.
    #[test]
    fn every_type_has_the_copies_of_the_standard() {
        assert_eq!(read(&[1, 0, 1, 10, 20]), [[0, 0], [10, 0], [0, 20], [10, 20], [0, 40], [10, 40]]);
        assert_eq!(read(&[2, 1, 10]), [[0, 0], [10, 0], [20, 0]]);
        assert_eq!(read(&[3, 0, 10]), [[0, 0], [0, 10]]);
        assert_eq!(read(&[4, 1, 10, 5]), [[0, 0], [10, 0], [15, 0]]);
        assert_eq!(read(&[5, 1, 10, 1, 2]), [[0, 0], [10, 0], [30, 0]]);
        assert_eq!(read(&[6, 1, 10, 5]), [[0, 0], [0, 10], [0, 15]]);
        assert_eq!(read(&[7, 1, 10, 1, 2]), [[0, 0], [0, 10], [0, 30]]);
        // Columns at (5, 0), rows at (-5, 5).
        assert_eq!(read(&[8, 0, 0, 0x50, 0x5a]), [[0, 0], [5, 0], [-5, 5], [0, 5]]);
        assert_eq!(read(&[9, 1, 0x5a]), [[0, 0], [-5, 5], [-10, 10]]);
        assert_eq!(read(&[10, 1, 0x5a, 0x50]), [[0, 0], [-5, 5], [0, 5]]);
        assert_eq!(read(&[11, 1, 3, 0x5a, 0x50]), [[0, 0], [-15, 15], [0, 15]]);
    }

    #[test]
    fn type_0_is_the_repetition_before() {
        let last = Repetition::List([[0, 0], [1, 2]].into());
        assert_eq!(Repetition::read(&mut Cursor::of_file(&[0]), Some(&last)).unwrap(), last);
        assert!(Repetition::read(&mut Cursor::of_file(&[0]), None).is_err());
        assert!(Repetition::read(&mut Cursor::of_file(&[12]), Some(&last)).is_err());
    }

    #[test]
    fn counts_without_end_cost_no_memory() {
        let most = [0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f];
        let lattice = [&[1][..], &most, &most, &[1, 1]].concat();
        let read = Repetition::read(&mut Cursor::of_file(&lattice), None).unwrap();
        assert_eq!(read.count(), ((1 << 63) + 1_u128).pow(2));
        let list = [&[10][..], &most, &[1, 1]].concat();
        assert!(Repetition::read(&mut Cursor::of_file(&list), None).is_err());
    }

    #[test]
    fn what_is_written_is_read_back_in_the_shortest_type() {
        let lattice =
            |columns, rows, column_step, row_step| Repetition::Lattice { columns, rows, column_step, row_step };
        let list = |vectors: &[[i64; 2]]| Repetition::List(vectors.into());
        let cases = [
            (1, lattice(3, 2, [10, 0], [0, 7])),
            (8, lattice(3, 2, [-10, 0], [0, 7])),
            (8, lattice(3, 2, [10, 1], [0, 7])),
            (2, lattice(5, 1, [4, 0], [0, 0])),
            (3, lattice(1, 5, [0, 0], [0, 4])),
            (9, lattice(5, 1, [4, -4], [0, 0])),
            (4, list(&[[0, 0], [1, 0], [4, 0]])),
            (5, list(&[[0, 0], [1000, 0], [5000, 0], [6000, 0]])),
            (6, list(&[[0, 0], [0, 3], [0, 4]])),
            (7, list(&[[0, 0], [0, 3000], [0, 4000], [0, 6000]])),
            (10, list(&[[0, 0], [5, 3], [1, -4]])),
            (11, list(&[[0, 0], [5000, 3000], [1000, -4000], [0, 0], [7000, 7000]])),
        ];
        for (kind, repetition) in cases {
            let mut bytes = Vec::new();
            repetition.write(&mut bytes);
            assert_eq!(bytes[0], kind);
            assert_eq!(read(&bytes), vectors(&repetition));
        }
    }
}
