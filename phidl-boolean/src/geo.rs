//! Regions for the geo crates: conversions to and from the multi-polygons of geo-types, holes included.
//!
//! On the grid the conversion is exact, with coordinates in steps (`MultiPolygon<i64>`). In micrometers the step is
//! given by the caller, since a region does not know it.

use geo_types::{Coord, CoordNum, LineString, MultiPolygon, Polygon};

use crate::{
    contours::Contours,
    engine::{Operand, Rule, resolve},
    error::BooleanError,
    grid,
    op::{Fill, Operation},
    options::RunOptions,
    point::{GridPoint, signed_area2},
    region::Region,
};

/// The polygons of a region with their holes, each ring mapped point by point and closed.
fn converted<T: CoordNum>(region: &Region, map: impl Fn(GridPoint) -> Coord<T>) -> MultiPolygon<T> {
    let ring = |points: &[GridPoint]| {
        let mut line: LineString<T> = points.iter().map(|point| map(*point)).collect();
        line.close();
        line
    };
    let polygon =
        |polygon: grid::RegionPolygon<'_>| Polygon::new(ring(polygon.outer()), polygon.holes().map(ring).collect());
    MultiPolygon::new(region.polygons().map(polygon).collect())
}

/// Rings as winding numbers need them: outer rings counter-clockwise, holes clockwise.
fn oriented(rings: impl Iterator<Item = (Vec<GridPoint>, bool)>) -> Contours {
    let mut contours = Contours::new();
    for (mut ring, is_outer) in rings {
        if (signed_area2(&ring) > 0) != is_outer {
            ring.reverse();
        }
        contours.push(ring);
    }
    contours
}

/// Every ring of a multi-polygon, and whether it is an outer one.
fn rings<T: CoordNum>(polygons: &MultiPolygon<T>) -> impl Iterator<Item = (&LineString<T>, bool)> {
    polygons.iter().flat_map(|polygon| {
        let holes = polygon.interiors().iter().map(|hole| (hole, false));
        std::iter::once((polygon.exterior(), true)).chain(holes)
    })
}

fn covered(contours: &Contours, options: &RunOptions) -> Result<Region, BooleanError> {
    let empty = Contours::new();
    let rule = Rule { operation: Operation::Or, fill: Fill::Positive };
    resolve([Operand::Oriented(contours), Operand::Oriented(&empty)], rule, options)
}

/// In grid steps, exactly.
impl From<&Region> for MultiPolygon<i64> {
    fn from(region: &Region) -> Self {
        converted(region, |point| Coord { x: point.x, y: point.y })
    }
}

/// From grid steps. Rings may run in either direction.
impl TryFrom<&MultiPolygon<i64>> for Region {
    type Error = BooleanError;

    fn try_from(polygons: &MultiPolygon<i64>) -> Result<Self, BooleanError> {
        let points = |line: &LineString<i64>| line.0.iter().map(|c| GridPoint::new(c.x, c.y)).collect();
        let contours = oriented(rings(polygons).map(|(line, is_outer)| (points(line), is_outer)));
        covered(&contours, &RunOptions::default())
    }
}

impl Region {
    /// The region in micrometers, for grid steps of `precision` µm.
    ///
    /// # Examples
    /// ```
    /// use phidl_boolean::{Region, RunOptions};
    /// let run = RunOptions::default();
    /// let square = geo_types::Rect::new((0.0, 0.0), (10.0, 10.0)).to_polygon();
    /// let hole = geo_types::Rect::new((4.0, 4.0), (6.0, 6.0)).to_polygon();
    /// let frame = geo_types::Polygon::new(square.exterior().clone(), vec![hole.exterior().clone()]);
    /// let region = Region::from_multi_polygon(&frame.into(), 0.001, &run)?;
    /// assert_eq!(region.area(), 96.0e6); // square steps
    /// assert_eq!(region.to_multi_polygon(0.001).0[0].interiors().len(), 1);
    /// # Ok::<(), phidl_boolean::BooleanError>(())
    /// ```
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "grid coordinates are within ±2^40")]
    pub fn to_multi_polygon(&self, precision: f64) -> MultiPolygon<f64> {
        converted(self, |point| Coord { x: point.x as f64 * precision, y: point.y as f64 * precision })
    }

    /// The region that polygons in micrometers cover, rounded to grid steps of `precision` µm. Rings may run in either
    /// direction; holes are not covered.
    ///
    /// # Errors
    /// [`BooleanError::Precision`], and [`BooleanError::OffGrid`] for the first ring with a coordinate that is out of
    /// range, infinite or NaN; as for [`grid::boolean`].
    pub fn from_multi_polygon(
        polygons: &MultiPolygon<f64>,
        precision: f64,
        options: &RunOptions,
    ) -> Result<Self, BooleanError> {
        let steps = grid::with_step(precision)?;
        let points = rings(polygons).map(|(line, _)| line.0.iter().map(|c| (c.x, c.y)));
        let snapped = grid::snap(&steps, points)?;
        let directions = rings(polygons).map(|(_, is_outer)| is_outer);
        covered(&oriented(snapped.iter().map(<[_]>::to_vec).zip(directions)), options)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(low: i64, high: i64) -> LineString<i64> {
        LineString::from(vec![(low, low), (high, low), (high, high), (low, high), (low, low)])
    }

    /// A frame with an island in its hole, and its rings in the wrong directions.
    fn frame_with_island() -> MultiPolygon<i64> {
        let reversed = |mut line: LineString<i64>| {
            line.0.reverse();
            line
        };
        let frame = Polygon::new(reversed(ring(0, 20)), vec![ring(5, 15)]);
        MultiPolygon::new(vec![frame, Polygon::new(ring(8, 12), Vec::new())])
    }

    #[test]
    fn holes_and_islands_survive_in_either_direction() {
        let region = Region::try_from(&frame_with_island()).unwrap();
        assert_eq!(region.area(), 400.0 - 100.0 + 16.0);
        let back = MultiPolygon::<i64>::from(&region);
        assert_eq!(back.iter().map(|polygon| polygon.interiors().len()).collect::<Vec<_>>(), [1, 0]);
        assert_eq!(Region::try_from(&back).unwrap(), region);
    }

    #[test]
    fn coordinates_that_are_not_finite_are_refused() {
        let line = LineString::from(vec![(0.0, 0.0), (1.0, 0.0), (1.0, f64::NAN)]);
        let polygons = MultiPolygon::new(vec![Polygon::new(line, Vec::new())]);
        assert!(Region::from_multi_polygon(&polygons, 0.001, &RunOptions::default()).is_err());
    }
}
