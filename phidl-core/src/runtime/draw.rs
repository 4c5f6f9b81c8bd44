//! Drawing a cell: from the cache or by the body, with bounds checked before it and the source recorded after it.
//!
//! The generic functions are thin shells around ones that are compiled once, so that a hundred generators stay cheap.

use super::flight::{self, Turn};
use super::key::Key;
use super::{Entry, Generator, Record};
use crate::error::Result;
use crate::scene::{Device, Source};

/// The cell with these parameters, from the cache if it is there.
pub(crate) fn build<G: Generator>(params: &G) -> Result<Device> {
    cached(&Key::of(params), G::entry(), &|| params.clone().draw())
}

/// The cell with these parameters, drawn anew.
pub(crate) fn build_uncached<G: Generator>(params: &G) -> Result<Device> {
    let (key, entry) = (Key::of(params), G::entry());
    let drawing = flight::request_uncached(&key, entry)?;
    let result = draw(entry, &key.record, &|| params.clone().draw());
    drawing.end(result)
}

fn cached(key: &Key, entry: &'static Entry, body: &dyn Fn() -> Result<Device>) -> Result<Device> {
    loop {
        match flight::request(key, entry)? {
            Turn::Done(device) => return Ok(device),
            Turn::Draw(drawing) => return drawing.end(draw(entry, &key.record, body)),
            Turn::Again => {}
        }
    }
}

fn draw(entry: &'static Entry, record: &Record, body: &dyn Fn() -> Result<Device>) -> Result<Device> {
    entry.check_bounds(record)?;
    let device = body().map_err(|error| match error.owner() {
        Some(owner) if owner != entry.name => error.within(entry.name),
        _ => error,
    })?;
    let Entry { name: generator, module, version, .. } = *entry;
    Ok(device.with_source(Source { generator, module, version, params: record.clone() }))
}

/// The unit of a parameter of the generator with this name, if this thread is just drawing it.
pub(crate) fn unit_while_drawing(device: &str, param: &str) -> Option<&'static str> {
    flight::search_own_stack(|entry| (entry.name == device).then_some(entry))?.unit(param)
}
