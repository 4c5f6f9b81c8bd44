//! How an operation is run. None of these options changes the result.

use std::fmt;

use crate::{error::BooleanError, progress::Watch};

/// Vertices per strip when nothing else is asked for; `benches/boolean.rs` compares the neighbors.
const DEFAULT_STRIP_VERTICES: usize = 4_000;

/// How to run an operation: how finely to divide it, on how many threads, and who watches.
///
/// The result is the same, point for point and in the same order, whatever stands here.
///
/// # Examples
/// ```
/// use phidl_boolean::RunOptions;
/// let one_thread = RunOptions { threads: Some(1), ..RunOptions::default() };
/// ```
#[derive(Clone, Copy)]
pub struct RunOptions<'a> {
    /// About how many vertices each strip of the plane gets; more than zero.
    pub strip_vertices: usize,
    /// Number of threads, more than zero; `None` means the current rayon pool (one thread per core).
    pub threads: Option<usize>,
    /// Receives progress and can cancel.
    pub watch: Option<&'a Watch>,
}

impl Default for RunOptions<'_> {
    fn default() -> Self {
        Self { strip_vertices: DEFAULT_STRIP_VERTICES, threads: None, watch: None }
    }
}

impl fmt::Debug for RunOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunOptions")
            .field("strip_vertices", &self.strip_vertices)
            .field("threads", &self.threads)
            .field("watched", &self.watch.is_some())
            .finish()
    }
}

impl RunOptions<'_> {
    pub(crate) fn check(&self) -> Result<(), BooleanError> {
        let rule = "at least 1";
        if self.strip_vertices == 0 {
            return Err(BooleanError::Option { option: "strip_vertices", value: 0.0, rule });
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
        let Some(threads) = self.threads else { return work() };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| BooleanError::Threads { threads, reason: error.to_string() })?;
        pool.install(work)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_threads_and_zero_vertices_are_refused() {
        assert!(RunOptions { threads: Some(0), ..RunOptions::default() }.check().is_err());
        assert!(RunOptions { strip_vertices: 0, ..RunOptions::default() }.check().is_err());
        assert!(RunOptions::default().check().is_ok());
    }
}
