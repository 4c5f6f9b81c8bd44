//! The cache of finished cells, bounded by bytes; the least recently used cell goes first.
//!
//! One table under one lock. A hit holds the lock for a lookup only (the hash is computed before), and no body runs
//! under it. Shards were rejected: a lookup is shorter than the drawing of the smallest cell, and one table keeps one
//! exact bound. So was a crate with single flight: waiting for another thread can deadlock on workers of rayon.
//!
//! - Threads that ask for a cell that is not there each draw it; the first finished cell is kept, and all get that one.
//! - A failure is not stored: the next call runs the body again.
//! - A generator that needs its own cell is [`Error::CyclicDependency`](crate::Error::CyclicDependency).

use std::cell::Cell;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use lru::LruCache;
use rustc_hash::FxBuildHasher;

use super::ParamValues;
use crate::scene::Device;

/// How many bytes of cells are kept unless [`set_limit`] says otherwise: half a gibibyte.
pub const DEFAULT_LIMIT: usize = 512 << 20;

/// What the cache has done since the program started or the counters were last [cleared](clear).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stats {
    /// Calls that found their cell.
    pub hits: u64,
    /// Calls that did not.
    pub misses: u64,
    /// Cells that were dropped to keep the limit.
    pub evictions: u64,
    /// Cells that are kept now.
    pub entries: usize,
    /// About how many bytes they take, without the cells they refer to.
    pub bytes: usize,
}

/// What the cache has done so far.
#[must_use]
pub fn stats() -> Stats {
    let state = lock();
    Stats { entries: state.done.len(), ..state.stats }
}

/// Forgets all cells and counters. Cells that are in use stay as they are.
pub fn clear() {
    let mut state = lock();
    state.stats = Stats::default();
    let cells = std::mem::replace(&mut state.done, LruCache::unbounded_with_hasher(FxBuildHasher));
    drop(state);
    drop(cells); // without the lock: it may take a while
}

/// Keeps at most this many bytes of cells, counted without the cells they refer to. Zero keeps none.
pub fn set_limit(bytes: usize) {
    let mut state = lock();
    state.limit = bytes;
    state.evict();
}

/// Runs `work` without the cache: every cell that it builds on this thread is drawn, also those inside other cells, and
/// none is kept. For measuring what drawing costs.
///
/// ```
/// # use phidl_core::cache;
/// let before = cache::stats();
/// cache::bypass(|| { /* build cells */ });
/// assert_eq!(cache::stats(), before);
/// ```
pub fn bypass<T>(work: impl FnOnce() -> T) -> T {
    /// Ends the bypass, also after a panic.
    struct Restore(bool);
    impl Drop for Restore {
        fn drop(&mut self) {
            BYPASSED.set(self.0);
        }
    }
    let _restore = Restore(BYPASSED.replace(true));
    work()
}

/// Whether this thread is inside [`bypass`].
pub(super) fn is_bypassed() -> bool {
    BYPASSED.get()
}

/// The cell, if it is there.
pub(super) fn get(key: &ParamValues) -> Option<Device> {
    lock().get(key)
}

/// Keeps a cell unless one is kept already, and returns the one that is kept.
pub(super) fn keep_first(key: &ParamValues, device: Device) -> Device {
    lock().keep_first(key, device)
}

struct State {
    done: LruCache<ParamValues, Device, FxBuildHasher>,
    limit: usize,
    stats: Stats,
}

static STATE: LazyLock<Mutex<State>> = LazyLock::new(|| Mutex::new(State::new(DEFAULT_LIMIT)));

thread_local! {
    static BYPASSED: Cell<bool> = const { Cell::new(false) };
}

/// Nothing panics while the lock is held, and if it did, the table would still be whole.
fn lock() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl State {
    fn new(limit: usize) -> Self {
        let done = LruCache::unbounded_with_hasher(FxBuildHasher);
        Self { done, limit, stats: Stats::default() }
    }

    /// The finished cell, which becomes the most recently used one.
    fn get(&mut self, key: &ParamValues) -> Option<Device> {
        let device = self.done.get(key).cloned();
        let counter = if device.is_some() { &mut self.stats.hits } else { &mut self.stats.misses };
        *counter += 1;
        device
    }

    /// Keeps a cell, unless one is kept for the key: that one is returned. A cell that is larger than the limit is not
    /// kept, since all others would have to go for it.
    fn keep_first(&mut self, key: &ParamValues, device: Device) -> Device {
        if let Some(first) = self.done.get(key) {
            return first.clone();
        }
        let size = device.own_size();
        if size <= self.limit {
            self.stats.bytes += size;
            self.done.put(key.clone(), device.clone());
            self.evict();
        }
        device
    }

    fn evict(&mut self) {
        while self.stats.bytes > self.limit {
            let Some((_, oldest)) = self.done.pop_lru() else { return };
            self.stats.bytes -= oldest.own_size();
            self.stats.evictions += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cell with this many points, 16 bytes each.
    fn cell(points: u32) -> Device {
        let mut d = Device::builder("cell");
        let outline: Vec<(u32, u32)> = (0..points).map(|i| (i, i * i)).collect();
        d.add_polygon(outline, 1).unwrap();
        d.build().unwrap()
    }

    fn key(n: u32) -> ParamValues {
        [("n", n.into())].into()
    }

    fn keep(state: &mut State, n: u32, points: u32) -> Device {
        state.keep_first(&key(n), cell(points))
    }

    #[test]
    fn the_least_recently_used_cells_go_when_the_limit_is_reached() {
        let mut state = State::new(3 * cell(1000).own_size());
        for n in 0..3 {
            keep(&mut state, n, 1000);
        }
        assert!(state.get(&key(0)).is_some(), "all three fit, and this one was just used");
        keep(&mut state, 3, 1000);
        let kept: Vec<bool> = (0..4).map(|n| state.get(&key(n)).is_some()).collect();
        assert_eq!(kept, [true, false, true, true]);
        assert_eq!((state.stats.evictions, state.stats.bytes), (1, 3 * cell(1000).own_size()));
    }

    #[test]
    fn a_cell_that_is_too_large_does_not_drive_out_the_others() {
        let mut state = State::new(cell(1000).own_size());
        keep(&mut state, 0, 10);
        keep(&mut state, 1, 2000);
        assert!(state.get(&key(0)).is_some() && state.get(&key(1)).is_none());
    }

    #[test]
    fn the_first_cell_under_a_key_stays() {
        let mut state = State::new(DEFAULT_LIMIT);
        let first = keep(&mut state, 0, 10);
        assert!(keep(&mut state, 0, 10).same_cell(&first));
        assert_eq!(state.stats.bytes, first.own_size());
    }
}
