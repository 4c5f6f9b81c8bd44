//! [`DeviceBuilder`]: the open cell.

use std::collections::BTreeMap;

use smol_str::SmolStr;

use super::addable::Addable;
use super::key_space::KeySpace;
use super::{Cell, Device, Key, Label, LabelKey, OpenCell, PolygonKey};
use crate::error::{Error, ItemKind, Result};
use crate::geom::{Outline, Point, Rect, Transform};
use crate::layer::{Layer, Layers};
use crate::param::Value;
use crate::place::{Bounded, DeferredError, Transformable};
use crate::port::Port;

/// The open cell, the only one that can be edited. [`DeviceBuilder::build`] finishes it.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (40, 0), (40, 20), (0, 20)], 1)?;
/// d.add_port("e", ((40, 10), 20, 0))?;
/// d.add_label("pad", (20, 10), 10)?;
/// let pad = d.build()?;
///
/// let mut d = Device::builder("two_pads");
/// let left = d.add_as("left", &pad);
/// let right = d.add(&pad);
/// d.mirror(right, (0, 0), (0, 1));
/// d.set_xmin(right, d.xmax("left") + 5.0);
/// d.add_port("out", d[left].port("e")?)?;
/// assert_eq!(d.build()?.bbox(), Some(Rect::new((0, 0), (85, 20))));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// A call that returns a `Result` reports its own error and changes nothing when it fails. Methods that chain cannot
/// fail: the cell keeps the first invalid one (a coordinate that is not finite, an alias that is taken, a key of another
/// cell) as a deferred error, which [`DeviceBuilder::check`] and [`DeviceBuilder::build`] return, and nothing else does.
///
/// # Placement methods
/// They take the elements that they act on first: a key, an alias, a list, or `..` for the whole cell (see [`Target`](super::Target)):
/// `d.rotate(key, 45)`, `d.align([a, b], Edge::YMax)`, `d.move_by(.., (10, 0))`, `d.xmax(..)`.
///
/// # Keys
/// A key belongs to the open cell that made it. A clone of the open cell accepts the keys that existed when it was made;
/// keys that either of the two makes later are its own. [`Device::edit`] opens a cell with keys of its own, which
/// [`DeviceBuilder::reference_keys`] and its siblings list.
///
/// # Panics
/// `d[key]`, and reading `d["alias"]`, panic like a `Vec` if the key or alias finds nothing or belongs to another cell;
/// [`DeviceBuilder::reference`] and [`DeviceBuilder::get`] return an error instead.
pub struct DeviceBuilder {
    pub(crate) cell: OpenCell,
    pub(super) keys: KeySpace,
    /// Names of polygons and labels. Those of references are part of the cell.
    pub(super) aliases: BTreeMap<SmolStr, Key>,
    deferred: Option<Box<Error>>,
}

impl DeviceBuilder {
    pub(crate) fn new(name: &str) -> Self {
        let mut builder = Self::from_cell(Cell { name: SmolStr::new(name), ..Cell::default() });
        builder.check_name();
        builder
    }

    pub(crate) fn from_cell(cell: Cell) -> Self {
        Self { keys: KeySpace::new(&cell.name), cell: cell.into(), aliases: BTreeMap::new(), deferred: None }
    }

    /// Adds an element at the end: a reference, a device (at the origin), a polygon, a label, a group, or a list of them.
    ///
    /// An invalid element is a deferred error.
    pub fn add<A: Addable>(&mut self, element: A) -> A::Key {
        element.add_to(self)
    }

    /// Draws an outline (pairs or two coordinate lists) on one layer, several, or none; one copy on each.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`], [`Error::NotFinite`].
    pub fn add_polygon(&mut self, outline: impl Outline, layers: impl Into<Layers>) -> Result<PolygonKey> {
        let layers = layers.into();
        let cell = &mut *self.cell;
        let key = self.keys.next_polygon(cell, layers.iter().len());
        let index = cell.polygons.len();
        // Checked on the drawn points, so that the usual case costs neither a buffer of its own nor a second pass.
        let first = layers.as_slice().first().copied().unwrap_or_default();
        let points = cell.polygons.push(outline, first);
        let valid = points.len() >= 3 && Point::all_finite(points);
        if !valid {
            let error = bad_outline(&cell.name, points);
            cell.polygons.pop();
            return Err(error);
        }
        match layers.as_slice() {
            [] => cell.polygons.pop(),
            [_, others @ ..] => others.iter().for_each(|layer| cell.polygons.repeat(index, *layer)),
        }
        Ok(key)
    }

    /// Draws several outlines on the same layers; all of them, or none if one is refused.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::add_polygon`].
    pub fn add_polygons<O: Outline>(
        &mut self,
        outlines: impl IntoIterator<Item = O>,
        layers: impl Into<Layers>,
    ) -> Result<Vec<PolygonKey>> {
        let (layers, before) = (layers.into(), self.cell.polygons.len());
        let added: Result<Vec<_>> = outlines.into_iter().map(|outline| self.add_polygon(outline, &layers)).collect();
        if added.is_err() {
            while self.cell.polygons.len() > before {
                self.cell.polygons.pop();
            }
        }
        added
    }

    /// Reserves memory for a number of polygons with a number of points in all. It only saves time.
    pub fn reserve(&mut self, polygons: usize, points: usize) -> &mut Self {
        self.cell.polygons.reserve(polygons, points);
        self
    }

    /// Adds a port under a name.
    ///
    /// # Errors
    /// [`Error::Duplicate`] if the name is taken; [`Error::NotFinite`] and [`Error::Invalid`] for an invalid port.
    pub fn add_port(&mut self, name: impl AsRef<str>, port: impl Into<Port>) -> Result<&mut Self> {
        self.push_port(port.into().named(name))
    }

