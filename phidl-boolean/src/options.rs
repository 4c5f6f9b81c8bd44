//! How an operation is run. None of these options changes the result.

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::ThreadPool;

use crate::{error::BooleanError, progress::Watch};

/// Vertices per strip where there are many; `benches/boolean.rs` compares the neighbors. Narrower strips see more edges
/// twice, wider ones leave the caches.
const STRIP_VERTICES: usize = 8_000;

/// Vertices per strip at least where there are few.
const FEWEST_STRIP_VERTICES: usize = 1_000;

/// Strips that share the work among threads well enough, so that few vertices are divided this far only.
const ENOUGH_STRIPS: usize = 16;

/// How finely the plane is divided for the threads. The result is the same for all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Division {
    /// Into as many strips as the number of vertices suggests, whatever the number of threads.
    #[default]
    Automatic,
    /// Into strips of about this many vertices; more than zero.
    Vertices(usize),
    /// Into about this many strips; more than zero. Fewer where long edges would be in many of them.
    Strips(usize),
}

impl Division {
    /// Number of strips for so many edges, at least one.
    pub(crate) fn strips(self, edges: usize) -> usize {
        match self {
            Self::Automatic => {
                let few = (edges / FEWEST_STRIP_VERTICES).min(ENOUGH_STRIPS);
                few.max(edges / STRIP_VERTICES).max(1)
            }
            Self::Vertices(vertices) => edges.div_ceil(vertices).max(1),
            Self::Strips(strips) => strips.min(edges.max(1)),
        }
    }
}

/// How to run an operation: how finely to divide it, on how many threads, and who watches.
///
/// The result is the same, point for point and in the same order, whatever stands here.
///
/// # Examples
/// ```
/// use phidl_boolean::RunOptions;
/// let one_thread = RunOptions { threads: Some(1), ..RunOptions::default() };
/// ```
#[derive(Clone, Copy, Default)]
pub struct RunOptions<'a> {
    /// How finely the plane is divided.
    pub division: Division,
    /// Number of threads, more than zero; `None` means the current rayon pool (one thread per core). Threads asked for by
    /// number are kept until another number is asked for.
    pub threads: Option<usize>,
    /// Receives progress and can cancel.
    pub watch: Option<&'a Watch>,
}

impl fmt::Debug for RunOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunOptions")
            .field("division", &self.division)
            .field("threads", &self.threads)
            .field("watched", &self.watch.is_some())
            .finish()
    }
}

impl RunOptions<'_> {
    pub(crate) fn check(&self) -> Result<(), BooleanError> {
        let rule = "at least 1";
        if let Division::Vertices(0) | Division::Strips(0) = self.division {
            return Err(BooleanError::Option { option: "division", value: 0.0, rule });
        }
        if self.threads == Some(0) {
            return Err(BooleanError::Option { option: "threads", value: 0.0, rule });
        }
        Ok(())
    }

    /// Runs `work` on the threads asked for.
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

/// The threads that were asked for last. They are kept, because memory that a thread has used is ready for it again: what
/// the system takes to hand out fresh memory is a twentieth of an operation.
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
    fn few_vertices_are_not_divided_and_some_are_divided_enough_for_threads() {
        let strips = [0, 1_999, 5_000, 52_000, 520_000].map(|edges| Division::Automatic.strips(edges));
        assert_eq!(strips, [1, 1, 5, 16, 65]);
    }

    #[test]
    fn zero_threads_and_zero_strips_are_refused() {
        assert!(RunOptions { threads: Some(0), ..RunOptions::default() }.check().is_err());
        for division in [Division::Vertices(0), Division::Strips(0)] {
            assert!(RunOptions { division, ..RunOptions::default() }.check().is_err());
        }
        assert!(RunOptions::default().check().is_ok());
    }
}
