//! [`Options`]: the options that all operations on devices share.

use phidl_core::num::grid::Grid;

use crate::{error::BooleanError, grid, options::RunOptions};

/// Default limit of points per polygon, as in PHIDL.
const MOST_POINTS: usize = 4000;

/// The grid, the hierarchy and the polygon size of the result, and how to run.
///
/// ```
/// use phidl_boolean::Options;
/// let fine = Options { precision: 1e-6, ..Options::default() };
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Options<'a> {
    /// The grid step (µm), greater than zero; every coordinate is rounded to it. The default is 1e-4 µm.
    pub precision: f64,
    /// The most points of a polygon of the result, at least 3; larger polygons are fractured. The default is 4000; `None`
    /// is no limit.
    pub max_points: Option<usize>,
    /// Whether the result is one flat cell or keeps repeated cells.
    pub hierarchy: Hierarchy,
    /// Strips, threads, progress. They do not change the result.
    pub run: RunOptions<'a>,
}

/// Whether the result of an operation is one flat cell or keeps repeated cells.
///
/// The covered area is the same. [`invert`](crate::invert()), [`Region::of`](crate::Region::of) and
/// [`Region::to_device`](crate::Region::to_device) refuse [`Hierarchy::Keep`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Hierarchy {
    /// Everything is drawn into one cell.
    #[default]
    Flatten,
    /// Placements that repeat without touching anything else are processed once, as a cell of their own, and referenced. A
    /// million placements of a cell cost little more than one.
    ///
    /// - Flattened and on the grid, the result has the same polygons as the flat result, in another order. (Two conditions
    ///   of the flat result concern all of it and do not apply: its range, and that all of it is narrower than twice the
    ///   inset.)
    /// - References of the result are shifts by whole grid steps, never rotated. A rotated placement is a case of its own,
    ///   of which there are at most eight on the grid.
    /// - The same input gives the same cells, in the same order.
    Keep,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            precision: 1e-4,
            max_points: Some(MOST_POINTS),
            hierarchy: Hierarchy::Flatten,
            run: RunOptions::default(),
        }
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

    /// Refuses [`Hierarchy::Keep`] where the result is always flat.
    ///
    /// # Errors
    /// [`BooleanError::Hierarchy`] with the reason.
    pub(crate) fn require_flat(&self, reason: &'static str) -> Result<(), BooleanError> {
        match self.hierarchy {
            Hierarchy::Flatten => Ok(()),
            Hierarchy::Keep => Err(BooleanError::Hierarchy { reason }),
        }
    }
}
