//! One device into a cell of the model.

use phidl_core::geom::Point;
use phidl_core::num::grid::{Grid, GridError};
use phidl_core::scene::{Anchor, Device, Label, PolygonView, Properties, Reference};

use super::Changes;
use super::lattice::{self, LatticeError, MOST_BLOCKS};
use super::limits::{FileLimits, Refusal};
use super::outline::{self, Cleaning};
use super::split::split;
use super::table::CellTable;
use crate::error::{IoError, Item, Result, real};
use crate::model::{Cell, Corner, Placement, Text};

/// The rules of a file for the elements of its cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rules<'a> {
    /// Every coordinate is rounded to it.
    pub(crate) grid: Grid,
    pub(crate) limits: &'a FileLimits,
    /// The most corners of an outline.
    pub(crate) max_points: usize,
    /// Whether lattices that are not rectangular are arrays in the file.
    pub(crate) skew_arrays: bool,
    /// The numbers that the format's real numbers reach.
    pub(crate) is_representable: fn(f64) -> bool,
}

/// Converts the cells of one file.
pub(crate) struct Converter<'a> {
    table: &'a CellTable,
    rules: Rules<'a>,
    corners: Vec<Corner>,
    /// What was changed in all cells so far.
    pub(crate) changes: Changes,
}

/// The cell whose elements are converted, for errors.
struct Source<'a> {
    cell: &'a Device,
}

impl Source<'_> {
    fn refused(&self, refusal: Refusal, item: Item) -> IoError {
        refusal.in_element(self.cell.name(), item)
    }

    fn out_of_range(&self, source: GridError, item: Item) -> IoError {
        IoError::OutOfRange { cell: self.cell.name().into(), item: Box::new(item), source }
    }
}

impl<'a> Converter<'a> {
    pub(crate) fn new(table: &'a CellTable, rules: Rules<'a>) -> Self {
        Self { table, rules, corners: Vec::new(), changes: Changes::default() }
    }

    /// Converts a device of the table. The cell's memory is used again.
    ///
    /// # Errors
    /// [`IoError::Refused`] and [`IoError::OutOfRange`], with cell and element.
    pub(crate) fn convert(&mut self, device: &Device, cell: &mut Cell) -> Result<()> {
        cell.reset(self.table.id_of(device));
        let source = Source { cell: device };
        for (index, polygon) in device.polygons().enumerate() {
            self.polygon(&source, index, &polygon, cell)?;
        }
        for (index, label) in device.labels().iter().enumerate() {
            cell.texts.push(self.label(&source, index, label)?);
            self.changes.labels += 1;
        }
        for (index, reference) in device.references().iter().enumerate() {
            self.reference(&source, index, reference, cell)?;
        }
        Ok(())
    }

    fn polygon(&mut self, source: &Source<'_>, index: usize, polygon: &PolygonView<'_>, cell: &mut Cell) -> Result<()> {
        let Rules { grid, limits, max_points, .. } = self.rules;
        let layer = polygon.layer;
        let item = || Item::Polygon { index, layer };
        limits.check_layer(layer).map_err(|refusal| source.refused(refusal, item()))?;
        let properties: Properties = polygon.properties().map(|(number, text)| (number, text.to_owned())).collect();
        limits.check_properties(&properties).map_err(|refusal| source.refused(refusal, item()))?;
        outline::round(polygon.points, &grid, &mut self.corners).map_err(|error| source.out_of_range(error, item()))?;
        match outline::clean(&mut self.corners) {
            Cleaning::Unchanged => {}
            Cleaning::Cleaned => self.changes.cleaned_polygons += 1,
            Cleaning::Collapsed => {
                self.changes.collapsed_polygons += 1;
                return Ok(());
            }
        }
        if self.corners.len() <= max_points {
            self.changes.outlines += 1;
            cell.polygons.push(layer, self.corners.iter().copied());
            cell.polygons.set_properties(properties);
            return Ok(());
        }
        self.changes.cut_polygons += 1;
        for piece in split(std::mem::take(&mut self.corners), max_points) {
            self.changes.outlines += 1;
            cell.polygons.push(layer, piece);
            cell.polygons.set_properties(properties.clone());
        }
        Ok(())
    }

