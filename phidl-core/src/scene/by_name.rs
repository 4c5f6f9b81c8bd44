//! [`ByName`]: things with names of their own, in the order in which they were added.
//!
//! Nearly every cell has a handful of ports and aliases, for which looking through a list is quicker than any table. So
//! a table of places is kept only where there are many. A map from names would hold every name twice, and costs three
//! allocations for two ports.

use std::collections::HashMap;

use rustc_hash::FxBuildHasher;
use smol_str::SmolStr;

use crate::port::Port;

/// So many things are looked through.
const FEW: usize = 16;

/// What has a name.
pub(crate) trait Named {
    fn name(&self) -> &SmolStr;
}

impl Named for Port {
    fn name(&self) -> &SmolStr {
        self.short_name()
    }
}

/// Things with different names.
#[derive(Debug, Clone)]
pub(crate) struct ByName<T> {
    things: Vec<T>,
    /// Where each name is, if they are more than a few. Names come from the program itself: nobody makes them collide.
    places: HashMap<SmolStr, usize, FxBuildHasher>,
}

impl<T> Default for ByName<T> {
    fn default() -> Self {
        Self { things: Vec::new(), places: HashMap::default() }
    }
}

impl<T: Named> ByName<T> {
    pub(crate) fn len(&self) -> usize {
        self.things.len()
    }

    pub(crate) fn iter(&self) -> std::slice::Iter<'_, T> {
        self.things.iter()
    }

    /// The things, to be changed in all but their names.
    pub(crate) fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.things.iter_mut()
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.things.iter().map(|thing| thing.name().as_str())
    }

    pub(crate) fn place(&self, name: &str) -> Option<usize> {
        match self.places.is_empty() {
            true => self.things.iter().position(|thing| thing.name() == name),
            false => self.places.get(name).copied(),
        }
    }

    pub(crate) fn get(&self, name: &str) -> Option<&T> {
        self.place(name).map(|place| &self.things[place])
    }

    /// Appends a thing; gives it back if its name is taken.
    pub(crate) fn push(&mut self, thing: T) -> Result<(), T> {
        if self.place(thing.name()).is_some() {
            return Err(thing);
        }
        if !self.places.is_empty() {
            self.places.insert(thing.name().clone(), self.things.len());
        }
        self.things.push(thing);
        if self.things.len() == FEW + 1 {
            self.note_places();
        }
        Ok(())
    }

    /// Keeps the things for which the test holds, which may change them in all but their names.
    pub(crate) fn retain(&mut self, keep: impl FnMut(&mut T) -> bool) {
        self.things.retain_mut(keep);
        self.note_places();
    }

    /// Puts another thing, whose name is not that of a third, at a place.
    pub(crate) fn replace(&mut self, place: usize, thing: T) {
        self.things[place] = thing;
        self.note_places();
    }

    fn note_places(&mut self) {
        self.places.clear();
        if self.things.len() > FEW {
            self.places.extend(self.things.iter().enumerate().map(|(place, thing)| (thing.name().clone(), place)));
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
    fn things_are_found_by_name_in_order_however_many_they_are() {
        for count in [3, FEW, FEW + 1, 100] {
            let name = |i: usize| SmolStr::from(format!("n{i}"));
            let mut names = ByName::default();
            assert!((0..count).all(|i| names.push(name(i)).is_ok()) && names.push(name(1)).is_err());
            names.replace(2, "other".into());
            names.retain(|name| name != "n0");
            names.push(name(0)).unwrap();
            let due: Vec<SmolStr> =
                [name(1), "other".into()].into_iter().chain((3..count).map(name)).chain([name(0)]).collect();
            assert!(names.names().eq(due.iter().map(SmolStr::as_str)), "{count}");
            assert!(due.iter().enumerate().all(|(place, name)| names.place(name) == Some(place)), "{count}");
            assert_eq!((names.place("n2"), names.get("other").is_some()), (None, true));
        }
    }
}
