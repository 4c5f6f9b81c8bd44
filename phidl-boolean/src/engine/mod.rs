//! The engine: from contours that cross each other to a [`Region`] without crossings.
//!
//! # Stages
//!
//! | stage | module | from | to |
//! | --- | --- | --- | --- |
//! | set contours aside that touch nothing | [`isolated`] | two operands | `IsolatedPolygons` |
//! | build segments, divide the plane | [`segment_set`], [`strips`] | the other contours | `SegmentSet`, `StripPlan` |
//! | snap rounding | [`snap`] | segments of a strip | `SnapChains` |
//! | fill self-intersecting contours | [`sweep`] | their chains | `FilledContours` |
//! | sweep | [`sweep`] | chains of a strip | `BoundaryEdges` |
//! | ring assembly | [`trace`] | boundary edges of all strips | [`Region`] |
//!
//! Operands whose edges are all axis-parallel skip the stages from segments on: see [`rectilinear`].
//!
//! # Why the result does not depend on the division
//!
//! A boolean on an integer grid has one hard question: the crossing of two segments is almost never a grid point, so the
//! segments must move, and a moved segment may cross a third one. Engines that repair this step by step, in the order in
//! which they meet the crossings, give a result that depends on everything they have seen. Divide the plane into tiles,
//! and the tiles disagree about their seams. This engine avoids the question:
//!
//! 1. **Snapping is local** ([`snap`]). The pixel of a grid point is the half-open square of one step around it. A pixel
//!    is *hot* if it contains a vertex or a crossing of input segments, and a segment is replaced by the chain of exactly
//!    the hot pixels that it crosses. This is snap rounding (Hobby 1999; Guibas and Marimont 1998). It moves no point of a
//!    segment by more than half a step in x or y, and chains meet only at grid points. What happens in a pixel depends on
//!    the segments through that pixel alone.
//! 2. **Seams lie between grid points** ([`strips`]). The plane is divided into strips at x = integer + ½, so each hot
//!    pixel belongs to exactly one strip. No segment is ever cut: a strip receives whole segments, all that touch it, and
//!    reports only the snap vertices inside. The reports of all strips, joined along a segment, are its chain.
//! 3. **Strips report links, not shapes** ([`sweep`]). Each strip reports, for the segments that begin in it, which side is
//!    covered, and for the vertices in it, which boundary edge follows which. A segment that spans a seam is the same
//!    segment on both sides. Rings are assembled after that, for the whole plane ([`trace`]).
//!
//! So there is nothing to stitch. No vertex, sliver or gap can be left on a seam, because no seam ever produces geometry.
//! The result is the undivided one, point for point and in the same order, for every strip count and every number of
//! threads. The cost stays near-linear, because a strip only processes what touches it.
//!
//! Rejected: clipping shapes at tile borders and uniting the parts (hundreds of extra vertices in a trial, and slanted
//! edges step aside at each border); whole shapes for each tile with crossings paired along half-grid seams (neighbors
//! snap differently, so rare pairs do not match); an off-the-shelf sweep for each tile (`i_overlay` rounds crossings in
//! passes that depend on the set of edges it receives; it serves the tests as an independent oracle).

mod budget;
mod input;
mod isolated;
mod predicates;
mod radix;
mod rectilinear;
mod segment;
mod segment_set;
mod snap;
pub(crate) mod stages;
mod strips;
mod sweep;
mod trace;

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::{
    error::BooleanError,
    options::RunOptions,
    progress::{Progress, ProgressMonitor},
    region::Region,
};
use budget::Budget;
pub(crate) use input::{Operand, Rule};
use isolated::IsolatedPolygons;
use segment_set::{MAX_SEGMENTS, SegmentSet};
use snap::{Kind, SnapChains, snap_strip};
use strips::StripPlan;
use sweep::{FilledContours, SpanningSegments, sweep_strip};
use trace::trace;

/// The most points of a result: two results together must not be too many for one operation, so that an operation on
/// regions that exist cannot be refused.
const MOST_RESULT_POINTS: usize = MAX_SEGMENTS / 2 - 1;

