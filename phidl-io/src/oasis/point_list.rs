//! Point lists: the corners of a polygon or path, as vectors from the first one.

use super::cursor::{Cursor, Fault, Result};
use super::encode;

/// What a point list belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// Closed: lists of alternating directions leave out one more corner.
    Polygon,
    Path,
}

/// Reads a list into `corners`, which begins with (0, 0). Returns whether it keeps the rule that a polygon of alternating
/// directions has an even number of deltas.
pub(super) fn read(cursor: &mut Cursor<'_>, owner: Owner, corners: &mut Vec<[i64; 2]>) -> Result<bool> {
    let start = cursor.position();
    let kind = cursor.unsigned()?;
    let count = cursor.count("corners")?;
    corners.clear();
    corners.reserve(count + 2);
    corners.push([0, 0]);
    if count == 0 {
        return Err(Fault::new(start, "a point list is empty"));
    }
    let too_far = || Fault::new(start, "a point list reaches beyond 64 bits");
    let mut at = [0_i64; 2];
    let mut add = |step: [i64; 2]| -> Result<()> {
        let [Some(x), Some(y)] = [at[0].checked_add(step[0]), at[1].checked_add(step[1])] else {
            return Err(too_far());
        };
        at = [x, y];
        corners.push(at);
        Ok(())
    };
    match kind {
        0 | 1 => {
            for i in 0..count {
                let length = cursor.signed()?;
                let horizontal = i.is_multiple_of(2) == (kind == 0);
                add(if horizontal { [length, 0] } else { [0, length] })?;
            }
            if owner == Owner::Polygon {
                // The last step ran along one axis; the one that is left out returns along the other.
                let last_horizontal = (count % 2 == 1) == (kind == 0);
                let [x, y] = at;
                corners.push(if last_horizontal { [x, 0] } else { [0, y] });
                return Ok(count.is_multiple_of(2));
            }
        }
        2 => (0..count).try_for_each(|_| add(cursor.two_delta()?))?,
        3 => (0..count).try_for_each(|_| add(cursor.three_delta()?))?,
        4 => (0..count).try_for_each(|_| add(cursor.g_delta()?))?,
        5 => {
            let mut step = [0_i64; 2];
            for _ in 0..count {
                let change = cursor.g_delta()?;
                let [Some(x), Some(y)] = [step[0].checked_add(change[0]), step[1].checked_add(change[1])] else {
                    return Err(too_far());
                };
                step = [x, y];
                add(step)?;
            }
        }
        other => return Err(Fault::new(start, format!("a point list has type {other}, but types are 0 to 5"))),
    }
    Ok(true)
}

/// Writes the corners of a polygon in the shortest list: alternating directions, then 2-, 3- and g-deltas.
///
/// `corners` has at least three corners, no two in a row alike, and does not repeat the first one at the end.
pub(super) fn write_polygon(corners: &[[i64; 2]], out: &mut Vec<u8>) {
    let steps = || corners.windows(2).map(|pair| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]]);
    if let Some(kind) = alternating(corners) {
        out.push(kind);
        encode::unsigned(corners.len() as u64 - 2, out);
        for step in steps().take(corners.len() - 2) {
            encode::signed(step[0] + step[1], out);
        }
        return;
    }
    write_steps(corners, out);
}

/// Writes the points of a path in the shortest list. `points` has at least two points, no two in a row alike.
pub(super) fn write_path(points: &[[i64; 2]], out: &mut Vec<u8>) {
    write_steps(points, out);
}

/// Writes the steps from point to point as 2-, 3- or g-deltas.
fn write_steps(corners: &[[i64; 2]], out: &mut Vec<u8>) {
    let steps = || corners.windows(2).map(|pair| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]]);
    let highest = steps().map(|step| encode::octant(step).map_or(8, |(direction, _)| direction)).max();
    let (kind, flags) = match highest {
        Some(0..4) => (2, 2),
        Some(4..8) => (3, 3),
        _ => (4, 0),
    };
    out.push(kind);
    encode::unsigned(corners.len() as u64 - 1, out);
    for step in steps() {
        match encode::octant(step) {
            Some((direction, length)) if kind < 4 => encode::unsigned((length << flags) | direction, out),
            _ => encode::g_delta(step, out),
        }
    }
}

