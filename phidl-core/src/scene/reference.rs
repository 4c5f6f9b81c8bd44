//! [`Reference`]: one placement, or a regular array of placements, of a finished cell.

use super::{Device, Element, Group, Properties};
use crate::error::{Error, Result};
use crate::geom::{Point, Rect, Transform};
use crate::num::angle;
use crate::place::{Bounded, DeferredError, Movable, Transformable};
use crate::port::Port;

/// One placement of a [`Device`], or a regular array of placements: an ordinary value. Make it with [`Device::place`] or
/// [`Device::array`], move it, relate it, connect it, then add it to an open cell.
///
/// ```
/// # use phidl_core::prelude::*;
/// let mut d = Device::builder("bar");
/// d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
/// d.add_port("w", ((0, 1), 2, 180))?;
/// d.add_port("e", ((4, 1), 2, 0))?;
/// let bar = d.build()?;
///
/// let first = bar.place().moved_by((10, 20)).rotated(30);
/// let mut second = bar.place();
/// second.connect("w", &first.port("e")?)?;
/// assert_eq!(second.transform().rotation, 30.0);
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    device: Device,
    transform: Transform,
    array: Option<Box<Array>>,
    /// Numbered texts that a file keeps with it.
    pub properties: Properties,
    deferred: Option<Box<DeferredError>>,
}

/// The lattice of an array. Steps are in the array's own frame: the reference mirrors and rotates them but does not
/// magnify them (as in GDSII, where an array states its extent).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Array {
    /// The number of columns.
    pub columns: u32,
    /// The number of rows.
    pub rows: u32,
    /// From one column to the next (µm).
    pub column_step: Point,
    /// From one row to the next (µm).
    pub row_step: Point,
}

impl Array {
    /// The step to one element, in the array's own frame.
    #[must_use]
    pub fn step(&self, column: u32, row: u32) -> Point {
        self.column_step * f64::from(column) + self.row_step * f64::from(row)
    }

    /// The number of elements.
    #[must_use]
    pub fn count(&self) -> usize {
        self.columns as usize * self.rows as usize
    }

    /// Column and row of every element: columns outside, rows inside.
    pub fn cells(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let rows = self.rows;
        (0..self.columns).flat_map(move |column| (0..rows).map(move |row| (column, row)))
    }

    fn is_finite(&self) -> bool {
        self.column_step.is_finite() && self.row_step.is_finite()
    }
}

impl Reference {
    /// A placement of a cell.
    #[must_use]
    pub fn new(device: Device, transform: Transform) -> Self {
        Self { device, transform, array: None, properties: Properties::new(), deferred: None }
    }

    /// The same placement repeated on a lattice.
    #[must_use]
    pub fn with_array(self, array: Array) -> Self {
        let single = array.columns == 1 && array.rows == 1;
        Self { array: (!single).then(|| Box::new(array)), ..self }
    }

    /// The same with one more property.
    #[must_use]
    pub fn with_property(mut self, attribute: u16, text: impl Into<String>) -> Self {
        self.properties.insert(attribute, text.into());
        self
    }

    /// The placed cell.
    #[must_use]
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The same placement of another cell.
    #[must_use]
    pub fn with_device(self, device: Device) -> Self {
        Self { device, ..self }
    }

    /// The same reference with another transform; the steps of an array do not change.
    #[must_use]
    pub fn with_transform(self, transform: Transform) -> Self {
        let rotation = angle::normalized(transform.rotation);
        Self { transform: Transform { rotation, ..transform }, ..self }
    }

    /// The transform; of an array, that of its first element.
    #[must_use]
    pub fn transform(&self) -> &Transform {
        &self.transform
    }

    /// The lattice, if this is an array.
    #[must_use]
    pub fn array(&self) -> Option<&Array> {
        self.array.as_deref()
    }

    /// The number of placements of the cell.
    #[must_use]
    pub fn count(&self) -> usize {
        self.array().map_or(1, Array::count)
    }

    /// The transform of one element of an array; (0, 0) is that of a single placement.
    #[must_use]
    pub fn element(&self, column: u32, row: u32) -> Transform {
        match self.array() {
            None => self.transform,
            Some(array) => self.stepped(array.step(column, row)),
        }
    }

