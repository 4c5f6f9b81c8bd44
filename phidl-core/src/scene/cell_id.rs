//! [`CellId`]: which open cell made a key.

use std::sync::atomic::{AtomicU64, Ordering};

/// The identity of an open cell within a run of the program, with the beginning of its name for error texts. A key
/// is `Copy`, so the name is kept in place.
#[derive(Clone, Copy)]
pub(super) struct CellId {
    id: u64,
    name: [u8; NAME],
}

/// Bytes of the name that are kept.
const NAME: usize = 24;

/// Threads take identities in blocks, so that they do not contend for one counter.
const BLOCK: u64 = 1024;

static NEXT_BLOCK: AtomicU64 = AtomicU64::new(0);

thread_local! {
    static NEXT: std::cell::Cell<u64> = const { std::cell::Cell::new(0) };
}

impl CellId {
    /// The identity of a cell that is opened now.
    pub(super) fn new(name: &str) -> Self {
        let mut id = NEXT.get();
        if id.is_multiple_of(BLOCK) {
            id = NEXT_BLOCK.fetch_add(BLOCK, Ordering::Relaxed);
        }
        NEXT.set(id + 1);
        Self { id, name: shortened(name) }
    }

    /// The same identity after the cell got another name.
    pub(super) fn renamed(self, name: &str) -> Self {
        Self { name: shortened(name), ..self }
    }

    /// The name of the cell; of a long one, the beginning.
    pub(super) fn name(&self) -> String {
        let end = self.name.iter().position(|byte| *byte == 0).unwrap_or(NAME);
        String::from_utf8_lossy(&self.name[..end]).into_owned()
    }
}

fn shortened(name: &str) -> [u8; NAME] {
    const CUT: &str = "…";
    let mut bytes = [0; NAME];
    if name.len() <= NAME {
        bytes[..name.len()].copy_from_slice(name.as_bytes());
    } else {
        let end = name.floor_char_boundary(NAME - CUT.len());
        bytes[..end].copy_from_slice(&name.as_bytes()[..end]);
        bytes[end..end + CUT.len()].copy_from_slice(CUT.as_bytes());
    }
    bytes
}

impl PartialEq for CellId {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for CellId {}

impl std::hash::Hash for CellId {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.id.hash(state);
    }
}

impl PartialOrd for CellId {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for CellId {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.id.cmp(&other.id)
    }
}

impl std::fmt::Debug for CellId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?}", self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identities_differ_also_between_threads_and_long_names_are_cut() {
        let of_a_thread = || (0..2000).map(|_| CellId::new("a")).collect::<Vec<_>>();
        let other = std::thread::spawn(of_a_thread);
        let mut all = of_a_thread();
        all.extend(other.join().unwrap());
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), 4000);
        assert_eq!(CellId::new("ring").name(), "ring");
        assert_eq!(CellId::new(&"é".repeat(20)).name(), "é".repeat(10) + "…");
    }
}
