//! Aliases of an open cell: names for its elements.
//!
//! `d["name"] = pad.place()` adds a reference under a name, as `D['name'] = D.add_ref(pad)` does in PHIDL. To make that
//! possible, writing to a name that does not exist adds a placeholder. A placeholder that was not assigned to, since the
//! name was misspelled, is an error of `build` and `check`.

use std::ops::{Index, IndexMut};
use std::sync::OnceLock;

use smol_str::SmolStr;

use super::cell::Alias;
use super::{Cell, Device, DeviceBuilder, Key, Reference, ReferenceKey};
use crate::error::{Error, ItemKind, Result};

/// The cell of placeholders, which is in no finished cell.
fn placeholder() -> &'static Device {
    static PLACEHOLDER: OnceLock<Device> = OnceLock::new();
    PLACEHOLDER.get_or_init(|| Device::from_cell(Cell { name: SmolStr::new("placeholder"), ..Cell::default() }))
}

impl DeviceBuilder {
    /// Adds a reference under an alias: `d["alias"]` is the reference from then on.
    ///
    /// An alias that is taken is a deferred error.
    pub fn add_as(&mut self, alias: &str, reference: impl Into<Reference>) -> ReferenceKey {
        let key = self.add(reference.into());
        let named = self.alias(alias, key).map(drop);
        self.defer_result(named);
        key
    }

    /// Gives an element of this cell a name. Names of references are part of the finished cell; those of polygons and
    /// labels are for the open cell only.
    ///
    /// # Errors
    /// [`Error::Duplicate`] if the name is taken; [`Error::Removed`], [`Error::ForeignKey`].
    pub fn alias(&mut self, name: &str, key: impl Into<Key>) -> Result<&mut Self> {
        let key = key.into();
        let taken = self.aliases.contains_key(name) || self.cell.aliases.index_of(name).is_some();
        if taken {
            return Err(Error::Duplicate {
                device: self.cell.name.as_str().into(),
                kind: ItemKind::Alias,
                name: name.into(),
            });
        }
        self.bbox_of_key(key)?;
        if let Key::Reference(key) = key {
            let index = self.reference_index(key)?;
            let _ = self.cell.aliases.push(Alias { name: SmolStr::new(name), index });
        } else {
            self.aliases.insert(SmolStr::new(name), key);
        }
        Ok(self)
    }

    /// The key of the element with an alias.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that exist.
    pub fn key(&self, alias: &str) -> Result<Key> {
        match self.aliases.get(alias) {
            Some(key) => Ok(*key),
            None => Ok(self.alias_key(alias)?.into()),
        }
    }

    /// The reference under an alias.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that exist.
    pub fn get(&self, alias: &str) -> Result<&Reference> {
        Ok(&self.cell.references[self.alias_index(alias)?])
    }

    /// The reference under an alias, to be changed.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that exist.
    pub fn get_mut(&mut self, alias: &str) -> Result<&mut Reference> {
        let index = self.alias_index(alias)?;
        Ok(&mut self.cell.references[index])
    }

    pub(super) fn alias_key(&self, alias: &str) -> Result<ReferenceKey> {
        let index = self.alias_index(alias)?;
        let key = self.reference_keys().nth(index);
        Ok(key.expect("invariant: every reference has a key"))
    }

    fn alias_index(&self, alias: &str) -> Result<usize> {
        let index = self.cell.alias(alias)?;
        if self.cell.references[index].device().same_cell(placeholder()) {
            Err(self.unknown_alias(alias))
        } else {
            Ok(index)
        }
    }

    fn unknown_alias(&self, alias: &str) -> Error {
        let assigned = |alias: &&Alias| !self.cell.references[alias.index].device().same_cell(placeholder());
        let references = self.cell.aliases.iter().filter(assigned).map(|alias| alias.name.as_str());
        self.cell.unknown(ItemKind::Alias, alias, references.chain(self.aliases.keys().map(SmolStr::as_str)))
    }

    /// Refuses placeholders.
    pub(super) fn check_aliases(&self) -> Result<()> {
        self.cell.aliases.iter().try_for_each(|alias| self.alias_index(&alias.name).map(drop))
    }
}

impl Index<&str> for DeviceBuilder {
    type Output = Reference;

    fn index(&self, alias: &str) -> &Reference {
        match self.get(alias) {
            Ok(reference) => reference,
            Err(error) => panic!("{error}"),
        }
    }
}

impl IndexMut<&str> for DeviceBuilder {
    /// Adds a reference to be assigned if there is none of this name. If nothing is assigned, `build` is an error.
    fn index_mut(&mut self, alias: &str) -> &mut Reference {
        let index = self.cell.aliases.index_of(alias).unwrap_or_else(|| {
            self.add_as(alias, placeholder());
            self.cell.references.len() - 1
        });
        &mut self.cell.references[index]
    }
}
