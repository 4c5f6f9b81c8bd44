//! Pieces that reach over a seam.

use rayon::prelude::*;

use super::{apart::Apart, bent::Bent, edge::Edge};
use crate::jobs::per_job;

/// The straight pieces that reach from one strip into another, numbered from left to right.
///
/// A piece belongs to the strip of its left end and enters every strip after that, up to the one of its right end.
#[derive(Default)]
pub(super) struct Spans {
    pieces: Vec<Edge>,
    /// Strip `s` has `pieces[owned[s]..owned[s + 1]]`.
    owned: Vec<usize>,
    entering: Vec<Vec<u32>>,
}

impl Spans {
    /// Joins what the strips know of each edge, and takes the pieces of contours that were filled apart.
    pub(super) fn join(bent: &Bent, apart: &Apart) -> Self {
        let strips = bent.plan.len();
        let leaving: Vec<Leaving> = (0..strips)
            .into_par_iter()
            .with_min_len(per_job(strips, bent.scene.len()))
            .map(|strip| Leaving::new(bent, apart, strip))
            .collect();
        let mut spans = Self {
            pieces: Vec::with_capacity(leaving.iter().map(|own| own.pieces.len()).sum()),
            owned: Vec::with_capacity(strips + 1),
            entering: vec![Vec::new(); strips],
        };
        for (strip, own) in leaving.iter().enumerate() {
            spans.add(strip, own);
        }
        spans.owned.push(spans.pieces.len());
        spans
    }

    #[expect(clippy::cast_possible_truncation, reason = "edge numbers fit a u32, and pieces are not more")]
    fn add(&mut self, strip: usize, own: &Leaving) {
        let first = self.pieces.len();
        self.owned.push(first);
        self.pieces.extend(&own.pieces);
        for (number, &end) in (first as u32..).zip(&own.ends) {
            self.entering[strip + 1..=end].iter_mut().for_each(|entering| entering.push(number));
        }
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

    /// The number of a piece whose left end is in a strip.
    #[expect(clippy::cast_possible_truncation, reason = "edge numbers fit a u32, and pieces are not more")]
    pub(super) fn number_of(&self, strip: usize, piece: &Edge) -> u32 {
        let before = self.owned(strip).partition_point(|other| (other.l, other.r) < (piece.l, piece.r));
        (self.owned[strip] + before) as u32
    }

    /// Numbers of the pieces that enter a strip over its left seam.
    pub(super) fn entering(&self, strip: usize) -> &[u32] {
        &self.entering[strip]
    }
}

/// The pieces of one strip that leave it.
struct Leaving {
    /// By left end, then by right end; coinciding ones are made one.
    pieces: Vec<Edge>,
    /// The strip of each right end.
    ends: Vec<usize>,
}

impl Leaving {
    fn new(bent: &Bent, apart: &Apart, strip: usize) -> Self {
        let mut all = apart.leaving(strip).to_vec();
        bent.leaving(strip, |contour| !bent.is_apart(contour), |_, piece| all.push(piece));
        all.sort_unstable_by_key(|piece| (piece.l, piece.r));
        let mut pieces = Vec::with_capacity(all.len());
        all.into_iter().for_each(|piece| push_merged(&mut pieces, piece));
        drop_last_cancelled(&mut pieces);
        let ends = pieces.iter().map(|piece| bent.plan.strip_of(piece.r.x)).collect();
        Self { pieces, ends }
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
