//! Segments, and lists of them without coincident ones.

use crate::point::{GridPoint, cross};

/// A segment from its smaller end `l` to its larger end `r`, in the order of grid points (x, then y).
///
/// Read with the plane tilted by less than any slope, so that a vertical segment runs to the right like every other:
/// "above" is to the left of the direction from `l` to `r`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Segment {
    pub(super) l: GridPoint,
    pub(super) r: GridPoint,
    /// The winding delta: winding numbers above the segment less those below, one per operand.
    pub(super) delta: [i32; 2],
}

impl Segment {
    /// Positive if `p` is above this segment.
    #[inline]
    pub(super) fn cross(&self, p: GridPoint) -> i128 {
        cross(self.l, self.r, p)
    }

    /// True if both segments have the same ends; the winding deltas may differ.
    pub(super) fn coincides(&self, other: &Self) -> bool {
        self.l == other.l && self.r == other.r
    }

    /// True for the segment between a point and its repetition; no strip receives it.
    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.l == self.r
    }
}

/// Adds a segment to a sorted list, or its winding delta to the last one if the two coincide. Segments whose winding
/// deltas cancel are dropped.
pub(super) fn push_merged(segments: &mut Vec<Segment>, segment: Segment) {
    match segments.last_mut() {
        Some(last) if last.coincides(&segment) => {
            last.delta[0] += segment.delta[0];
            last.delta[1] += segment.delta[1];
        }
        _ => {
            drop_last_cancelled(segments);
            segments.push(segment);
        }
    }
}

/// Drops the last segment of a list if its winding deltas have cancelled.
pub(super) fn drop_last_cancelled(segments: &mut Vec<Segment>) {
    if segments.last().is_some_and(|last| last.delta == [0, 0]) {
        segments.pop();
    }
}
