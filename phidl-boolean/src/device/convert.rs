//! Conversions between a [`Region`] and devices.

use phidl_core::geom::{Outline, Point};
use phidl_core::layer::Layers;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Device, DeviceBuilder};

use super::{Options, Shapes, operand::Operand};
use crate::{error::BooleanError, point::GridPoint, region::Region};

impl Region {
    /// The union of some shapes, on the grid of `options`.
    ///
    /// # Errors
    /// A shape with bad coordinates, an option out of its range.
    ///
    /// # Examples
    /// ```
    /// use phidl_boolean::{Options, Region};
    /// let options = Options { precision: 1.0, ..Options::default() };
    /// let two = Region::of(&[[(0, 0), (4, 0), (0, 4)], [(0, 0), (4, 0), (4, 4)]], &options)?;
    /// assert_eq!(two.area(), 8.0 + 8.0 - 4.0);
    /// # Ok::<(), phidl_boolean::BooleanError>(())
    /// ```
    pub fn of(shapes: &(impl Shapes + ?Sized), options: &Options) -> Result<Self, BooleanError> {
        options.require_flat("a region has no cells")?;
        let operand = Operand::new("shapes", shapes)?;
        operand.check_size(&options.run)?;
        let contours = operand.contours(&options.grid()?)?;
        Self::merged(&contours, &options.run)
    }

    /// A flat device of the region: holes become keyholes, and polygons above the limit of `options` are fractured.
    ///
    /// # Errors
    /// An option out of its range, a name that no cell can have.
    ///
    /// # Examples
    /// ```
    /// use phidl_boolean::{Options, Region};
    /// use phidl_core::prelude::*;
    /// let options = Options { precision: 0.5, ..Options::default() };
    /// let triangle = Region::of(&[(0, 0), (4, 0), (0, 4)], &options)?.to_device("triangle", 1, &options)?;
    /// assert_eq!(triangle.bbox(), Some(Rect::new((0, 0), (4, 4))));
    /// # Ok::<(), phidl_boolean::BooleanError>(())
    /// ```
    pub fn to_device(&self, name: &str, layer: impl Into<Layers>, options: &Options) -> Result<Device, BooleanError> {
        options.require_flat("a region has no cells")?;
        let mut cell = Device::builder(name);
        self.draw(&mut cell, &layer.into(), options)?;
        Ok(cell.build()?)
    }

    /// Draws the region into an open cell.
    pub(super) fn draw(
        &self,
        cell: &mut DeviceBuilder,
        layers: &Layers,
        options: &Options,
    ) -> Result<(), BooleanError> {
        let grid = options.grid()?;
        let outlines = match options.max_points {
            Some(most) => self.fractured(most)?,
            None => self.without_holes(),
        };
        cell.reserve(outlines.len(), outlines.point_count());
        for outline in outlines.iter() {
            cell.add_polygon(OnGrid { grid: &grid, points: outline }, layers)?;
        }
        Ok(())
    }
}

/// An outline in grid steps; a cell takes its points in micrometers without a buffer in between.
struct OnGrid<'a> {
    grid: &'a Grid,
    points: &'a [GridPoint],
}

impl Outline for OnGrid<'_> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        buffer.extend(self.points.iter().map(|p| Point::new(self.grid.um(p.x), self.grid.um(p.y))));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_of_a_device_obey_the_limit_and_keep_the_area() {
        let ring: Vec<(f64, f64)> = (0..300)
            .map(|i| (f64::from(i) * 1.2_f64).to_radians().sin_cos())
            .map(|(s, c)| (10.0 * c, 10.0 * s))
            .collect();
        for max_points in [Some(3), Some(50), None] {
            let options = Options { max_points, ..Options::default() };
            let region = Region::of(&ring, &options).unwrap();
            let device = region.to_device("disc", 1, &options).unwrap();
            assert!(device.polygons().all(|p| p.points.len() <= max_points.unwrap_or(300)));
            let area: f64 = device.polygons().map(|p| p.area()).sum();
            assert!((area - region.area() * 1e-8).abs() < 1e-9);
        }
        let refused = Options { max_points: Some(2), ..Options::default() };
        assert!(Region::new().to_device("none", 1, &refused).is_err());
    }
}
