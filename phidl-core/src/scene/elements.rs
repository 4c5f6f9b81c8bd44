//! Reading and reaching the elements of an open cell.

use std::ops::{Index, IndexMut};

use super::{DeviceBuilder, Label, LabelKey, PolygonKey, PolygonView, Reference, ReferenceKey};
use crate::error::{Error, ItemKind, Result};
use crate::port::Port;

impl DeviceBuilder {
    /// A port of this cell.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn port(&self, name: &str) -> Result<&Port> {
        self.cell.port(name)
    }

    /// The ports of this cell, in the order in which they were added.
    pub fn ports(&self) -> impl ExactSizeIterator<Item = &Port> {
        self.cell.ports.iter()
    }

    /// The polygons of this cell itself, in the order in which they were added.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = PolygonView<'_>> {
        self.cell.polygons.iter()
    }

    /// The references of this cell, in the order in which they were added.
    pub fn references(&self) -> impl ExactSizeIterator<Item = &Reference> {
        self.cell.references.iter()
    }

    /// The labels of this cell itself, in the order in which they were added.
    pub fn labels(&self) -> impl ExactSizeIterator<Item = &Label> {
        self.cell.labels.iter()
    }

    /// The reference under a key.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`].
    pub fn reference(&self, key: ReferenceKey) -> Result<&Reference> {
        Ok(&self.cell.references[self.reference_index(key)?])
    }

    /// The reference under a key, to be changed.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`].
    pub fn reference_mut(&mut self, key: ReferenceKey) -> Result<&mut Reference> {
        let index = self.reference_index(key)?;
        Ok(&mut self.cell.references[index])
    }

    /// The polygon under a key; of several copies, the first.
    ///
    /// # Errors
    /// [`Error::Removed`], also for a polygon on no layer; [`Error::ForeignKey`].
    pub fn polygon(&self, key: PolygonKey) -> Result<PolygonView<'_>> {
        let index = self.polygon_indices(key)?.first().copied();
        let removed = || Error::Removed { device: self.cell.name.as_str().into(), kind: ItemKind::Polygon };
        index.map(|index| self.cell.polygons.get(index)).ok_or_else(removed)
    }

    /// The label under a key.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`].
    pub fn label(&self, key: LabelKey) -> Result<&Label> {
        Ok(&self.cell.labels[self.label_index(key)?])
    }

    /// The keys of the references, in the order of [`DeviceBuilder::references`].
    pub fn reference_keys(&self) -> impl Iterator<Item = ReferenceKey> + '_ {
        self.keys.reference_keys(&self.cell)
    }

    /// The keys of the polygons, in the order of [`DeviceBuilder::polygons`]; one for each copy.
    pub fn polygon_keys(&self) -> impl Iterator<Item = PolygonKey> + '_ {
        self.keys.polygon_keys(&self.cell)
    }

    /// The keys of the labels, in the order of [`DeviceBuilder::labels`].
    pub fn label_keys(&self) -> impl Iterator<Item = LabelKey> + '_ {
        self.keys.label_keys(&self.cell)
    }

    pub(super) fn reference_index(&self, key: ReferenceKey) -> Result<usize> {
        self.keys.reference_index(key, &self.cell)
    }

    pub(super) fn label_index(&self, key: LabelKey) -> Result<usize> {
        self.keys.label_index(key, &self.cell)
    }

    pub(super) fn polygon_indices(&self, key: PolygonKey) -> Result<Vec<usize>> {
        self.keys.polygon_indices(key, &self.cell)
    }
}

impl Index<ReferenceKey> for DeviceBuilder {
    type Output = Reference;

    fn index(&self, key: ReferenceKey) -> &Reference {
        match self.reference(key) {
            Ok(reference) => reference,
            Err(error) => panic!("{error}"),
        }
    }
}

impl IndexMut<ReferenceKey> for DeviceBuilder {
    fn index_mut(&mut self, key: ReferenceKey) -> &mut Reference {
        match self.reference_mut(key) {
            Ok(reference) => reference,
            Err(error) => panic!("{error}"),
        }
    }
}
