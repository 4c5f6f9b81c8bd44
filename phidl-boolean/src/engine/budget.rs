//! [`Budget`]: what an operation may still use, so that it ends early instead of filling the memory or ignoring a request
//! to cancel.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::{error::BooleanError, options::RunOptions, progress::ProgressMonitor};

/// Bytes per segment of the input, over all stages.
const BYTES_PER_SEGMENT: usize = 200;

/// Bytes per snap vertex or corner, over all stages.
const BYTES_PER_VERTEX: usize = 100;

/// The memory that is left, and the monitor that may cancel.
pub(super) struct Budget<'a> {
    monitor: Option<&'a ProgressMonitor>,
    limit: usize,
    segments: usize,
    vertices: AtomicUsize,
}

impl<'a> Budget<'a> {
    /// The budget of an operation on some segments.
    ///
    /// # Errors
    /// [`BooleanError::Memory`] if the segments alone are too many.
    pub(super) fn new(segments: usize, options: &RunOptions<'a>) -> Result<Self, BooleanError> {
        let budget =
            Self { monitor: options.monitor, limit: options.memory_limit, segments, vertices: AtomicUsize::new(0) };
        budget.check()?;
        Ok(budget)
    }

    /// Counts new vertices.
    pub(super) fn add_vertices(&self, count: usize) {
        self.vertices.fetch_add(count, Ordering::Relaxed);
    }

    /// True if the operation must stop; [`Budget::check`] has the reason.
    pub(super) fn is_over(&self) -> bool {
        self.check().is_err()
    }

    /// # Errors
    /// [`BooleanError::Cancelled`] or [`BooleanError::Memory`].
    pub(super) fn check(&self) -> Result<(), BooleanError> {
        ProgressMonitor::check(self.monitor)?;
        let vertices = self.vertices.load(Ordering::Relaxed);
        let needed = self.segments.saturating_mul(BYTES_PER_SEGMENT);
        if needed.saturating_add(vertices.saturating_mul(BYTES_PER_VERTEX)) > self.limit {
            return Err(BooleanError::Memory { edges: self.segments, crossings: vertices, limit: self.limit });
        }
        Ok(())
    }
}
