//! The bodies that a thread runs, one inside the other: here a generator that needs its own cell is found.
//!
//! Every thread keeps its own list, so that drawing a cell takes no lock.
//!
//! A body with a parallel loop in it is a special case (feature `parallel`): while a worker of rayon waits for the loop
//! to end, it may run an unrelated job, which may ask for the very cell that the body is drawing. The job stands on the
//! stack of the body without being part of it, and rayon does not say so. Such a request is drawn once more inside the
//! first one. A cycle of generators repeats itself without end, stolen jobs do not: a worker reports a cycle when the
//! same chain of bodies has repeated [`REPEATS`] times.

use std::cell::RefCell;

use super::{GeneratorInfo, ParamValues};
use crate::error::{Error, Result};

/// How often a chain of bodies repeats itself on a worker of rayon before it counts as a cycle.
const REPEATS: usize = 32;
/// How many bodies may run inside each other, far more than cells are nested in practice, and few enough for the stack
/// of a thread.
const DEEPEST: usize = 256;

/// A body that runs.
struct Frame {
    key: ParamValues,
    info: &'static GeneratorInfo,
}

thread_local! {
    /// Outermost first.
    static BODIES: RefCell<Vec<Frame>> = const { RefCell::new(Vec::new()) };
}

/// Keeps a body on the stack until it is dropped, also by a panic.
pub(super) struct Running(());

impl Drop for Running {
    fn drop(&mut self) {
        BODIES.with_borrow_mut(Vec::pop);
    }
}

/// Puts a body on the stack.
///
/// # Errors
/// The body runs already, or too many do.
pub(super) fn enter(key: &ParamValues, info: &'static GeneratorInfo) -> Result<Running> {
    BODIES.with_borrow_mut(|bodies| {
        if let Some(cycle) = cycle(bodies, key) {
            let names = cycle.iter().chain(cycle.first()).map(|frame| frame.info.name.to_owned());
            return Err(Error::CyclicDependency { chain: names.collect() });
        }
        if bodies.len() == DEEPEST {
            let message = format_args!("generators call each other more than {DEEPEST} levels deep");
            return Err(Error::custom(info.name, message));
        }
        bodies.push(Frame { key: key.clone(), info });
        Ok(Running(()))
    })
}

/// The bodies from a cell upwards, if the cell needs itself.
fn cycle<'a>(bodies: &'a [Frame], key: &ParamValues) -> Option<&'a [Frame]> {
    let start = bodies.iter().rposition(|frame| frame.key == *key)?;
    let cycle = &bodies[start..];
    let same = |chain: &&[Frame]| chain.iter().map(|frame| &frame.key).eq(cycle.iter().map(|frame| &frame.key));
    let needed = if is_worker() { REPEATS } else { 1 };
    (bodies.rchunks(cycle.len()).take_while(same).count() >= needed).then_some(cycle)
}

/// Whether this thread may run an unrelated job in the middle of a body.
#[cfg(feature = "parallel")]
fn is_worker() -> bool {
    rayon::current_thread_index().is_some()
}

/// Whether this thread may run an unrelated job in the middle of a body.
#[cfg(not(feature = "parallel"))]
fn is_worker() -> bool {
    false
}
