//! Polygons for the geo crates: conversions between ours and those of geo-types.
//!
//! geo-types closes its rings with a copy of the first point; ours do not. Its polygons may have holes, which a polygon of
//! a mask cannot have: such a polygon is refused here and belongs into a region of phidl-boolean.

use geo_types::{Coord, LineString, MultiPolygon};

use super::{Device, Polygon};
use crate::error::{Error, Result};
use crate::geom::{Outline, Point, Rect};
use crate::layer::Layers;

/// A closed line string is an outline; its last point, a copy of the first, is dropped.
impl Outline for &LineString<f64> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        let closed = self.0.len() > 1 && self.0.first() == self.0.last();
        let own = if closed { &self.0[..self.0.len() - 1] } else { &self.0[..] };
        buffer.extend(own.iter().map(|coord| Point::from(*coord)));
    }
}

impl Outline for LineString<f64> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        (&self).append_to(buffer);
    }
}

/// The ring through these points, closed.
fn ring(points: impl IntoIterator<Item = Point>) -> LineString<f64> {
    let mut line: LineString<f64> = points.into_iter().map(Coord::from).collect();
    line.close();
    line
}

impl From<&Polygon> for geo_types::Polygon<f64> {
    fn from(polygon: &Polygon) -> Self {
        Self::new(ring(polygon.points.iter().copied()), Vec::new())
    }
}

/// A polygon on layer 0; set `layers` for another one.
impl TryFrom<&geo_types::Polygon<f64>> for Polygon {
    type Error = Error;

    fn try_from(polygon: &geo_types::Polygon<f64>) -> Result<Self> {
        match polygon.interiors().len() {
            0 => Ok(Self::new(polygon.exterior(), 0)),
            1 => Err(Error::custom("polygon", "the polygon has a hole, but a polygon of a mask has none")),
            n => Err(Error::custom("polygon", format!("the polygon has {n} holes, but a polygon of a mask has none"))),
        }
    }
}

impl From<Rect> for geo_types::Rect<f64> {
    fn from(rect: Rect) -> Self {
        Self::new(rect.min, rect.max)
    }
}

impl From<geo_types::Rect<f64>> for Rect {
    fn from(rect: geo_types::Rect<f64>) -> Self {
        Self::new(rect.min(), rect.max())
    }
}

impl Device {
    /// The polygons on some layers at every depth, in the coordinates of this cell, for algorithms of the geo crates.
    ///
    /// They are as drawn: they may overlap or touch, which algorithms on a `MultiPolygon` usually exclude. Merge them
    /// first where that matters (`phidl_boolean::union`).
    ///
    /// # Examples
    /// ```
    /// use phidl_core::prelude::*;
    /// let mut d = Device::builder("pad");
    /// d.add_polygon([(0, 0), (4, 0), (4, 3)], 1)?;
    /// let triangles = d.build()?.to_multi_polygon(1);
    /// assert_eq!(triangles.0[0].exterior().0.len(), 4); // closed
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn to_multi_polygon(&self, layers: impl Into<Layers>) -> MultiPolygon<f64> {
        let layers = layers.into();
        let drawn = self.flat_polygons().filter(|polygon| polygon.layer.is_some_and(|layer| layers.contains(layer)));
        MultiPolygon::new(drawn.map(|polygon| geo_types::Polygon::new(ring(polygon.points()), Vec::new())).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_go_there_and_back() {
        let drawn = Polygon::new([(0, 0), (4, 0), (4, 3)], 0);
        let theirs = geo_types::Polygon::from(&drawn);
        assert!(theirs.exterior().is_closed());
        assert_eq!(Polygon::try_from(&theirs), Ok(drawn));
    }

    #[test]
    fn holes_are_refused() {
        let [outer, hole] = [8, 2].map(|side| ring([(0, 0), (side, 0), (side, side)].map(Point::from)));
        let error = Polygon::try_from(&geo_types::Polygon::new(outer, vec![hole])).unwrap_err();
        assert_eq!(error.to_string(), "polygon: the polygon has a hole, but a polygon of a mask has none");
    }

    #[test]
    fn a_layer_of_a_hierarchy_is_in_the_coordinates_of_the_top_cell() {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (1, 0), (1, 1)], 1).unwrap();
        d.add_polygon([(0, 0), (9, 0), (9, 9)], 2).unwrap();
        let dot = d.build().unwrap();
        let mut d = Device::builder("row");
        d.add(dot.array(3, 1, (10, 0)));
        let row = d.build().unwrap().to_multi_polygon(1);
        let left: Vec<f64> = row.iter().map(|polygon| polygon.exterior().0[0].x).collect();
        assert_eq!(left, [0.0, 10.0, 20.0]);
    }
}
