//! Polygons on the way into a file: rounded, cleaned, cut.
//!
//! Rounding can put neighboring corners onto one grid point and edges back onto each other. Readers and mask shops warn
//! of such corners, and they cover nothing, so they are taken out and counted. Corners in the middle of a straight edge
//! stay: they may be there to meet the corner of a neighbor.

use phidl_core::geom::Point;
use phidl_core::num::grid::{Grid, GridError};

use super::convert::corner;
use crate::model::Corner;

/// What became of an outline on the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cleaning {
    /// Every corner has an effect.
    Unchanged,
    /// Some corners were taken out.
    Cleaned,
    /// Nothing is left.
    Collapsed,
}

/// Rounds points to the grid, into a buffer.
pub(super) fn round(points: &[Point], grid: &Grid, corners: &mut Vec<Corner>) -> Result<(), GridError> {
    corners.clear();
    corners.reserve(points.len());
    for point in points {
        corners.push(corner(grid, *point)?);
    }
    Ok(())
}

/// Takes out repeated corners and edges that go there and back.
pub(super) fn clean(corners: &mut Vec<Corner>) -> Cleaning {
    if !has_idle_corner(corners) {
        return if corners.len() < 3 { Cleaning::Collapsed } else { Cleaning::Unchanged };
    }
    let mut kept: Vec<Corner> = Vec::with_capacity(corners.len());
    for corner in corners.iter() {
        push(&mut kept, *corner);
    }
    trim_ends(&mut kept);
    *corners = kept;
    if corners.len() < 3 { Cleaning::Collapsed } else { Cleaning::Cleaned }
}

/// Whether some corner repeats its neighbor or is the tip of an edge there and back.
fn has_idle_corner(corners: &[Corner]) -> bool {
    let count = corners.len();
    let Some(last) = corners.last() else { return false };
    let mut before = *last;
    (0..count).any(|index| {
        let here = corners[index];
        let idle = is_idle(before, here, corners[(index + 1) % count]);
        before = here;
        idle
    })
}

/// Appends a corner, and takes out those that lose their effect by it.
fn push(kept: &mut Vec<Corner>, corner: Corner) {
    loop {
        match kept[..] {
            [.., last] if last == corner => return,
            [.., before, last] if is_idle(before, last, corner) => {
                kept.pop();
            }
            _ => break,
        }
    }
    kept.push(corner);
}

/// Takes out idle corners where the end of the list meets its beginning.
fn trim_ends(kept: &mut Vec<Corner>) {
    let mut start = 0;
    while let [first, second, .., before, last] = kept[start..] {
        if last == first || is_idle(before, last, first) {
            kept.pop();
        } else if is_idle(last, first, second) {
            start += 1;
        } else {
            break;
        }
    }
    kept.drain(..start);
    if let [a, b, c] = kept[..]
        && (is_idle(a, b, c) || is_idle(b, c, a) || is_idle(c, a, b))
    {
        kept.clear();
    }
}

/// Whether `here` has no effect: it repeats a neighbor, or the outline turns back at it.
#[inline]
fn is_idle(before: Corner, here: Corner, after: Corner) -> bool {
    if here == before || here == after {
        return true;
    }
    let difference = |a: Corner, b: Corner| [0, 1].map(|axis| i128::from(b[axis]) - i128::from(a[axis]));
    let (a, b) = (difference(before, here), difference(here, after));
    a[0] * b[1] == a[1] * b[0] && a[0] * b[0] + a[1] * b[1] < 0
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::{prop_assert, prop_assert_eq, proptest};

    use super::*;

    fn cleaned(outline: &[Corner]) -> (Vec<Corner>, Cleaning) {
        let mut corners = outline.to_vec();
        let cleaning = clean(&mut corners);
        (corners, cleaning)
    }

    #[test]
    fn corners_with_an_effect_stay() {
        let square = [[0, 0], [5, 0], [10, 0], [10, 10], [0, 10]];
        assert_eq!(cleaned(&square), (square.to_vec(), Cleaning::Unchanged));
    }

    #[test]
    fn repeated_corners_and_spikes_are_taken_out_anywhere() {
        let square = vec![[0, 0], [10, 0], [10, 10], [0, 10]];
        let odd: [&[Corner]; 6] = [
            &[[0, 0], [10, 0], [10, 0], [10, 10], [0, 10], [0, 0]],
            &[[0, 0], [10, 0], [20, 0], [10, 0], [10, 10], [0, 10]],
            &[[0, 0], [10, 0], [20, 0], [30, 0], [10, 0], [10, 10], [0, 10]],
            &[[0, 0], [10, 0], [10, 10], [0, 10], [0, 20], [0, 10]],
            &[[0, 0], [-5, 0], [0, 0], [10, 0], [10, 10], [0, 10]],
            &[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0], [-3, -3]],
        ];
        for outline in odd {
            let (mut corners, cleaning) = cleaned(outline);
            let start = corners.iter().position(|corner| *corner == [0, 0]).unwrap();
            corners.rotate_left(start);
            assert_eq!((corners, cleaning), (square.clone(), Cleaning::Cleaned), "{outline:?}");
        }
    }

    #[test]
    fn lines_and_points_collapse() {
        let nothing: [&[Corner]; 5] = [
            &[],
            &[[1, 1], [1, 1], [1, 1]],
            &[[0, 0], [10, 0], [5, 0]],
            &[[0, 0], [10, 0], [0, 0], [10, 0]],
            &[[0, 0], [5, 5], [10, 10], [20, 0], [10, 10]],
        ];
        for outline in nothing {
            assert_eq!(cleaned(outline).1, Cleaning::Collapsed, "{outline:?}");
        }
    }

    proptest! {
        #[test]
        fn cleaning_keeps_the_area_and_leaves_no_idle_corner(outline in vec((0..4_i32, 0..4_i32), 0..14)) {
            let area2 = |c: &[Corner]| -> i64 {
                let edges = c.iter().zip(c.iter().cycle().skip(1));
                edges.map(|(a, b)| i64::from(a[0]) * i64::from(b[1]) - i64::from(a[1]) * i64::from(b[0])).sum()
            };
            let outline: Vec<Corner> = outline.into_iter().map(|(x, y)| [x, y]).collect();
            let (corners, cleaning) = cleaned(&outline);
            if cleaning == Cleaning::Collapsed {
                prop_assert_eq!(area2(&outline), 0);
            } else {
                prop_assert_eq!(area2(&outline), area2(&corners));
                prop_assert!(!has_idle_corner(&corners));
            }
        }
    }
}
