//! [`fractured`]: one outline as several with fewer points.

use phidl_boolean::RunOptions;
use phidl_boolean::grid::{self, GridPoint, Region};
use phidl_core::prelude::*;

/// Cuts an outline into outlines of at most `max_points` points, which cover the same area without overlap.
///
/// Corners are rounded to `precision` (µm). Cuts run between corners, so all edges stay as they are. Areas that an outline
/// with crossing edges covers are covered once.
///
/// # Errors
/// `max_points` below 3; a precision of 0 or less; a corner beyond the grid of ±2⁴⁰ steps of `precision`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let disc: Vec<Point> = (0..300).map(|i| Point::polar(50.0, 1.2 * f64::from(i))).collect();
/// let parts = pg::polygon::fractured(&disc, 60, 1e-4)?;
/// assert!(parts.len() >= 5 && parts.iter().all(|part| part.len() <= 60));
/// # Ok::<(), Error>(())
/// ```
pub fn fractured(outline: &[Point], max_points: usize, precision: f64) -> Result<Vec<Vec<Point>>> {
    let grid = grid::with_step(precision)?;
    let contours = grid::snap(&grid, [outline.iter().map(|p| (p.x, p.y))])?;
    let region = Region::merged(&contours, &RunOptions::default())?;
    let corner = |p: &GridPoint| Point::new(grid.um(p.x), grid.um(p.y));
    Ok(region.fractured(max_points)?.iter().map(|part| part.iter().map(corner).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::signed_area;
    use proptest::prelude::*;

    fn area(parts: &[Vec<Point>]) -> f64 {
        parts.iter().map(|part| signed_area(part).abs()).sum()
    }

    #[test]
    fn an_outline_below_the_limit_is_one_part() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        assert_eq!(area(&fractured(&square, 4, 1e-3).unwrap()), 100.0);
        assert_eq!(fractured(&square, 4, 1e-3).unwrap().len(), 1);
    }

    #[test]
    fn limits_below_a_triangle_and_no_precision_are_refused() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        assert!(fractured(&square, 2, 1e-3).is_err() && fractured(&square, 9, 0.0).is_err());
    }

    proptest! {
        #[test]
        fn parts_keep_the_limit_and_the_area(
            radii in prop::collection::vec(1.0..20.0_f64, 5..80), max_points in 3..12_usize,
        ) {
            // A star around the origin: no edges cross.
            let step = 360.0 / radii.len() as f64;
            let star: Vec<Point> = radii.iter().enumerate().map(|(i, r)| Point::polar(*r, step * i as f64)).collect();
            let parts = fractured(&star, max_points, 1e-4).unwrap();
            prop_assert!(parts.iter().all(|part| part.len() <= max_points));
            prop_assert!((area(&parts) - signed_area(&star).abs()).abs() < 0.05, "{} {}", area(&parts), signed_area(&star));
        }
    }
}
