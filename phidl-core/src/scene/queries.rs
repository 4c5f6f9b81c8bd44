//! Questions to an open cell and to a reference that a finished cell answers as well.

use std::collections::BTreeMap;

use super::walk::{FlatPolygons, Instances};
use super::{Device, DeviceBuilder, Reference};
use crate::error::{Error, Result};
use crate::geom::Point;
use crate::layer::Layer;
use crate::param::Value;

impl Device {
    /// The outlines of all polygons of the hierarchy by layer, in the order of [`Device::flat_polygons`].
    ///
    /// # Errors
    /// [`Error::TooLarge`] beyond [`FLAT_LIMIT`](super::FLAT_LIMIT).
    pub fn polygons_by_layer(&self) -> Result<BTreeMap<Layer, Vec<Vec<Point>>>> {
        self.check_flat_size(super::FLAT_LIMIT)?;
        let mut layers: BTreeMap<Layer, Vec<Vec<Point>>> = BTreeMap::new();
        for polygon in self.flat_polygons() {
            let Some(layer) = polygon.layer else { continue };
            layers.entry(layer).or_default().push(polygon.points().collect());
        }
        Ok(layers)
    }
}

impl DeviceBuilder {
    /// The cell as it is now, finished; the open cell stays open.
    ///
    /// # Errors
    /// As for [`DeviceBuilder::build`].
    pub fn to_device(&self) -> Result<Device> {
        self.clone().build()
    }

    /// As [`Device::layers`].
    #[must_use]
    pub fn layers(&self) -> Vec<Layer> {
        self.area_by_layer().into_keys().collect()
    }

    /// As [`Device::area`].
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area_by_layer().values().sum()
    }

    /// As [`Device::area_by_layer`].
    #[must_use]
    pub fn area_by_layer(&self) -> BTreeMap<Layer, f64> {
        let mut areas: BTreeMap<Layer, f64> = BTreeMap::new();
        for polygon in self.polygons() {
            *areas.entry(polygon.layer).or_default() += polygon.area();
        }
        for (layer, area) in self.references().flat_map(Reference::area_by_layer) {
            *areas.entry(layer).or_default() += area;
        }
        areas
    }

    /// As [`Device::polygons_by_layer`].
    ///
    /// # Errors
    /// As for [`Device::polygons_by_layer`] and [`DeviceBuilder::build`].
    pub fn polygons_by_layer(&self) -> Result<BTreeMap<Layer, Vec<Vec<Point>>>> {
        self.to_device()?.polygons_by_layer()
    }

    /// As [`Device::hash_geometry`].
    ///
    /// # Errors
    /// As for [`Device::hash_geometry`] and [`DeviceBuilder::build`].
    pub fn hash_geometry(&self, precision: f64) -> Result<String> {
        self.to_device()?.hash_geometry(precision)
    }
}

impl Reference {
    /// The info of the placed cell.
    #[must_use]
    pub fn info(&self) -> &BTreeMap<String, Value> {
        self.device().info()
    }

    /// The layers of all polygons that are placed, ascending.
    #[must_use]
    pub fn layers(&self) -> Vec<Layer> {
        self.device().layers()
    }

    /// The area of all polygons that are placed (µm²); where polygons overlap, both count.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area_by_layer().values().sum()
    }

    /// The area of all polygons that are placed by layer (µm²); where polygons overlap, both count.
    #[must_use]
    pub fn area_by_layer(&self) -> BTreeMap<Layer, f64> {
        let factor = self.transform().magnification.powi(2) * self.count() as f64;
        self.device().area_by_layer().into_iter().map(|(layer, area)| (layer, area * factor)).collect()
    }

    /// Every polygon that is placed, in the coordinates of the reference, element by element.
    pub fn flat_polygons(&self) -> impl Iterator<Item = super::FlatPolygon<'_>> {
        self.elements().flat_map(|element| FlatPolygons::of(Instances::new(self.device(), element)))
    }

    /// As [`Device::hash_geometry`], of what is placed.
    ///
    /// # Errors
    /// As for [`Device::hash_geometry`], and an invalid placement.
    pub fn hash_geometry(&self, precision: f64) -> Result<String, Error> {
        self.to_device()?.hash_geometry(precision)
    }
}

impl std::fmt::Display for Reference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let transform = self.transform();
        write!(f, "Reference (device {:?}, origin {}", self.device().name(), transform.origin)?;
        write!(f, ", rotation {}°, magnification {}", transform.rotation, transform.magnification)?;
        write!(f, ", x_reflection {}", transform.x_reflection)?;
        match self.array() {
            Some(array) => write!(f, ", {} x {} elements)", array.columns, array.rows),
            None => f.write_str(")"),
        }
    }
}
