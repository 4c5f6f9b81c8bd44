//! Edits of an open cell beyond adding: removing, flattening, layers, simplifying.

use std::collections::{BTreeMap, BTreeSet};

use super::flat_counts::FLAT_LIMIT;
use super::flatten::Flat;
use super::map_cells::rewrite_below;
use super::{Cell, Device, DeviceBuilder, Key, Label, PolygonKey, PolygonView, Properties, ReferenceKey, Target};
use crate::error::{Error, ItemKind, Result};
use crate::geom::simplified;
use crate::layer::{Layer, Layers};

/// What an edit of layers applies to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayerTarget {
    /// Polygons and labels.
    All,
    /// Polygons only; labels stay as they are.
    PolygonsOnly,
}

impl DeviceBuilder {
    /// Removes references (with their aliases), polygons (with all copies) and labels: by key, alias, or a list. If one
    /// key is refused, nothing is removed.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`].
    pub fn remove(&mut self, target: impl Target) -> Result<&mut Self> {
        let (mut references, mut polygons, mut labels) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for key in target.keys(self)? {
            match key {
                Key::Reference(key) => _ = references.insert(self.reference_index(key)?),
                Key::Polygon(key) => polygons.extend(self.polygon_indices(key)?),
                Key::Label(key) => _ = labels.insert(self.label_index(key)?),
            }
        }
        self.remove_references(&Vec::from_iter(references));
        self.remove_polygon_indices(|index, _| polygons.contains(&index));
        self.remove_label_indices(|index, _| labels.contains(&index));
        Ok(self)
    }

    /// Removes references by ascending indices.
    fn remove_references(&mut self, removed: &[usize]) {
        if removed.is_empty() {
            return;
        }
        let mut index = 0;
        self.cell.references.retain(|_| {
            index += 1;
            removed.binary_search(&(index - 1)).is_err()
        });
        self.keys.references.remove(removed);
        self.cell.aliases.retain(|alias| match removed.binary_search(&alias.index) {
            Ok(_) => false,
            Err(before) => {
                alias.index -= before;
                true
            }
        });
    }

    fn remove_polygon_indices(&mut self, mut test: impl FnMut(usize, PolygonView<'_>) -> bool) {
        let mut index = 0;
        let removed = self.cell.polygons.retain(|polygon| {
            index += 1;
            !test(index - 1, polygon)
        });
        self.keys.polygons.remove(&removed);
    }

    fn remove_label_indices(&mut self, mut test: impl FnMut(usize, &Label) -> bool) {
        let labels = &mut self.cell.labels;
        let removed: Vec<usize> = (0..labels.len()).filter(|index| test(*index, &labels[*index])).collect();
        let mut index = 0;
        labels.retain(|_| {
            index += 1;
            removed.binary_search(&(index - 1)).is_err()
        });
        self.keys.labels.remove(&removed);
    }

    /// Removes a port.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn remove_port(&mut self, name: &str) -> Result<&mut Self> {
        self.cell.port(name)?;
        self.cell.ports.retain(|port| port.name() != name);
        Ok(self)
    }

    /// Gives a port another name; it keeps its position in the order of ports.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist, [`Error::Duplicate`] if the new name is taken.
    pub fn rename_port(&mut self, name: &str, new: &str) -> Result<&mut Self> {
        if new != name && self.cell.ports.index_of(new).is_some() {
            let device = self.cell.name.as_str().into();
            return Err(Error::Duplicate { device, kind: ItemKind::Port, name: new.into() });
        }
        let port = self.cell.port(name)?.clone().named(new);
        if let Some(index) = self.cell.ports.index_of(name) {
            self.cell.ports.replace(index, port);
        }
        Ok(self)
    }

