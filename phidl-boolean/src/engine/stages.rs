//! [`Stages`]: the intermediate results of one operation, for the picture in `docs/stages.md`.

use super::{
    budget::Budget,
    input::{Operand, Rule},
    isolated::IsolatedPolygons,
    segment_set::SegmentSet,
    snap::{Kind, SnapChains, snap_strip},
    strips::StripPlan,
    sweep::{FilledContours, SpanningSegments, sweep_strip},
    trace::{boundary_edges, trace},
};
use crate::{
    contours::Contours,
    error::BooleanError,
    op::{Fill, Operation},
    options::{RunOptions, StripCount},
    point::GridPoint,
    region::Region,
};

/// The intermediate results of one operation.
#[derive(Debug)]
pub struct Stages {
    /// Whether each contour is isolated; indices of the second operand follow those of the first.
    pub isolated: Vec<bool>,
    /// The first grid column of each strip but the first.
    pub seams: Vec<i64>,
    /// The segments that are not isolated, from their smaller end.
    pub segments: Vec<[GridPoint; 2]>,
    /// The straight segments of all snap chains.
    pub chains: Vec<[GridPoint; 2]>,
    /// Directed boundary edges; the covered side is on the left.
    pub boundary: Vec<[GridPoint; 2]>,
    /// The result.
    pub region: Region,
}

/// Runs all stages on two lists of shapes, in `strips` strips.
///
/// # Errors
/// Too many edges.
pub fn record(a: &Contours, b: &Contours, operation: Operation, strips: usize) -> Result<Stages, BooleanError> {
    let (operands, rule) = ([Operand::Shapes(a), Operand::Shapes(b)], Rule { operation, fill: Fill::NonZero });
    let isolated = IsolatedPolygons::find(&operands);
    let set = SegmentSet::new(&operands, |contour| isolated.contains(contour))?;
    let plan = StripPlan::new(&set, StripCount::Fixed(strips));
    let budget = Budget::new(set.len(), &RunOptions::default())?;
    let snapped = (0..plan.len()).map(|strip| snap_strip(&set, &plan, strip, &budget)).collect();
    let chains = SnapChains::new(&set, &plan, snapped);
    let filled = FilledContours::fill(&chains);
    let spanning = SpanningSegments::join(&chains, &filled);
    let mut parts = Vec::new();
    let swept: Vec<_> = (0..plan.len())
        .map(|strip| {
            let mut inside = [filled.within(strip), spanning.owned(strip)].concat();
            chains.within(strip, Kind::Ordinary, |_, segment| inside.push(segment));
            parts.extend(inside.iter().map(|segment| [segment.l, segment.r]));
            let columns = plan.columns(strip);
            let points = isolated.in_columns(columns).map(|polygon| isolated.begin(polygon));
            sweep_strip(&inside, &spanning, strip, columns.1, rule, points)
        })
        .collect();
    let numbers = (0u32..).take(set.len()).map(|number| set.segment(number));
    Ok(Stages {
        isolated: (0..a.len() + b.len()).map(|contour| isolated.contains(contour)).collect(),
        seams: (1..plan.len()).map(|strip| plan.columns(strip).0).collect(),
        segments: numbers.filter(|segment| !segment.is_empty()).map(|segment| [segment.l, segment.r]).collect(),
        chains: parts,
        boundary: boundary_edges(&swept, spanning.len()),
        region: trace(&swept, spanning.len(), &isolated, rule, &budget)?,
    })
}
