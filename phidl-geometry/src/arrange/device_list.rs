//! [`DeviceList`]: cells for a grid, in one row or in several.

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;

/// Cells in one list, or in rows with the top one first. Where a cell is missing (`None`), its place stays free.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// use pg::arrange::DeviceList;
/// let (a, b) = (pg::rectangle((4, 2), 0)?, pg::circle(3, 2.5, 0)?);
/// let _row = DeviceList::from([&a, &b]);
/// let _rows = DeviceList::from([[Some(&a), Some(&b)], [Some(&b), None]]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum DeviceList {
    /// One list, which a shape may break into rows.
    Flat(Vec<Slot>),
    /// Rows, from the top; all have the same length.
    Rows(Vec<Vec<Slot>>),
}

/// A place in a [`DeviceList`], with a cell or free.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot(pub Option<Device>);

impl From<Device> for Slot {
    fn from(device: Device) -> Self {
        Self(Some(device))
    }
}

impl From<&Device> for Slot {
    fn from(device: &Device) -> Self {
        Self(Some(device.clone()))
    }
}

impl From<Option<Device>> for Slot {
    fn from(device: Option<Device>) -> Self {
        Self(device)
    }
}

impl From<Option<&Device>> for Slot {
    fn from(device: Option<&Device>) -> Self {
        Self(device.cloned())
    }
}

impl<S: Into<Slot>> FromIterator<S> for DeviceList {
    fn from_iter<I: IntoIterator<Item = S>>(cells: I) -> Self {
        Self::Flat(cells.into_iter().map(Into::into).collect())
    }
}

impl<S: Into<Slot>, const N: usize> From<[S; N]> for DeviceList {
    fn from(cells: [S; N]) -> Self {
        cells.into_iter().collect()
    }
}

impl<S: Into<Slot>> From<Vec<S>> for DeviceList {
    fn from(cells: Vec<S>) -> Self {
        cells.into_iter().collect()
    }
}

impl From<&[Device]> for DeviceList {
    fn from(cells: &[Device]) -> Self {
        cells.iter().collect()
    }
}

impl From<&Vec<Device>> for DeviceList {
    fn from(cells: &Vec<Device>) -> Self {
        cells.iter().collect()
    }
}

impl<S: Into<Slot>, const N: usize, const M: usize> From<[[S; M]; N]> for DeviceList {
    fn from(rows: [[S; M]; N]) -> Self {
        Self::Rows(rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect())
    }
}

impl<S: Into<Slot>> From<Vec<Vec<S>>> for DeviceList {
    fn from(rows: Vec<Vec<S>>) -> Self {
        Self::Rows(rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect())
    }
}

impl Param for Slot {
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

impl Param for DeviceList {
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
        for list in [DeviceList::from([Some(&a), None]), DeviceList::from([[&a, &a], [&a, &a]])] {
            assert_eq!(DeviceList::from_value(&list.to_value()).unwrap(), list);
        }
    }

    #[test]
    fn a_row_among_cells_is_refused_with_its_place() {
        let a = rectangle((1, 2), 0).unwrap();
        let mixed = Value::from(vec![Value::from(a.clone()), Value::from(vec![Value::from(a)])]);
        assert!(DeviceList::from_value(&mixed).unwrap_err().to_string().starts_with("[0] is"));
    }
}
