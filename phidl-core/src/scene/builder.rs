//! [`DeviceBuilder`]: the open cell.

use std::collections::BTreeMap;
use std::ops::{Index, IndexMut};

use smol_str::SmolStr;

use super::cell::Alias;
use super::keys::Removals;
use super::{
    Cell, Device, Element, Group, Key, Label, LabelKey, OpenCell, Polygon, PolygonKey, PolygonView, Reference,
    ReferenceKey,
};
use crate::error::{Error, ItemKind, Result};
use crate::geom::{Outline, Point, Rect, Transform};
use crate::layer::{Layer, Layers};
use crate::param::Value;
use crate::place::{Bounded, DeferredError, Transformable};
use crate::port::Port;

/// The open cell: the only thing that can be edited. [`DeviceBuilder::build`] finishes it.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (40, 0), (40, 20), (0, 20)], 1)?;
/// d.add_port("e", ((40, 10), 20, 0))?;
/// d.add_label("pad", (20, 10), 10);
/// let pad = d.build()?;
///
/// let mut d = Device::builder("two_pads");
/// let left = d.add_as("left", &pad);
/// let right = d.add(&pad);
/// let edge = d["left"].xmax();
/// d[right].mirror((0, 0), (0, 1)).set_xmin(edge + 5.0);
/// d.add_port("out", d[left].port("e")?)?;
/// assert_eq!(d.build()?.bbox(), Some(Rect::new((0, 0), (85, 20))));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Bad values
/// Words that chain do not fail. The first bad value (a coordinate that is not finite, a repeated alias) is kept and
/// comes back as the error of the next fallible call, at the latest of `build`.
///
/// # Panics
/// `d[key]` and `d["alias"]` panic like a `Vec` when there is nothing under the key or alias;
/// [`DeviceBuilder::reference`] and [`DeviceBuilder::get`] return an error instead.
#[derive(Debug, Clone)]
pub struct DeviceBuilder {
    pub(crate) cell: OpenCell,
    pub(super) removed_references: Removals,
    pub(super) removed_polygons: Removals,
    pub(super) removed_labels: Removals,
    fault: Option<Box<Error>>,
}

/// What [`DeviceBuilder::add`] takes: references, devices, polygons, labels and groups.
pub trait Addable {
    /// How the added thing is found again.
    type Key;

    /// Adds the thing at the end of a cell.
    fn add_to(self, cell: &mut DeviceBuilder) -> Self::Key;
}

impl DeviceBuilder {
    pub(crate) fn new(name: &str) -> Self {
        let mut builder = Self::from_cell(Cell { name: SmolStr::new(name), ..Cell::default() });
        builder.check_name();
        builder
    }

    pub(crate) fn from_cell(cell: Cell) -> Self {
        Self {
            cell: cell.into(),
            removed_references: Removals::default(),
            removed_polygons: Removals::default(),
            removed_labels: Removals::default(),
            fault: None,
        }
    }

    /// Adds a thing at the end: a reference, a device (at the origin), a polygon, a label or a group.
    ///
    /// What is wrong with it comes back as the error of the next fallible call.
    pub fn add<A: Addable>(&mut self, thing: A) -> A::Key {
        thing.add_to(self)
    }

    /// Adds a reference and names it: `d["alias"]` is the reference from then on.
    ///
    /// An alias that is taken comes back as the error of the next fallible call.
    pub fn add_as(&mut self, alias: &str, reference: impl Into<Reference>) -> ReferenceKey {
        let key = self.add(reference.into());
        let place = self.cell.references.len() - 1;
        if self.cell.aliases.push(Alias { name: SmolStr::new(alias), place }).is_err() {
            self.keep(Error::Duplicate {
                device: self.cell.name.as_str().into(),
                kind: ItemKind::Alias,
                name: alias.into(),
            });
        }
        key
    }

