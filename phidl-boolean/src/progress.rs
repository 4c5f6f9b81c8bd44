//! Watching and stopping a long operation.
//!
//! A [`Watch`] is shared by the caller and the engine. The engine asks it between strips, so cancelling takes effect
//! after the strips that are already running, a few milliseconds later. Polling instead of a channel keeps the engine
//! free of threads of its own.

use std::{
    fmt,
    sync::atomic::{AtomicBool, Ordering},
};

use crate::error::BooleanError;

/// How far an operation has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Steps that are finished.
    pub done: usize,
    /// Steps of the present stage; offsets run through several stages and count anew in each.
    pub total: usize,
}

type Report = Box<dyn Fn(Progress) + Send + Sync>;

/// Receives progress and can cancel the operation it is handed to.
///
/// # Examples
/// ```
/// use phidl_boolean::{BooleanError, Operation, RunOptions, Watch};
/// use phidl_boolean::grid::{Contours, boolean};
/// let watch = Watch::new();
/// watch.cancel();
/// let options = RunOptions { watch: Some(&watch), ..RunOptions::default() };
/// let stopped = boolean(&Contours::new(), &Contours::new(), Operation::Or, &options);
/// assert_eq!(stopped, Err(BooleanError::Cancelled));
/// ```
#[derive(Default)]
pub struct Watch {
    cancelled: AtomicBool,
    report: Option<Report>,
}

impl Watch {
    /// A watch that only serves to cancel.
    pub fn new() -> Self {
        Self::default()
    }

    /// A watch that calls `report` as the work advances, from any of the working threads.
    pub fn with_report(report: impl Fn(Progress) + Send + Sync + 'static) -> Self {
        Self { cancelled: AtomicBool::new(false), report: Some(Box::new(report)) }
    }

    /// Asks the operation to stop with [`BooleanError::Cancelled`]. The watch stays cancelled.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// True after [`Watch::cancel`].
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    pub(crate) fn check(watch: Option<&Self>) -> Result<(), BooleanError> {
        if watch.is_some_and(Self::is_cancelled) { Err(BooleanError::Cancelled) } else { Ok(()) }
    }

    pub(crate) fn report(&self, progress: Progress) {
        if let Some(report) = &self.report {
            report(progress);
        }
    }
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch")
            .field("cancelled", &self.is_cancelled())
            .field("reports", &self.report.is_some())
            .finish()
    }
}
