//! Drawing a cell: from the cache or by the body, with bounds checked before it.
//!
//! The generic functions are thin shells around ones that are compiled once, so that a hundred generators stay cheap.

use super::flight::{self, Drawing, Turn};
use super::{Generator, GeneratorInfo, ParamValues, stack, worker};
use crate::error::{Error, Result};
use crate::scene::Device;

/// The body with its parameters.
type Body<'a> = dyn Fn() -> Result<Device> + Sync + 'a;

/// The cell with these parameters, from the cache if it is there.
pub(crate) fn build<G: Generator>(params: &G) -> Result<Device> {
    run(flight::request, params.record(), G::entry(), &|| params.clone().draw())
}

/// The cell with these parameters, drawn anew.
pub(crate) fn build_uncached<G: Generator>(params: &G) -> Result<Device> {
    run(flight::request_uncached, params.record(), G::entry(), &|| params.clone().draw())
}

fn run(
    request: fn(ParamValues, &'static GeneratorInfo) -> Result<Turn>,
    mut key: ParamValues,
    entry: &'static GeneratorInfo,
    body: &Body<'_>,
) -> Result<Device> {
    let draw = |drawing: Drawing| drawing.end(draw(entry, body));
    loop {
        match request(key, entry)? {
            Turn::Done(device) => return Ok(device),
            Turn::Draw(drawing) => return draw(drawing),
            Turn::DrawApart(key, end) => {
                let drawn = worker::apart(&|| draw(flight::start_apart(key.clone(), entry, &end)));
                // It may be no circle at all, but without a thread there is no way to find out.
                return drawn.unwrap_or_else(|| Err(Error::CyclicDependency { chain: vec![entry.name.to_owned(); 2] }));
            }
            Turn::Again(same) => key = same,
        }
    }
}

fn draw(entry: &'static GeneratorInfo, body: &Body<'_>) -> Result<Device> {
    stack::check_bounds()?;
    body().map_err(|error| match error.owner() {
        Some(owner) if owner != entry.name => error.within(entry.name),
        _ => error,
    })
}
