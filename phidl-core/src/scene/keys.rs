//! Keys to what stands in an open cell.
//!
//! `add` returns a key and not a borrow, so that the next thing can be added. A key stays good when other things are
//! removed; the key of a removed thing finds nothing any more.

/// Where a reference of an open cell is found again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ReferenceKey(pub(crate) usize);

/// Where a polygon of an open cell is found again. A polygon on several layers has one key for all its copies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PolygonKey {
    pub(crate) first: usize,
    pub(crate) copies: usize,
}

/// Where a label of an open cell is found again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LabelKey(pub(crate) usize);

/// The key of anything that has a place in an open cell.
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

/// Which of the things ever added are gone. Things are stored without holes; this turns the number under which a thing
/// was added into its present place.
#[derive(Debug, Clone, Default)]
pub(crate) struct Removals {
    /// Numbers of removed things, ascending.
    gone: Vec<usize>,
}

impl Removals {
    /// The present place of the thing that was added under `number`.
    pub(crate) fn place(&self, number: usize) -> Option<usize> {
        match self.gone.binary_search(&number) {
            Ok(_) => None,
            Err(before) => Some(number - before),
        }
    }

    /// The number that the next thing gets when `stored` things are there.
    pub(crate) fn next_number(&self, stored: usize) -> usize {
        stored + self.gone.len()
    }

    /// Notes that the thing at a present place goes.
    pub(crate) fn remove_place(&mut self, place: usize) {
        // The number is the place plus the removed numbers that lie before it.
        let mut number = place;
        let mut at = 0;
        while at < self.gone.len() && self.gone[at] <= number {
            number += 1;
            at += 1;
        }
        self.gone.insert(at, number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_finding_their_things_while_others_go() {
        let mut things = vec!['a', 'b', 'c', 'd', 'e'];
        let mut removals = Removals::default();
        for gone in ['b', 'a', 'd'] {
            let place = things.iter().position(|t| *t == gone).unwrap();
            removals.remove_place(place);
            things.remove(place);
        }
        let found: Vec<_> = (0..5).map(|n| removals.place(n).map(|p| things[p])).collect();
        assert_eq!(found, [None, None, Some('c'), None, Some('e')]);
        assert_eq!(removals.next_number(things.len()), 5);
    }
}