    /// Draws an outline (pairs or two coordinate lists) on one layer, several, or none; one copy on each.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`], [`Error::NotFinite`]; and what was kept before.
    pub fn add_polygon(&mut self, outline: impl Outline, layers: impl Into<Layers>) -> Result<PolygonKey> {
        let layers = layers.into();
        let cell = &mut *self.cell;
        let first_place = cell.outlines.len();
        let key = PolygonKey { first: self.removed_polygons.next_number(first_place), copies: layers.iter().len() };
        // Checked on the drawn points, so that the usual case costs neither a buffer of its own nor a second pass.
        let first = layers.as_slice().first().copied().unwrap_or_default();
        let points = cell.outlines.push(outline, first);
        let sound = points.len() >= 3 && Point::all_finite(points);
        if !sound {
            let error = bad_outline(&cell.name, points);
            cell.outlines.pop();
            return Err(self.fault.take().map_or(error, |fault| *fault));
        }
        match layers.as_slice() {
            [] => cell.outlines.pop(),
            [_, others @ ..] => others.iter().for_each(|layer| cell.outlines.repeat(first_place, *layer)),
        }
        self.report()?;
        Ok(key)
    }

    /// Makes room for so many polygons with so many points in all. It only saves time.
    pub fn reserve(&mut self, polygons: usize, points: usize) -> &mut Self {
        self.cell.outlines.reserve(polygons, points);
        self
    }

    /// Adds a port under a name.
    ///
    /// # Errors
    /// [`Error::Duplicate`] if the name is taken, [`Error::NotFinite`] and [`Error::Refused`] for a port that cannot
    /// be; and what was kept before.
    pub fn add_port(&mut self, name: impl AsRef<str>, port: impl Into<Port>) -> Result<&mut Self> {
        self.push_port(port.into().named(name))
    }

    fn push_port(&mut self, port: Port) -> Result<&mut Self> {
        self.report()?;
        port.check(&self.cell.name)?;
        match self.cell.ports.push(port) {
            Ok(()) => Ok(self),
            Err(port) => {
                let device = self.cell.name.as_str().into();
                Err(Error::Duplicate { device, kind: ItemKind::Port, name: port.name().into() })
            }
        }
    }

    /// Adds the ports of a reference under their own names.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::add_port`].
    pub fn add_ports(&mut self, ports: impl IntoIterator<Item = Port>) -> Result<&mut Self> {
        for port in ports {
            self.push_port(port)?;
        }
        Ok(self)
    }

    /// Adds a centered, level text at a position. For other texts, `add` a [`Label`].
    pub fn add_label(
        &mut self,
        text: impl Into<String>,
        position: impl Into<Point>,
        layer: impl Into<Layer>,
    ) -> LabelKey {
        self.add(Label::new(text, position, layer))
    }

    /// Records something about the cell; a second record under the same key replaces the first.
    ///
    /// A number that is not finite comes back as the error of the next fallible call.
    pub fn info(&mut self, key: impl Into<String>, value: impl Into<Value>) -> &mut Self {
        let (key, value) = (key.into(), value.into());
        if !value.is_finite() {
            self.keep(Error::NotFinite {
                device: self.cell.name.as_str().into(),
                what: format!("info \"{key}\"").into(),
                value: value.to_string().into(),
            });
        }
        self.cell.info.insert(key, value);
        self
    }

    /// What was recorded so far.
    #[must_use]
    pub fn recorded(&self) -> &BTreeMap<String, Value> {
        &self.cell.info
    }

