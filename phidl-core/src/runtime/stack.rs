//! What the bodies are that a thread runs, one inside the other.
//!
//! Every thread keeps its own list, so that drawing a cell takes no lock. Others see a copy of it while the thread
//! waits, which is the only time when they ask.

use std::cell::RefCell;

use super::{GeneratorInfo, ParamValues};
use crate::error::Result;

/// A body that runs.
#[derive(Clone)]
pub(super) struct Frame {
    pub(super) key: ParamValues,
    pub(super) entry: &'static GeneratorInfo,
}

thread_local! {
    /// Outermost first.
    static OWN: RefCell<Vec<Frame>> = const { RefCell::new(Vec::new()) };
}

/// Notes that a body begins.
pub(super) fn push(key: ParamValues, entry: &'static GeneratorInfo) {
    OWN.with_borrow_mut(|stack| stack.push(Frame { key, entry }));
}

/// Notes that the innermost body ended.
pub(super) fn pop() -> Option<Frame> {
    OWN.with_borrow_mut(Vec::pop)
}

/// Refuses parameters of the innermost body that are out of their bounds.
pub(super) fn check_bounds() -> Result<()> {
    OWN.with_borrow(|stack| stack.last().map_or(Ok(()), |Frame { key, entry }| entry.check_bounds(key)))
}

/// What this thread is drawing.
pub(super) fn copy() -> Vec<Frame> {
    OWN.with_borrow(Vec::clone)
}

/// The names from a cell upwards and its own once more, if this thread is drawing it.
pub(super) fn circle(key: &ParamValues) -> Option<Vec<String>> {
    OWN.with_borrow(|stack| {
        let place = stack.iter().position(|frame| frame.key == *key)?;
        let names = stack[place..].iter().chain([&stack[place]]);
        Some(names.map(|frame| frame.entry.name.to_owned()).collect())
    })
}

/// The names from a cell upwards.
pub(super) fn names_from(stack: &[Frame], key: &ParamValues) -> Vec<String> {
    stack.iter().skip_while(|frame| frame.key != *key).map(|frame| frame.entry.name.to_owned()).collect()
}
