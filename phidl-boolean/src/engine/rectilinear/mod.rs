//! Operations on rectilinear contours, whose edges are all axis-parallel.
//!
//! Their crossings are grid points, so snap rounding would change nothing. One sweep from left to right visits the columns
//! with vertical edges. The [`Status`] holds the heights at which the winding numbers change, and a column updates the
//! heights between the ends of its vertical edges. Coincident edges add up before anything is visited. So the cost is
//! proportional to edges and crossings, with small constants.
//!
//! The result is that of the other stages, byte for byte; a test compares both. It is not taken where most contours are
//! isolated, because a copy is faster.

mod rings;
mod status;

use rayon::prelude::*;

use super::{
    budget::Budget,
    input::{Operand, Rule},
};
use crate::{
    error::BooleanError,
    op::{Fill, Operation},
    point::GridPoint,
    region::Region,
};
use rings::{Corners, NONE};
use status::{Height, Status};

/// Columns between two looks at the budget.
const COLUMNS_PER_CHECK: usize = 64;

/// Whether all edges of both operands are axis-parallel.
pub(super) fn is_rectilinear(operands: &[Operand; 2]) -> bool {
    operands
        .iter()
        .flat_map(|operand| operand.contours().iter())
        .all(|contour| edges(contour).all(|(a, b)| a.x == b.x || a.y == b.y))
}

/// Runs one operation on rectilinear operands.
///
/// # Errors
/// Cancelled, out of memory, or a result that is too large.
pub(super) fn resolve(operands: &[Operand; 2], rule: Rule, budget: &Budget) -> Result<Region, BooleanError> {
    let mut jumps = Vec::with_capacity(operands.iter().map(|operand| operand.contours().point_count()).sum());
    for (index, operand) in operands.iter().enumerate() {
        for contour in operand.contours().iter() {
            match operand {
                Operand::Shapes(_) => add_shape(contour, index, budget, &mut jumps)?,
                Operand::Oriented(_) => add_contour(contour, index, 1, &mut jumps),
            }
        }
    }
    swept(jumps, rule, budget)
}

/// The change of the winding numbers, at a height of a column, from left to right and from below to above.
#[derive(Debug, Clone, Copy)]
struct Jump {
    x: i64,
    y: i64,
    winding: [i32; 2],
}

/// A shape covers what it encloses: a rectangle in any direction, other shapes by the non-zero rule.
fn add_shape(
    contour: &[GridPoint],
    operand: usize,
    budget: &Budget,
    jumps: &mut Vec<Jump>,
) -> Result<(), BooleanError> {
    if let &[a, b, c, d] = contour
        && ((a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x)
            || (a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y))
    {
        let sign = if crate::point::signed_area2(contour) < 0 { -1 } else { 1 };
        add_contour(contour, operand, sign, jumps);
        return Ok(());
    }
    let mut own = Vec::with_capacity(contour.len());
    add_contour(contour, 0, 1, &mut own);
    let filled = swept(own, Rule { operation: Operation::Or, fill: Fill::NonZero }, budget)?;
    filled.contours().iter().for_each(|ring| add_contour(ring, operand, 1, jumps));
    Ok(())
}

fn add_contour(contour: &[GridPoint], operand: usize, sign: i32, jumps: &mut Vec<Jump>) {
    for (a, b) in edges(contour).filter(|(a, b)| a.x == b.x && a.y != b.y) {
        // To the right of a downward edge, the winding number is larger by one; above its upper end, it is not.
        let mut winding = [0, 0];
        winding[operand] = sign;
        jumps.push(Jump { x: a.x, y: b.y, winding });
        winding[operand] = -sign;
        jumps.push(Jump { x: a.x, y: a.y, winding });
    }
}

fn edges(contour: &[GridPoint]) -> impl Iterator<Item = (GridPoint, GridPoint)> {
    contour.iter().copied().zip(contour.iter().copied().cycle().skip(1))
}

fn swept(mut jumps: Vec<Jump>, rule: Rule, budget: &Budget) -> Result<Region, BooleanError> {
    jumps.par_sort_unstable_by_key(|jump| (jump.x, jump.y));
    let mut sweep = Sweep { rule, status: Status::default(), corners: Corners::default(), fresh: Vec::new() };
    let mut counted = 0;
    for (index, column) in jumps.chunk_by(|a, b| a.x == b.x).enumerate() {
        if index.is_multiple_of(COLUMNS_PER_CHECK) {
            let corners = sweep.corners.check_size()?;
            budget.add_vertices(corners - std::mem::replace(&mut counted, corners));
            budget.check()?;
        }
        sweep.visit_column(column);
    }
    sweep.corners.check_size()?;
    let (contours, polygons) = sweep.corners.into_rings();
    Ok(Region::from_parts(contours, polygons))
}

