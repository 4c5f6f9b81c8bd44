//! Cells that are being drawn: who draws what, and who waits for whom.
//!
//! Every thread has a [stack] of the bodies it runs, and waits for at most one cell of another thread. A thread that is
//! about to wait first follows the waiting from owner to owner; if the way leads back to itself, the generators need
//! each other in a circle, and waiting would never end. A cell that nobody else will get is not in the tables here.
//!
//! A worker of rayon is different (feature `parallel`): while a body on it waits for a parallel loop of its own, the
//! worker may take up an unrelated job that asks for the very cell the body is drawing. That is no circle of
//! generators, and waiting would still never end. So a worker waits with limited patience and then draws the cell
//! itself, and a circle that leads over a worker is looked into by drawing on a thread of its own, which takes up no
//! jobs: a real circle shows itself there. The cell that is finished first is kept for everyone.
//!
//! A body that starts threads by hand and asks from them for the cell that it is drawing is out of sight here; it hangs.

use std::collections::HashMap;
use std::sync::{Arc, Condvar, MutexGuard, OnceLock, PoisonError};
use std::thread::{self, ThreadId};

use rustc_hash::FxBuildHasher;

use super::cache::{State, lock};
use super::stack::{self, Frame};
use super::{GeneratorInfo, ParamValues, worker};
use crate::error::{Error, Result};
use crate::scene::Device;

/// The cells that are being drawn for others, too.
#[derive(Default)]
pub(super) struct Flights {
    /// Those that others may wait for.
    by_key: HashMap<ParamValues, Arc<Flight>, FxBuildHasher>,
    /// What a thread waits for.
    waiting: HashMap<ThreadId, Waiting, FxBuildHasher>,
}

/// A thread that waits.
struct Waiting {
    /// The cell it waits for.
    wanted: ParamValues,
    /// What it draws meanwhile.
    stack: Vec<Frame>,
}

/// A cell that others wait for.
pub(super) struct Flight {
    thread: ThreadId,
    /// Whether the thread may take up unrelated jobs in the middle of a body.
    on_worker: bool,
    /// Set at the end; `None` if the body panicked.
    outcome: OnceLock<Option<Result<Device>>>,
    ended: Condvar,
}

/// What a call for a cell is to do.
pub(super) enum Turn {
    /// Take the cell.
    Done(Device),
    /// Draw the cell.
    Draw(Drawing),
    /// Draw the cell on a thread of its own, with [`start_apart`]: here it is not clear whether it needs itself.
    DrawApart(ParamValues, End),
    /// Ask again: the body panicked in the thread that was waited for.
    Again(ParamValues),
}

/// The way of the waiting, from the wanted cell on.
enum Way {
    /// It ends at a thread that is drawing.
    Open,
    /// It leads back here. These generators need each other.
    Circle(Vec<String>),
    /// It leads back here, but over a worker.
    Unclear,
}

/// Asks for a cell, and waits if another thread is drawing it.
pub(super) fn request(key: ParamValues, entry: &'static GeneratorInfo) -> Result<Turn> {
    let mut state = lock();
    if let Some(device) = state.hit(&key) {
        return Ok(Turn::Done(device));
    }
    if let Some(chain) = stack::circle(&key) {
        return if worker::is_one() {
            Ok(Turn::DrawApart(key, End::Cache))
        } else {
            Err(Error::CyclicDependency { chain })
        };
    }
    let me = this_thread();
    let Some(flight) = state.flights.by_key.get(&key).cloned() else {
        state.stats.misses += 1;
        return Ok(Turn::Draw(state.flights.start(me, key, entry)));
    };
    let waiting = Waiting { wanted: key.clone(), stack: stack::copy() };
    match state.flights.way(me, &waiting) {
        Way::Circle(chain) => Err(Error::CyclicDependency { chain }),
        Way::Unclear => Ok(Turn::Draw(state.draw_again(key, entry))),
        Way::Open => wait(state, me, key, waiting, &flight, entry),
    }
}

fn wait(
    mut state: MutexGuard<'static, State>,
    me: ThreadId,
    key: ParamValues,
    waiting: Waiting,
    flight: &Flight,
    entry: &'static GeneratorInfo,
) -> Result<Turn> {
    state.flights.waiting.insert(me, waiting);
    let mut patient = true;
    while flight.outcome.get().is_none() && patient {
        (state, patient) = worker::wait(&flight.ended, state);
    }
    state.flights.waiting.remove(&me);
    match flight.outcome.get() {
        Some(Some(Ok(device))) => {
            state.stats.hits += 1;
            Ok(Turn::Done(device.clone()))
        }
        Some(Some(Err(error))) => Err(error.clone()),
        Some(None) => Ok(Turn::Again(key)),
        None => Ok(Turn::Draw(state.draw_again(key, entry))),
    }
}

