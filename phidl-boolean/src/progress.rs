//! Progress and cancellation of a long operation.
//!
//! A [`ProgressMonitor`] is shared by the caller and the engine. The engine polls it between strips, so cancellation takes
//! effect after the strips that are running, a few milliseconds later. Rejected: a channel, which would need a thread of
//! its own.

use std::{
    fmt,
    sync::atomic::{AtomicBool, Ordering},
};

use crate::error::BooleanError;

/// The progress of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Finished steps.
    pub done: usize,
    /// Steps of the current stage; offsets have several stages, each with its own count.
    pub total: usize,
}

type Report = Box<dyn Fn(Progress) + Send + Sync>;

/// Receives the progress of an operation and can cancel it.
///
/// # Examples
/// ```
/// use phidl_boolean::{BooleanError, Operation, RunOptions, ProgressMonitor};
/// use phidl_boolean::grid::{Contours, boolean};
/// let monitor = ProgressMonitor::new();
/// monitor.cancel();
/// let options = RunOptions { monitor: Some(&monitor), ..RunOptions::default() };
/// let stopped = boolean(&Contours::new(), &Contours::new(), Operation::Or, &options);
/// assert_eq!(stopped, Err(BooleanError::Cancelled));
/// ```
#[derive(Default)]
pub struct ProgressMonitor {
    cancelled: AtomicBool,
    report: Option<Report>,
}

impl ProgressMonitor {
    /// A monitor without reports, for cancellation.
    pub fn new() -> Self {
        Self::default()
    }

    /// A monitor that calls `report` after each step, from any of the worker threads.
    pub fn with_report(report: impl Fn(Progress) + Send + Sync + 'static) -> Self {
        Self { cancelled: AtomicBool::new(false), report: Some(Box::new(report)) }
    }

    /// Stops the operation with [`BooleanError::Cancelled`]. The monitor stays cancelled.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// True after [`ProgressMonitor::cancel`].
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    pub(crate) fn check(monitor: Option<&Self>) -> Result<(), BooleanError> {
        if monitor.is_some_and(Self::is_cancelled) { Err(BooleanError::Cancelled) } else { Ok(()) }
    }

    pub(crate) fn report(&self, progress: Progress) {
        if let Some(report) = &self.report {
            report(progress);
        }
    }
}

impl fmt::Debug for ProgressMonitor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ProgressMonitor")
            .field("cancelled", &self.is_cancelled())
            .field("reports", &self.report.is_some())
            .finish()
    }
}
