//! [`CellNames`]: each cell name once, so that a placement refers to its cell by a number of four bytes.

use std::collections::HashMap;

/// The number of a cell name in a [`CellNames`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(u32);

impl CellId {
    /// The index of the name, for tables by cell.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The cell names of a layout, numbered in the order in which they were first seen.
#[derive(Debug, Clone, Default)]
pub struct CellNames {
    names: Vec<Box<str>>,
    ids: HashMap<Box<str>, CellId>,
}

impl CellNames {
    /// The number of a name; a new name gets the next number.
    ///
    /// # Panics
    /// At 2³² names, for which no file has room.
    pub fn intern(&mut self, name: &str) -> CellId {
        if let Some(id) = self.ids.get(name) {
            return *id;
        }
        let id = CellId(u32::try_from(self.names.len()).expect("invariant: a file has fewer than 2³² names"));
        self.names.push(name.into());
        self.ids.insert(name.into(), id);
        id
    }

    /// The number of a name that is known.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<CellId> {
        self.ids.get(name).copied()
    }

    /// The number of the name at an index.
    pub(crate) fn id(&self, index: usize) -> CellId {
        CellId(u32::try_from(index).expect("invariant: a file has fewer than 2³² names"))
    }

    /// The name of a number.
    ///
    /// # Panics
    /// If the number belongs to another list of names.
    #[must_use]
    pub fn name(&self, id: CellId) -> &str {
        &self.names[id.index()]
    }

    /// The names in the order of their numbers.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &str> {
        self.names.iter().map(AsRef::as_ref)
    }

    /// How many names there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is no name.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }
}
