//! [`PortMut`]: editing a port of an open cell in place.

use super::DeviceBuilder;
use crate::error::{ItemKind, Result};
use crate::geom::{Point, Rect, Transform};
use crate::param::Value;
use crate::place::{Bounded, DeferredError, Transformable};
use crate::port::Port;

/// A port of an open cell, to be changed in everything but its name; see
/// [`rename_port`](DeviceBuilder::rename_port). It also has the placement methods. An invalid value is an error of `build`.
#[derive(Debug)]
pub struct PortMut<'a>(&'a mut Port);

impl DeviceBuilder {
    /// A port of this cell, to be changed.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// let mut d = Device::builder("cell");
    /// d.add_port("in", ((0, 0), 1, 180))?;
    /// d.port_mut("in")?.set_width(7).set_midpoint((3, 0)).set_orientation(90).set_info("mode", "TE");
    /// assert_eq!(d.port("in")?.to_string(), "port \"in\" at (3, 0), 7 µm wide, facing 90°");
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) with the names that exist.
    pub fn port_mut(&mut self, name: &str) -> Result<PortMut<'_>> {
        match self.cell.ports.index_of(name) {
            Some(index) => Ok(PortMut(self.cell.ports.get_mut(index))),
            None => Err(self.cell.unknown(ItemKind::Port, name, self.cell.ports.names())),
        }
    }
}

impl PortMut<'_> {
    /// Sets the width (µm).
    pub fn set_width(self, width: impl Into<f64>) -> Self {
        self.change(|port| port.with_width(width))
    }

    /// Sets the midpoint.
    pub fn set_midpoint(self, midpoint: impl Into<Point>) -> Self {
        self.change(|port| port.with_midpoint(midpoint))
    }

    /// Sets the orientation (degrees).
    pub fn set_orientation(self, orientation: impl Into<f64>) -> Self {
        self.change(|port| port.with_orientation(orientation))
    }

    /// Sets a value of the info.
    pub fn set_info(self, key: impl Into<String>, value: impl Into<Value>) -> Self {
        self.change(|port| port.with_info(key, value))
    }

    fn change(self, change: impl FnOnce(Port) -> Port) -> Self {
        *self.0 = change(self.0.clone());
        self
    }
}

impl Bounded for PortMut<'_> {
    fn bbox(&self) -> Option<Rect> {
        self.0.bbox()
    }
}

impl Transformable for PortMut<'_> {
    fn transform_mut(&mut self, by: &Transform) {
        self.0.transform_mut(by);
    }

    fn pivot(&self) -> Point {
        self.0.pivot()
    }

    fn defer(&mut self, error: DeferredError) {
        self.0.defer(error);
    }
}
