//! Moves all edges of rings sideways and joins them at the corners, in parallel chunks.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    Join,
    corner::{Corner, edge_between},
};
use crate::{contours::Contours, jobs::per_job, point::GridPoint};

/// Corners that are moved by one parallel job.
const CHUNK: usize = 2048;

/// The rings with each edge moved by `distance` to its outside, and joined at the corners.
pub(super) fn moved_rings(rings: &Contours, distance: f64, join: Join) -> Contours {
    // A merged layer may be one ring of a million corners, so the parallel jobs are chunks, not rings.
    let chunks: Vec<Chunk> = rings.iter().flat_map(chunks).collect();
    let parts: Vec<(Vec<GridPoint>, Vec<usize>)> = chunks
        .par_chunks(per_job(chunks.len(), rings.point_count()))
        .map(|chunks| moved_part(chunks, distance, join))
        .collect();
    let mut all = Contours::with_capacity(rings.len(), parts.iter().map(|(points, _)| points.len()).sum());
    parts.iter().for_each(|(points, ends)| all.push_part(points, ends));
    all
}

/// Some consecutive corners of a ring.
type Chunk<'a> = (&'a [GridPoint], Range<usize>);

fn chunks(ring: &[GridPoint]) -> impl Iterator<Item = Chunk<'_>> {
    let corners = |first: usize| first..(first + CHUNK).min(ring.len());
    (0..ring.len()).step_by(CHUNK).map(move |first| (ring, corners(first)))
}

/// The moved corners of some chunks, and the ends of rings among them.
fn moved_part(chunks: &[Chunk], distance: f64, join: Join) -> (Vec<GridPoint>, Vec<usize>) {
    let corners: usize = chunks.iter().map(|(_, corners)| corners.len()).sum();
    let (mut points, mut ends) = (Vec::with_capacity(corners + corners / 4), Vec::with_capacity(chunks.len()));
    for (ring, corners) in chunks {
        move_chunk(ring, corners.clone(), distance, join, &mut points);
        if corners.end == ring.len() {
            ends.push(points.len());
        }
    }
    (points, ends)
}

/// Draws the moved form of some corners of a ring.
fn move_chunk(ring: &[GridPoint], corners: Range<usize>, distance: f64, join: Join, moved: &mut Vec<GridPoint>) {
    let n = ring.len();
    let at = |i: usize| ring[i % n];
    let first = corners.start + n;
    let edge = |i: usize| edge_between(at(i), at(i + 1));
    let mut previous = Corner::new(at(first - 1), edge(first - 2), edge(first - 1), distance);
    let mut corner = Corner::new(at(first), previous.after, edge(first), distance);
    for i in corners {
        let next = Corner::new(at(i + 1), corner.after, edge(i + 1), distance);
        let keeps_edges = previous.keeps_edge_to(&corner) && corner.keeps_edge_to(&next);
        corner.draw(keeps_edges, join, moved);
        (previous, corner) = (corner, next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contours(points: &[(i64, i64)]) -> Contours {
        [points.iter().copied().map(GridPoint::from).collect::<Vec<_>>()].into_iter().collect()
    }

    #[test]
    fn long_rings_are_moved_in_chunks_like_in_one() {
        let comb: Vec<GridPoint> =
            (0..3000i64).map(|i| GridPoint::new(10 * i, if i % 4 < 2 { 0 } else { 50 + i % 7 })).collect();
        for distance in [-4.0, 2.5, 40.0] {
            let mut whole = Vec::new();
            move_chunk(&comb, 0..comb.len(), distance, Join::default(), &mut whole);
            let rings: Contours = [comb.clone()].into_iter().collect();
            let moved = moved_rings(&rings, distance, Join::default());
            assert_eq!(moved.iter().collect::<Vec<_>>(), [whole.as_slice()]);
        }
    }

    #[test]
    fn edges_that_keep_a_part_are_cut_where_they_meet() {
        // Each step takes more than half of the short edges, but never all of them.
        let stairs = contours(&[(0, 0), (100, 0), (100, 10), (60, 10), (60, 40), (0, 40)]);
        let moved = moved_rings(&stairs, -4.0, Join::default());
        let cut = contours(&[(4, 4), (96, 4), (96, 6), (56, 6), (56, 36), (4, 36)]);
        assert_eq!(moved, cut);
    }
}
