//! [`Pen`]: size and accuracy of the letters of a text.

use phidl_core::prelude::*;

/// Size and accuracy of letters.
pub(super) struct Pen<'a> {
    /// The rules of the text.
    pub(super) check: Check<'a>,
    /// Size of the text (µm), not zero.
    pub(super) size: f64,
    /// Largest distance of a chord from its curve (µm).
    #[cfg_attr(not(feature = "fonts"), expect(dead_code, reason = "DEPLOF has no curves"))]
    pub(super) tolerance: f64,
    /// Width of the bridges through counters (µm).
    #[cfg_attr(not(feature = "fonts"), expect(dead_code, reason = "DEPLOF has no counters"))]
    pub(super) stencil: Option<f64>,
}

/// Largest number of points of a text.
const MOST_POINTS: usize = 10_000_000;

impl Pen<'_> {
    /// Refuses a text of more points than a drawing may have.
    pub(super) fn check_points(&self, points: usize) -> Result<()> {
        self.check.at_most("number of points", points, MOST_POINTS)
    }
}
