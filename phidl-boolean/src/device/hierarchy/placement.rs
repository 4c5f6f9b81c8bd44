//! [`Placement`]: a placed cell or array in top-level coordinates; [`FlatGeometry`]: the outlines of opened cells.

use phidl_core::geom::{Point, Rect, Transform};
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Device, Reference};

use crate::{contours::Contours, error::BooleanError, grid::off_grid, point::GridPoint};

/// A box in grid steps, before rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Bounds {
    fn new(rect: Rect, grid: &Grid) -> Self {
        let steps = |p: Point| [p.x / grid.step(), p.y / grid.step()];
        Self { low: steps(rect.min), high: steps(rect.max) }
    }

    /// Around a placed cell and the cells below it; `None` without polygons.
    fn of_cell(cell: &Device, transform: &Transform, grid: &Grid) -> Option<Self> {
        use phidl_core::place::Bounded;
        let turned = || Rect::around(cell.hull().iter().map(|&p| transform.apply(p)));
        let rect = cell.bbox()?;
        Some(Self::new(transform.apply_rect(rect).or_else(turned)?, grid))
    }

    pub(super) fn around(self, other: Self) -> Self {
        let axis = |i: usize| (self.low[i].min(other.low[i]), self.high[i].max(other.high[i]));
        let (x, y) = (axis(0), axis(1));
        Self { low: [x.0, y.0], high: [x.1, y.1] }
    }

    pub(super) fn shifted(self, by: [f64; 2]) -> Self {
        let moved = |p: [f64; 2]| [p[0] + by[0], p[1] + by[1]];
        Self { low: moved(self.low), high: moved(self.high) }
    }

    pub(super) fn grown(self, by: f64) -> Self {
        Self { low: self.low.map(|v| v - by), high: self.high.map(|v| v + by) }
    }

    pub(super) fn area(self) -> f64 {
        (self.high[0] - self.low[0]) * (self.high[1] - self.low[1])
    }

    /// Largest absolute coordinate.
    pub(super) fn reach(self) -> f64 {
        self.low.into_iter().chain(self.high).map(f64::abs).fold(0.0, f64::max)
    }

    /// The side of zero of the box along each axis, with a margin of one step: −1 or 1, or 0 if zero is inside.
    pub(super) fn sides(self) -> [i8; 2] {
        let side = |i: usize| i8::from(self.low[i] > 1.0) - i8::from(self.high[i] < -1.0);
        [side(0), side(1)]
    }
}

/// The elements of an array that has not been opened.
#[derive(Debug)]
struct Elements {
    reference: Reference,
    /// The transform of the cell with the array.
    parent: Transform,
    /// From the first element to the next column and the next row (steps).
    steps: [[f64; 2]; 2],
}

/// A placement of a cell in one of the operands.
#[derive(Debug)]
pub(super) struct Placement {
    /// Operand 0 or 1.
    pub(super) side: usize,
    pub(super) cell: Device,
    /// The transform of the cell; of an array, of the first element.
    pub(super) transform: Transform,
    /// Around all elements.
    pub(super) bounds: Bounds,
    elements: Option<Box<Elements>>,
}

impl Placement {
    /// The placement of a reference of a cell; `None` without polygons.
    fn new(side: usize, reference: &Reference, parent: &Transform, grid: &Grid) -> Option<Self> {
        let cell = reference.device();
        let transform = reference.element(0, 0).then(parent);
        let first = Bounds::of_cell(cell, &transform, grid)?;
        let Some(array) = reference.array() else {
            return Some(Self { side, cell: cell.clone(), transform, bounds: first, elements: None });
        };
        let (columns, rows) = (array.columns.checked_sub(1)?, array.rows.checked_sub(1)?);
        let away = |column, row| {
            let by = reference.element(column, row).then(parent).origin - transform.origin;
            [by.x / grid.step(), by.y / grid.step()]
        };
        let corners = [away(columns, 0), away(0, rows), away(columns, rows)];
        let bounds = corners.into_iter().fold(first, |all, by| all.around(first.shifted(by)));
        let steps = [away(1, 0), away(0, 1)];
        let elements = Elements { reference: reference.clone(), parent: *parent, steps };
        Some(Self { side, cell: cell.clone(), transform, bounds, elements: Some(Box::new(elements)) })
    }