    /// The transform of every element: columns outside, rows inside.
    pub fn elements(&self) -> impl Iterator<Item = Transform> + '_ {
        let array = self.array().copied().unwrap_or(Array {
            columns: 1,
            rows: 1,
            column_step: Point::ORIGIN,
            row_step: Point::ORIGIN,
        });
        array.cells().map(move |(column, row)| self.stepped(array.step(column, row)))
    }

    /// The transforms of the elements in the corners of the lattice; of a single placement, its own.
    pub(crate) fn corner_elements(&self) -> Vec<Transform> {
        let Some(array) = self.array() else { return vec![self.transform] };
        if array.count() == 0 {
            return Vec::new();
        }
        let (column, row) = (array.columns - 1, array.rows - 1);
        [(0, 0), (column, 0), (0, row), (column, row)].map(|(c, r)| self.element(c, r)).to_vec()
    }

    /// A step in the array's own frame, as a displacement in the coordinates of the reference.
    #[must_use]
    pub fn placed_step(&self, step: Point) -> Point {
        Transform { magnification: 1.0, ..self.transform }.apply_vector(step)
    }

    fn stepped(&self, step: Point) -> Transform {
        Transform { origin: self.transform.origin + self.placed_step(step), ..self.transform }
    }

    /// A port of the placed cell, in the coordinates of the reference.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist; [`Error::Invalid`] for an array, whose elements have a port
    /// of this name each (ask [`Reference::port_at`]).
    pub fn port(&self, name: &str) -> Result<Port> {
        if self.array.is_some() {
            let problem =
                format!("every element of the array has a port \"{name}\"; port_at takes one by column and row");
            return Err(Error::invalid(self.device.name(), problem));
        }
        self.port_at(name, 0, 0)
    }

    /// A port of one element of an array, in the coordinates of the reference.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist; [`Error::Invalid`] if there is no such column or row.
    pub fn port_at(&self, name: &str, column: u32, row: u32) -> Result<Port> {
        let (columns, rows) = self.array().map_or((1, 1), |a| (a.columns, a.rows));
        if column >= columns || row >= rows {
            let problem = format!(
                "the array has no element in column {column}, row {row}: its size is {columns} x {rows}, counted from 0"
            );
            return Err(Error::invalid(self.device.name(), problem));
        }
        let mut port = self.device.port(name)?.clone();
        port.transform_mut(&self.element(column, row));
        Ok(port)
    }

    /// All ports of the placed cell, in the coordinates of the reference; of an array, those of its first element.
    pub fn ports(&self) -> impl Iterator<Item = Port> + '_ {
        self.device.ports().map(|port| {
            let mut port = port.clone();
            port.transform_mut(&self.transform);
            port
        })
    }

    /// Rotates and moves this reference until its port `own` meets `target` face to face.
    ///
    /// # Errors
    /// As for [`Reference::port`], and [`Error::NotFinite`] if `target` is not finite.
    pub fn connect(&mut self, own: &str, target: impl AsRef<Port>) -> Result<&mut Self> {
        self.connect_overlapping(own, target, 0.0)
    }

    /// As [`Reference::connect`], pushed `overlap` µm into the target (a negative one leaves a gap).
    ///
    /// # Errors
    /// As for [`Reference::connect`], and [`Error::NotFinite`] if the overlap is not finite.
    pub fn connect_overlapping(
        &mut self,
        own: &str,
        target: impl AsRef<Port>,
        overlap: impl Into<f64>,
    ) -> Result<&mut Self> {
        let (target, overlap) = (target.as_ref(), overlap.into());
        self.check(self.device.name())?;
        target.check(self.device.name())?;
        if !overlap.is_finite() {
            return Err(Error::NotFinite {
                device: self.device.name().into(),
                what: "the overlap of connect".into(),
                value: overlap.to_string().into(),
            });
        }
        let port = self.port(own)?;
        let turn = angle::normalized(target.orientation() + 180.0 - port.orientation());
        self.rotate_about(turn, port.midpoint());
        // The rotation may leave noise on the port; its midpoint is read again, so that both midpoints coincide.
        let turned = self.port(own)?.midpoint();
        self.move_by(target.midpoint() - turned - target.normal() * overlap);
        Ok(self)
    }

    /// The reference under an alias of the placed cell, in the coordinates of this reference: a value, not an element.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the aliases that exist.
    pub fn get(&self, alias: &str) -> Result<Reference> {
        let mut inner = self.device.get(alias)?.clone();
        inner.transform_mut(&self.transform);
        Ok(inner)
    }

    /// A cell with this reference as its only element, named after the placed cell, with its ports: for functions that take
    /// a device.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// # let mut d = Device::builder("pad");
    /// # d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
    /// # let pad = d.build()?;
    /// let moved = pad.place().moved_by((10, 0)).to_device()?;
    /// assert_eq!(moved.bbox(), Some(Rect::new((10, 0), (14, 2))));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`DeviceBuilder::add`](crate::scene::DeviceBuilder::add): a transform that is not finite, or a
    /// deferred error.
    pub fn to_device(&self) -> Result<Device> {
        let mut d = Device::builder(self.device.name());
        d.add(self.clone());
        d.add_ports(self.ports())?;
        d.build()
    }

    /// Refuses an invalid reference in the name of a cell.
    pub(crate) fn check(&self, device: &str) -> Result<()> {
        let what = || format!("reference to \"{}\"", self.device.name());
        if let Some(error) = &self.deferred {
            return Err(error.into_error(device, &format!("the {}", what())));
        }
        if self.count() == 0 {
            let (columns, rows) = self.array().map_or((1, 1), |a| (a.columns, a.rows));
            let problem = format!(
                "the array {} has {columns} columns and {rows} rows, but it needs at least one of each",
                what()
            );
            return Err(Error::invalid(device, problem));
        }
        let finite = self.transform.is_finite() && self.array().is_none_or(Array::is_finite);
        if finite {
            return Ok(());
        }
        Err(Error::NotFinite {
            device: device.into(),
            what: format!("the placement of the {}", what()).into(),
            value: self.described_placement().into(),
        })
    }

    /// The placement as error texts print it.
    fn described_placement(&self) -> String {
        let steps = self.array().map(|a| format!(", with array steps {} and {}", a.column_step, a.row_step));
        format!("{}{}", self.transform, steps.unwrap_or_default())
    }

    pub(crate) fn set_device(&mut self, device: Device) {
        self.device = device;
    }
}

