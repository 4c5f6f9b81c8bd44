//! The area of the union of shapes: [`merged_area`], [`merged_areas`].

use phidl_core::geom::Rect;
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;

use super::{Shapes, operand::Operand};
use crate::{
    contours::Contours,
    error::{BooleanError, in_function},
    grid,
    options::RunOptions,
    point::MAX_COORDINATE,
    region::Region,
};

/// The finest grid on which areas are measured (µm).
const FINEST: f64 = 1e-6;

/// Area (µm²) of the union of shapes on all layers; overlaps count once.
///
/// It is measured on a grid of 1e-6 µm, or of the finest power of ten that reaches the shapes.
///
/// # Errors
/// A shape that no cell accepts, a coordinate that is not finite.
///
/// # Examples
/// ```
/// use phidl_core::geom::Rect;
/// let two = [Rect::new((0, 0), (2, 2)), Rect::new((1, 0), (3, 2))];
/// assert_eq!(phidl_boolean::merged_area(&two)?, 6.0);
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
pub fn merged_area(shapes: &(impl Shapes + ?Sized)) -> Result<f64, BooleanError> {
    in_function("merged_area", || {
        let operand = Operand::new("shapes", shapes)?;
        operand.check_size(&RunOptions::default())?;
        let grid = finest_grid(operand.bbox())?;
        area(&operand.contours(&grid)?, &grid)
    })
}

/// Area (µm²) of the union of the shapes on each layer, ascending by layer. See [`merged_area`].
///
/// # Errors
/// As for [`merged_area`].
pub fn merged_areas(shapes: &(impl Shapes + ?Sized)) -> Result<Vec<(Layer, f64)>, BooleanError> {
    in_function("merged_areas", || {
        let operand = Operand::new("shapes", shapes)?;
        operand.check_size(&RunOptions::default())?;
        let grid = finest_grid(operand.bbox())?;
        let measured = |layer| Ok((layer, area(&operand.contours_on(&grid, layer)?, &grid)?));
        operand.layers().into_iter().map(measured).collect()
    })
}

#[expect(clippy::cast_precision_loss, reason = "the range of the grid is exact in an f64")]
fn finest_grid(bbox: Option<Rect>) -> Result<Grid, BooleanError> {
    let corners = bbox.map_or([0.0; 4], |b| [b.min.x, b.min.y, b.max.x, b.max.y]);
    let reach = corners.into_iter().map(f64::abs).fold(0.0, f64::max);
    let mut step = FINEST;
    while reach > step * (MAX_COORDINATE - 1) as f64 && step.is_finite() {
        step *= 10.0;
    }
    grid::with_step(step)
}

fn area(contours: &Contours, grid: &Grid) -> Result<f64, BooleanError> {
    Ok(Region::merged(contours, &RunOptions::default())?.area() * grid.step() * grid.step())
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::scene::Polygon;

    #[test]
    fn areas_far_from_the_origin_are_measured() {
        let square = |at: f64| Rect::new((at, at), (at + 2e7, at + 2e7));
        let far = merged_area(&[square(3e9), square(3e9 + 1e7)]).unwrap();
        assert!((far - 7e14).abs() < 1e3, "{far}");
        assert_eq!(merged_area(&()), Ok(0.0));
        assert!(merged_area(&[(0.0, 0.0), (1.0, f64::NAN), (1.0, 1.0)]).is_err());
    }

    #[test]
    fn each_layer_is_measured_separately() {
        let square = |x: f64, layer: u16| Polygon::new(Rect::new((x, 0.0), (x + 2.0, 2.0)), layer);
        let areas = merged_areas(&[square(0.0, 2), square(1.0, 2), square(0.5, 1)]).unwrap();
        assert_eq!(areas, [(1.into(), 4.0), (2.into(), 6.0)]);
    }
}
