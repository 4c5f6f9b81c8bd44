//! [`grid`]: cells in rows and columns.

use phidl_core::param::{ConversionError, IntoOption, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::cell_grid::{CellGrid, LineSpacing};
use super::{EdgeX, EdgeY, GridCells};
use crate::arguments::PerAxis;
use crate::basic::{circle, cross, rectangle};

/// Largest number of positions of a grid.
const MOST_POSITIONS: usize = 1_000_000;

/// Number of columns and rows of a grid, columns first. −1 stands for the smallest sufficient number.
///
/// ```
/// # use phidl_geometry::arrange::GridShape;
/// assert_eq!(GridShape::from((3, -1)), GridShape { columns: 3, rows: -1 });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GridShape {
    /// From left to right.
    pub columns: i64,
    /// From top to bottom.
    pub rows: i64,
}

impl<C: Into<i64>, R: Into<i64>> From<(C, R)> for GridShape {
    fn from((columns, rows): (C, R)) -> Self {
        Self { columns: columns.into(), rows: rows.into() }
    }
}

impl IntoOption<GridShape> for GridShape {
    fn into_option(self) -> Option<GridShape> {
        Some(self)
    }
}

impl<C: Into<i64>, R: Into<i64>> IntoOption<GridShape> for (C, R) {
    fn into_option(self) -> Option<GridShape> {
        Some(self.into())
    }
}

impl Param for GridShape {
    fn param_type() -> ParamType {
        ParamType::Other("number of columns and number of rows")
    }

    fn to_value(&self) -> Value {
        [self.columns, self.rows].into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match Vec::<i64>::from_value(value)?[..] {
            [columns, rows] => Ok(Self { columns, rows }),
            _ => Err(ConversionError::new(value, "be a number of columns and a number of rows")),
        }
    }
}

/// Places cells in rows and columns, aligned and spaced by their bounding boxes.
///
/// ```text
///   ┌──┐  ┌────┐   row by row from the top left
///   └──┘  │    │   ↕ spacing.y
///   ┌───┐ └────┘
///   └───┘ ┌──┐     the leftmost column and the bottom row stay where they are
///      ↔ spacing.x
/// ```
///
/// One reference for each grid position, row by row from the top left. Each row is aligned by `align_y`, each column by
/// `align_x`; then the columns are spaced to the right and the rows upwards. A position without a cell, or with an empty
/// cell, takes no room.
///
/// # Ports
/// None.
///
/// # Errors
/// An empty list; rows of different lengths; a `shape` with fewer positions than cells; more than a million
/// positions.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let cells: Vec<Device> = (1..=5).map(|r| pg::circle(r, 2.5, 0)).collect::<Result<_>>()?;
/// let two_columns = pg::GridParams::new(cells).shape((2, -1)).spacing(1).build()?;
/// assert_eq!(two_columns.references().len(), 6);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `grid`, except that empty positions have no box (see [`arrange`](super)).
#[device(picture = "docs/grid.svg", example = GridParams::new([rectangle((9, 4), 0)?, circle(4, 2.5, 1)?, cross(9, 2, 2)?, circle(2, 2.5, 3)?]).shape((2, 2)))]
pub fn grid(
    /// The cells: a list, or rows with the top one first.
    device_list: GridCells,
    /// Between columns and between rows: the gap, or without `separation` the pitch.
    #[default((5, 10))]
    #[param(unit = "um")]
    spacing: PerAxis,
    /// Whether `spacing` is the gap between bounding boxes; otherwise it is the pitch of `edge_x` and `edge_y`.
    #[default(true)]
    separation: bool,
    /// Columns and rows, −1 for as many as are needed; none takes the list as it is.
    #[default(None)]
    shape: Option<GridShape>,
    /// What the cells of a column have in common.
    #[default(EdgeX::X)]
    align_x: EdgeX,
    /// What the cells of a row have in common.
    #[default(EdgeY::Y)]
    align_y: EdgeY,
    /// Without `separation`: what the pitch of the columns is measured at.
    #[default(EdgeX::X)]
    edge_x: EdgeX,
    /// Without `separation`: what the pitch of the rows is measured at.
    #[default(EdgeY::YMax)]
    edge_y: EdgeY,
) -> Result<Device> {
    let (columns, rows) = dimensions(check, &device_list, shape)?;
    let mut cells = CellGrid::new(device_list, columns, rows)?;
    cells.align(align_y.into(), align_x.into());
    match separation {
        true => cells.distribute(LineSpacing::Gap(spacing.x), LineSpacing::Gap(spacing.y)),
        false => {
            cells
                .distribute(LineSpacing::Pitch(edge_x.into(), spacing.x), LineSpacing::Pitch(edge_y.into(), spacing.y));
        }
    }
    let mut d = Device::builder("grid");
    for reference in cells.into_references() {
        d.add(reference);
    }
    d.build()
}

/// The checked numbers of columns and rows of a grid.
fn dimensions(check: Check<'_>, list: &GridCells, shape: Option<GridShape>) -> Result<(usize, usize)> {
    let (columns, rows) = extent(check, list)?;
    let cells = columns * rows;
    check.that("device_list", "empty", cells > 0, "hold at least one cell")?;
    check.at_most("number of cells in device_list", cells, MOST_POSITIONS)?;
    let Some(shape) = shape else { return Ok((columns, rows)) };
    let shown = format!("({}, {})", shape.columns, shape.rows);
    let number = |n: i64| usize::try_from(n).ok().filter(|n| (1..=MOST_POSITIONS).contains(n));
    let dimensions = match (number(shape.columns), number(shape.rows)) {
        (Some(columns), Some(rows)) => Some((columns, rows)),
        (Some(columns), None) if shape.rows == -1 => Some((columns, cells.div_ceil(columns))),
        (None, Some(rows)) if shape.columns == -1 => Some((cells.div_ceil(rows), rows)),
        _ => None,
    };
    let rule = "be two numbers from 1 on, one of which may be -1 for as many as are needed";
    check.that("shape", &shown, dimensions.is_some(), rule)?;
    let (columns, rows) = dimensions.unwrap_or_default();
    let enough = (cells..=MOST_POSITIONS).contains(&columns.saturating_mul(rows));
    check.that("shape", shown, enough, &format!("have from {cells} to {MOST_POSITIONS} positions"))?;
    Ok((columns, rows))
}

/// Columns and rows of a list as it is.
fn extent(check: Check<'_>, list: &GridCells) -> Result<(usize, usize)> {
    match list {
        GridCells::Flat(slots) => Ok((slots.len(), 1)),
        GridCells::Rows(rows) => {
            let columns = rows.first().map_or(0, Vec::len);
            if let Some((index, row)) = rows.iter().enumerate().find(|(_, row)| row.len() != columns) {
                let rule = format!("be {columns}, as in device_list[0]");
                check.that(&format!("number of cells in device_list[{index}]"), row.len(), false, &rule)?;
            }
            Ok((columns, rows.len()))
        }
    }
}
