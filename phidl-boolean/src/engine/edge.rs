//! Edges: what all contours of both operands look like to the engine.

use std::ops::Range;

use rayon::prelude::*;

use super::{Operand, free::Free, order::by_x};
use crate::{
    error::BooleanError,
    point::{GridPoint, cross, signed_area2},
};

/// Edge numbers are `u32`, and the top bit marks edges that reach over a seam.
pub(super) const MAX_EDGES: usize = 1 << 31;

/// Contours handled by one parallel job while their directions are found.
const CONTOURS_PER_JOB: usize = 512;

/// An edge from its smaller end `l` to its larger end `r`, in the order of grid points (x, then y).
///
/// Read with the plane tilted by less than any slope, so that a vertical edge runs to the right like every other:
/// "above" is to the left of the direction from `l` to `r`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Edge {
    pub(super) l: GridPoint,
    pub(super) r: GridPoint,
    /// How much the winding number of each operand grows on the way from below to above.
    pub(super) delta: [i32; 2],
}

impl Edge {
    /// Positive if `p` is above this edge.
    #[inline]
    pub(super) fn cross(&self, p: GridPoint) -> i128 {
        cross(self.l, self.r, p)
    }

    /// True if the edge has equal ends to `other` and only the winding differs.
    pub(super) fn coincides(&self, other: &Self) -> bool {
        self.l == other.l && self.r == other.r
    }

    /// True for what lies between a point and its repetition; no strip sees it.
    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.l == self.r
    }
}

/// The edges of all contours of both operands that are not free, numbered along the contours.
///
/// Points are copied with the contours from left to right, so that what a strip sees lies together in memory. Edges are
/// made of the points when they are asked for: a list of them would be much longer.
pub(super) struct Scene {
    /// Where each edge ends, as its contour runs.
    points: Vec<GridPoint>,
    /// Contour of each edge.
    contour_of: Vec<u32>,
    contours: Vec<Contour>,
    drawn: [bool; 2],
}

/// The edges of a contour.
#[derive(Clone, Copy)]
struct Contour {
    /// Number of its first edge.
    first: u32,
    /// Number of its edges.
    len: u32,
    operand: u8,
    /// Factor for the winding: −1 for drawn ones that run clockwise, which cover what they enclose.
    sign: i8,
}

impl Scene {
    /// The edges of all contours that are not free.
    pub(super) fn new(operands: &[Operand; 2], free: &Free) -> Result<Self, BooleanError> {
        let points: usize = operands.iter().map(|operand| operand.contours().point_count()).sum();
        if points >= MAX_EDGES {
            return Err(BooleanError::TooLarge { edges: points, limit: MAX_EDGES });
        }
        let of_operand = |operand| std::iter::repeat(operand).zip(operands[usize::from(operand)].contours().iter());
        let all = [0, 1].into_iter().flat_map(of_operand).enumerate();
        let contours: Vec<(u8, &[GridPoint])> = all
            .filter(|&(number, (_, points))| !points.is_empty() && !free.contains(number))
            .map(|(_, contour)| contour)
            .collect();
        let edges = contours.iter().map(|(_, points)| points.len()).sum();
        let mut scene = Self {
            points: Vec::with_capacity(edges),
            contour_of: Vec::with_capacity(edges),
            contours: Vec::with_capacity(contours.len()),
            drawn: operands.map(|operand| matches!(operand, Operand::Drawn(_))),
        };
        let begins = (0u32..).zip(contours.iter().map(|(_, points)| points[0].x));
        for number in by_x(begins, |a, b| a.cmp(&b)) {
            let (operand, points) = contours[number as usize];
            scene.add(operand, points);
        }
        scene.turn_drawn();
        Ok(scene)
    }

    #[expect(clippy::cast_possible_truncation, reason = "edges are fewer than MAX_EDGES, contours too")]
    fn add(&mut self, operand: u8, points: &[GridPoint]) {
        let (number, first) = (self.contours.len() as u32, self.points.len() as u32);
        self.contours.push(Contour { first, len: points.len() as u32, operand, sign: 1 });
        self.contour_of.extend(std::iter::repeat_n(number, points.len()));
        self.points.extend_from_slice(points);
    }

    /// Finds the drawn contours that run clockwise.
    fn turn_drawn(&mut self) {
        let (points, drawn) = (&self.points, self.drawn);
        self.contours.par_iter_mut().with_min_len(CONTOURS_PER_JOB).for_each(|contour| {
            if drawn[usize::from(contour.operand)] && signed_area2(contour.of(points)) < 0 {
                contour.sign = -1;
            }
        });
    }

    /// Number of edges.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// An edge by its number.
    pub(super) fn edge(&self, number: u32) -> Edge {
        self.reader().edge(number)
    }