    fn label(&self, source: &Source<'_>, index: usize, label: &Label) -> Result<Text> {
        let Rules { grid, limits, .. } = self.rules;
        let item = || Item::Label { index, text: label.text.clone() };
        let refused = |refusal| source.refused(refusal, item());
        limits.check_layer(label.layer).map_err(refused)?;
        limits.check_text(&label.text).map_err(refused)?;
        limits.check_properties(&label.properties).map_err(refused)?;
        let transform = *label.transform();
        self.check_magnification(transform.magnification).map_err(refused)?;
        let origin = corner(&grid, transform.origin).map_err(|error| source.out_of_range(error, item()))?;
        let style = label.style();
        let unstated = style.anchor_unstated && label.anchor == Anchor::NorthWest && style.font == 0;
        let width = style.width.map(|width| steps(&grid, width).map_err(|error| source.out_of_range(error, item())));
        Ok(Text {
            layer: label.layer,
            string: label.text.clone(),
            origin,
            x_reflection: transform.x_reflection,
            magnification: (transform.magnification != 1.0 || style.magnification_stated)
                .then_some(transform.magnification),
            rotation: transform.rotation,
            anchor: (!unstated).then_some(label.anchor),
            font: style.font,
            path_type: style.path_type,
            width: width.transpose()?,
            properties: label.properties.clone(),
            offset: 0,
        })
    }

    fn reference(&mut self, source: &Source<'_>, index: usize, reference: &Reference, cell: &mut Cell) -> Result<()> {
        let Rules { grid, limits, .. } = self.rules;
        let item = || reference_item(index, reference);
        let refused = |refusal| source.refused(refusal, item());
        let transform = *reference.transform();
        self.check_magnification(transform.magnification).map_err(refused)?;
        limits.check_properties(&reference.properties).map_err(refused)?;
        let placement = Placement {
            x_reflection: transform.x_reflection,
            magnification: transform.magnification,
            rotation: transform.rotation,
            properties: (!reference.properties.is_empty()).then(|| Box::new(reference.properties.clone())),
            ..Placement::new(self.table.id_of(reference.device()))
        };
        if reference.array().is_none() {
            let origin = corner(&grid, transform.origin).map_err(|error| source.out_of_range(error, item()))?;
            cell.placements.push(Placement { origin, ..placement });
            return Ok(());
        }
        let blocks = lattice::blocks(reference, &grid, self.rules.skew_arrays).map_err(|error| match error {
            LatticeError::OutOfRange(error) => source.out_of_range(error, item()),
            LatticeError::TooManyBlocks => refused(Refusal {
                what: "array",
                value: format!("of {} elements that are not a lattice on the grid", reference.count()),
                rule: format!("have at most {MOST_BLOCKS} of these"),
            }),
        })?;
        self.changes.arrays_taken_apart += u64::from(blocks.len() > 1);
        cell.placements.extend(blocks.iter().map(|block| Placement {
            origin: block.first,
            lattice: block.lattice(),
            ..placement.clone()
        }));
        Ok(())
    }

    /// The format's real numbers reach only so far.
    fn check_magnification(&self, magnification: f64) -> Result<(), Refusal> {
        if (self.rules.is_representable)(magnification) {
            return Ok(());
        }
        let rule = "be from 1e-70 to 1e70".to_owned();
        Err(Refusal { what: "magnification", value: real(magnification), rule })
    }
}

fn reference_item(index: usize, reference: &Reference) -> Item {
    Item::Reference { index, child: reference.device().name().to_owned() }
}

/// A point in grid steps, in the 32 bits of a file.
#[inline]
pub(super) fn corner(grid: &Grid, point: Point) -> Result<Corner, GridError> {
    Ok([steps(grid, point.x)?, steps(grid, point.y)?])
}

/// A length in grid steps. 32 bits reach one step further down than up.
#[inline]
fn steps(grid: &Grid, um: f64) -> Result<i32, GridError> {
    match grid.steps(um) {
        Ok(steps) => Ok(i32::try_from(steps).expect("invariant: the grid of a file reaches 32 bits")),
        Err(error) => {
            let lowest = grid.reaching(1 << 31).steps(um).ok();
            lowest.and_then(|steps| i32::try_from(steps).ok()).ok_or(error)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_step_below_is_within_reach() {
        let grid = Grid::new(1e-3).unwrap();
        let at = |x: f64| corner(&grid, Point::new(x, 0.0)).map(|corner| corner[0]);
        assert_eq!(at(-2_147_483.648), Ok(i32::MIN));
        assert_eq!(at(2_147_483.647), Ok(i32::MAX));
        assert!(at(2_147_483.648).is_err() && at(-2_147_483.649).is_err() && at(f64::NAN).is_err());
    }
}
