//! [`Device::check_extent`]: whether everything that a hierarchy places lies within the range of a grid.

use std::collections::HashMap;

use super::{Device, Reference};
use crate::geom::{Point, Rect, convex_hull};
use crate::num::grid::{Grid, GridError};
use crate::place::Bounded;

/// An element that reaches out of the range of a grid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{device}: {element} reaches the point {point}: {error}")]
pub struct ExtentError {
    /// The cell in whose coordinates the point is out of range.
    pub device: Box<str>,
    /// The element of that cell that reaches it, with its article.
    pub element: Box<str>,
    /// The point (µm).
    pub point: Point,
    /// The range.
    pub error: GridError,
}

impl Device {
    /// Whether every corner and label of the hierarchy is in the range of a grid, in the coordinates of each cell that it
    /// is placed in, directly or through other cells: corners of polygons, in cells that are nested, magnified, turned
    /// and arrayed. Exact, without flattening: the points of a cell that decide are its convex hull.
    ///
    /// ```
    /// # use phidl_core::{num::grid::Grid, prelude::*};
    /// let mut d = Device::builder("tile");
    /// d.add_polygon([(0, 0), (1, 0), (1, 1), (0, 1)], 1)?;
    /// let tile = d.build()?;
    /// let mut d = Device::builder("wafer");
    /// d.add(tile.array(3000, 1, (1000, 1000))); // the last tile ends at 2,999,001 µm
    /// let error = d.build()?.check_extent(&Grid::new(1e-3).unwrap()).unwrap_err();
    /// assert_eq!((&*error.device, &*error.element), ("wafer", "the reference to \"tile\""));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// The first element that is out of range, placed cells before those that place them.
    pub fn check_extent(&self, grid: &Grid) -> Result<(), Box<ExtentError>> {
        let cells = self.cells();
        let mut labels: HashMap<usize, Vec<Point>> = HashMap::new();
        for cell in cells.iter().rev() {
            check_cell(cell, grid, &labels)?;
            labels.insert(cell.ptr_id(), label_hull(cell, &labels));
        }
        Ok(())
    }
}

fn check_cell(cell: &Device, grid: &Grid, labels: &HashMap<usize, Vec<Point>>) -> Result<(), Box<ExtentError>> {
    let check = |rect: Option<Rect>, element: &dyn Fn() -> String| {
        let corners = rect.map(|rect| [rect.min, rect.max]).into_iter().flatten();
        for point in corners {
            if let Err(error) = grid.point_steps(point) {
                let (device, element) = (cell.name().into(), element().into());
                return Err(Box::new(ExtentError { device, element, point, error }));
            }
        }
        Ok(())
    };
    // Two boxes for all polygons and labels of the cell; the guilty one is looked for only if they are out of range.
    check(cell.cell().polygons.bbox(), &|| "a polygon".to_owned())?;
    for label in cell.labels() {
        check(label.bbox(), &|| format!("the label \"{}\"", label.text))?;
    }
    for reference in cell.references() {
        let element = || format!("the reference to \"{}\"", reference.device().name());
        check(reference.bbox(), &element)?;
        check(Rect::around(placed_points(reference, &labels[&reference.device().ptr_id()])), &element)?;
    }
    Ok(())
}

/// The convex hull of the positions of all labels in a cell and below.
fn label_hull(cell: &Device, below: &HashMap<usize, Vec<Point>>) -> Vec<Point> {
    /// The hull is built in batches, so that a cell of many references does not collect all points.
    const BATCH: usize = 4096;
    let mut points: Vec<Point> = cell.labels().iter().map(super::Label::position).collect();
    for reference in cell.references() {
        points.extend(placed_points(reference, &below[&reference.device().ptr_id()]));
        if points.len() > BATCH {
            points = convex_hull(points);
        }
    }
    convex_hull(points)
}

/// Points of a placed cell in the corner elements of the lattice, which decide the extent of an array.
fn placed_points<'a>(reference: &'a Reference, points: &'a [Point]) -> impl Iterator<Item = Point> + 'a {
    let corners = if points.is_empty() { Vec::new() } else { reference.corner_elements() };
    corners.into_iter().flat_map(move |element| {
        let matrix = element.matrix();
        points.iter().map(move |p| matrix.apply(*p))
    })
}
