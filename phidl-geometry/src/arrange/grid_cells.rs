//! [`GridCells`]: the cells of a grid, in one row or in several.

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;

/// Cells in one list, or in rows with the top one first. `None` leaves a position empty.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// use pg::arrange::GridCells;
/// let (a, b) = (pg::rectangle((4, 2), 0)?, pg::circle(3, 2.5, 0)?);
/// let _row = GridCells::from([&a, &b]);
/// let _rows = GridCells::from([[Some(&a), Some(&b)], [Some(&b), None]]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum GridCells {
    /// One list, which a shape may break into rows.
    Flat(Vec<GridCell>),
    /// Rows, from the top; all have the same length.
    Rows(Vec<Vec<GridCell>>),
}

/// One position of [`GridCells`]: a cell or nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct GridCell(pub Option<Device>);

impl From<Device> for GridCell {
    fn from(device: Device) -> Self {
        Self(Some(device))
    }
}

impl From<&Device> for GridCell {
    fn from(device: &Device) -> Self {
        Self(Some(device.clone()))
    }
}

impl From<Option<Device>> for GridCell {
    fn from(device: Option<Device>) -> Self {
        Self(device)
    }
}

impl From<Option<&Device>> for GridCell {
    fn from(device: Option<&Device>) -> Self {
        Self(device.cloned())
    }
}

impl<S: Into<GridCell>> FromIterator<S> for GridCells {
    fn from_iter<I: IntoIterator<Item = S>>(cells: I) -> Self {
        Self::Flat(cells.into_iter().map(Into::into).collect())
    }
}

impl<S: Into<GridCell>, const N: usize> From<[S; N]> for GridCells {
    fn from(cells: [S; N]) -> Self {
        cells.into_iter().collect()
    }
}

impl<S: Into<GridCell>> From<Vec<S>> for GridCells {
    fn from(cells: Vec<S>) -> Self {
        cells.into_iter().collect()
    }
}

impl From<&[Device]> for GridCells {
    fn from(cells: &[Device]) -> Self {
        cells.iter().collect()
    }
}

impl From<&Vec<Device>> for GridCells {
    fn from(cells: &Vec<Device>) -> Self {
        cells.iter().collect()
    }
}

impl<S: Into<GridCell>, const N: usize, const M: usize> From<[[S; M]; N]> for GridCells {
    fn from(rows: [[S; M]; N]) -> Self {
        Self::Rows(rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect())
    }
}

impl<S: Into<GridCell>> From<Vec<Vec<S>>> for GridCells {
    fn from(rows: Vec<Vec<S>>) -> Self {
        Self::Rows(rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect())
    }
}

impl Param for GridCell {
    fn param_type() -> ParamType {
        ParamType::Optional(Box::new(ParamType::Device))
    }

    fn to_value(&self) -> Value {
        self.0.to_value()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        Option::from_value(value).map(Self)
    }
}

impl Param for GridCells {
    fn param_type() -> ParamType {
        ParamType::Other("list of devices, or list of such rows")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Flat(cells) => cells.to_value(),
            Self::Rows(rows) => rows.to_value(),
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let nested = value.as_list().is_some_and(|list| list.iter().any(|item| item.as_list().is_some()));
        if nested { Vec::from_value(value).map(Self::Rows) } else { Vec::from_value(value).map(Self::Flat) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basic::rectangle;

    #[test]
    fn lists_and_rows_come_back_from_their_values() {
        let a = rectangle((1, 2), 0).unwrap();
        for list in [GridCells::from([Some(&a), None]), GridCells::from([[&a, &a], [&a, &a]])] {
            assert_eq!(GridCells::from_value(&list.to_value()).unwrap(), list);
        }
    }

    #[test]
    fn a_row_among_cells_is_refused_with_its_index() {
        let a = rectangle((1, 2), 0).unwrap();
        let mixed = Value::from(vec![Value::from(a.clone()), Value::from(vec![Value::from(a)])]);
        assert!(GridCells::from_value(&mixed).unwrap_err().to_string().starts_with("[0] is"));
    }
}
