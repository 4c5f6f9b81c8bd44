//! The engine: from edges that cross each other to a [`Region`] without crossings.
//!
//! # Why dividing the plane cannot show
//!
//! A boolean on an integer grid has one hard question: a crossing of two edges is almost never a grid point, so edges
//! must bend, and a bent edge may now cross a third one. Engines that repair this step by step, in the order in which
//! they meet the crossings, give a result that depends on everything they have seen; cut the plane into tiles and the
//! tiles disagree about their seams. We avoid the question instead of answering it at each seam:
//!
//! 1. **Snapping is local** ([`snap`]). Each grid point owns the half-open square of one step around it. A square is
//!    *hot* if it holds a vertex or a crossing of the original edges, and an edge is bent through exactly the hot
//!    squares that it passes. (This is snap rounding, Hobby 1999, Guibas and Marimont 1998. It moves no point of an
//!    edge by more than half a step in x or y, and bent edges meet only at their ends.) What happens in a square
//!    depends on the edges through that square alone.
//! 2. **Seams lie between grid points** ([`plan`]). The plane is cut at x = integer + ½ into strips, so each hot
//!    square belongs to exactly one strip. No edge is ever cut: a strip sees whole edges, all that touch it, and
//!    reports only the bends inside. Joined along the edge, the reports of all strips are the bends of the edge.
//! 3. **Strips report facts, not shapes** ([`sweep`]). Each strip then tells, for the edges that begin in it, what
//!    lies on either side, and for the vertices in it, which boundary edge follows which. An edge that reaches over a
//!    seam is the same edge on both sides. Outlines are only drawn after that, for the whole plane ([`trace`]).
//!
//! Contours that meet nothing take no part in any of this ([`free`]): the sweep only says what lies around them.
//!
//! A drawn contour that touches itself is filled on its own between steps 2 and 3, from its bent pieces ([`apart`]):
//! no second rounding.
//!
//! So there is nothing to stitch: no vertex, sliver or gap can be left on a seam because no seam ever produces
//! geometry. The result is the undivided one, point for point and in the same order, for every strip size and every
//! number of threads, and cost stays near-linear because a strip only looks at what touches it.
//!
//! Rejected: cutting shapes at tile borders and uniting the pieces (hundreds of extra vertices in a trial, and slanted
//! edges step aside at each border); whole shapes for each tile with crossings paired along half-grid seams (neighbors
//! see different bends, so rare pairs do not match); an off-the-shelf sweep for each tile (`i_overlay` rounds
//! crossings in rounds that depend on the set of edges it sees; it serves our tests as an independent oracle).

mod active;
mod apart;
mod bands;
mod bent;
mod edge;
mod free;
mod order;
mod plain;
mod plan;
mod raster;
mod snap;
mod span;
mod sweep;
mod trace;

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::{
    contours::Contours,
    error::BooleanError,
    op::{Fill, Operation},
    options::RunOptions,
    progress::{Progress, Watch},
    region::Region,
};
use apart::Apart;
use bent::Bent;
use edge::Scene;
use free::Free;
use plan::StripPlan;
use span::Spans;

/// One side of an operation, as the engine takes it.
#[derive(Clone, Copy)]
pub(crate) enum Operand<'a> {
    /// Shapes as drawn: any direction, any self-crossing; each is filled on its own, then all are united.
    Drawn(&'a Contours),
    /// Contours whose direction and overlap have meaning: winding numbers are taken as they are.
    Wound(&'a Contours),
}

impl<'a> Operand<'a> {
    fn contours(self) -> &'a Contours {
        match self {
            Self::Drawn(contours) | Self::Wound(contours) => contours,
        }
    }
}

/// What the operation should find, once the plane is divided into places with two winding numbers each.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rule {
    pub(crate) operation: Operation,
    pub(crate) fill: Fill,
}

impl Rule {
    #[inline]
    fn covers(self, winding: [i32; 2]) -> bool {
        self.operation.keeps(self.fill.covers(winding[0]), self.fill.covers(winding[1]))
    }
}

/// The most points of a result: two results together must not be too many for one operation, so that an operation on
/// regions that exist cannot be refused.
const MOST_RESULT_POINTS: usize = edge::MAX_EDGES / 2 - 1;

/// Runs one operation.
///
/// # Errors
/// Options out of range, coordinates out of range, too many edges, a result that is too large, no threads, or cancelled.
pub(crate) fn resolve(operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    options.check()?;
    Watch::check(options.watch)?;
    for operand in &operands {
        operand.contours().check_range()?;
    }
    let region = options.on_threads(|| run(operands, rule, options))?;
    match region.contours().point_count() {
        edges if edges > MOST_RESULT_POINTS => Err(BooleanError::TooLarge { edges, limit: MOST_RESULT_POINTS }),
        _ => Ok(region),
    }
}

fn run(operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    run_around(&Free::find(&operands), operands, rule, options)
}

