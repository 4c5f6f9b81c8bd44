//! [`PolygonStore`]: all polygons of a cell in flat buffers.
//!
//! One buffer holds the points of all outlines, one the end and the layer of each. A cell of a million rectangles is two
//! allocations, iteration runs through memory in order, and a copy is two copies of memory. A `Vec` of polygons would cost
//! an allocation and a cache miss for each.

use std::collections::BTreeMap;

use super::Properties;
use crate::geom::{Outline, Point, Rect, signed_area};
use crate::layer::Layer;

/// The polygons of one cell.
#[derive(Debug, Clone, Default)]
pub(crate) struct PolygonStore {
    points: Vec<Point>,
    entries: Vec<StoreEntry>,
    /// By index; few polygons have any.
    properties: BTreeMap<usize, Properties>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct StoreEntry {
    /// The end of the points; they begin at the end of the entry before.
    pub(super) end: usize,
    pub(super) layer: Layer,
}

/// A polygon as it is stored in a cell.
#[derive(Debug, Clone, Copy)]
pub struct PolygonView<'a> {
    /// The corners, in order.
    pub points: &'a [Point],
    /// The layer.
    pub layer: Layer,
    properties: Option<&'a Properties>,
}

impl<'a> PolygonView<'a> {
    /// Texts that a file keeps with it: attribute and text.
    pub fn properties(&self) -> impl Iterator<Item = (u16, &'a str)> + use<'a> {
        self.properties.into_iter().flatten().map(|(attribute, text)| (*attribute, text.as_str()))
    }

    /// Area (µm²), whatever the direction of the outline.
    #[must_use]
    pub fn area(&self) -> f64 {
        signed_area(self.points).abs()
    }

    pub(crate) fn property_map(&self) -> Option<&'a Properties> {
        self.properties
    }
}

impl PolygonStore {
    pub(crate) fn len(&self) -> usize {
        self.entries.len()
    }

    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn reserve(&mut self, polygons: usize, points: usize) {
        self.entries.reserve(polygons);
        self.points.reserve(points);
    }

    /// Appends an outline and returns its points for the caller to check.
    #[inline]
    pub(crate) fn push(&mut self, outline: impl Outline, layer: Layer) -> &mut [Point] {
        let start = self.points.len();
        outline.append_to(&mut self.points);
        self.entries.push(StoreEntry { end: self.points.len(), layer });
        &mut self.points[start..]
    }

    /// Appends an outline with a map applied to its points.
    pub(crate) fn push_mapped(&mut self, points: &[Point], layer: Layer, image: impl Fn(Point) -> Point) {
        self.points.extend(points.iter().map(|p| image(*p)));
        self.entries.push(StoreEntry { end: self.points.len(), layer });
    }

    /// Removes the last polygon.
    pub(crate) fn pop(&mut self) {
        self.entries.pop();
        self.points.truncate(self.entries.last().map_or(0, |s| s.end));
    }

    /// Appends a copy of the outline at a index on another layer.
    pub(crate) fn repeat(&mut self, index: usize, layer: Layer) {
        let range = self.range(index);
        self.points.extend_from_within(range);
        self.entries.push(StoreEntry { end: self.points.len(), layer });
        if let Some(properties) = self.properties.get(&index) {
            self.properties.insert(self.entries.len() - 1, properties.clone());
        }
    }

    pub(crate) fn get(&self, index: usize) -> PolygonView<'_> {
        PolygonView {
            points: &self.points[self.range(index)],
            layer: self.entries[index].layer,
            properties: if self.properties.is_empty() { None } else { self.properties.get(&index) },
        }
    }

    pub(crate) fn points_mut(&mut self, index: usize) -> &mut [Point] {
        let range = self.range(index);
        &mut self.points[range]
    }

    pub(crate) fn all_points(&self) -> &[Point] {
        &self.points
    }

    pub(crate) fn all_points_mut(&mut self) -> &mut [Point] {
        &mut self.points
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = PolygonView<'_>> + DoubleEndedIterator + Clone {
        (0..self.len()).map(|index| self.get(index))
    }

    pub(crate) fn set_properties(&mut self, index: usize, properties: Properties) {
        if properties.is_empty() {
            self.properties.remove(&index);
        } else {
            self.properties.insert(index, properties);
        }
    }

    pub(crate) fn set_layer(&mut self, index: usize, layer: Layer) {
        self.entries[index].layer = layer;
    }

    pub(crate) fn bbox(&self) -> Option<Rect> {
        Rect::around(self.points.iter().copied())
    }

    /// Keeps the polygons for which the test holds; returns the indices of the others, ascending.
    pub(crate) fn retain(&mut self, mut keep: impl FnMut(PolygonView<'_>) -> bool) -> Vec<usize> {
        let mut kept = Self::default();
        let mut removed = Vec::new();
        for (index, polygon) in self.iter().enumerate() {
            if keep(polygon) {
                kept.push_view(polygon);
            } else {
                removed.push(index);
            }
        }
        if !removed.is_empty() {
            *self = kept;
        }
        removed
    }

    /// Appends a polygon of any cell with its properties.
    pub(crate) fn push_view(&mut self, polygon: PolygonView<'_>) {
        self.push_mapped(polygon.points, polygon.layer, |p| p);
        if let Some(properties) = polygon.properties {
            self.properties.insert(self.entries.len() - 1, properties.clone());
        }
    }

    /// Bytes on the heap.
    pub(crate) fn heap_size(&self) -> usize {
        self.points.capacity() * size_of::<Point>() + self.entries.capacity() * size_of::<StoreEntry>()
    }

    /// Frees unused capacity if it is large.
    pub(crate) fn shrink(&mut self) {
        /// Unused capacity of this size costs less than another allocation.
        const LITTLE: usize = 16;
        if self.points.capacity() > 2 * self.points.len() + LITTLE {
            self.points.shrink_to_fit();
        }
        if self.entries.capacity() > 2 * self.entries.len() + LITTLE {
            self.entries.shrink_to_fit();
        }
    }

    fn range(&self, index: usize) -> std::ops::Range<usize> {
        let start = if index == 0 { 0 } else { self.entries[index - 1].end };
        start..self.entries[index].end
    }

    /// A store from its buffers, for parallel flattening, which fills them out of order.
    #[cfg(feature = "parallel")]
    pub(super) fn from_parts(points: Vec<Point>, entries: Vec<StoreEntry>) -> Self {
        Self { points, entries, properties: BTreeMap::new() }
    }

    #[cfg(feature = "parallel")]
    pub(super) fn entry(&self, index: usize) -> StoreEntry {
        self.entries[index]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_keep_points_layers_and_properties_when_others_are_removed() {
        let mut polygons = PolygonStore::default();
        polygons.push([(0, 0), (1, 0), (0, 1)], Layer::new(1, 0));
        polygons.push([(5, 5), (6, 5), (6, 6), (5, 6)], Layer::new(2, 0));
        polygons.set_properties(1, Properties::from([(3, "x".to_owned())]));
        polygons.repeat(1, Layer::new(4, 0));
        assert_eq!(polygons.retain(|p| p.layer.number != 1), [0]);
        assert_eq!(polygons.len(), 2);
        assert_eq!(polygons.get(0).points, polygons.get(1).points);
        assert_eq!(polygons.get(1).properties().collect::<Vec<_>>(), [(3, "x")]);
        polygons.pop();
        assert_eq!((polygons.len(), polygons.point_count()), (1, 4));
    }
}
