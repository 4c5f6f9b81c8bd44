//! The sweep over one strip.

use std::cmp::Ordering;

use super::{
    scan::{BoundaryEdges, Scan, in_order},
    spanning::SpanningSegments,
};
use crate::{
    engine::{input::Rule, segment::Segment},
    point::{GridPoint, side},
};

/// Sweeps one strip, whose last grid column is `last`, and answers what surrounds some `points` of it (ascending).
pub(in crate::engine) fn sweep_strip(
    segments: &[Segment],
    spanning: &SpanningSegments,
    strip: usize,
    last: i64,
    rule: Rule,
    points: impl Iterator<Item = GridPoint>,
) -> BoundaryEdges {
    let mut segments = in_order(segments);
    let own = segments.len();
    let mut entering: Vec<u32> = spanning.entering(strip).to_vec();
    entering.sort_unstable_by(|&a, &b| upward_at_seam(&spanning.segment(a), &spanning.segment(b)));
    segments.extend(entering.iter().map(|&number| spanning.segment(number)));

    let mut scan = Scan::new(rule, &segments, last);
    scan.enter(own, &entering);
    scan.run(own, points);
    let mut edges = scan.into_edges();
    for (segment, _) in &mut edges.spanning {
        *segment = spanning.number_of(strip, &segments[*segment as usize]);
    }
    edges
}

/// Order from bottom to top of segments that all cross one vertical line and do not cross each other.
fn upward_at_seam(a: &Segment, b: &Segment) -> Ordering {
    if a.l >= b.l { side(b.l, b.r, a.l).then_with(|| side(b.l, b.r, a.r)) } else { upward_at_seam(b, a).reverse() }
}
