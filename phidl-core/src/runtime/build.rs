//! Building a cell: from the cache, or by the body after its parameters were checked.
//!
//! A cell is computed once for the process, with one exception: threads that ask for the same cell while it is not
//! there each run the body, and the first finished cell is kept for all of them. Bodies depend on their parameters
//! only, so the cells are equal. The alternative, waiting for the thread that was first, was built and given up: it
//! needs a graph of who waits for whom, and a worker of rayon that waits inside a stolen job can wait for itself.
//!
//! The generic functions are thin shells around ones that are compiled once, so that a hundred generators stay cheap.

use super::{Generator, GeneratorInfo, ParamValues, cache, stack};
use crate::error::Result;
use crate::scene::Device;

/// The cell with these parameters, from the cache if it is there.
pub(crate) fn build<G: Generator>(params: &G) -> Result<Device> {
    run(params.record(), G::entry(), &|| params.clone().draw())
}

fn run(key: ParamValues, info: &'static GeneratorInfo, body: &dyn Fn() -> Result<Device>) -> Result<Device> {
    let cached = info.is_cached() && !cache::is_bypassed();
    if cached && let Some(device) = cache::get(&key) {
        return Ok(device);
    }
    let running = stack::enter(&key, info)?;
    info.check_bounds(&key)?;
    let drawn = body().map_err(|error| match error.owner() {
        Some(owner) if owner != info.name => error.within(info.name),
        _ => error,
    });
    drop(running);
    let device = drawn?.with_source(info.source(key.clone()));
    Ok(if cached { cache::keep_first(&key, device) } else { device })
}