    /// The name of the cell.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.cell.name
    }

    /// Gives the cell another name. An empty one comes back as the error of the next fallible call.
    pub fn rename(&mut self, name: impl AsRef<str>) -> &mut Self {
        self.cell.name = SmolStr::new(name);
        self.check_name();
        self
    }

    /// A port of this cell.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that are there.
    pub fn port(&self, name: &str) -> Result<&Port> {
        self.cell.port(name)
    }

    /// The ports of this cell, in the order in which they were added.
    pub fn ports(&self) -> impl ExactSizeIterator<Item = &Port> {
        self.cell.ports.iter()
    }

    /// The polygons of this cell itself, in the order in which they were added.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = PolygonView<'_>> {
        self.cell.outlines.iter()
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
    /// [`Error::Unknown`] if it was removed or belongs to another cell.
    pub fn reference(&self, key: ReferenceKey) -> Result<&Reference> {
        let place = self.reference_place(key)?;
        Ok(&self.cell.references[place])
    }

    /// The reference under a key, to be changed.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it was removed or belongs to another cell.
    pub fn reference_mut(&mut self, key: ReferenceKey) -> Result<&mut Reference> {
        let place = self.reference_place(key)?;
        Ok(&mut self.cell.references[place])
    }

    /// The reference under an alias.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that are there.
    pub fn get(&self, alias: &str) -> Result<&Reference> {
        Ok(&self.cell.references[self.cell.alias(alias)?])
    }

    /// The reference under an alias, to be changed.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that are there.
    pub fn get_mut(&mut self, alias: &str) -> Result<&mut Reference> {
        let place = self.cell.alias(alias)?;
        Ok(&mut self.cell.references[place])
    }

    /// The polygon under a key; of several copies, the first.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it was removed, belongs to another cell, or was drawn on no layer.
    pub fn polygon(&self, key: PolygonKey) -> Result<PolygonView<'_>> {
        let place = self.polygon_places(key)?.first().copied();
        place.map(|place| self.cell.outlines.get(place)).ok_or_else(|| self.lost(ItemKind::Polygon, key.first))
    }

    /// The label under a key.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it was removed or belongs to another cell.
    pub fn label(&self, key: LabelKey) -> Result<&Label> {
        let place = self.label_place(key)?;
        Ok(&self.cell.labels[place])
    }

    /// Finishes the cell.
    ///
    /// # Errors
    /// What was kept, or what is wrong with a reference or label that was placed after it was added.
    pub fn build(mut self) -> Result<Device> {
        self.report()?;
        self.check_contents()?;
        self.cell.outlines.shrink();
        Ok(self.cell.finish())
    }

    /// Returns what was kept, if anything.
    pub(super) fn report(&mut self) -> Result<()> {
        match self.fault.take() {
            Some(fault) => Err(*fault),
            None => Ok(()),
        }
    }

    /// Keeps an error for the next fallible call, if none is kept yet.
    pub(super) fn keep(&mut self, error: Error) {
        self.fault.get_or_insert_with(|| Box::new(error));
    }

    pub(super) fn keep_result(&mut self, result: Result<()>) {
        if let Err(error) = result {
            self.keep(error);
        }
    }

    pub(super) fn reference_place(&self, key: ReferenceKey) -> Result<usize> {
        let place = self.removed_references.place(key.0).filter(|place| *place < self.cell.references.len());
        place.ok_or_else(|| self.lost(ItemKind::Reference, key.0))
    }

    pub(super) fn label_place(&self, key: LabelKey) -> Result<usize> {
        let place = self.removed_labels.place(key.0).filter(|place| *place < self.cell.labels.len());
        place.ok_or_else(|| self.lost(ItemKind::Label, key.0))
    }

    /// The places of all copies of a polygon that are still there. (A copy may have gone with its layer.)
    pub(super) fn polygon_places(&self, key: PolygonKey) -> Result<Vec<usize>> {
        let numbers = key.first..key.first + key.copies;
        let places: Vec<usize> = numbers
            .filter_map(|number| self.removed_polygons.place(number))
            .filter(|place| *place < self.cell.outlines.len())
            .collect();
        if places.is_empty() && key.copies > 0 { Err(self.lost(ItemKind::Polygon, key.first)) } else { Ok(places) }
    }

    fn lost(&self, kind: ItemKind, number: usize) -> Error {
        Error::Unknown {
            owner: self.cell.name.as_str().into(),
            kind,
            name: format!("number {number}").into(),
            known: Vec::new(),
        }
    }

    fn check_name(&mut self) {
        if self.cell.name.is_empty() {
            self.keep(Error::Refused {
                device: "device".into(),
                what: "name".into(),
                value: "\"\"".into(),
                rule: "have at least one character".into(),
            });
        }
    }

    /// Things can be moved after they were added, so they are looked at once more at the end.
    fn check_contents(&self) -> Result<()> {
        let name = self.cell.name.as_str();
        self.cell.references.iter().try_for_each(|reference| reference.check(name))?;
        self.cell.labels.iter().try_for_each(|label| check_label(label, name))?;
        self.cell.ports.iter().try_for_each(|port| port.check(name))?;
        // Only an overflow can bring a coordinate in here that is not finite; moves are checked where they are made.
        let points = self.cell.outlines.all_points();
        let lost = if Point::all_finite(points) { None } else { points.iter().find(|p| !p.is_finite()) };
        match lost {
            None => Ok(()),
            Some(p) => Err(Error::NotFinite {
                device: name.into(),
                what: "corner of a moved polygon".into(),
                value: p.to_string().into(),
            }),
        }
    }
}