    /// Removes the polygons of this cell itself for which the test holds.
    pub fn remove_polygons(&mut self, mut test: impl FnMut(PolygonView<'_>) -> bool) -> &mut Self {
        self.remove_polygon_indices(|_, polygon| test(polygon));
        self
    }

    /// Removes the labels of this cell itself for which the test holds.
    pub fn remove_labels(&mut self, mut test: impl FnMut(&Label) -> bool) -> &mut Self {
        self.remove_label_indices(|_, label| test(label));
        self
    }

    /// Sets the properties of a polygon: numbered texts that a file keeps with it.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`].
    pub fn set_properties(&mut self, key: PolygonKey, properties: Properties) -> Result<&mut Self> {
        for index in self.polygon_indices(key)? {
            self.cell.polygons.set_properties(index, properties.clone());
        }
        Ok(self)
    }

    /// Replaces a reference by the polygons and labels of its whole hierarchy, in this cell.
    ///
    /// # Errors
    /// [`Error::Removed`], [`Error::ForeignKey`]; what is wrong with its placement; [`Error::TooLarge`] beyond
    /// [`FLAT_LIMIT`].
    pub fn absorb(&mut self, key: ReferenceKey) -> Result<&mut Self> {
        let reference = self.reference(key)?.clone();
        reference.check(&self.cell.name)?;
        let single = Device::from_cell(Cell { references: vec![reference], ..Cell::default() });
        let flat = Flat::of(&single, &self.cell.name, FLAT_LIMIT)?;
        flat.polygons.iter().for_each(|polygon| self.cell.polygons.push_view(polygon));
        self.cell.labels.extend(flat.labels);
        self.remove(key)
    }

    /// Replaces all references by the polygons and labels of their whole hierarchy, in this cell. Ports stay; aliases are
    /// removed with the references that they name.
    ///
    /// # Errors
    /// What is wrong with the placement of a reference; [`Error::TooLarge`] beyond [`FLAT_LIMIT`]. The cell stays as it
    /// was.
    pub fn flatten(&mut self) -> Result<&mut Self> {
        self.flatten_within(FLAT_LIMIT)
    }

    /// As [`DeviceBuilder::flatten`], with another limit on polygons, points and labels.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::flatten`].
    pub fn flatten_within(&mut self, limit: u64) -> Result<&mut Self> {
        self.cell.references.iter().try_for_each(|r| r.check(&self.cell.name))?;
        if self.cell.references.is_empty() {
            return Ok(self);
        }
        let removed = Vec::from_iter(0..self.cell.references.len());
        // The polygons of the open cell are moved into the hierarchy and back, not copied, unless the limit refuses it.
        let hierarchy = Device::from_cell(std::mem::take(&mut *self.cell));
        let cell = hierarchy.cell();
        let flat = match Flat::of(&hierarchy, &cell.name, limit) {
            Ok(flat) => flat,
            Err(error) => {
                *self.cell = cell.clone();
                return Err(error);
            }
        };
        *self.cell = Cell {
            name: cell.name.clone(),
            polygons: flat.polygons,
            labels: flat.labels,
            ports: cell.ports.clone(),
            info: cell.info.clone(),
            ..Cell::default()
        };
        self.keys.references.remove(&removed);
        Ok(self)
    }

    /// As [`DeviceBuilder::flatten`], with all polygons and labels on one layer.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::flatten`].
    pub fn flatten_onto(&mut self, layer: impl Into<Layer>) -> Result<&mut Self> {
        let layer = layer.into();
        self.flatten()?;
        (0..self.cell.polygons.len()).for_each(|index| self.cell.polygons.set_layer(index, layer));
        self.cell.labels.iter_mut().for_each(|label| label.layer = layer);
        Ok(self)
    }

    /// Moves elements from layers to other layers, in this cell and in copies of all cells below. Every layer is looked up
    /// once, so two layers can be exchanged.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// let mut d = Device::builder("pair");
    /// d.add_polygon([(0, 0), (1, 0), (0, 1)], 6)?;
    /// d.add_polygon([(0, 0), (1, 0), (0, 1)], (8, 2))?;
    /// d.remap_layers([((8, 2), 99), ((6, 0), 77)], LayerTarget::All);
    /// assert_eq!(d.build()?.layers(), [Layer::new(77, 0), Layer::new(99, 0)]);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    pub fn remap_layers<F: Into<Layer>, T: Into<Layer>>(
        &mut self,
        map: impl IntoIterator<Item = (F, T)>,
        affects: LayerTarget,
    ) -> &mut Self {
        let map: BTreeMap<Layer, Layer> = map.into_iter().map(|(from, to)| (from.into(), to.into())).collect();
        rewrite_below(&mut self.cell, |cell| remap(cell, &map, affects));
        self
    }

