//! [`Options`]: what all operations on devices have in common.

use phidl_core::num::grid::Grid;

use crate::{error::BooleanError, grid, options::RunOptions};

/// Points per polygon of a result when nothing else is asked for, as in the specification.
const MOST_POINTS: usize = 4000;

/// On which grid to work, how large the polygons of the result may be, and how to run.
///
/// ```
/// use phidl_boolean::Options;
/// let fine = Options { precision: 1e-6, ..Options::default() };
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Options<'a> {
    /// The grid step (µm), greater than zero; every coordinate is rounded to it. 1e-4 µm unless told otherwise.
    pub precision: f64,
    /// The most points of a polygon of the result, at least 3; those with more are cut, so that more polygons than
    /// pieces come back. 4000 unless told otherwise; `None` is no limit.
    pub max_points: Option<usize>,
    /// Threads, division, progress. None of it changes the result.
    pub run: RunOptions<'a>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { precision: 1e-4, max_points: Some(MOST_POINTS), run: RunOptions::default() }
    }
}

impl Options<'_> {
    /// The grid to work on.
    ///
    /// # Errors
    /// [`BooleanError::Precision`] unless the precision is a positive length.
    pub(crate) fn grid(&self) -> Result<Grid, BooleanError> {
        grid::with_step(self.precision)
    }
}
