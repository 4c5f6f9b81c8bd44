//! [`KeySpace`]: from the keys of an open cell to the indices of its elements.

use super::cell_id::CellId;
use super::keys::Tombstones;
use super::{Cell, LabelKey, PolygonKey, ReferenceKey};
use crate::error::{Error, ItemKind, Result};

/// The keys that an open cell accepts: those that it made, and those that the cell it was cloned from had made before.
#[derive(Debug)]
pub(super) struct KeySpace {
    id: CellId,
    /// The cells that this one was cloned from, with the numbers that they had given away by then.
    origins: Vec<(CellId, NextNumbers)>,
    pub(super) references: Tombstones,
    pub(super) polygons: Tombstones,
    pub(super) labels: Tombstones,
}

#[derive(Debug, Clone, Copy)]
struct NextNumbers {
    reference: usize,
    polygon: usize,
    label: usize,
}

impl KeySpace {
    pub(super) fn new(name: &str) -> Self {
        Self {
            id: CellId::new(name),
            origins: Vec::new(),
            references: Tombstones::default(),
            polygons: Tombstones::default(),
            labels: Tombstones::default(),
        }
    }

    /// The keys of a copy of the cell: all that exist now, and new ones that the original does not accept.
    pub(super) fn of_clone(&self, cell: &Cell) -> Self {
        let mut origins = self.origins.clone();
        origins.push((self.id, self.next_numbers(cell)));
        Self {
            id: CellId::new(&cell.name),
            origins,
            references: self.references.clone(),
            polygons: self.polygons.clone(),
            labels: self.labels.clone(),
        }
    }

    pub(super) fn rename(&mut self, name: &str) {
        self.id = self.id.renamed(name);
    }

    /// The key of the next reference.
    pub(super) fn next_reference(&self, cell: &Cell) -> ReferenceKey {
        ReferenceKey { cell: self.id, number: self.next_numbers(cell).reference }
    }

    /// The key of the next polygon, with a number of copies.
    pub(super) fn next_polygon(&self, cell: &Cell, copies: usize) -> PolygonKey {
        PolygonKey { cell: self.id, first: self.polygons.next_number(cell.polygons.len()), copies }
    }

    /// The key of a polygon that was not added. It finds nothing.
    pub(super) fn no_polygon(&self) -> PolygonKey {
        PolygonKey { cell: self.id, first: usize::MAX - 1, copies: 1 }
    }

    /// The key of the next label.
    pub(super) fn next_label(&self, cell: &Cell) -> LabelKey {
        LabelKey { cell: self.id, number: self.next_numbers(cell).label }
    }

    pub(super) fn reference_keys<'a>(&'a self, cell: &Cell) -> impl Iterator<Item = ReferenceKey> + 'a {
        self.references.numbers(cell.references.len()).map(|number| ReferenceKey { cell: self.id, number })
    }

    pub(super) fn polygon_keys<'a>(&'a self, cell: &Cell) -> impl Iterator<Item = PolygonKey> + 'a {
        self.polygons.numbers(cell.polygons.len()).map(|first| PolygonKey { cell: self.id, first, copies: 1 })
    }

    pub(super) fn label_keys<'a>(&'a self, cell: &Cell) -> impl Iterator<Item = LabelKey> + 'a {
        self.labels.numbers(cell.labels.len()).map(|number| LabelKey { cell: self.id, number })
    }

    pub(super) fn reference_index(&self, key: ReferenceKey, cell: &Cell) -> Result<usize> {
        self.check_owner(key.cell, key.number.saturating_add(1), |next| next.reference, cell, ItemKind::Reference)?;
        let index = self.references.index(key.number).filter(|index| *index < cell.references.len());
        index.ok_or_else(|| removed(cell, ItemKind::Reference))
    }

    pub(super) fn label_index(&self, key: LabelKey, cell: &Cell) -> Result<usize> {
        self.check_owner(key.cell, key.number.saturating_add(1), |next| next.label, cell, ItemKind::Label)?;
        let index = self.labels.index(key.number).filter(|index| *index < cell.labels.len());
        index.ok_or_else(|| removed(cell, ItemKind::Label))
    }

    /// The indices of all copies of a polygon that are still there. (A copy may have been removed with its layer.)
    pub(super) fn polygon_indices(&self, key: PolygonKey, cell: &Cell) -> Result<Vec<usize>> {
        self.check_owner(key.cell, key.first + key.copies, |next| next.polygon, cell, ItemKind::Polygon)?;
        let numbers = key.first..key.first + key.copies;
        let indices = numbers.filter_map(|number| self.polygons.index(number));
        let indices: Vec<usize> = indices.filter(|index| *index < cell.polygons.len()).collect();
        if indices.is_empty() && key.copies > 0 { Err(removed(cell, ItemKind::Polygon)) } else { Ok(indices) }
    }

    fn next_numbers(&self, cell: &Cell) -> NextNumbers {
        NextNumbers {
            reference: self.references.next_number(cell.references.len()),
            polygon: self.polygons.next_number(cell.polygons.len()),
            label: self.labels.next_number(cell.labels.len()),
        }
    }

    /// Whether the cell accepts a key of this owner whose numbers lie below `end`.
    fn check_owner(
        &self,
        owner: CellId,
        end: usize,
        next: impl Fn(&NextNumbers) -> usize,
        cell: &Cell,
        kind: ItemKind,
    ) -> Result<()> {
        let inherited = |origin: &(CellId, NextNumbers)| origin.0 == owner && end <= next(&origin.1);
        if owner == self.id || self.origins.iter().any(inherited) {
            return Ok(());
        }
        Err(Error::ForeignKey { device: cell.name.as_str().into(), kind, owner: owner.name().into() })
    }
}

fn removed(cell: &Cell, kind: ItemKind) -> Error {
    Error::Removed { device: cell.name.as_str().into(), kind }
}
