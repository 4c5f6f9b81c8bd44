//! [`Outlines`]: all polygons of a cell, flat.
//!
//! One buffer holds the points of all outlines, one the end and the layer of each. A cell of a million rectangles is two
//! allocations, walks run through memory in order, and a copy is two copies of memory. A `Vec` of polygons would cost an
//! allocation and a jump for each.

use std::collections::BTreeMap;

use super::Properties;
use crate::geom::{Outline, Point, Rect, signed_area};
use crate::layer::Layer;

/// The polygons of one cell.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outlines {
    points: Vec<Point>,
    spans: Vec<Span>,
    /// Few polygons have any: kept apart, by place.
    properties: BTreeMap<usize, Properties>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    /// Where the points end; they begin where those of the span before end.
    pub(super) end: usize,
    pub(super) layer: Layer,
}

/// A polygon as it is stored in a cell.
#[derive(Debug, Clone, Copy)]
pub struct PolygonView<'a> {
    /// The corners, in order.
    pub points: &'a [Point],
    /// Where it is drawn.
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

impl Outlines {
    pub(crate) fn len(&self) -> usize {
        self.spans.len()
    }

    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn reserve(&mut self, polygons: usize, points: usize) {
        self.spans.reserve(polygons);
        self.points.reserve(points);
    }

    /// Appends an outline and returns its points, for the caller to check or to fill.
    #[inline]
    pub(crate) fn push(&mut self, outline: impl Outline, layer: Layer) -> &mut [Point] {
        let start = self.points.len();
        outline.append_to(&mut self.points);
        self.spans.push(Span { end: self.points.len(), layer });
        &mut self.points[start..]
    }

    /// Appends the image of an outline.
    pub(crate) fn push_mapped(&mut self, points: &[Point], layer: Layer, image: impl Fn(Point) -> Point) {
        self.points.extend(points.iter().map(|p| image(*p)));
        self.spans.push(Span { end: self.points.len(), layer });
    }

    /// Takes the last outline back.
    pub(crate) fn pop(&mut self) {
        self.spans.pop();
        self.points.truncate(self.spans.last().map_or(0, |s| s.end));
    }

    /// Appends a copy of the outline at a place on another layer.
    pub(crate) fn repeat(&mut self, place: usize, layer: Layer) {
        let range = self.range(place);
        self.points.extend_from_within(range);
        self.spans.push(Span { end: self.points.len(), layer });
        if let Some(properties) = self.properties.get(&place) {
            self.properties.insert(self.spans.len() - 1, properties.clone());
        }
    }

    pub(crate) fn get(&self, place: usize) -> PolygonView<'_> {
        PolygonView {
            points: &self.points[self.range(place)],
            layer: self.spans[place].layer,
            properties: if self.properties.is_empty() { None } else { self.properties.get(&place) },
        }
    }

    pub(crate) fn points_mut(&mut self, place: usize) -> &mut [Point] {
        let range = self.range(place);
        &mut self.points[range]
    }

    pub(crate) fn all_points(&self) -> &[Point] {
        &self.points
    }

    pub(crate) fn all_points_mut(&mut self) -> &mut [Point] {
        &mut self.points
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = PolygonView<'_>> + DoubleEndedIterator + Clone {
        (0..self.len()).map(|place| self.get(place))
    }

    pub(crate) fn set_properties(&mut self, place: usize, properties: Properties) {
        if properties.is_empty() {
            self.properties.remove(&place);
        } else {
            self.properties.insert(place, properties);
        }
    }

    pub(crate) fn set_layer(&mut self, place: usize, layer: Layer) {
        self.spans[place].layer = layer;
    }

    pub(crate) fn bbox(&self) -> Option<Rect> {
        Rect::around(self.points.iter().copied())
    }

    /// Keeps the polygons for which the test holds; returns the places of the others, ascending.
    pub(crate) fn retain(&mut self, mut keep: impl FnMut(PolygonView<'_>) -> bool) -> Vec<usize> {
        let mut kept = Self::default();
        let mut removed = Vec::new();
        for (place, polygon) in self.iter().enumerate() {
            if keep(polygon) {
                kept.push_view(polygon);
            } else {
                removed.push(place);
            }
        }
        if !removed.is_empty() {
            *self = kept;
        }
        removed
    }

    /// Appends a stored polygon of any cell with all it has.
    pub(crate) fn push_view(&mut self, polygon: PolygonView<'_>) {
        self.push_mapped(polygon.points, polygon.layer, |p| p);
        if let Some(properties) = polygon.properties {
            self.properties.insert(self.spans.len() - 1, properties.clone());
        }
    }

    /// Bytes on the heap.
    pub(crate) fn heap_size(&self) -> usize {
        self.points.capacity() * size_of::<Point>() + self.spans.capacity() * size_of::<Span>()
    }

    /// Gives back memory that growing left over, where it is much.
    pub(crate) fn shrink(&mut self) {
        /// Room for so many things costs less than another allocation.
        const LITTLE: usize = 16;
        if self.points.capacity() > 2 * self.points.len() + LITTLE {
            self.points.shrink_to_fit();
        }
        if self.spans.capacity() > 2 * self.spans.len() + LITTLE {
            self.spans.shrink_to_fit();
        }
    }

    fn range(&self, place: usize) -> std::ops::Range<usize> {
        let start = if place == 0 { 0 } else { self.spans[place - 1].end };
        start..self.spans[place].end
    }

    /// All points, and where each polygon ends in them: for the parallel flatten, which fills them out of order.
    #[cfg(feature = "parallel")]
    pub(super) fn from_parts(points: Vec<Point>, spans: Vec<Span>) -> Self {
        Self { points, spans, properties: BTreeMap::new() }
    }

    #[cfg(feature = "parallel")]
    pub(super) fn span(&self, place: usize) -> Span {
        self.spans[place]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_keep_their_points_layers_and_properties_when_others_go() {
        let mut outlines = Outlines::default();
        outlines.push([(0, 0), (1, 0), (0, 1)], Layer::new(1, 0));
        outlines.push([(5, 5), (6, 5), (6, 6), (5, 6)], Layer::new(2, 0));
        outlines.set_properties(1, Properties::from([(3, "x".to_owned())]));
        outlines.repeat(1, Layer::new(4, 0));
        assert_eq!(outlines.retain(|p| p.layer.number != 1), [0]);
        assert_eq!(outlines.len(), 2);
        assert_eq!(outlines.get(0).points, outlines.get(1).points);
        assert_eq!(outlines.get(1).properties().collect::<Vec<_>>(), [(3, "x")]);
        outlines.pop();
        assert_eq!((outlines.len(), outlines.point_count()), (1, 4));
    }
}
