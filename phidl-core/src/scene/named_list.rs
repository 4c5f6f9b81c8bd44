//! [`NamedList`]: elements with unique names, in the order in which they were added.
//!
//! Not an `IndexMap`: nearly every cell has a handful of ports and aliases, for which a linear search is faster than a
//! hash, and a map holds every name twice and takes three allocations for two ports. A hash table is kept only for long
//! lists.

use std::collections::HashMap;

use rustc_hash::FxBuildHasher;
use smol_str::SmolStr;

use crate::port::Port;

/// Linear search up to this length.
const FEW: usize = 16;

/// An element with a name.
pub(crate) trait Named {
    fn name(&self) -> &SmolStr;
}

impl Named for Port {
    fn name(&self) -> &SmolStr {
        self.short_name()
    }
}

/// Elements with different names.
#[derive(Debug, Clone)]
pub(crate) struct NamedList<T> {
    items: Vec<T>,
    /// The index of each name, if the list is long. Names come from the program itself, so nothing provokes collisions.
    indices: HashMap<SmolStr, usize, FxBuildHasher>,
}

impl<T> Default for NamedList<T> {
    fn default() -> Self {
        Self { items: Vec::new(), indices: HashMap::default() }
    }
}

impl<T: Named> NamedList<T> {
    pub(crate) fn len(&self) -> usize {
        self.items.len()
    }

    pub(crate) fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    /// The items, to be changed in everything but their names.
    pub(crate) fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.items.iter_mut()
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.items.iter().map(|item| item.name().as_str())
    }

    pub(crate) fn index_of(&self, name: &str) -> Option<usize> {
        match self.indices.is_empty() {
            true => self.items.iter().position(|item| item.name() == name),
            false => self.indices.get(name).copied(),
        }
    }

    pub(crate) fn get(&self, name: &str) -> Option<&T> {
        self.index_of(name).map(|index| &self.items[index])
    }

    /// The item at an index, to be changed in everything but its name.
    pub(crate) fn get_mut(&mut self, index: usize) -> &mut T {
        &mut self.items[index]
    }

    /// Appends an item; gives it back if its name is taken.
    pub(crate) fn push(&mut self, item: T) -> Result<(), T> {
        if self.index_of(item.name()).is_some() {
            return Err(item);
        }
        if !self.indices.is_empty() {
            self.indices.insert(item.name().clone(), self.items.len());
        }
        self.items.push(item);
        if self.items.len() == FEW + 1 {
            self.rebuild_indices();
        }
        Ok(())
    }

    /// Keeps the items for which the test holds. The test may change them in everything but their names.
    pub(crate) fn retain(&mut self, keep: impl FnMut(&mut T) -> bool) {
        self.items.retain_mut(keep);
        self.rebuild_indices();
    }

    /// Keeps the first `len` items.
    pub(crate) fn truncate(&mut self, len: usize) {
        self.items.truncate(len);
        self.rebuild_indices();
    }

    /// Replaces an item by one whose name no other item has.
    pub(crate) fn replace(&mut self, index: usize, item: T) {
        self.items[index] = item;
        self.rebuild_indices();
    }

    fn rebuild_indices(&mut self) {
        self.indices.clear();
        if self.items.len() > FEW {
            self.indices.extend(self.items.iter().enumerate().map(|(index, item)| (item.name().clone(), index)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Named for SmolStr {
        fn name(&self) -> &SmolStr {
            self
        }
    }

    #[test]
    fn items_are_found_by_name_and_stay_in_order_in_short_and_long_lists() {
        for count in [3, FEW, FEW + 1, 100] {
            let name = |i: usize| SmolStr::from(format!("n{i}"));
            let mut names = NamedList::default();
            assert!((0..count).all(|i| names.push(name(i)).is_ok()) && names.push(name(1)).is_err());
            names.replace(2, "other".into());
            names.retain(|name| name != "n0");
            names.push(name(0)).unwrap();
            let due: Vec<SmolStr> =
                [name(1), "other".into()].into_iter().chain((3..count).map(name)).chain([name(0)]).collect();
            assert!(names.names().eq(due.iter().map(SmolStr::as_str)), "{count}");
            assert!(due.iter().enumerate().all(|(index, name)| names.index_of(name) == Some(index)), "{count}");
            assert_eq!((names.index_of("n2"), names.get("other").is_some()), (None, true));
        }
    }
}
