//! Keys: handles to the elements of an open cell.
//!
//! `add` returns a key and not a borrow, so that the next element can be added. A key knows the open cell that made it,
//! and stays valid while other elements are removed. The key of a removed element finds nothing.
//!
//! Not a slot map: polygons lie in one flat buffer without holes, and a slot map would add a handle to each of them. A
//! list of removed numbers costs nothing until something is removed.

use super::cell_id::CellId;

/// The key of a reference in an open cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ReferenceKey {
    pub(super) cell: CellId,
    pub(super) number: usize,
}

/// The key of a polygon in an open cell. A polygon on several layers has one key for all its copies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PolygonKey {
    pub(super) cell: CellId,
    pub(super) first: usize,
    pub(super) copies: usize,
}

/// The key of a label in an open cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LabelKey {
    pub(super) cell: CellId,
    pub(super) number: usize,
}

/// The key of any element of an open cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the variants hold what they are called")]
pub enum Key {
    Reference(ReferenceKey),
    Polygon(PolygonKey),
    Label(LabelKey),
}

impl From<ReferenceKey> for Key {
    fn from(key: ReferenceKey) -> Self {
        Self::Reference(key)
    }
}

impl From<PolygonKey> for Key {
    fn from(key: PolygonKey) -> Self {
        Self::Polygon(key)
    }
}

impl From<LabelKey> for Key {
    fn from(key: LabelKey) -> Self {
        Self::Label(key)
    }
}

impl From<&Key> for Key {
    fn from(key: &Key) -> Self {
        *key
    }
}

/// The numbers of removed elements. Every element has the number under which it was added; this turns a number into the
/// present index and back.
#[derive(Debug, Clone, Default)]
pub(super) struct Tombstones {
    /// Ascending.
    removed: Vec<usize>,
}

impl Tombstones {
    /// The present index of the element that was added under `number`.
    pub(super) fn index(&self, number: usize) -> Option<usize> {
        match self.removed.binary_search(&number) {
            Ok(_) => None,
            Err(before) => Some(number - before),
        }
    }

    /// The number of the next element when there are `stored` elements.
    pub(super) fn next_number(&self, stored: usize) -> usize {
        stored + self.removed.len()
    }

    /// The numbers of the `stored` elements, in order.
    pub(super) fn numbers(&self, stored: usize) -> impl Iterator<Item = usize> + '_ {
        let mut removed = self.removed.iter().copied().peekable();
        (0..self.next_number(stored)).filter(move |number| removed.next_if_eq(number).is_none())
    }

    /// Notes the removal of the elements at these present indices, which ascend.
    pub(super) fn remove(&mut self, indices: &[usize]) {
        // The number of an element is its index plus the removed numbers below it.
        let mut merged = Vec::with_capacity(self.removed.len() + indices.len());
        let mut before = 0;
        for index in indices {
            while self.removed.get(before).is_some_and(|number| *number <= index + before) {
                merged.push(self.removed[before]);
                before += 1;
            }
            merged.push(index + before);
        }
        merged.extend_from_slice(&self.removed[before..]);
        self.removed = merged;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_find_their_elements_while_others_are_removed() {
        let mut elements = vec!['a', 'b', 'c', 'd', 'e', 'f'];
        let mut tombstones = Tombstones::default();
        for removed in [&['b'][..], &['a', 'e'], &['d']] {
            let indices: Vec<usize> = removed.iter().filter_map(|r| elements.iter().position(|e| e == r)).collect();
            tombstones.remove(&indices);
            elements.retain(|element| !removed.contains(element));
        }
        let found: Vec<_> = (0..6).map(|number| tombstones.index(number).map(|index| elements[index])).collect();
        assert_eq!(found, [None, None, Some('c'), None, None, Some('f')]);
        assert_eq!(tombstones.numbers(elements.len()).collect::<Vec<_>>(), [2, 5]);
        assert_eq!(tombstones.next_number(elements.len()), 6);
    }
}
