//! The cache of finished cells: each parameter set of a generator is drawn once for the process.
//!
//! One table under one lock, bounded by bytes; the least recently used cell goes first. A hit holds the lock for a
//! lookup only (the hash is computed before), and a body runs without it. Shards were left out: a lookup is shorter
//! than the drawing of the smallest cell, and one table keeps one exact bound.
//!
//! - Whoever asks for a cell that another thread is drawing waits for it and gets the same cell, or the same failure.
//! - A failure is not stored: the next call runs the body again.
//! - A body that panics releases those who wait; one of them runs the body again.
//! - Waiting in a circle, also across threads, is [`Error::Circle`](crate::Error::Circle) for the thread that would
//!   close the circle.

use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use lru::LruCache;
use rustc_hash::FxBuildHasher;

use super::flight::Flights;
use super::key::Key;
use crate::scene::Device;

/// How many bytes of cells are kept unless [`set_limit`] says otherwise: half a gibibyte.
pub const DEFAULT_LIMIT: usize = 512 << 20;

/// What the cache has done since the program started or the counters were last [cleared](clear).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stats {
    /// Calls that were answered without running a body, those that waited for another thread included.
    pub hits: u64,
    /// Calls that ran a body.
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

/// Keeps at most so many bytes of cells, counted without the cells they refer to. Zero keeps none.
pub fn set_limit(bytes: usize) {
    let mut state = lock();
    state.limit = bytes;
    state.evict();
}

/// Everything that threads share.
pub(super) struct State {
    done: LruCache<Key, Device, FxBuildHasher>,
    limit: usize,
    pub(super) stats: Stats,
    pub(super) flights: Flights,
}

static STATE: LazyLock<Mutex<State>> = LazyLock::new(|| {
    Mutex::new(State {
        done: LruCache::unbounded_with_hasher(FxBuildHasher),
        limit: DEFAULT_LIMIT,
        stats: Stats::default(),
        flights: Flights::default(),
    })
});

/// Nothing panics while the lock is held, and if it did, every table would still be whole.
pub(super) fn lock() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl State {
    /// The finished cell, which becomes the most recently used one.
    pub(super) fn hit(&mut self, key: &Key) -> Option<Device> {
        let device = self.done.get(key)?.clone();
        self.stats.hits += 1;
        Some(device)
    }

    /// Keeps a cell, unless one is kept for the key: that one is returned.
    pub(super) fn keep_first(&mut self, key: &Key, device: Device) -> Device {
        if let Some(first) = self.done.get(key) {
            return first.clone();
        }
        self.stats.bytes += device.own_size();
        self.done.put(key.clone(), device.clone());
        self.evict();
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
