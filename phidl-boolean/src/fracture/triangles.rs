//! Triangles of a polygon that chords have cut into mountains.

use std::cmp::Ordering;

use super::chords::Chord;
use crate::point::{GridPoint, cross, side};

/// Corners counter-clockwise; edge `i` runs from corner `i` to the next.
pub(super) type Triangle = [GridPoint; 3];

/// An edge of a face, with the face on its left.
#[derive(Debug, Clone, Copy)]
struct Half {
    from: GridPoint,
    to: GridPoint,
}

/// Cuts a polygon into triangles that have all chords among their edges.
pub(super) fn triangles(outlines: &[&[GridPoint]], chords: &[Chord]) -> Vec<Triangle> {
    let closed = |outline: &&[GridPoint]| {
        let outline = outline.to_vec();
        (0..outline.len()).map(move |i| Half { from: outline[i], to: outline[(i + 1) % outline.len()] })
    };
    let mut halves: Vec<Half> = outlines.iter().flat_map(closed).collect();
    for &Chord { from, to, .. } in chords {
        halves.extend([Half { from, to }, Half { from: to, to: from }]);
    }
    halves.sort_unstable_by(|a, b| a.from.cmp(&b.from).then_with(|| counter_clockwise(a, b)));

    let mut triangles = Vec::with_capacity(halves.len());
    let mut is_done = vec![false; halves.len()];
    let mut face = Vec::new();
    for first in 0..halves.len() {
        face.clear();
        let mut half = first;
        while !is_done[half] {
            is_done[half] = true;
            face.push(halves[half].from);
            half = following(&halves, halves[half]);
        }
        cut_mountain(&face, &mut triangles);
    }
    triangles
}

/// Order of directions around a common start, counter-clockwise from straight down (excluded).
fn counter_clockwise(a: &Half, b: &Half) -> Ordering {
    let leads_left = |half: &Half| half.to < half.from;
    leads_left(a).cmp(&leads_left(b)).then_with(|| side(a.from, b.to, a.to))
}

/// The edge that leads on around the same face: the next one clockwise from the way back.
fn following(halves: &[Half], half: Half) -> usize {
    let back = Half { from: half.to, to: half.from };
    let start = halves.partition_point(|other| other.from < back.from);
    let around = halves[start..].partition_point(|other| other.from == back.from);
    let before = halves[start..start + around].partition_point(|other| counter_clockwise(other, &back).is_lt());
    start + before.checked_sub(1).unwrap_or(around - 1)
}

/// A mountain has one edge from its leftmost to its rightmost corner, so each convex corner of the chain is an ear.
fn cut_mountain(face: &[GridPoint], triangles: &mut Vec<Triangle>) {
    let Some(chain_start) = base_end(face) else { return };
    let mut chain: Vec<GridPoint> = Vec::with_capacity(face.len());
    for step in 0..face.len() {
        let point = face[(chain_start + step) % face.len()];
        while let [.., a, b] = chain[..] {
            if cross(a, b, point) <= 0 {
                break;
            }
            triangles.push([a, b, point]);
            chain.pop();
        }
        chain.push(point);
    }
    debug_assert_eq!(chain.len(), 2, "a face is no mountain: {face:?}");
}

/// Index of the corner at which the base edge ends and the chain begins.
fn base_end(face: &[GridPoint]) -> Option<usize> {
    let (low, high) = (*face.iter().min()?, *face.iter().max()?);
    (0..face.len()).find(|&end| {
        let (a, b) = (face[(end + face.len() - 1) % face.len()], face[end]);
        (a == low && b == high) || (a == high && b == low)
    })
}
