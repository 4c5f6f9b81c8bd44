//! Edges bent by what the strips found along them, as straight pieces.
//!
//! Pieces are made where they are needed: a strip makes those that stay in it when it is swept. Only pieces that reach
//! over a seam take what several strips know.

use std::cmp::Ordering;

use super::{
    edge::{Edge, Scene},
    plan::StripPlan,
    snap::Snapped,
};
use crate::point::GridPoint;

/// All edges with their bends.
pub(super) struct Bent<'a> {
    pub(super) scene: &'a Scene,
    pub(super) plan: &'a StripPlan,
    strips: Vec<Snapped>,
    /// Drawn contours that touch themselves, ascending: they are filled apart.
    apart: Vec<u32>,
}

impl<'a> Bent<'a> {
    pub(super) fn new(scene: &'a Scene, plan: &'a StripPlan, snapped: Vec<Snapped>) -> Self {
        let mut apart: Vec<u32> = snapped.iter().flat_map(|strip| &strip.touching).copied().collect();
        apart.sort_unstable();
        apart.dedup();
        Self { scene, plan, strips: snapped, apart }
    }

    /// True if a contour is to be filled apart.
    pub(super) fn is_apart(&self, contour: u32) -> bool {
        self.apart.binary_search(&contour).is_ok()
    }

    /// True if some contour is to be filled apart.
    pub(super) fn has_apart(&self) -> bool {
        !self.apart.is_empty()
    }

    /// The pieces of the edges of some contours that stay in a strip.
    pub(super) fn within(&self, strip: usize, wanted: impl Fn(u32) -> bool, mut take: impl FnMut(u32, Edge)) {
        let (first, last) = self.plan.columns(strip);
        let mut reader = self.scene.reader();
        for (place, &number) in self.plan.seen(strip).iter().enumerate() {
            let e = reader.edge(number);
            if !wanted(reader.contour()) {
                continue;
            }
            let mut from = if e.l.x >= first { Some(e.l) } else { None };
            let end = if e.r.x <= last { Some(e.r) } else { None };
            for to in self.strips[strip].bends.of(place).iter().copied().chain(end) {
                if let Some(piece) = from.replace(to).and_then(|from| piece(from, to, e.delta)) {
                    take(reader.contour(), piece);
                }
            }
        }
    }

    /// The pieces of the edges of some contours that begin in a strip and end in a later one.
    pub(super) fn leaving(&self, strip: usize, wanted: impl Fn(u32) -> bool, mut take: impl FnMut(u32, Edge)) {
        let (first, _) = self.plan.columns(strip);
        let mut reader = self.scene.reader();
        let seen = self.plan.seen(strip);
        for (place, number) in self.strips[strip].leaving.iter().map(|&place| (place as usize, seen[place as usize])) {
            let e = reader.edge(number);
            if !wanted(reader.contour()) {
                continue;
            }
            let begin = if e.l.x >= first { Some(e.l) } else { None };
            if let Some(l) = self.strips[strip].bends.of(place).last().copied().or(begin) {
                let r = self.next_point(number, &e, strip + 1);
                take(reader.contour(), Edge { l, r, delta: e.delta });
            }
        }
    }

    /// The first point of an edge from a strip on.
    fn next_point(&self, number: u32, e: &Edge, strip: usize) -> GridPoint {
        let bend = (strip..self.plan.strip_of(e.r.x) + 1).find_map(|strip| {
            let place = self.plan.seen(strip).partition_point(|&seen| seen < number);
            self.strips[strip].bends.of(place).first().copied()
        });
        bend.unwrap_or(e.r)
    }
}

/// The piece of an edge from one point that it passes to a later one.
fn piece(from: GridPoint, to: GridPoint, delta: [i32; 2]) -> Option<Edge> {
    match from.cmp(&to) {
        Ordering::Less => Some(Edge { l: from, r: to, delta }),
        // A falling edge that is bent within one grid column has a vertical piece, and those run upward.
        Ordering::Greater => Some(Edge { l: to, r: from, delta: delta.map(|d| -d) }),
        Ordering::Equal => None,
    }
}