struct Sweep {
    rule: Rule,
    status: Status,
    corners: Corners,
    /// The heights of the present run, to the right of the column.
    fresh: Vec<Height>,
}

/// The winding numbers on one side of a column below the current height, and whether they are covered.
#[derive(Clone, Copy)]
struct Side {
    winding: [i32; 2],
    is_covered: bool,
}

impl Sweep {
    /// Visits the runs of a column: stretches along which the winding numbers differ from left to right.
    fn visit_column(&mut self, column: &[Jump]) {
        let mut rest = column;
        while let [first, ..] = rest {
            let from = self.status.search(first.y);
            let winding = self.status.winding_below(from);
            let below = Side { winding, is_covered: self.rule.covers(winding) };
            rest = self.visit_run(rest, from, below);
        }
    }

    /// Visits one run; returns the jumps above it.
    fn visit_run<'a>(&mut self, mut jumps: &'a [Jump], from: status::Slot, below: Side) -> &'a [Jump] {
        let (mut left, mut right) = (below, below);
        let mut run = Run { x: jumps[0].x, from, vertical: NONE, under: NONE };
        self.fresh.clear();
        let mut slot = from;
        loop {
            let (jump, height) = (jumps.first(), self.status.get(slot));
            let y = match (jump, height) {
                (Some(jump), Some(height)) => jump.y.min(height.y),
                (Some(jump), None) => jump.y,
                (None, Some(height)) => height.y,
                (None, None) => break,
            };
            let is_jump = jump.is_some_and(|jump| jump.y == y);
            if left.winding == right.winding && !is_jump {
                break;
            }
            let height = height.copied().filter(|height| height.y == y);
            let left_above = height.map_or(left, |height| self.side(height.above, left));
            let mut above =
                [0, 1].map(|operand| right.winding[operand] + left_above.winding[operand] - left.winding[operand]);
            while let Some((jump, others)) = jumps.split_first().filter(|(jump, _)| jump.y == y) {
                above = [above[0] + jump.winding[0], above[1] + jump.winding[1]];
                jumps = others;
            }
            let right_above = self.side(above, right);
            self.visit_node(&mut run, y, height, [left, left_above], [right, right_above]);
            if height.is_some() {
                slot = self.status.step_up(slot);
            }
            (left, right) = (left_above, right_above);
            if left.winding == right.winding && jumps.first().is_none_or(|jump| jump.y > y) {
                break;
            }
        }
        self.status.replace(from, slot, &self.fresh);
        jumps
    }

    fn side(&self, winding: [i32; 2], same: Side) -> Side {
        if winding == same.winding { same } else { Side { winding, is_covered: self.rule.covers(winding) } }
    }

    /// Visits a height of a column: adds its corners and links them with those to the left and below.
    fn visit_node(
        &mut self,
        run: &mut Run,
        y: i64,
        height: Option<Height>,
        [left, left_above]: [Side; 2],
        [right, right_above]: [Side; 2],
    ) {
        let [lb, la, rb, ra] = [left, left_above, right, right_above].map(|side| side.is_covered);
        let (to_left, to_right, down, up) = (lb != la, rb != ra, lb != rb, la != ra);
        let left_corner = height.map_or(NONE, |height| height.corner);
        let at = GridPoint::new(run.x, y);
        // The corner at the left end of the boundary to the right.
        let mut corner = NONE;
        if !down && !up {
            corner = if to_right { left_corner } else { NONE };
        } else if to_left && to_right && down && up {
            let (first, second) = (self.corners.push(at), self.corners.push(at));
            if lb {
                // The lower left and the upper right quadrant are covered, and stay separate.
                self.corners.link(first, left_corner);
                self.corners.link(run.vertical, first);
            } else {
                self.corners.link(left_corner, first);
                self.corners.link(second, run.vertical);
            }
            (corner, run.vertical) = if lb { (second, second) } else { (second, first) };
        } else if to_left || to_right {
            let own = self.corners.push(at);
            if to_left {
                let (start, end) = if la { (left_corner, own) } else { (own, left_corner) };
                self.corners.link(start, end);
            } else {
                corner = own;
            }
            if down {
                let (start, end) = if lb { (run.vertical, own) } else { (own, run.vertical) };
                self.corners.link(start, end);
            } else {
                run.vertical = own;
            }
            if !to_left && !down && lb {
                let below = if run.under == NONE { self.status.boundary_below(run.from) } else { run.under };
                self.corners.begin_hole(own, below);
            }
        }
        if right.winding != right_above.winding {
            self.fresh.push(Height { y, above: right_above.winding, corner });
        }
        if to_right {
            run.under = corner;
        }
    }
}

/// A run of a column in progress.
struct Run {
    x: i64,
    /// The slot below its first height.
    from: status::Slot,
    /// The corner at the lower end of the vertical boundary in progress.
    vertical: u32,
    /// A corner of the last boundary that leads to the right.
    under: u32,
}
