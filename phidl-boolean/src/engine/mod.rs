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
mod edge;
mod plan;
mod snap;
mod span;
mod sweep;
mod trace;

use std::sync::{
    Mutex,
    atomic::{AtomicUsize, Ordering},
};

use rayon::prelude::*;

use crate::{
    contours::Contours,
    error::BooleanError,
    op::{Fill, Operation},
    options::RunOptions,
    progress::{Progress, Watch},
    region::Region,
};
use edge::Scene;
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

impl Operand<'_> {
    fn contours(&self) -> &Contours {
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

/// Runs one operation.
///
/// # Errors
/// Options out of range, coordinates out of range, too many edges, no threads, or cancelled.
pub(crate) fn resolve(operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    options.check()?;
    Watch::check(options.watch)?;
    for operand in &operands {
        operand.contours().check_range()?;
    }
    options.on_threads(|| run(operands, rule, options))
}

fn run(operands: [Operand; 2], rule: Rule, options: &RunOptions) -> Result<Region, BooleanError> {
    let scene = Scene::gather(&operands)?;
    let plan = StripPlan::new(&scene.edges, options.division);
    let mut work = Work::new(options.watch, 2 * plan.len());

    let mut snapped = work.each(plan.len(), |strip| snap::snap_strip(&scene, &plan, strip, &[]))?;
    let touching = snap::self_touching(&mut snapped);
    if !touching.is_empty() {
        work.total += plan.len();
        snapped = work.each(plan.len(), |strip| snap::snap_strip(&scene, &plan, strip, &touching))?;
    }
    let spans = Spans::join(&scene, &plan, &mut snapped, &touching);
    drop(scene);

    let pieces: Vec<_> = snapped.into_iter().map(|strip| Mutex::new(strip.pieces)).collect();
    let swept = work.each(plan.len(), |strip| {
        let pieces = std::mem::take(&mut *pieces[strip].lock().expect("invariant: each strip is taken once"));
        sweep::sweep_strip(pieces, &spans, strip, plan.columns(strip).1, rule)
    })?;
    Ok(trace::trace(&swept, spans.len()))
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
