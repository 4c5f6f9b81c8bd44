//! The second stage: snap rounding (Hobby 1999; Guibas and Marimont 1998), strip by strip.
//!
//! [`candidates`] finds pairs of segments whose bounding boxes touch, [`strip`] finds the hot pixels that each segment
//! crosses, and [`chains`] keeps the result.

pub(super) mod candidates;
pub(super) mod chains;
mod strip;

pub(super) use chains::{Kind, SnapChains};
pub(super) use strip::snap_strip;
