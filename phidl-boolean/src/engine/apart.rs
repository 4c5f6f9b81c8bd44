//! Drawn contours that touch or cross themselves, filled one by one.
//!
//! A drawn figure-eight winds +1 around one lobe and −1 around the other, and the −1 would cancel the +1 of another
//! shape on top of it. On its own, each contour is filled by the non-zero rule, and from then on all winding is
//! positive. This happens after the edges are bent, so that bending once is enough.

use rayon::prelude::*;

use super::{
    Rule,
    bent::Bent,
    edge::{Edge, Scene},
    sweep,
};
use crate::{
    jobs::per_job,
    op::{Fill, Operation},
};

/// The boundary pieces of the contours that were filled apart, by the strip in which they begin.
#[derive(Default)]
pub(super) struct Apart {
    within: Vec<Vec<Edge>>,
    leaving: Vec<Vec<Edge>>,
}

impl Apart {
    /// Fills the contours that touch themselves.
    pub(super) fn fill(bent: &Bent) -> Self {
        if !bent.has_apart() {
            return Self::default();
        }
        let plan = bent.plan;
        let mut apart = Self { within: vec![Vec::new(); plan.len()], leaving: vec![Vec::new(); plan.len()] };
        for piece in filled(gathered(bent), bent.scene) {
            let strip = plan.strip_of(piece.l.x);
            let is_within = strip == plan.strip_of(piece.r.x);
            (if is_within { &mut apart.within } else { &mut apart.leaving })[strip].push(piece);
        }
        apart
    }

    /// The pieces that stay in a strip.
    pub(super) fn within(&self, strip: usize) -> &[Edge] {
        self.within.get(strip).map_or(&[], Vec::as_slice)
    }

    /// The pieces that begin in a strip and end in a later one.
    pub(super) fn leaving(&self, strip: usize) -> &[Edge] {
        self.leaving.get(strip).map_or(&[], Vec::as_slice)
    }
}

/// The pieces of the contours that touch themselves, with the number of the contour.
fn gathered(bent: &Bent) -> Vec<(u32, Edge)> {
    let in_strip = |strip| {
        let mut pieces = Vec::new();
        bent.within(strip, |contour| bent.is_apart(contour), |contour, piece| pieces.push((contour, piece)));
        bent.leaving(strip, |contour| bent.is_apart(contour), |contour, piece| pieces.push((contour, piece)));
        pieces
    };
    (0..bent.plan.len()).into_par_iter().flat_map_iter(in_strip).collect()
}

/// The boundary pieces of each contour, wound once around what the contour covers.
fn filled(mut pieces: Vec<(u32, Edge)>, scene: &Scene) -> Vec<Edge> {
    pieces.sort_by_key(|&(contour, _)| contour);
    let contours: Vec<&[(u32, Edge)]> = pieces.chunk_by(|a, b| a.0 == b.0).collect();
    let rule = Rule { operation: Operation::Or, fill: Fill::NonZero };
    let per_job = per_job(contours.len(), pieces.len());
    let filled: Vec<Vec<Edge>> = contours
        .into_par_iter()
        .with_min_len(per_job)
        .map(|own| {
            let operand = scene.operand_of(own[0].0);
            let pieces: Vec<Edge> = own.iter().map(|&(_, piece)| piece).collect();
            sweep::boundary(&pieces, operand, rule)
        })
        .collect();
    filled.concat()
}
