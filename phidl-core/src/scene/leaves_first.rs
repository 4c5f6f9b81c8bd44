//! Cached properties of a hierarchy, computed from the leaves up, and its release.
//!
//! A chain of cells can be as deep as memory allows: nothing here recurses with the depth of the hierarchy.

use std::cell::{Cell as Slot, RefCell};
use std::collections::BTreeMap;

use super::{Cell, Device, Reference, Source};
use crate::param::Value;

/// Calls `compute` for this cell and every cell below that is not `known`, placed cells before those that place them.
/// `compute` finds what it needs of the placed cells known.
pub(super) fn leaves_first<'a>(
    device: &'a Device,
    children: impl Fn(&'a Device) -> Vec<&'a Device>,
    known: impl Fn(&Device) -> bool,
    compute: impl Fn(&Device),
) {
    let mut stack = vec![(device, false)];
    while let Some((device, visited)) = stack.pop() {
        if known(device) {
            continue;
        }
        if visited {
            compute(device);
            continue;
        }
        stack.push((device, true));
        stack.extend(children(device).into_iter().filter(|child| !known(child)).map(|child| (child, false)));
    }
}

/// The cells that a cell places.
pub(super) fn placed(device: &Device) -> Vec<&Device> {
    device.references().iter().map(Reference::device).collect()
}

/// The cells that a cell places or records as values.
pub(super) fn placed_and_recorded(device: &Device) -> Vec<&Device> {
    let mut devices = placed(device);
    let parameters = device.source().into_iter().flat_map(|source| source.params.iter().map(|(_, value)| value));
    let port_info = device.ports().flat_map(|port| port.info().values());
    let mut values: Vec<&Value> = device.info().values().chain(parameters).chain(port_info).collect();
    while let Some(value) = values.pop() {
        match value {
            Value::Device(device) => devices.push(device),
            Value::List(list) => values.extend(list),
            Value::Map(map) => values.extend(map.values()),
            _ => {}
        }
    }
    devices
}

/// Levels of a hierarchy that are released by recursion. Deeper ones wait until these have returned.
const RECURSION: u32 = 32;

/// What holds other cells in a released cell.
struct Released {
    _references: Vec<Reference>,
    _source: Option<Source>,
    _info: BTreeMap<String, Value>,
}

thread_local! {
    static DEPTH: Slot<u32> = const { Slot::new(0) };
    static WAITING: RefCell<Vec<Released>> = const { RefCell::new(Vec::new()) };
}

/// Releases the cells that a cell holds.
pub(super) fn release(cell: &mut Cell) {
    if cell.references.is_empty() && cell.source.is_none() && cell.info.is_empty() {
        return;
    }
    let depth = DEPTH.get();
    let held = Released {
        _references: std::mem::take(&mut cell.references),
        _source: cell.source.take(),
        _info: std::mem::take(&mut cell.info),
    };
    if depth >= RECURSION {
        // While the thread ends, the list may be gone already; then recursion has to do.
        let _ = WAITING.try_with(|waiting| waiting.borrow_mut().push(held));
        return;
    }
    DEPTH.set(depth + 1);
    drop(held);
    while depth == 0
        && let Some(held) = WAITING.try_with(|waiting| waiting.borrow_mut().pop()).ok().flatten()
    {
        drop(held);
    }
    DEPTH.set(depth);
}
