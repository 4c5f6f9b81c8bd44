//! Edits of an open cell that reach further than one thing in it.

use std::collections::BTreeMap;

use super::flatten::{all_labels, all_outlines};
use super::map_cells::rewrite_below;
use super::{Cell, Device, DeviceBuilder, Key, Label, PolygonKey, Properties, ReferenceKey};
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
    /// Removes a reference (with its aliases), a polygon (all its copies) or a label.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it is gone already or belongs to another cell.
    pub fn remove(&mut self, key: impl Into<Key>) -> Result<&mut Self> {
        match key.into() {
            Key::Reference(key) => {
                let place = self.reference_place(key)?;
                self.removed_references.remove_place(place);
                self.cell.references.remove(place);
                self.drop_aliases_of(place);
            }
            Key::Label(key) => {
                let place = self.label_place(key)?;
                self.removed_labels.remove_place(place);
                self.cell.labels.remove(place);
            }
            Key::Polygon(key) => {
                let places = self.polygon_places(key)?;
                let mut place = 0;
                self.cell.outlines.retain(|_| {
                    place += 1;
                    !places.contains(&(place - 1))
                });
                places.iter().rev().for_each(|place| self.removed_polygons.remove_place(*place));
            }
        }
        Ok(self)
    }

    /// Removes a port.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that are there.
    pub fn remove_port(&mut self, name: &str) -> Result<&mut Self> {
        self.cell.port(name)?;
        self.cell.ports.retain(|port| port.name() != name);
        Ok(self)
    }

    /// Gives a port another name and keeps its place among the others.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that are there, [`Error::Duplicate`] if the new name is taken.
    pub fn rename_port(&mut self, name: &str, new: &str) -> Result<&mut Self> {
        if new != name && self.cell.ports.place(new).is_some() {
            let device = self.cell.name.as_str().into();
            return Err(Error::Duplicate { device, kind: ItemKind::Port, name: new.into() });
        }
        let port = self.cell.port(name)?.clone().named(new);
        if let Some(place) = self.cell.ports.place(name) {
            self.cell.ports.replace(place, port);
        }
        Ok(self)
    }

    /// Removes the polygons of this cell itself for which the test holds.
    pub fn remove_polygons(&mut self, mut test: impl FnMut(super::PolygonView<'_>) -> bool) -> &mut Self {
        let removed = self.cell.outlines.retain(|polygon| !test(polygon));
        removed.iter().rev().for_each(|place| self.removed_polygons.remove_place(*place));
        self
    }

    /// Removes the labels of this cell itself for which the test holds.
    pub fn remove_labels(&mut self, mut test: impl FnMut(&Label) -> bool) -> &mut Self {
        let removed: Vec<usize> = (0..self.cell.labels.len()).filter(|place| test(&self.cell.labels[*place])).collect();
        for place in removed.into_iter().rev() {
            self.removed_labels.remove_place(place);
            self.cell.labels.remove(place);
        }
        self
    }

    /// Keeps texts with a polygon when it is written to a file.
    ///
    /// # Errors
    /// [`Error::Unknown`] if the polygon was removed or belongs to another cell.
    pub fn set_properties(&mut self, key: PolygonKey, properties: Properties) -> Result<&mut Self> {
        for place in self.polygon_places(key)? {
            self.cell.outlines.set_properties(place, properties.clone());
        }
        Ok(self)
    }

    /// Puts a reference's polygons and labels, the whole way down, into this cell in its place.
    ///
    /// # Errors
    /// [`Error::Unknown`] if the reference was removed or belongs to another cell; what is wrong with its placement.
    pub fn absorb(&mut self, key: ReferenceKey) -> Result<&mut Self> {
        let reference = self.reference(key)?.clone();
        reference.check(&self.cell.name)?;
        let lone = Cell { name: "absorbed".into(), references: vec![reference], ..Cell::default() };
        let lone = Device::from_cell(lone);
        all_outlines(&lone).iter().for_each(|polygon| self.cell.outlines.push_view(polygon));
        self.cell.labels.extend(all_labels(&lone));
        self.remove(key)
    }

    /// Puts all polygons and labels of the hierarchy into this cell in place of the references. Ports stay; aliases go
    /// with the references that they name.
    pub fn flatten(&mut self) -> &mut Self {
        let checked = self.cell.references.iter().try_for_each(|r| r.check(&self.cell.name));
        if let Err(error) = checked {
            self.keep(error);
            return self;
        }
        if self.cell.references.is_empty() {
            return self;
        }
        let hierarchy = Device::from_cell(std::mem::take(&mut *self.cell));
        let cell = hierarchy.cell();
        *self.cell = Cell {
            name: cell.name.clone(),
            outlines: all_outlines(&hierarchy),
            labels: all_labels(&hierarchy),
            ports: cell.ports.clone(),
            info: cell.info.clone(),
            ..Cell::default()
        };
        (0..cell.references.len()).rev().for_each(|place| self.removed_references.remove_place(place));
        self
    }

    /// As [`DeviceBuilder::flatten`], with all polygons and labels on one layer.
    pub fn flatten_onto(&mut self, layer: impl Into<Layer>) -> &mut Self {
        let layer = layer.into();
        self.flatten();
        (0..self.cell.outlines.len()).for_each(|place| self.cell.outlines.set_layer(place, layer));
        self.cell.labels.iter_mut().for_each(|label| label.layer = layer);
        self
    }

    /// Moves what is drawn from layers to others, here and in copies of all cells below; every layer is looked up once,
    /// so two layers can be exchanged.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// let mut d = Device::builder("pair");
    /// d.add_polygon([(0, 0), (1, 0), (0, 1)], 6)?;
    /// d.add_polygon([(0, 0), (1, 0), (0, 1)], (8, 2))?;
    /// d.remap_layers([((8, 2).into(), 99.into()), (6.into(), 77.into())], LayerTarget::All);
    /// assert_eq!(d.build()?.layers(), [Layer::new(77, 0), Layer::new(99, 0)]);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    pub fn remap_layers(&mut self, map: impl IntoIterator<Item = (Layer, Layer)>, affects: LayerTarget) -> &mut Self {
        let map: BTreeMap<Layer, Layer> = map.into_iter().collect();
        rewrite_below(&mut self.cell, |cell| remap(cell, &map, affects));
        self
    }

    /// Removes what is drawn on some layers, here and in copies of all cells below.
    pub fn remove_layers(&mut self, layers: impl Into<Layers>, affects: LayerTarget) -> &mut Self {
        let layers = layers.into();
        self.keep_where(affects, |layer| !layers.contains(layer))
    }

    /// Removes what is not drawn on some layers, here and in copies of all cells below.
    pub fn keep_layers(&mut self, layers: impl Into<Layers>, affects: LayerTarget) -> &mut Self {
        let layers = layers.into();
        self.keep_where(affects, |layer| layers.contains(layer))
    }

    /// Takes out the points that are not needed to stay within `tolerance` (µm) of every outline, here and in copies of
    /// all cells below. An outline that would lose its third point stays as it is.
    ///
    /// # Errors
    /// [`Error::Refused`] if the tolerance is negative or not a number.
    pub fn simplify(&mut self, tolerance: f64) -> Result<&mut Self> {
        if tolerance.is_nan() || tolerance < 0.0 {
            return Err(Error::Refused {
                device: self.cell.name.as_str().into(),
                what: "tolerance of simplify".into(),
                value: format!("{tolerance} µm").into(),
                rule: "be at least 0 µm".into(),
            });
        }
        rewrite_below(&mut self.cell, |cell| simplify(cell, tolerance));
        Ok(self)
    }

    fn keep_where(&mut self, affects: LayerTarget, keep: impl Fn(Layer) -> bool) -> &mut Self {
        let mut removed = (Vec::new(), Vec::new());
        // The open cell itself comes last; its removals are the ones that keys must know of.
        rewrite_below(&mut self.cell, |cell| {
            removed = retain_layers(cell, affects, &keep);
            !(removed.0.is_empty() && removed.1.is_empty())
        });
        removed.0.iter().rev().for_each(|place| self.removed_polygons.remove_place(*place));
        removed.1.iter().rev().for_each(|place| self.removed_labels.remove_place(*place));
        self
    }

    fn drop_aliases_of(&mut self, removed: usize) {
        self.cell.aliases.retain(|alias| alias.place != removed);
        self.cell.aliases.iter_mut().filter(|alias| alias.place > removed).for_each(|alias| alias.place -= 1);
    }
}

fn remap(cell: &mut Cell, map: &BTreeMap<Layer, Layer>, affects: LayerTarget) -> bool {
    let mut any = false;
    for place in 0..cell.outlines.len() {
        if let Some(layer) = map.get(&cell.outlines.get(place).layer) {
            cell.outlines.set_layer(place, *layer);
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

/// Removes what is not to be kept; returns the places of removed polygons and labels.
fn retain_layers(cell: &mut Cell, affects: LayerTarget, keep: &impl Fn(Layer) -> bool) -> (Vec<usize>, Vec<usize>) {
    let polygons = cell.outlines.retain(|polygon| keep(polygon.layer));
    let mut labels = Vec::new();
    if affects == LayerTarget::All {
        labels = (0..cell.labels.len()).filter(|place| !keep(cell.labels[*place].layer)).collect();
        cell.labels.retain(|label| keep(label.layer));
    }
    (polygons, labels)
}

fn simplify(cell: &mut Cell, tolerance: f64) -> bool {
    let mut simple = super::outlines::Outlines::default();
    for polygon in cell.outlines.iter() {
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
    let changed = simple.point_count() != cell.outlines.point_count();
    if changed {
        cell.outlines = simple;
    }
    changed
}
