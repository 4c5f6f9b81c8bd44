//! The faces into which chords divide a polygon.
//!
//! Each edge of an outline is a half-edge with the polygon on its left, each chord is two. Around a face, a half-edge is
//! followed by the next one clockwise from the way back. Half-edges are sorted by where they start, and each knows one
//! that starts where it ends, so no step has to search.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::chords::Chord;
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
    chords: impl Iterator<Item = &'a Chord>,
    mut visit: impl FnMut(&[GridPoint]),
) {
    let halves = sorted_halves(outlines, chords);
    let mut places = vec![0; halves.len()];
    for (place, half) in halves.iter().enumerate() {
        places[half.number as usize] = place;
    }
    let mut is_done = vec![false; halves.len()];
    let mut face = Vec::new();
    for first in 0..halves.len() {
        face.clear();
        let mut place = first;
        while !is_done[place] {
            is_done[place] = true;
            face.push(halves[place].from);
            place = following(&halves, halves[place], places[halves[place].next as usize]);
        }
        if !face.is_empty() {
            visit(&face);
        }
    }
}

/// All half-edges by their start, and around it counter-clockwise.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a region has fewer than 2^31 edges, and less than two chords each"
)]
fn sorted_halves<'a>(outlines: &[&[GridPoint]], chords: impl Iterator<Item = &'a Chord>) -> Vec<Half> {
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
    for &Chord { from, to, .. } in chords {
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

/// The place of the half-edge that leads on around the same face; `near` is the place of one that starts there.
fn following(halves: &[Half], half: Half, near: usize) -> usize {
    let starts_here = |other: &&Half| other.from == half.to;
    let start = near - halves[..near].iter().rev().take_while(starts_here).count();
    let around = &halves[start..];
    let around = &around[..around.iter().take_while(starts_here).count()];
    let back = Half { from: half.to, to: half.from, ..half };
    let before = around.partition_point(|other| counter_clockwise(other, &back).is_lt());
    start + before.checked_sub(1).unwrap_or(around.len() - 1)
}
