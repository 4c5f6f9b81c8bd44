//! The third and fourth stage: which sides of the snapped segments are covered (Bentley–Ottmann without crossings).
//!
//! [`scan`] is the sweep itself, over any sorted list of segments. [`self_intersecting`] uses it to fill shapes that touch
//! or cross themselves, [`spanning`] gathers the segments that span a seam, and [`strip`] sweeps one strip. [`status`] is
//! the status structure.

mod scan;
mod self_intersecting;
mod spanning;
mod status;
mod strip;

pub(super) use scan::{BoundaryEdges, BoundaryId, SPANNING, Surroundings};
pub(super) use self_intersecting::FilledContours;
pub(super) use spanning::SpanningSegments;
pub(super) use strip::sweep_strip;
