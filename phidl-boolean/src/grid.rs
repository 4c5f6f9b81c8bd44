//! The operations on integer grid coordinates: no micrometers and no rounding of the input.
//!
//! The functions at the top of the crate take devices and micrometers. They round ([`snap`]), call this module, and
//! fracture the result. Programs that have grid coordinates, or that process results further, start here.
//!
//! The rounding rule is that of [`phidl_core::num::grid::Grid`], so that a boolean and a file round half steps alike.

use phidl_core::layer::Layers;
use phidl_core::num::grid::{Grid, GridError};
use phidl_core::scene::Device;

pub use crate::{
    contours::Contours,
    offset::offset,
    point::{GridPoint, MAX_COORDINATE, signed_area2},
    region::{Region, RegionPolygon},
};
use crate::{error::BooleanError, op::Operation, options::RunOptions, region_ops::combine_shapes};

/// Runs a set operation on two layers of shapes.
///
/// Each operand is the union of its shapes, of any direction; a shape that crosses itself covers all its lobes. An
/// operand without shapes is the empty set.
///
/// # Errors
/// [`BooleanError::OutOfRange`] for a coordinate beyond ±[`MAX_COORDINATE`], [`BooleanError::Option`] for a bad
/// option, [`BooleanError::TooLarge`] for more than 2³¹ edges or a result of half as many, [`BooleanError::Cancelled`]
/// after [`ProgressMonitor::cancel`](crate::ProgressMonitor::cancel).
///
/// # Examples
/// ```
/// use phidl_boolean::{Operation, RunOptions, grid};
/// let steps = grid::with_step(1e-3)?;
/// let square = |x: f64| [(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 2.0), (x, 2.0)];
/// let (a, b) = (grid::snap(&steps, [square(0.0)])?, grid::snap(&steps, [square(1.0)])?);
/// let both = grid::boolean(&a, &b, Operation::And, &RunOptions::default())?;
/// assert_eq!(both.area(), 1000.0 * 2000.0);
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
pub fn boolean(a: &Contours, b: &Contours, operation: Operation, options: &RunOptions) -> Result<Region, BooleanError> {
    combine_shapes(a, b, operation, options)
}

/// The grid with steps of `precision` µm, as far as the engine reaches (±[`MAX_COORDINATE`] steps).
///
/// # Errors
/// [`BooleanError::Precision`] if `precision` is not finite and greater than zero.
pub fn with_step(precision: f64) -> Result<Grid, BooleanError> {
    let grid = Grid::new(precision).map_err(|_| BooleanError::Precision { precision })?;
    Ok(grid.reaching(MAX_COORDINATE))
}

/// Rounds closed shapes (µm) to the grid, in order.
///
/// # Errors
/// [`BooleanError::OffGrid`] names the first shape with a coordinate that is out of range, infinite or NaN.
pub fn snap<S, P>(grid: &Grid, shapes: S) -> Result<Contours, BooleanError>
where
    S: IntoIterator<Item = P>,
    P: IntoIterator<Item = (f64, f64)>,
{
    let mut contours = Contours::new();
    for (shape, outline) in shapes.into_iter().enumerate() {
        let points = outline.into_iter().map(|(x, y)| Ok(GridPoint::new(grid.steps(x)?, grid.steps(y)?)));
        contours.try_push(points).map_err(|error| off_grid(error, shape))?;
    }
    Ok(contours)
}

/// Rounds the polygons of a device and of the cells below it to the grid, on some layers or on all.
///
/// # Errors
/// [`BooleanError::InCell`] names the cell of the first polygon with a coordinate that is out of range.
pub fn snap_device(grid: &Grid, device: &Device, layers: Option<Layers>) -> Result<Contours, BooleanError> {
    let polygons = match layers {
        Some(layers) => device.flat_polygons().on(layers),
        None => device.flat_polygons(),
    };
    let mut contours = Contours::new();
    for polygon in polygons {
        let points = polygon.points().map(|p| Ok(GridPoint::new(grid.steps(p.x)?, grid.steps(p.y)?)));
        let shape = contours.len();
        contours.try_push(points).map_err(|error| BooleanError::InCell {
            cell: polygon.device.name().into(),
            source: Box::new(off_grid(error, shape)),
        })?;
    }
    Ok(contours)
}

/// The error for a coordinate of a shape that the grid refuses.
pub(crate) fn off_grid(error: GridError, shape: usize) -> BooleanError {
    match error {
        GridError::OutOfRange { um, limit_um, .. } => BooleanError::OffGrid { shape, value: um, limit: limit_um },
        GridError::BadStep { step } => BooleanError::Precision { precision: step },
        _ => BooleanError::OffGrid { shape, value: f64::NAN, limit: f64::NAN },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_outside_the_grid_are_refused_with_their_shape() {
        let grid = with_step(1e-4).unwrap();
        for bad in [f64::NAN, f64::INFINITY, 1.2e8] {
            let shapes = [vec![(0.0, 0.0)], vec![(1.0, bad)]];
            let Err(BooleanError::OffGrid { shape, .. }) = snap(&grid, shapes) else { panic!("{bad} was accepted") };
            assert_eq!(shape, 1);
        }
        assert_eq!(with_step(0.0).unwrap_err(), BooleanError::Precision { precision: 0.0 });
        assert!(with_step(f64::NAN).is_err());
    }

    #[test]
    fn coordinates_round_half_away_from_zero() {
        let contours = snap(&with_step(1e-4).unwrap(), [[(0.3, -0.00005), (0.00005, -0.56789)]]).unwrap();
        assert_eq!(contours.points(), [GridPoint::new(3000, -1), GridPoint::new(1, -5679)]);
    }
}
