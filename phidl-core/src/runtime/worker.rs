//! Workers of rayon, which may take up an unrelated job in the middle of a body. See [`flight`](super::flight).

use std::cell::Cell;
use std::sync::{Condvar, MutexGuard};
use std::thread;
#[cfg(feature = "parallel")]
use std::time::Duration;

use super::cache::State;
use super::flight::wait_for;
use crate::error::Result;
use crate::scene::Device;

/// How long a worker waits for a cell of another thread before it draws the cell itself. Longer than nearly every body
/// runs, so that work is seldom done twice; short enough that a program which would hang is only slow.
#[cfg(feature = "parallel")]
const PATIENCE: Duration = Duration::from_millis(100);

thread_local! {
    /// Whether this thread was started by a worker, which waits for it.
    static FOR_A_WORKER: Cell<bool> = const { Cell::new(false) };
}

/// Whether this thread may take up an unrelated job in the middle of a body.
#[cfg(feature = "parallel")]
pub(super) fn is_one() -> bool {
    rayon::current_thread_index().is_some()
}

/// Whether this thread may take up an unrelated job in the middle of a body.
#[cfg(not(feature = "parallel"))]
pub(super) fn is_one() -> bool {
    false
}

/// Waits for a signal, and tells whether to wait on if it was not the right one.
#[cfg(feature = "parallel")]
pub(super) fn wait(ended: &Condvar, state: MutexGuard<'static, State>) -> (MutexGuard<'static, State>, bool) {
    if !is_one() && !FOR_A_WORKER.get() {
        return (wait_for(ended, state), true);
    }
    let (state, timeout) = ended.wait_timeout(state, PATIENCE).unwrap_or_else(std::sync::PoisonError::into_inner);
    (state, !timeout.timed_out())
}

/// Waits for a signal, and tells whether to wait on if it was not the right one.
#[cfg(not(feature = "parallel"))]
pub(super) fn wait(ended: &Condvar, state: MutexGuard<'static, State>) -> (MutexGuard<'static, State>, bool) {
    (wait_for(ended, state), true)
}

/// Runs something on a thread of its own, which takes up no jobs. None if the system has no thread to give.
pub(super) fn apart(work: &(dyn Fn() -> Result<Device> + Sync)) -> Option<Result<Device>> {
    let work = || {
        FOR_A_WORKER.set(true);
        work()
    };
    thread::scope(|scope| {
        let running = thread::Builder::new().spawn_scoped(scope, work).ok()?;
        match running.join() {
            Ok(result) => Some(result),
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}
