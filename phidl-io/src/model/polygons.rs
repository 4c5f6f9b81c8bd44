//! [`Polygons`]: the polygons of a cell in one buffer of corners.

use std::collections::BTreeMap;

use phidl_core::layer::Layer;
use phidl_core::scene::Properties;

use super::Corner;

/// The polygons of one cell. The first corner is not repeated at the end.
#[derive(Debug, Clone, Default)]
pub struct Polygons {
    corners: Vec<Corner>,
    /// Where the corners of each polygon end, and its layer.
    ends: Vec<(usize, Layer)>,
    /// Few polygons have properties; by index.
    properties: BTreeMap<usize, Properties>,
}

/// One polygon of a [`Polygons`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolygonRef<'a> {
    /// Layer and datatype.
    pub layer: Layer,
    /// The corners, in order.
    pub corners: &'a [Corner],
    /// Attributes and texts.
    pub properties: Option<&'a Properties>,
}

impl Polygons {
    /// Appends a polygon.
    pub fn push(&mut self, layer: Layer, corners: impl IntoIterator<Item = Corner>) {
        self.corners.extend(corners);
        self.ends.push((self.corners.len(), layer));
    }

    /// Gives properties to the last polygon.
    pub fn set_properties(&mut self, properties: Properties) {
        if let Some(last) = self.ends.len().checked_sub(1).filter(|_| !properties.is_empty()) {
            self.properties.insert(last, properties);
        }
    }

    /// The properties of all polygons that have some, in order.
    #[cfg(feature = "oasis")]
    pub(crate) fn properties(&self) -> impl Iterator<Item = &Properties> {
        self.properties.values()
    }

    /// The properties of a polygon, to add some.
    #[cfg(feature = "oasis")]
    pub(crate) fn properties_mut(&mut self, index: usize) -> &mut Properties {
        self.properties.entry(index).or_default()
    }

    /// How many polygons there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no polygon.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of all polygons.
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The polygons in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = PolygonRef<'_>> + Clone {
        (0..self.ends.len()).map(|index| {
            let start = if index == 0 { 0 } else { self.ends[index - 1].0 };
            let (end, layer) = self.ends[index];
            let properties = if self.properties.is_empty() { None } else { self.properties.get(&index) };
            PolygonRef { layer, corners: &self.corners[start..end], properties }
        })
    }

    pub(crate) fn clear(&mut self) {
        self.corners.clear();
        self.ends.clear();
        self.properties.clear();
    }
}