    fn push_port(&mut self, port: Port) -> Result<&mut Self> {
        port.check(&self.cell.name)?;
        match self.cell.ports.push(port) {
            Ok(()) => Ok(self),
            Err(port) => {
                let device = self.cell.name.as_str().into();
                Err(Error::Duplicate { device, kind: ItemKind::Port, name: port.name().into() })
            }
        }
    }

    /// Adds ports under their own names, for example those of a reference: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::add_port`].
    pub fn add_ports(&mut self, ports: impl IntoIterator<Item = impl Into<Port>>) -> Result<&mut Self> {
        let before = self.cell.ports.len();
        for port in ports {
            if let Err(error) = self.push_port(port.into()).map(drop) {
                self.cell.ports.truncate(before);
                return Err(error);
            }
        }
        Ok(self)
    }

    /// Adds a centered, level text at a position. For other texts, `add` a [`Label`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the position is not finite.
    pub fn add_label(
        &mut self,
        text: impl Into<String>,
        position: impl Into<Point>,
        layer: impl Into<Layer>,
    ) -> Result<LabelKey> {
        let label = Label::new(text, position, layer);
        check_label(&label, &self.cell.name)?;
        Ok(self.add(label))
    }

    /// Records a value about the cell; a second value under the same key replaces the first.
    ///
    /// A number that is not finite is a deferred error.
    pub fn info(&mut self, key: impl Into<String>, value: impl Into<Value>) -> &mut Self {
        let (key, value) = (key.into(), value.into());
        if value.is_finite() {
            self.cell.info.insert(key, value);
        } else {
            let device = self.cell.name.as_str().into();
            let (what, value) = (format!("info \"{key}\"").into(), value.to_string().into());
            self.defer_error(Error::NotFinite { device, what, value });
        }
        self
    }

    /// The values recorded so far.
    #[must_use]
    pub fn recorded(&self) -> &BTreeMap<String, Value> {
        &self.cell.info
    }

    /// The name of the cell.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.cell.name
    }

    /// Gives the cell another name. An empty one is a deferred error.
    pub fn rename(&mut self, name: impl AsRef<str>) -> &mut Self {
        self.cell.name = SmolStr::new(name);
        self.keys.rename(&self.cell.name);
        self.check_name();
        self
    }

    /// Whether the cell can be built as it is.
    ///
    /// # Errors
    /// The deferred error, or what is wrong with an element that was moved after it was added.
    pub fn check(&self) -> Result<()> {
        match &self.deferred {
            Some(error) => Err((**error).clone()),
            None => self.check_aliases().and_then(|()| self.check_contents()),
        }
    }

    /// Finishes the cell.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::check`].
    pub fn build(mut self) -> Result<Device> {
        self.check()?;
        self.cell.polygons.shrink();
        Ok(self.cell.finish())
    }

    /// Keeps an error for `build`, if none is kept yet.
    pub(super) fn defer_error(&mut self, error: Error) {
        self.deferred.get_or_insert_with(|| Box::new(error));
    }

    pub(super) fn defer_result(&mut self, result: Result<()>) {
        if let Err(error) = result {
            self.defer_error(error);
        }
    }

    fn check_name(&mut self) {
        if self.cell.name.is_empty() {
            self.defer_error(Error::invalid("device", "the name of a cell needs at least one character"));
        }
    }

    fn check_contents(&self) -> Result<()> {
        let name = self.cell.name.as_str();
        self.cell.references.iter().try_for_each(|reference| reference.check(name))?;
        self.cell.labels.iter().try_for_each(|label| check_label(label, name))?;
        self.cell.ports.iter().try_for_each(|port| port.check(name))?;
        // Only an overflow can bring a coordinate in here that is not finite; moves are checked where they are made.
        let points = self.cell.polygons.all_points();
        let invalid = if Point::all_finite(points) { None } else { points.iter().find(|p| !p.is_finite()) };
        match invalid {
            None => Ok(()),
            Some(p) => Err(Error::NotFinite {
                device: name.into(),
                what: "a corner of a moved polygon".into(),
                value: p.to_string().into(),
            }),
        }
    }
}

impl std::fmt::Debug for DeviceBuilder {
    /// The content. (The identity of an open cell differs from run to run.)
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DeviceBuilder").field("cell", &self.cell).field("deferred", &self.deferred).finish()
    }
}

impl Clone for DeviceBuilder {
    fn clone(&self) -> Self {
        Self {
            keys: self.keys.of_clone(&self.cell),
            cell: self.cell.clone(),
            aliases: self.aliases.clone(),
            deferred: self.deferred.clone(),
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

pub(super) fn check_label(label: &Label, device: &str) -> Result<()> {
    if let Some(error) = label.deferred() {
        return Err(error.into_error(device, &format!("the label \"{}\"", label.text)));
    }
    match label.transform().is_finite() {
        true => Ok(()),
        false => Err(Error::NotFinite {
            device: device.into(),
            what: format!("the placement of the label \"{}\"", label.text).into(),
            value: label.transform().to_string().into(),
        }),
    }
}

impl Bounded for DeviceBuilder {
    /// The bounding box of all polygons and references; ports and labels do not count.
    fn bbox(&self) -> Option<Rect> {
        self.cell.bbox()
    }
}

impl Transformable for DeviceBuilder {
    fn transform_mut(&mut self, by: &Transform) {
        self.cell.transform_mut(by);
    }

    fn defer(&mut self, error: DeferredError) {
        let error = error.into_error(&self.cell.name, "the cell");
        self.defer_error(error);
    }
}