/// Runs one operation.
///
/// # Errors
/// Options out of range, coordinates out of range, too many edges, a result that is too large, no threads, or cancelled.
pub(crate) fn resolve(operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    options.check()?;
    ProgressMonitor::check(options.monitor)?;
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
    let isolated = IsolatedPolygons::find(&operands);
    let contours: usize = operands.iter().map(|operand| operand.contours().len()).sum();
    if 2 * isolated.len() < contours && rectilinear::is_rectilinear(&operands) {
        let points = operands.iter().map(|operand| operand.contours().point_count()).sum();
        return rectilinear::resolve(&operands, rule, &Budget::new(points, options)?);
    }
    run_around(&isolated, operands, rule, options)
}

/// Runs all stages but the first for the contours that are not isolated.
fn run_around(
    isolated: &IsolatedPolygons,
    operands: [Operand; 2],
    rule: Rule,
    options: &RunOptions,
) -> Result<Region, BooleanError> {
    let segments = SegmentSet::new(&operands, |contour| isolated.contains(contour))?;
    let plan = StripPlan::new(&segments, options.strips);
    let budget = Budget::new(segments.len(), options)?;
    let jobs = StripJobs::new(options.monitor, &budget, 2 * plan.len());

    let snapped = jobs.each(plan.len(), |strip| snap_strip(&segments, &plan, strip, &budget))?;
    let chains = SnapChains::new(&segments, &plan, snapped);
    let filled = FilledContours::fill(&chains);
    let spanning = SpanningSegments::join(&chains, &filled);

    let boundary = jobs.each(plan.len(), |strip| {
        let columns = plan.columns(strip);
        let points = isolated.in_columns(columns).map(|polygon| isolated.begin(polygon));
        let mut inside = [filled.within(strip), spanning.owned(strip)].concat();
        chains.within(strip, Kind::Ordinary, |_, segment| inside.push(segment));
        sweep_strip(&inside, &spanning, strip, columns.1, rule, points)
    })?;
    trace(&boundary, spanning.len(), isolated, rule, &budget)
}

/// Runs the strips of a stage in parallel, reports progress and stops when cancelled.
struct StripJobs<'a> {
    monitor: Option<&'a ProgressMonitor>,
    budget: &'a Budget<'a>,
    done: AtomicUsize,
    total: usize,
}

impl<'a> StripJobs<'a> {
    fn new(monitor: Option<&'a ProgressMonitor>, budget: &'a Budget<'a>, total: usize) -> Self {
        Self { monitor, budget, done: AtomicUsize::new(0), total }
    }