/// Asks to draw a cell which nobody else will get.
pub(super) fn request_uncached(key: ParamValues, entry: &'static GeneratorInfo) -> Result<Turn> {
    match stack::circle(&key) {
        None => Ok(Turn::Draw(Drawing::begin(key, entry, End::Nobody))),
        Some(_) if worker::is_one() => Ok(Turn::DrawApart(key, End::Nobody)),
        Some(chain) => Err(Error::CyclicDependency { chain }),
    }
}

/// Starts to draw a cell that the thread which waits for this one is drawing already.
pub(super) fn start_apart(key: ParamValues, entry: &'static GeneratorInfo, end: &End) -> Drawing {
    Drawing::begin(key, entry, end.clone())
}

impl State {
    /// Draws a cell here that another thread is drawing, too: the one that is finished first is kept.
    fn draw_again(&mut self, key: ParamValues, entry: &'static GeneratorInfo) -> Drawing {
        self.stats.misses += 1;
        Drawing::begin(key, entry, End::Cache)
    }
}

impl Flights {
    fn start(&mut self, me: ThreadId, key: ParamValues, entry: &'static GeneratorInfo) -> Drawing {
        let (outcome, ended) = (OnceLock::new(), Condvar::new());
        let flight = Arc::new(Flight { thread: me, on_worker: worker::is_one(), outcome, ended });
        self.by_key.insert(key.clone(), Arc::clone(&flight));
        Drawing::begin(key, entry, End::Waiting(flight))
    }

    /// Follows the waiting from the cell that this thread is about to wait for.
    fn way(&self, me: ThreadId, own: &Waiting) -> Way {
        let (mut chain, mut clear) = (Vec::new(), !worker::is_one());
        let mut key = &own.wanted;
        while let Some(flight) = self.by_key.get(key) {
            let back = flight.thread == me;
            // Who does not wait is drawing, and will come to an end.
            let Some(waiting) = (if back { Some(own) } else { self.waiting.get(&flight.thread) }) else { break };
            chain.extend(stack::names_from(&waiting.stack, key));
            clear &= !flight.on_worker;
            if back {
                chain.extend(chain.first().cloned());
                return if clear { Way::Circle(chain) } else { Way::Unclear };
            }
            key = &waiting.wanted;
        }
        Way::Open
    }
}

/// The right and the duty to draw a cell, which is the innermost one of this thread. Dropped without an end (by a panic),
/// it releases those who wait.
pub(super) struct Drawing {
    /// Until it has ended.
    end: Option<End>,
}

/// Who gets the cell, apart from the caller.
#[derive(Clone)]
pub(super) enum End {
    /// Nobody.
    Nobody,
    /// The cache.
    Cache,
    /// The cache, and those who wait.
    Waiting(Arc<Flight>),
}

impl Drawing {
    fn begin(key: ParamValues, entry: &'static GeneratorInfo, end: End) -> Self {
        stack::push(key, entry);
        Self { end: Some(end) }
    }

    /// Ends the drawing: records in the cell who drew it, keeps it, and gives it, or the failure, to those who wait.
    ///
    /// Returns the cell that is kept, which is another one if somebody else was first.
    pub(super) fn end(mut self, result: Result<Device>) -> Result<Device> {
        let (end, frame) = (self.end.take(), stack::pop());
        let Frame { key, entry } = frame.expect("invariant: the body that ends is on the stack");
        let signed = |record: ParamValues| result.map(|device| device.with_source(entry.source(record)));
        let Some(end @ (End::Cache | End::Waiting(_))) = end else { return signed(key) };
        let result = signed(key.clone());
        let mut state = lock();
        let result = result.map(|device| state.keep_first(&key, device));
        if let End::Waiting(flight) = end {
            state.flights.land(&key, &flight, Some(result.clone()));
        }
        drop(state); // the key goes without the lock
        result
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        let Some(end) = self.end.take() else { return };
        if let (Some(frame), End::Waiting(flight)) = (stack::pop(), end) {
            lock().flights.land(&frame.key, &flight, None);
        }
    }
}

impl Flights {
    fn land(&mut self, key: &ParamValues, flight: &Flight, outcome: Option<Result<Device>>) {
        self.by_key.remove(key);
        let fresh = flight.outcome.set(outcome);
        debug_assert!(fresh.is_ok(), "invariant: a flight ends with its drawing, once");
        flight.ended.notify_all();
    }
}

/// This thread.
fn this_thread() -> ThreadId {
    thread_local! {
        static ME: ThreadId = thread::current().id();
    }
    ME.with(|me| *me)
}

/// Waits for a signal without limit.
pub(super) fn wait_for(ended: &Condvar, state: MutexGuard<'static, State>) -> MutexGuard<'static, State> {
    ended.wait(state).unwrap_or_else(PoisonError::into_inner)
}
