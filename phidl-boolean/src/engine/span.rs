//! Edges that reach over a seam, bent by what all strips found along them.

use super::{
    apart::fill_apart,
    edge::{Edge, Scene},
    plan::StripPlan,
    snap::{Bend, Snapped, pieces},
};

/// The straight pieces that reach from one strip into another, numbered from left to right.
///
/// A piece belongs to the strip of its left end and enters every strip after that, up to the one of its right end.
#[derive(Default)]
pub(super) struct Spans {
    pieces: Vec<Edge>,
    owned: Vec<usize>,
    entering: Vec<Vec<u32>>,
}

impl Spans {
    /// Joins the bends of all strips. Pieces that stay in one strip are added to that strip, after the contours `apart`
    /// (ascending) have been filled.
    pub(super) fn join(scene: &Scene, plan: &StripPlan, strips: &mut [Snapped], apart: &[u32]) -> Self {
        let mut bends: Vec<Bend> = Vec::with_capacity(strips.iter().map(|strip| strip.bends.len()).sum());
        strips.iter_mut().for_each(|strip| bends.append(&mut strip.bends));
        bends.sort_by_key(|bend| bend.edge); // stable: strips are in order along each edge

        let mut spans = Vec::new();
        let mut route = |piece: Edge, strips: &mut [Snapped]| {
            let strip = plan.strip_of(piece.l.x);
            if strip == plan.strip_of(piece.r.x) { strips[strip].pieces.push(piece) } else { spans.push(piece) }
        };
        let mut kept_apart: Vec<(u32, Edge)> =
            strips.iter_mut().flat_map(|strip| std::mem::take(&mut strip.apart)).collect();
        let mut rest = &bends[..];
        for &number in plan.long_edges() {
            let (own, others) = rest.split_at(rest.partition_point(|bend| bend.edge == number));
            rest = others;
            let contour = scene.contour_of[number as usize];
            let pieces = pieces(&scene.edges[number as usize], own);
            if apart.binary_search(&contour).is_ok() {
                kept_apart.extend(pieces.map(|piece| (contour, piece)));
            } else {
                pieces.for_each(|piece| route(piece, strips));
            }
        }
        fill_apart(kept_apart, scene).into_iter().for_each(|piece| route(piece, strips));
        spans.sort_unstable_by_key(|span: &Edge| (span.l, span.r));
        let mut merged = Vec::with_capacity(spans.len());
        spans.into_iter().for_each(|span| push_merged(&mut merged, span));
        drop_last_cancelled(&mut merged);
        Self::with_pieces(merged, plan)
    }

    pub(super) fn len(&self) -> usize {
        self.pieces.len()
    }

    /// A piece by its number.
    pub(super) fn piece(&self, number: u32) -> Edge {
        self.pieces[number as usize]
    }

    /// The pieces whose left end is in a strip.
    pub(super) fn owned(&self, strip: usize) -> &[Edge] {
        &self.pieces[self.owned[strip]..self.owned[strip + 1]]
    }

    /// The number of a piece.
    #[expect(clippy::cast_possible_truncation, reason = "edge numbers fit a u32, and pieces are not more")]
    pub(super) fn number_of(&self, piece: &Edge) -> u32 {
        self.pieces.partition_point(|other| (other.l, other.r) < (piece.l, piece.r)) as u32
    }

    /// Numbers of the pieces that enter a strip over its left seam.
    pub(super) fn entering(&self, strip: usize) -> &[u32] {
        &self.entering[strip]
    }

    fn with_pieces(pieces: Vec<Edge>, plan: &StripPlan) -> Self {
        let mut owned = vec![0; plan.len() + 1];
        let mut entering = vec![Vec::new(); plan.len()];
        for (number, piece) in (0u32..).zip(&pieces) {
            let strip = plan.strip_of(piece.l.x);
            owned[strip + 1] += 1;
            for other in &mut entering[strip + 1..=plan.strip_of(piece.r.x)] {
                other.push(number);
            }
        }
        for strip in 1..owned.len() {
            owned[strip] += owned[strip - 1];
        }
        Self { pieces, owned, entering }
    }
}

/// Adds an edge to a sorted list, or its winding to the last one if the two coincide; nothing stays where windings cancel.
pub(super) fn push_merged(edges: &mut Vec<Edge>, edge: Edge) {
    match edges.last_mut() {
        Some(last) if last.coincides(&edge) => {
            last.delta[0] += edge.delta[0];
            last.delta[1] += edge.delta[1];
        }
        _ => {
            drop_last_cancelled(edges);
            edges.push(edge);
        }
    }
}

/// Drops the last edge of a list if its windings have cancelled.
pub(super) fn drop_last_cancelled(edges: &mut Vec<Edge>) {
    if edges.last().is_some_and(|last| last.delta == [0, 0]) {
        edges.pop();
    }
}