impl Bounded for Reference {
    fn bbox(&self) -> Option<Rect> {
        let single = match self.transform.apply_rect(self.device.bbox()?) {
            Some(rect) => rect,
            None => {
                let matrix = self.transform.matrix();
                Rect::around(self.device.hull().iter().map(|p| matrix.apply(*p)))?
            }
        };
        let Some(array) = self.array() else { return Some(single) };
        if array.count() == 0 {
            return None;
        }
        // Displaced copies of one box: the corners of the lattice decide.
        let (column, row) = (array.columns - 1, array.rows - 1);
        let corners = [(0, 0), (column, 0), (0, row), (column, row)];
        Rect::union_all(corners.map(|(column, row)| Some(single.shifted(self.placed_step(array.step(column, row))))))
    }
}

impl Transformable for Reference {
    fn transform_mut(&mut self, by: &Transform) {
        self.transform = self.transform.then(by);
        if let Some(array) = &mut self.array {
            array.column_step = array.column_step * by.magnification;
            array.row_step = array.row_step * by.magnification;
        }
    }

    fn defer(&mut self, error: DeferredError) {
        self.deferred.get_or_insert(Box::new(error));
    }
}

impl From<Device> for Reference {
    fn from(device: Device) -> Self {
        device.place()
    }
}

impl From<&Device> for Reference {
    fn from(device: &Device) -> Self {
        device.place()
    }
}

impl<E: Into<Element>> std::ops::Add<E> for Reference {
    type Output = Group;
    fn add(self, other: E) -> Group {
        Group::from(self) + other
    }
}