    /// Columns, rows and the steps from one to the next, if this is an array.
    pub(super) fn lattice(&self) -> Option<([u32; 2], [[f64; 2]; 2])> {
        let elements = self.elements.as_ref()?;
        let array = elements.reference.array()?;
        Some(([array.columns, array.rows], elements.steps))
    }

    /// The position of the cell in grid steps; of an array, of its first element.
    pub(super) fn position(&self, grid: &Grid) -> [f64; 2] {
        [self.transform.origin.x / grid.step(), self.transform.origin.y / grid.step()]
    }

    /// The first element of an array, or the placement itself.
    pub(super) fn first(&self, grid: &Grid) -> Option<Self> {
        let bounds = Bounds::of_cell(&self.cell, &self.transform, grid)?;
        Some(Self { cell: self.cell.clone(), bounds, elements: None, ..*self })
    }

    /// Replaces an array by its elements, and a placement by the outlines and placements of its cell.
    pub(super) fn open(
        self,
        grid: &Grid,
        placements: &mut Vec<Self>,
        flat: &mut FlatGeometry,
    ) -> Result<(), BooleanError> {
        match &self.elements {
            Some(elements) => {
                placements.extend(elements.reference.elements().filter_map(|element| {
                    let transform = element.then(&elements.parent);
                    let bounds = Bounds::of_cell(&self.cell, &transform, grid)?;
                    Some(Self { cell: self.cell.clone(), transform, bounds, elements: None, ..self })
                }));
                Ok(())
            }
            None => open_cell(&self.cell, self.side, &self.transform, grid, placements, flat),
        }
    }
}

/// Adds the outlines of a cell to the flat geometry, and its references to the placements.
pub(super) fn open_cell(
    cell: &Device,
    side: usize,
    transform: &Transform,
    grid: &Grid,
    placements: &mut Vec<Placement>,
    flat: &mut FlatGeometry,
) -> Result<(), BooleanError> {
    flat.draw(side, cell, transform, grid)?;
    placements
        .extend(cell.references().iter().filter_map(|reference| Placement::new(side, reference, transform, grid)));
    Ok(())
}

/// Outlines of both operands on the grid that belong to no placement.
#[derive(Debug, Default)]
pub(super) struct FlatGeometry {
    pub(super) sides: [Contours; 2],
}

impl FlatGeometry {
    fn draw(&mut self, side: usize, cell: &Device, transform: &Transform, grid: &Grid) -> Result<(), BooleanError> {
        let matrix = transform.matrix();
        for (shape, polygon) in cell.polygons().enumerate() {
            let points = polygon.points.iter().map(|&p| {
                let p = matrix.apply(p);
                Ok(GridPoint::new(grid.steps(p.x)?, grid.steps(p.y)?))
            });
            self.sides[side].try_push(points).map_err(|error| BooleanError::InCell {
                cell: cell.name().into(),
                source: Box::new(off_grid(error, shape)),
            })?;
        }
        Ok(())
    }

    /// The outlines relative to a point.
    pub(super) fn relative_to(&self, origin: GridPoint) -> [Contours; 2] {
        let moved = |contours: &Contours| {
            let moved_point = |p: &GridPoint| GridPoint::new(p.x - origin.x, p.y - origin.y);
            let mut all = Contours::with_capacity(contours.len(), contours.point_count());
            contours.iter().for_each(|contour| all.push(contour.iter().map(moved_point)));
            all
        };
        self.sides.each_ref().map(moved)
    }
}