    /// Removes the elements on some layers, in this cell and in copies of all cells below.
    pub fn remove_layers(&mut self, layers: impl Into<Layers>, affects: LayerTarget) -> &mut Self {
        let layers = layers.into();
        self.keep_where(affects, |layer| !layers.contains(layer))
    }

    /// Removes the elements on all other layers, in this cell and in copies of all cells below.
    pub fn keep_layers(&mut self, layers: impl Into<Layers>, affects: LayerTarget) -> &mut Self {
        let layers = layers.into();
        self.keep_where(affects, |layer| layers.contains(layer))
    }

    /// Removes the points that are not needed to stay within `tolerance` (µm) of every outline, in this cell and in copies
    /// of all cells below. An outline that would be left with fewer than three points stays as it is.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the tolerance is negative or not a number.
    pub fn simplify(&mut self, tolerance: f64) -> Result<&mut Self> {
        if tolerance.is_nan() || tolerance < 0.0 {
            let problem = format!("the tolerance of simplify is {tolerance} µm, but it must be at least 0 µm");
            return Err(Error::invalid(&self.cell.name, problem));
        }
        rewrite_below(&mut self.cell, |cell| simplify(cell, tolerance));
        Ok(self)
    }

    fn keep_where(&mut self, affects: LayerTarget, keep: impl Fn(Layer) -> bool) -> &mut Self {
        let mut removed = (Vec::new(), Vec::new());
        // The open cell itself comes last; only its removals concern keys.
        rewrite_below(&mut self.cell, |cell| {
            removed = retain_layers(cell, affects, &keep);
            !(removed.0.is_empty() && removed.1.is_empty())
        });
        self.keys.polygons.remove(&removed.0);
        self.keys.labels.remove(&removed.1);
        self
    }
}

fn remap(cell: &mut Cell, map: &BTreeMap<Layer, Layer>, affects: LayerTarget) -> bool {
    let mut any = false;
    for index in 0..cell.polygons.len() {
        if let Some(layer) = map.get(&cell.polygons.get(index).layer) {
            cell.polygons.set_layer(index, *layer);
            any = true;
        }
    }
    if affects == LayerTarget::All {
        for label in &mut cell.labels {
            if let Some(layer) = map.get(&label.layer) {
                label.layer = *layer;
                any = true;
            }
        }
    }
    any
}

/// Removes what is not to be kept; returns the indices of removed polygons and labels.
fn retain_layers(cell: &mut Cell, affects: LayerTarget, keep: &impl Fn(Layer) -> bool) -> (Vec<usize>, Vec<usize>) {
    let polygons = cell.polygons.retain(|polygon| keep(polygon.layer));
    let mut labels = Vec::new();
    if affects == LayerTarget::All {
        labels = (0..cell.labels.len()).filter(|index| !keep(cell.labels[*index].layer)).collect();
        cell.labels.retain(|label| keep(label.layer));
    }
    (polygons, labels)
}

fn simplify(cell: &mut Cell, tolerance: f64) -> bool {
    let mut simple = super::polygon_store::PolygonStore::default();
    for polygon in cell.polygons.iter() {
        let points = simplified(polygon.points, tolerance);
        if points.len() < 3 {
            simple.push_view(polygon);
            continue;
        }
        simple.push(points, polygon.layer);
        if let Some(properties) = polygon.property_map() {
            simple.set_properties(simple.len() - 1, properties.clone());
        }
    }
    let changed = simple.point_count() != cell.polygons.point_count();
    if changed {
        cell.polygons = simple;
    }
    changed
}