fn bad_outline(device: &str, points: &[Point]) -> Error {
    match points.iter().enumerate().find(|(_, p)| !p.is_finite()) {
        Some((i, p)) => Error::NotFinite {
            device: device.into(),
            what: format!("point {i} of an outline").into(),
            value: p.to_string().into(),
        },
        None => Error::TooFewPoints { device: device.into(), points: points.len() },
    }
}

fn check_label(label: &Label, device: &str) -> Result<()> {
    if let Some(fault) = label.fault() {
        return Err(fault.into_error(device, &format!("label \"{}\"", label.text)));
    }
    match label.transform().is_finite() {
        true => Ok(()),
        false => Err(Error::NotFinite {
            device: device.into(),
            what: format!("placement of label \"{}\"", label.text).into(),
            value: format!("{:?}", label.transform()).into(),
        }),
    }
}

impl Addable for Reference {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        cell.keep_result(self.check(&cell.cell.name));
        let key = ReferenceKey(cell.removed_references.next_number(cell.cell.references.len()));
        cell.cell.references.push(self);
        key
    }
}

impl Addable for Device {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        Reference::from(self).add_to(cell)
    }
}

impl Addable for &Device {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        Reference::from(self).add_to(cell)
    }
}

impl Addable for Polygon {
    type Key = PolygonKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> PolygonKey {
        let nowhere = PolygonKey { first: 0, copies: 0 };
        if let Some(fault) = self.fault {
            cell.keep(fault.into_error(&cell.cell.name, "a polygon"));
            return nowhere;
        }
        let place = cell.cell.outlines.len();
        match cell.add_polygon(self.points, self.layers) {
            Ok(key) => {
                for copy in place..cell.cell.outlines.len() {
                    cell.cell.outlines.set_properties(copy, self.properties.clone());
                }
                key
            }
            Err(error) => {
                cell.keep(error);
                nowhere
            }
        }
    }
}

impl Addable for Label {
    type Key = LabelKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> LabelKey {
        cell.keep_result(check_label(&self, &cell.cell.name));
        let key = LabelKey(cell.removed_labels.next_number(cell.cell.labels.len()));
        cell.cell.labels.push(self);
        key
    }
}

impl Addable for Element {
    type Key = Key;

    fn add_to(self, cell: &mut DeviceBuilder) -> Key {
        match self {
            Self::Reference(reference) => reference.add_to(cell).into(),
            Self::Polygon(polygon) => polygon.add_to(cell).into(),
            Self::Label(label) => label.add_to(cell).into(),
        }
    }
}

impl Addable for Group {
    type Key = Vec<Key>;

    fn add_to(self, cell: &mut DeviceBuilder) -> Vec<Key> {
        if let Some(fault) = self.fault() {
            cell.keep(fault.into_error(&cell.cell.name, "a group"));
        }
        self.into_iter().map(|member| member.add_to(cell)).collect()
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
    fn index_mut(&mut self, alias: &str) -> &mut Reference {
        match self.get_mut(alias) {
            Ok(reference) => reference,
            Err(error) => panic!("{error}"),
        }
    }
}

impl Bounded for DeviceBuilder {
    /// The box around all polygons and references; ports and labels do not count.
    fn bbox(&self) -> Option<Rect> {
        self.cell.bbox()
    }
}

impl Transformable for DeviceBuilder {
    fn transform_mut(&mut self, by: &Transform) {
        self.cell.transform_mut(by);
    }

    fn refuse(&mut self, fault: DeferredError) {
        let error = fault.into_error(&self.cell.name, "the cell");
        self.keep(error);
    }
}
