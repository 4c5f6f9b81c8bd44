//! The faces into which diagonals divide a polygon.
//!
//! Each edge of a ring is a half-edge with the polygon on its left, each diagonal is two. Around a face, a half-edge is
//! followed by the next one clockwise from its twin. Half-edges are sorted by their start, and each knows one that starts
//! at its end, so no step needs a search.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::diagonals::Diagonal;
use crate::point::{GridPoint, side};

/// An edge of a face, with the face on its left.
#[derive(Debug, Clone, Copy)]
struct Half {
    from: GridPoint,
    to: GridPoint,
    /// Its number before sorting.
    number: u32,
    /// The number of a half-edge that starts where this one ends.
    next: u32,
}

/// Calls `visit` with the corners of each face, counter-clockwise.
pub(super) fn for_each_face<'a>(
    outlines: &[&[GridPoint]],
    diagonals: impl Iterator<Item = &'a Diagonal>,
    mut visit: impl FnMut(&[GridPoint]),
) {
    let halves = sorted_halves(outlines, diagonals);
    let mut indices = vec![0; halves.len()];
    for (index, half) in halves.iter().enumerate() {
        indices[half.number as usize] = index;
    }
    let mut is_done = vec![false; halves.len()];
    let mut face = Vec::new();
    for first in 0..halves.len() {
        face.clear();
        let mut index = first;
        while !is_done[index] {
            is_done[index] = true;
            face.push(halves[index].from);
            index = following(&halves, halves[index], indices[halves[index].next as usize]);
        }
        if !face.is_empty() {
            visit(&face);
        }
    }
}

/// All half-edges by their start, and around it counter-clockwise.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a region has fewer than 2^31 edges, and less than two diagonals each"
)]
fn sorted_halves<'a>(outlines: &[&[GridPoint]], diagonals: impl Iterator<Item = &'a Diagonal>) -> Vec<Half> {
    let mut halves: Vec<Half> = Vec::new();
    for outline in outlines {
        let first = halves.len() as u32;
        for (number, (&from, &to)) in (first..).zip(outline.iter().zip(outline.iter().cycle().skip(1))) {
            halves.push(Half { from, to, number, next: number + 1 });
        }
        if let Some(last) = halves.last_mut() {
            last.next = first;
        }
    }
    for &Diagonal { from, to, .. } in diagonals {
        let number = halves.len() as u32;
        halves.push(Half { from, to, number, next: number + 1 });
        halves.push(Half { from: to, to: from, number: number + 1, next: number });
    }
    halves.par_sort_unstable_by(|a, b| a.from.cmp(&b.from).then_with(|| counter_clockwise(a, b)));
    halves
}

/// Order of directions around a common start, counter-clockwise from straight down (excluded).
fn counter_clockwise(a: &Half, b: &Half) -> Ordering {
    let leads_left = |half: &Half| half.to < half.from;
    leads_left(a).cmp(&leads_left(b)).then_with(|| side(a.from, b.to, a.to))
}

/// The index of the half-edge that follows around the same face; `near` is the index of one with the same start.
fn following(halves: &[Half], half: Half, near: usize) -> usize {
    let starts_here = |other: &&Half| other.from == half.to;
    let start = near - halves[..near].iter().rev().take_while(starts_here).count();
    let around = &halves[start..];
    let around = &around[..around.iter().take_while(starts_here).count()];
    let back = Half { from: half.to, to: half.from, ..half };
    let before = around.partition_point(|other| counter_clockwise(other, &back).is_lt());
    start + before.checked_sub(1).unwrap_or(around.len() - 1)
}
