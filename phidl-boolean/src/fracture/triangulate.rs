//! Triangulation of a polygon that diagonals cut into monotone mountains.

use super::{diagonals::Diagonal, half_edges::for_each_face};
use crate::point::{GridPoint, cross};

/// Corners counter-clockwise; edge `i` runs from corner `i` to the next.
pub(super) type Triangle = [GridPoint; 3];

/// Cuts a polygon into triangles that have all diagonals among their edges.
pub(super) fn triangles(outlines: &[&[GridPoint]], diagonals: &[Diagonal]) -> Vec<Triangle> {
    let mut triangles =
        Vec::with_capacity(outlines.iter().map(|outline| outline.len()).sum::<usize>() + diagonals.len());
    for_each_face(outlines, diagonals.iter(), |face| cut_mountain(face, &mut triangles));
    triangles
}

/// A monotone mountain has one edge from its leftmost to its rightmost corner, so each convex corner of the chain is an
/// ear.
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
