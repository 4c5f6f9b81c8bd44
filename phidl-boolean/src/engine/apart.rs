//! Drawn contours that touch or cross themselves, filled one by one.
//!
//! A drawn figure-eight winds +1 around one lobe and −1 around the other, and the −1 would cancel the +1 of another
//! shape on top of it. On its own, each contour is filled by the non-zero rule, and from then on all winding is
//! positive. This happens after the edges are bent, so that bending once is enough.

use rayon::prelude::*;

use super::{
    Rule,
    edge::{Edge, Scene},
    sweep,
};
use crate::op::{Fill, Operation};

/// The boundary pieces of each contour, wound once around what the contour covers.
pub(super) fn fill_apart(mut pieces: Vec<(u32, Edge)>, scene: &Scene) -> Vec<Edge> {
    pieces.sort_by_key(|&(contour, _)| contour);
    let contours: Vec<&[(u32, Edge)]> = pieces.chunk_by(|a, b| a.0 == b.0).collect();
    let rule = Rule { operation: Operation::Or, fill: Fill::NonZero };
    let filled: Vec<Vec<Edge>> = contours
        .into_par_iter()
        .map(|own| {
            let operand = scene.operand_of(own[0].0);
            let pieces: Vec<Edge> = own.iter().map(|&(_, piece)| piece).collect();
            sweep::boundary(&pieces, operand, rule)
        })
        .collect();
    filled.concat()
}
