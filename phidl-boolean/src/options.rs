//! How an operation is run. None of these options changes the result.

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::ThreadPool;

use crate::{error::BooleanError, progress::ProgressMonitor};

/// Vertices per strip of large operations; `benches/boolean.rs` compares other values. Narrower strips share more
/// segments, wider ones leave the caches.
const STRIP_VERTICES: usize = 8_000;

/// Fewest vertices per strip of small operations.
const FEWEST_STRIP_VERTICES: usize = 1_000;

/// Most strips of small operations; enough to keep all threads busy.
const ENOUGH_STRIPS: usize = 16;

/// Default limit of memory (bytes).
const DEFAULT_MEMORY: usize = 16_000_000_000;

/// How many strips the plane is divided into for the threads. The result does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StripCount {
    /// Chosen from the number of vertices, never from the number of threads.
    #[default]
    Automatic,
    /// About this many vertices per strip; more than zero.
    VerticesPerStrip(usize),
    /// About this many strips; more than zero. Fewer where long edges would be in many of them.
    Fixed(usize),
}

impl StripCount {
    /// Number of strips for `edges` edges, at least one.
    pub(crate) fn strips(self, edges: usize) -> usize {
        match self {
            Self::Automatic => {
                let few = (edges / FEWEST_STRIP_VERTICES).min(ENOUGH_STRIPS);
                few.max(edges / STRIP_VERTICES).max(1)
            }
            Self::VerticesPerStrip(vertices) => edges.div_ceil(vertices).max(1),
            Self::Fixed(strips) => strips.min(edges.max(1)),
        }
    }
}

/// How to run an operation: strips, threads, progress and cancellation.
///
/// The result is the same, point for point and in the same order, for all values.
///
/// # Examples
/// ```
/// use phidl_boolean::RunOptions;
/// let one_thread = RunOptions { threads: Some(1), ..RunOptions::default() };
/// ```
#[derive(Clone, Copy)]
pub struct RunOptions<'a> {
    /// How many strips the plane is divided into.
    pub strips: StripCount,
    /// Number of threads, more than zero; `None` means the current rayon pool (one thread per core). A pool of a given
    /// number of threads is kept until another number is requested.
    pub threads: Option<usize>,
    /// The most memory (bytes) that the lists of an operation may need, as estimated from the edges and crossings; beyond
    /// it, the operation is refused or stopped with [`BooleanError::Memory`]. The default is 16 GB.
    pub memory_limit: usize,
    /// Receives progress and can cancel.
    pub monitor: Option<&'a ProgressMonitor>,
}

impl Default for RunOptions<'_> {
    fn default() -> Self {
        Self { strips: StripCount::Automatic, threads: None, memory_limit: DEFAULT_MEMORY, monitor: None }
    }
}

impl fmt::Debug for RunOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunOptions")
            .field("strips", &self.strips)
            .field("threads", &self.threads)
            .field("memory_limit", &self.memory_limit)
            .field("monitored", &self.monitor.is_some())
            .finish()
    }
}

impl RunOptions<'_> {
    pub(crate) fn check(&self) -> Result<(), BooleanError> {
        let rule = "at least 1";
        if let StripCount::VerticesPerStrip(0) | StripCount::Fixed(0) = self.strips {
            return Err(BooleanError::Option { option: "strips", value: 0.0, rule });
        }
        if self.threads == Some(0) {
            return Err(BooleanError::Option { option: "threads", value: 0.0, rule });
        }
        Ok(())
    }

    /// Runs `work` on the requested threads.
    pub(crate) fn on_threads<T: Send>(
        &self,
        work: impl FnOnce() -> Result<T, BooleanError> + Send,
    ) -> Result<T, BooleanError> {
        match self.threads {
            None => work(),
            Some(threads) => pool(threads)?.install(work),
        }
    }
}

/// The last requested thread pool. It is kept because its threads reuse their memory: fresh pages from the operating
/// system take a twentieth of an operation.
static LAST_POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

fn pool(threads: usize) -> Result<Arc<ThreadPool>, BooleanError> {
    let mut last = LAST_POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(pool) = last.as_ref().filter(|pool| pool.current_num_threads() == threads) {
        return Ok(Arc::clone(pool));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| BooleanError::Threads { threads, reason: error.to_string() })?;
    Ok(Arc::clone(last.insert(Arc::new(pool))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_operations_are_not_divided_and_medium_ones_keep_the_threads_busy() {
        let strips = [0, 1_999, 5_000, 52_000, 520_000].map(|edges| StripCount::Automatic.strips(edges));
        assert_eq!(strips, [1, 1, 5, 16, 65]);
    }

    #[test]
    fn zero_threads_and_zero_strips_are_refused() {
        assert!(RunOptions { threads: Some(0), ..RunOptions::default() }.check().is_err());
        for strips in [StripCount::VerticesPerStrip(0), StripCount::Fixed(0)] {
            assert!(RunOptions { strips, ..RunOptions::default() }.check().is_err());
        }
        assert!(RunOptions::default().check().is_ok());
    }
}