/// The type of the list, if all edges turn at right angles and run along the axes: 0 if the first one is horizontal.
fn alternating(corners: &[[i64; 2]]) -> Option<u8> {
    if corners.len() < 4 || corners.len() % 2 == 1 {
        return None;
    }
    let horizontal_first = corners[0][1] == corners[1][1];
    let next = corners[1..].iter().chain(&corners[..1]);
    let right = corners.iter().zip(next).enumerate().all(|(i, (from, to))| {
        let along = usize::from(i.is_multiple_of(2) == horizontal_first);
        from[along] == to[along]
    });
    right.then_some(u8::from(!horizontal_first))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(bytes: &[u8], owner: Owner) -> (Vec<[i64; 2]>, bool) {
        let mut corners = Vec::new();
        let mut cursor = Cursor::of_file(bytes);
        let even = read(&mut cursor, owner, &mut corners).unwrap();
        assert_eq!(cursor.left(), 0);
        (corners, even)
    }

    /// By hand, from the rules of section 7.7 of SEMI P39.
    #[test]
    fn every_type_has_the_corners_of_the_standard() {
        let polygon = |bytes: &[u8]| list(bytes, Owner::Polygon);
        assert_eq!(polygon(&[0, 2, 12, 8]), (vec![[0, 0], [6, 0], [6, 4], [0, 4]], true));
        assert_eq!(polygon(&[1, 2, 8, 12]), (vec![[0, 0], [0, 4], [6, 4], [6, 0]], true));
        assert_eq!(list(&[0, 2, 12, 8], Owner::Path).0, [[0, 0], [6, 0], [6, 4]]);
        // 2-deltas: 6 to the east, 4 to the north.
        assert_eq!(polygon(&[2, 2, 0x18, 0x11]).0, [[0, 0], [6, 0], [6, 4]]);
        // 3-deltas: 5 to the north-east, 5 to the west.
        assert_eq!(polygon(&[3, 2, 0x2c, 0x2a]).0, [[0, 0], [5, 5], [0, 5]]);
        assert_eq!(polygon(&[4, 2, 0xe9, 3, 0x6c, 0x5a]).0, [[0, 0], [122, 54], [117, 59]]);
        // Double deltas: (5, 0), and then (5, 0) + (-5, 5).
        assert_eq!(polygon(&[5, 2, 0x50, 0x5a]).0, [[0, 0], [5, 0], [5, 5]]);
    }

    #[test]
    fn a_polygon_of_an_odd_number_of_deltas_closes_and_is_reported() {
        let (corners, even) = list(&[0, 3, 12, 8, 3], Owner::Polygon);
        assert_eq!(corners, [[0, 0], [6, 0], [6, 4], [5, 4], [5, 0]]);
        assert!(!even);
        assert!(list(&[0, 3, 12, 8, 3], Owner::Path).1);
    }

    #[test]
    fn lists_that_are_empty_too_long_or_too_far_are_faults() {
        let mut far = vec![0, 6];
        (0..6).for_each(|_| encode::signed((1 << 62) - 1, &mut far));
        for bytes in [&[4, 0][..], &[6, 1, 0x50], &[4, 100, 0x50], &far] {
            let fault = read(&mut Cursor::of_file(bytes), Owner::Polygon, &mut Vec::new());
            assert!(fault.is_err(), "{bytes:02x?}");
        }
    }

    #[test]
    fn polygons_are_written_in_the_shortest_type_and_read_back() {
        let cases: [(u8, &[[i64; 2]]); 6] = [
            (0, &[[0, 0], [6, 0], [6, 4], [3, 4], [3, 2], [0, 2]]),
            (1, &[[0, 0], [0, 4], [6, 4], [6, 0]]),
            (2, &[[0, 0], [6, 0], [9, 0], [9, 4], [0, 4]]),
            (3, &[[0, 0], [6, 0], [9, 3], [0, 3]]),
            (4, &[[0, 0], [6, 1], [9, 3], [0, 3]]),
            (4, &[[0, 0], [1 << 31, 1], [-(1 << 31), 3]]),
        ];
        for (kind, corners) in cases {
            let mut bytes = Vec::new();
            write_polygon(corners, &mut bytes);
            assert_eq!(bytes[0], kind);
            assert_eq!(list(&bytes, Owner::Polygon), (corners.to_vec(), true));
        }
    }
}
