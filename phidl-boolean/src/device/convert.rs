//! From a [`Region`] to a device and back, and the area that outlines cover together.

use phidl_core::geom::{Outline, Point};
use phidl_core::layer::Layers;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Device, DeviceBuilder};

use super::{Options, Shapes, operand::Operand};
use crate::{
    contours::Contours,
    error::BooleanError,
    grid,
    options::RunOptions,
    point::{GridPoint, MAX_COORDINATE},
    region::Region,
};

/// The finest grid on which areas are measured (µm).
const FINEST: f64 = 1e-6;

impl Region {
    /// What some shapes cover, merged, on the grid of `options`.
    ///
    /// # Errors
    /// A shape that is off the grid or no shape, an option out of its range.
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
        let contours = Operand::new("shapes", shapes)?.contours(&options.grid()?)?;
        Self::merged(&contours, &options.run)
    }

    /// A flat device that draws the region: holes are cut open, and polygons over the limit of `options` are cut.
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

/// Area (µm²) that outlines (µm) cover together, on a grid of 1e-6 µm, or of the finest power of ten that reaches them.
///
/// # Errors
/// [`BooleanError::OffGrid`] for a coordinate that is not finite; [`BooleanError::TooLarge`] for more than 2³¹ edges.
///
/// # Examples
/// ```
/// use phidl_core::geom::Point;
/// let square = |x: f64| [(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 2.0), (x, 2.0)].map(Point::from);
/// assert_eq!(phidl_boolean::merged_area([square(0.0), square(1.0)])?, 6.0);
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
#[expect(clippy::cast_precision_loss, reason = "the range of the grid is exact in an f64")]
pub fn merged_area<S, P>(outlines: S) -> Result<f64, BooleanError>
where
    S: IntoIterator<Item = P> + Clone,
    P: IntoIterator<Item = Point>,
{
    let points = outlines.clone().into_iter().flatten();
    let reach = points.map(|p| p.x.abs().max(p.y.abs())).filter(|r| r.is_finite()).fold(0.0, f64::max);
    let mut step = FINEST;
    while reach > step * (MAX_COORDINATE - 1) as f64 {
        step *= 10.0;
    }
    let pairs = outlines.into_iter().map(|outline| outline.into_iter().map(|p| (p.x, p.y)));
    let contours: Contours = grid::snap(&grid::with_step(step)?, pairs)?;
    Ok(Region::merged(&contours, &RunOptions::default())?.area() * step * step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_are_measured_far_out_and_refused_where_there_is_none() {
        let square = |at: f64| [(at, at), (at + 2e7, at), (at + 2e7, at + 2e7), (at, at + 2e7)].map(Point::from);
        let far = merged_area([square(3e9), square(3e9 + 1e7)]).unwrap();
        assert!((far - 7e14).abs() < 1e3, "{far}");
        assert!(merged_area([[(0.0, 0.0), (1.0, f64::NAN), (1.0, 1.0)].map(Point::from)]).is_err());
        assert_eq!(merged_area(Vec::<Vec<Point>>::new()), Ok(0.0));
    }

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