/// Runs the strips for all contours but the free ones.
fn run_around(free: &Free, operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    let scene = Scene::new(&operands, free)?;
    let plan = StripPlan::new(&scene, options.division);
    let work = Work::new(options.watch, 2 * plan.len());

    let snapped = work.each(plan.len(), |strip| snap::snap_strip(&scene, &plan, strip))?;
    let bent = Bent::new(&scene, &plan, snapped);
    let apart = Apart::fill(&bent);
    let spans = Spans::join(&bent, &apart);

    let swept = work.each(plan.len(), |strip| {
        let columns = plan.columns(strip);
        let points = free.in_columns(columns).map(|outline| free.begin(outline));
        let mut pieces = [apart.within(strip), spans.owned(strip)].concat();
        bent.within(strip, |contour| !bent.is_apart(contour), |_, piece| pieces.push(piece));
        sweep::sweep_strip(&pieces, &spans, strip, columns.1, rule, points)
    })?;
    Ok(trace::trace(&swept, spans.len(), free, rule))
}

/// Runs the strips of a stage in parallel, reports progress and stops when cancelled.
struct Work<'a> {
    watch: Option<&'a Watch>,
    done: AtomicUsize,
    total: usize,
}

impl<'a> Work<'a> {
    fn new(watch: Option<&'a Watch>, total: usize) -> Self {
        Self { watch, done: AtomicUsize::new(0), total }
    }

    /// Results come in strip order, whichever thread made them.
    fn each<T: Send>(&self, strips: usize, job: impl Fn(usize) -> T + Sync) -> Result<Vec<T>, BooleanError> {
        (0..strips)
            .into_par_iter()
            .with_max_len(1)
            .map(|strip| {
                Watch::check(self.watch)?;
                let result = job(strip);
                let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
                if let Some(watch) = self.watch {
                    watch.report(Progress { done, total: self.total });
                }
                Ok(result)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::GridPoint;
    use proptest::prelude::*;

    /// Small shapes scattered over a field with a few large ones: squares, triangles, stars, figure-eights, backwards
    /// ones. Many meet nothing.
    fn field() -> impl Strategy<Value = Contours> {
        let small = (0..30i64, 0..30i64, 1..9i64, 0..6usize).prop_map(|(column, row, size, kind)| {
            let (x, y) = (10 * column, 10 * row);
            let s = size;
            let points = match kind {
                0 => vec![(0, 0), (s, 0), (s, s), (0, s)],
                1 => vec![(0, 0), (0, s), (s, s), (s, 0)],
                2 => vec![(0, 0), (s, 1), (1, s)],
                3 => vec![(0, 0), (s, s), (s, 0), (0, s)],
                4 => vec![(0, 0), (9, 3), (4, 4), (3, 9)],
                _ => vec![(0, 0), (s, 0), (2 * s, 0), (2 * s, s), (0, s)],
            };
            points.into_iter().map(|(dx, dy)| GridPoint::new(x + dx, y + dy)).collect::<Vec<_>>()
        });
        let large = prop::collection::vec((-20..320i64, -20..320i64).prop_map(GridPoint::from), 3..6);
        let shapes = (prop::collection::vec(small, 0..60), prop::collection::vec(large, 0..3));
        shapes.prop_map(|(small, large)| small.into_iter().chain(large).collect())
    }

    fn same_without_free(operands: [Operand; 2], rule: Rule) -> Result<(), TestCaseError> {
        let options = RunOptions { division: crate::Division::Strips(7), ..RunOptions::default() };
        let swept = run_around(&Free::none(&operands), operands, rule, &options).unwrap();
        prop_assert_eq!(run(operands, rule, &options).unwrap(), swept);
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        #[test]
        fn contours_that_meet_nothing_come_out_as_the_sweep_would_draw_them(a in field(), b in field()) {
            for operation in [Operation::Or, Operation::And, Operation::Not, Operation::NotReversed, Operation::Xor] {
                let rule = Rule { operation, fill: Fill::NonZero };
                same_without_free([Operand::Drawn(&a), Operand::Drawn(&b)], rule)?;
                same_without_free([Operand::Drawn(&a), Operand::Wound(&b)], rule)?;
            }
            let rule = Rule { operation: Operation::Or, fill: Fill::Positive };
            same_without_free([Operand::Wound(&a), Operand::Wound(&Contours::new())], rule)?;
        }
    }

    /// What the operators of [`Region`] rely on.
    #[test]
    fn two_results_are_never_too_many_edges_for_one_operation() {
        const { assert!(2 * MOST_RESULT_POINTS < edge::MAX_EDGES) };
    }

    #[test]
    fn most_of_a_field_is_free_and_what_a_cross_meets_is_not() {
        let square = |x: i64, y: i64| [(x, y), (x + 5, y), (x + 5, y + 5), (x, y + 5)].map(GridPoint::from).to_vec();
        let field: Contours = (0..50).flat_map(|x| (0..50).map(move |y| square(10 * x, 10 * y))).collect();
        let bar = [(248, -9), (252, -9), (252, 509), (248, 509)].map(GridPoint::from);
        let cross: Contours = [bar.to_vec()].into_iter().collect();
        let free = Free::find(&[Operand::Drawn(&field), Operand::Drawn(&cross)]);
        assert_eq!(free.len(), 49 * 50);
        let rule = Rule { operation: Operation::Not, fill: Fill::NonZero };
        let rest = run([Operand::Drawn(&field), Operand::Drawn(&cross)], rule, &RunOptions::default()).unwrap();
        assert_eq!(rest.area2(), 2 * (25 * 2500 - 50 * 2 * 5));
    }
}