    /// Results are in strip order, for any assignment to threads.
    fn each<T: Send>(&self, strips: usize, job: impl Fn(usize) -> T + Sync) -> Result<Vec<T>, BooleanError> {
        (0..strips)
            .into_par_iter()
            .with_max_len(1)
            .map(|strip| {
                self.budget.check()?;
                let result = job(strip);
                self.budget.check()?;
                let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
                if let Some(monitor) = self.monitor {
                    monitor.report(Progress { done, total: self.total });
                }
                Ok(result)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        contours::Contours,
        op::{Fill, Operation},
        point::GridPoint,
    };
    use proptest::prelude::*;

    /// Small shapes scattered over a field with a few large ones: squares, triangles, stars, figure-eights, clockwise
    /// squares. Many are isolated.
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

    fn same_without_isolated(operands: [Operand; 2], rule: Rule) -> Result<(), TestCaseError> {
        let options = RunOptions { strips: crate::StripCount::Fixed(7), ..RunOptions::default() };
        let swept = run_around(&IsolatedPolygons::none(&operands), operands, rule, &options).unwrap();
        prop_assert_eq!(run(operands, rule, &options).unwrap(), swept);
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        #[test]
        fn isolated_contours_give_the_result_of_the_sweep(a in field(), b in field()) {
            for operation in [Operation::Or, Operation::And, Operation::Not, Operation::BMinusA, Operation::Xor] {
                let rule = Rule { operation, fill: Fill::NonZero };
                same_without_isolated([Operand::Shapes(&a), Operand::Shapes(&b)], rule)?;
                same_without_isolated([Operand::Shapes(&a), Operand::Oriented(&b)], rule)?;
            }
            let rule = Rule { operation: Operation::Or, fill: Fill::Positive };
            same_without_isolated([Operand::Oriented(&a), Operand::Oriented(&Contours::new())], rule)?;
        }
    }

    /// Rectangles, staircases, and rectilinear figures that cross and retrace themselves, on a coarse grid.
    fn rectilinear_shapes() -> impl Strategy<Value = Contours> {
        let rectangle = (0..30i64, 0..30i64, 1..12i64, 1..12i64, any::<bool>()).prop_map(|(x, y, w, h, clockwise)| {
            let mut points = vec![(x, y), (x + w, y), (x + w, y + h), (x, y + h)];
            if clockwise {
                points.reverse();
            }
            points
        });
        let walk = prop::collection::vec((0..30i64, 0..30i64), 1..7).prop_map(|corners| {
            // Each corner is reached along x, then along y; the last leg closes the contour likewise.
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).flat_map(|(&(x0, y0), &(x1, _))| [(x0, y0), (x1, y0)]).collect()
        });
        let shapes = prop::collection::vec(prop_oneof![3 => rectangle, 1 => walk], 0..25);
        shapes.prop_map(|shapes| {
            shapes.into_iter().map(|s| s.into_iter().map(GridPoint::from).collect::<Vec<_>>()).collect()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        #[test]
        fn rectilinear_operations_give_the_result_of_the_general_stages(
            a in rectilinear_shapes(), b in rectilinear_shapes(), positive in any::<bool>(),
        ) {
            let options = RunOptions::default();
            let fill = if positive { Fill::Positive } else { Fill::NonZero };
            for operation in [Operation::Or, Operation::And, Operation::Not, Operation::BMinusA, Operation::Xor] {
                for operands in [
                    [Operand::Shapes(&a), Operand::Shapes(&b)],
                    [Operand::Oriented(&a), Operand::Shapes(&b)],
                    [Operand::Oriented(&a), Operand::Oriented(&b)],
                ] {
                    let rule = Rule { operation, fill };
                    prop_assert!(rectilinear::is_rectilinear(&operands));
                    let general = run_around(&IsolatedPolygons::none(&operands), operands, rule, &options).unwrap();
                    prop_assert_eq!(rectilinear::resolve(&operands, rule, &Budget::new(0, &options).unwrap()).unwrap(), general);
                }
            }
        }
    }

    /// The operators of [`Region`] rely on this.
    #[test]
    fn two_results_are_never_too_many_edges_for_one_operation() {
        const { assert!(2 * MOST_RESULT_POINTS < MAX_SEGMENTS) };
    }

    #[test]
    fn most_of_a_field_is_isolated_but_not_where_a_cross_overlaps_it() {
        let square = |x: i64, y: i64| [(x, y), (x + 5, y), (x + 5, y + 5), (x, y + 5)].map(GridPoint::from).to_vec();
        let field: Contours = (0..50).flat_map(|x| (0..50).map(move |y| square(10 * x, 10 * y))).collect();
        let bar = [(248, -9), (252, -9), (252, 509), (248, 509)].map(GridPoint::from);
        let cross: Contours = [bar.to_vec()].into_iter().collect();
        let isolated = IsolatedPolygons::find(&[Operand::Shapes(&field), Operand::Shapes(&cross)]);
        assert_eq!(isolated.len(), 49 * 50);
        let rule = Rule { operation: Operation::Not, fill: Fill::NonZero };
        let rest = run([Operand::Shapes(&field), Operand::Shapes(&cross)], rule, &RunOptions::default()).unwrap();
        assert_eq!(rest.area2(), 2 * (25 * 2500 - 50 * 2 * 5));
    }
}
