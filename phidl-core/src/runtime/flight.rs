//! Cells that are being drawn: who draws what, and who waits for whom.
//!
//! Every thread has a stack of the bodies it runs, and waits for at most one cell of another thread. A thread that is
//! about to wait first follows the waiting from owner to owner; if the way leads back to itself, the generators need
//! each other in a circle, and waiting would never end. A body that starts threads of its own and asks from them for
//! the very cell that it draws is out of sight here, and hangs.

use std::collections::HashMap;
use std::sync::{Arc, Condvar, OnceLock, PoisonError};
use std::thread::{self, ThreadId};

use rustc_hash::FxBuildHasher;

use super::Entry;
use super::cache::{State, lock};
use super::key::Key;
use crate::error::{Error, Result};
use crate::scene::Device;

/// All cells that are being drawn.
#[derive(Default)]
pub(super) struct Flights {
    /// Those that are drawn for the cache.
    by_key: HashMap<Key, Arc<Flight>, FxBuildHasher>,
    /// What each thread draws, outermost first.
    stacks: HashMap<ThreadId, Vec<Frame>, FxBuildHasher>,
    /// The cell that a thread waits for.
    waiting: HashMap<ThreadId, Key, FxBuildHasher>,
}

/// A cell that is drawn for the cache.
struct Flight {
    thread: ThreadId,
    /// Set at the end; `None` if the body panicked.
    outcome: OnceLock<Option<Result<Device>>>,
    ended: Condvar,
}

/// A body that runs.
struct Frame {
    key: Key,
    entry: &'static Entry,
}

/// What a call for a cell is to do.
pub(super) enum Turn {
    /// Take the cell.
    Done(Device),
    /// Draw the cell for everyone.
    Draw(Drawing),
    /// Ask again: the body panicked in the thread that was waited for.
    Again,
}

/// Asks for a cell, and waits if another thread is drawing it.
pub(super) fn request(key: &Key, entry: &'static Entry) -> Result<Turn> {
    let mut state = lock();
    if let Some(device) = state.hit(key) {
        return Ok(Turn::Done(device));
    }
    let me = thread::current().id();
    let Some(flight) = state.flights.by_key.get(key).cloned() else {
        state.stats.misses += 1;
        return Ok(Turn::Draw(state.flights.start(me, key, entry)));
    };
    state.flights.refuse_circle(me, key)?;
    state.flights.waiting.insert(me, key.clone());
    while flight.outcome.get().is_none() {
        state = flight.ended.wait(state).unwrap_or_else(PoisonError::into_inner);
    }
    state.flights.waiting.remove(&me);
    match flight.outcome.get() {
        Some(Some(Ok(device))) => {
            state.stats.hits += 1;
            Ok(Turn::Done(device.clone()))
        }
        Some(Some(Err(error))) => Err(error.clone()),
        _ => Ok(Turn::Again),
    }
}

/// Notes that this thread draws a cell which nobody else will get.
pub(super) fn request_uncached(key: &Key, entry: &'static Entry) -> Result<Drawing> {
    let me = thread::current().id();
    let flights = &mut lock().flights;
    let stack = flights.stacks.entry(me).or_default();
    if let Some(first) = stack.iter().position(|frame| frame.key == *key) {
        let names = stack[first..].iter().map(|frame| frame.entry.name);
        return Err(Error::Circle { chain: names.chain([entry.name]).map(str::to_owned).collect() });
    }
    stack.push(Frame { key: key.clone(), entry });
    Ok(Drawing { key: key.clone(), flight: None })
}

/// What this thread is drawing, innermost first, until `find` has found something.
pub(super) fn search_own_stack<T>(find: impl FnMut(&'static Entry) -> Option<T>) -> Option<T> {
    let state = lock();
    let stack = state.flights.stacks.get(&thread::current().id())?;
    stack.iter().rev().map(|frame| frame.entry).find_map(find)
}

impl Flights {
    fn start(&mut self, me: ThreadId, key: &Key, entry: &'static Entry) -> Drawing {
        let flight = Arc::new(Flight { thread: me, outcome: OnceLock::new(), ended: Condvar::new() });
        self.by_key.insert(key.clone(), Arc::clone(&flight));
        self.stacks.entry(me).or_default().push(Frame { key: key.clone(), entry });
        Drawing { key: key.clone(), flight: Some(flight) }
    }

    /// Refuses to wait for a cell whose drawing waits for this thread.
    fn refuse_circle(&self, me: ThreadId, wanted: &Key) -> Result<()> {
        let mut chain = Vec::new();
        let mut key = wanted;
        while let Some(flight) = self.by_key.get(key) {
            let stack = self.stacks.get(&flight.thread).map(Vec::as_slice).unwrap_or_default();
            let above = stack.iter().skip_while(|frame| frame.key != *key);
            chain.extend(above.map(|frame| frame.entry.name.to_owned()));
            if flight.thread == me {
                chain.extend(chain.first().cloned());
                return Err(Error::Circle { chain });
            }
            match self.waiting.get(&flight.thread) {
                Some(next) => key = next,
                None => return Ok(()),
            }
        }
        Ok(())
    }

    /// Takes the innermost body from the stack of a thread.
    fn pop(&mut self, thread: ThreadId) {
        if let Some(stack) = self.stacks.get_mut(&thread) {
            stack.pop();
            if stack.is_empty() {
                self.stacks.remove(&thread);
            }
        }
    }
}

/// The right and the duty to draw a cell. Dropped without an end (by a panic), it releases those who wait.
pub(super) struct Drawing {
    key: Key,
    /// None if nobody else gets the cell.
    flight: Option<Arc<Flight>>,
}

impl Drawing {
    /// Ends the drawing: keeps the cell and gives it, or the failure, to those who wait.
    pub(super) fn end(mut self, result: Result<Device>) -> Result<Device> {
        if let Some(flight) = self.flight.take() {
            let mut state = lock();
            if let Ok(device) = &result {
                state.keep(self.key.clone(), device.clone());
            }
            land(&mut state, &self.key, &flight, Some(result.clone()));
        }
        result
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        let mut state = lock();
        if let Some(flight) = self.flight.take() {
            land(&mut state, &self.key, &flight, None);
        }
        state.flights.pop(thread::current().id());
    }
}

fn land(state: &mut State, key: &Key, flight: &Flight, outcome: Option<Result<Device>>) {
    state.flights.by_key.remove(key);
    // Set once: a flight ends with its drawing.
    let _ = flight.outcome.set(outcome);
    flight.ended.notify_all();
}
