//! Edges: what all contours of both operands look like to the engine.

use rayon::prelude::*;

use super::{Operand, free::Free};
use crate::{
    error::BooleanError,
    point::{GridPoint, cross, signed_area2},
};

/// Edge numbers are `u32`, and the top bit marks edges that reach over a seam.
pub(super) const MAX_EDGES: usize = 1 << 31;

/// Contours handled by one parallel job while edges are gathered.
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
}

/// The edges of both operands, with the contour that each belongs to.
pub(super) struct Scene {
    pub(super) edges: Vec<Edge>,
    /// Contour of each edge; those of the second operand count on from the first.
    pub(super) contour_of: Vec<u32>,
    first_contours: usize,
    drawn: [bool; 2],
}

impl Scene {
    /// Gathers the edges of all contours that are not free.
    pub(super) fn gather(operands: &[Operand; 2], free: &Free) -> Result<Self, BooleanError> {
        let bound: usize = operands.iter().map(|operand| operand.contours().point_count()).sum();
        if bound >= MAX_EDGES {
            return Err(BooleanError::TooLarge { edges: bound, limit: MAX_EDGES });
        }
        let first_contours = operands[0].contours().len();
        let mut scene = Self {
            edges: Vec::with_capacity(bound - free.point_count().min(bound)),
            contour_of: Vec::with_capacity(bound - free.point_count().min(bound)),
            first_contours,
            drawn: operands.map(|operand| matches!(operand, Operand::Drawn(_))),
        };
        scene.add_operand(operands[0], 0, 0, free);
        scene.add_operand(operands[1], 1, first_contours, free);
        Ok(scene)
    }

    /// True if the contours of an operand are shapes as drawn, so that touching itself matters.
    pub(super) fn is_drawn(&self, contour: u32) -> bool {
        self.drawn[self.operand_of(contour)]
    }

    /// The operand that a contour belongs to.
    pub(super) fn operand_of(&self, contour: u32) -> usize {
        usize::from(contour as usize >= self.first_contours)
    }

    fn add_operand(&mut self, operand: Operand, index: usize, first_contour: usize, free: &Free) {
        let (contours, drawn) = (operand.contours(), self.drawn[index]);
        let jobs = contours.len().div_ceil(CONTOURS_PER_JOB);
        let parts: Vec<(Vec<Edge>, Vec<u32>)> = (0..jobs)
            .into_par_iter()
            .map(|job| {
                let range = job * CONTOURS_PER_JOB..((job + 1) * CONTOURS_PER_JOB).min(contours.len());
                let mut part = (Vec::new(), Vec::new());
                for contour in range.filter(|contour| !free.contains(first_contour + contour)) {
                    let points = contours.get(contour).unwrap_or_default();
                    let winding = if drawn && signed_area2(points) < 0 { -1 } else { 1 };
                    let before = part.0.len();
                    add_edges(&mut part.0, points, index, winding);
                    #[expect(clippy::cast_possible_truncation, reason = "contours with edges are fewer than MAX_EDGES")]
                    let number = (first_contour + contour) as u32;
                    part.1.extend(std::iter::repeat_n(number, part.0.len() - before));
                }
                part
            })
            .collect();
        for (edges, numbers) in parts {
            self.edges.extend(edges);
            self.contour_of.extend(numbers);
        }
    }
}

fn add_edges(edges: &mut Vec<Edge>, points: &[GridPoint], operand: usize, winding: i32) {
    let Some(&last) = points.last() else { return };
    let mut from = last;
    for &to in points {
        let mut delta = [0; 2];
        if from < to {
            delta[operand] = winding;
            edges.push(Edge { l: from, r: to, delta });
        } else if to < from {
            delta[operand] = -winding;
            edges.push(Edge { l: to, r: from, delta });
        }
        from = to;
    }
}