    /// Reads edges that are mostly of the contour of the one before.
    pub(super) fn reader(&self) -> Reader<'_> {
        Reader { scene: self, contour: 0, points: &[], first: 0, delta: [0; 2] }
    }

    /// The contour of an edge.
    #[inline]
    pub(super) fn contour_of(&self, edge: u32) -> u32 {
        self.contour_of[edge as usize]
    }

    /// True if the contours of an operand are shapes as drawn, so that touching itself matters.
    pub(super) fn is_drawn(&self, contour: u32) -> bool {
        self.drawn[self.operand_of(contour)]
    }

    /// The operand that a contour belongs to.
    pub(super) fn operand_of(&self, contour: u32) -> usize {
        usize::from(self.contours[contour as usize].operand)
    }

    /// Whether one of two edges of a contour (the first has the lower number) begins where the other ends.
    pub(super) fn are_neighbors(&self, low: u32, high: u32) -> bool {
        let Contour { first, len, .. } = self.contours[self.contour_of(low) as usize];
        let empty = |mut edges: Range<u32>| edges.all(|edge| self.edge(edge).is_empty());
        empty(low + 1..high) || (empty(first..low) && empty(high + 1..first + len))
    }
}

impl Contour {
    fn of(self, points: &[GridPoint]) -> &[GridPoint] {
        &points[self.first as usize..][..self.len as usize]
    }
}

/// Makes edges, and remembers the contour that the last one was of.
pub(super) struct Reader<'a> {
    scene: &'a Scene,
    contour: u32,
    points: &'a [GridPoint],
    /// Number of the first edge of the contour.
    first: u32,
    /// Of an edge that runs from left to right.
    delta: [i32; 2],
}

impl Reader<'_> {
    /// An edge by its number.
    #[inline]
    pub(super) fn edge(&mut self, number: u32) -> Edge {
        let (from, to) = self.ends(number);
        // Which end is smaller cannot be guessed, so nothing here branches on it.
        let forward = (from.x < to.x) | ((from.x == to.x) & (from.y < to.y));
        let sign = if forward { 1 } else { -1 };
        let (l, r) = if forward { (from, to) } else { (to, from) };
        Edge { l, r, delta: self.delta.map(|d| sign * d) }
    }

    /// The contour that the last edge was of.
    #[inline]
    pub(super) fn contour(&self) -> u32 {
        self.contour
    }

    /// First and last grid column of an edge; `None` if it is empty.
    #[inline]
    pub(super) fn columns(&mut self, number: u32) -> Option<(i64, i64)> {
        let (from, to) = self.ends(number);
        if from == to { None } else { Some((from.x.min(to.x), from.x.max(to.x))) }
    }

    #[inline]
    fn ends(&mut self, number: u32) -> (GridPoint, GridPoint) {
        let mut end = number.wrapping_sub(self.first) as usize;
        if end >= self.points.len() {
            self.turn_to(self.scene.contour_of(number));
            end = (number - self.first) as usize;
        }
        let start = if end == 0 { self.points.len() } else { end };
        (self.points[start - 1], self.points[end])
    }

    fn turn_to(&mut self, number: u32) {
        let contour = self.scene.contours[number as usize];
        (self.contour, self.points, self.first) = (number, contour.of(&self.scene.points), contour.first);
        self.delta = [0; 2];
        self.delta[usize::from(contour.operand)] = i32::from(contour.sign);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contours::Contours;

    fn contours(outlines: &[&[(i64, i64)]]) -> Contours {
        outlines.iter().map(|outline| outline.iter().copied().map(GridPoint::from)).collect()
    }

    #[test]
    fn drawn_contours_wind_once_however_they_run_and_others_as_they_run() {
        let clockwise = contours(&[&[(0, 0), (0, 4), (4, 0)]]);
        let operands = [Operand::Drawn(&clockwise), Operand::Wound(&clockwise)];
        let scene = Scene::new(&operands, &Free::none(&operands)).unwrap();
        let left = (GridPoint::new(0, 0), GridPoint::new(0, 4));
        let found: Vec<Edge> = (0..6).map(|number| scene.edge(number)).filter(|e| (e.l, e.r) == left).collect();
        // To the right of the left edge (read upward) is the inside; "above" it is the outside.
        assert_eq!(found.iter().map(|e| e.delta).collect::<Vec<_>>(), [[-1, 0], [0, 1]]);
        assert_eq!((scene.operand_of(0), scene.operand_of(1)), (0, 1));
    }

    #[test]
    fn neighbors_are_found_over_repeated_points() {
        let repeated = contours(&[&[], &[(0, 0), (0, 0), (5, 0), (5, 0), (5, 0), (5, 5), (0, 0)]]);
        let operands = [Operand::Drawn(&repeated), Operand::Wound(&repeated)];
        let scene = Scene::new(&operands, &Free::none(&operands)).unwrap();
        let edges: Vec<u32> = (0..7).filter(|&edge| !scene.edge(edge).is_empty()).collect();
        assert_eq!(edges, [2, 5, 6]);
        assert!(scene.are_neighbors(2, 5) && scene.are_neighbors(5, 6) && scene.are_neighbors(2, 6));
        let square = contours(&[&[(0, 0), (5, 0), (5, 5), (0, 5)]]);
        let operands = [Operand::Drawn(&square), Operand::Wound(&square)];
        let scene = Scene::new(&operands, &Free::none(&operands)).unwrap();
        assert!(scene.are_neighbors(0, 3) && !scene.are_neighbors(0, 2) && !scene.are_neighbors(5, 7));
    }
}
