//! Polygons to BOUNDARY records: the hot path of the writer.
//!
//! gds21 would want every outline as a vector of its own and write it number by number through a `dyn Write`. Here the
//! points go from the cell's buffer to the grid to the file's bytes, which is what a mask of millions of them needs.

use gds21::{GdsDataType, GdsRecordType};
use phidl_core::num::grid::{Grid, GridError};
use phidl_core::scene::{Device, PolygonView};

use super::limits::Limits;
use super::options::GdsOptions;
use super::record::{header, put_property};
use super::split::{Corner, split};
use crate::error::{IoError, Item, Result};

/// What happened to the polygons on the way into the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Written {
    /// Outlines in the file.
    pub(super) outlines: u64,
    /// Polygons that were cut, since they had more corners than the file allows.
    pub(super) cut: u64,
    /// Polygons that are a line or a point on the grid, and are left out.
    pub(super) collapsed: u64,
}

/// Writes the polygons of a cell, by portions.
pub(super) struct Outlines<'a> {
    pub(super) grid: &'a Grid,
    pub(super) options: &'a GdsOptions,
    pub(super) limits: &'a Limits<'a>,
    corners: Vec<Corner>,
    pub(super) written: Written,
}

impl<'a> Outlines<'a> {
    pub(super) fn new(grid: &'a Grid, options: &'a GdsOptions, limits: &'a Limits<'a>) -> Self {
        Self { grid, options, limits, corners: Vec::new(), written: Written::default() }
    }

    /// Appends the records of all polygons of a cell; `flush` takes the bytes away from time to time.
    pub(super) fn write(
        &mut self,
        cell: &Device,
        bytes: &mut Vec<u8>,
        mut flush: impl FnMut(&mut Vec<u8>) -> Result<()>,
    ) -> Result<()> {
        for (index, polygon) in cell.polygons().enumerate() {
            self.polygon(cell, index, &polygon, bytes)?;
            flush(bytes)?;
        }
        Ok(())
    }

    fn polygon(&mut self, cell: &Device, index: usize, polygon: &PolygonView<'_>, bytes: &mut Vec<u8>) -> Result<()> {
        let item = || Item::Polygon { index, layer: polygon.layer };
        self.limits.layer(cell, polygon.layer, item)?;
        self.round(polygon).map_err(|source| IoError::OutOfRange {
            cell: cell.name().into(),
            item: Box::new(item()),
            source,
        })?;
        if is_collapsed(&self.corners) {
            self.written.collapsed += 1;
            return Ok(());
        }
        let mut properties = Vec::new();
        for (attribute, text) in polygon.properties() {
            self.limits.property(cell, attribute, text, item)?;
            put_property(attribute, text, &mut properties);
        }
        let head = head(polygon);
        if self.corners.len() <= self.options.max_points {
            self.written.outlines += 1;
            put_boundary(&head, &self.corners, &properties, bytes);
            return Ok(());
        }
        self.written.cut += 1;
        for piece in split(std::mem::take(&mut self.corners), self.options.max_points) {
            self.written.outlines += 1;
            put_boundary(&head, &piece, &properties, bytes);
        }
        Ok(())
    }

    /// Takes the corners to the grid.
    fn round(&mut self, polygon: &PolygonView<'_>) -> Result<(), GridError> {
        self.corners.clear();
        self.corners.reserve(polygon.points.len());
        for point in polygon.points {
            self.corners.push(super::corner(self.grid, *point)?);
        }
        Ok(())
    }
}

/// Whether nothing is enclosed, since fewer than three different corners are left.
fn is_collapsed(corners: &[Corner]) -> bool {
    let Some((first, rest)) = corners.split_first() else { return true };
    let Some(second) = rest.iter().find(|corner| *corner != first) else { return true };
    rest.iter().all(|corner| corner == first || corner == second)
}

/// BOUNDARY, LAYER, DATATYPE: the 16 bytes in front of the coordinates.
fn head(polygon: &PolygonView<'_>) -> [u8; 16] {
    let mut head = [0; 16];
    head[..4].copy_from_slice(&header(GdsRecordType::Boundary, GdsDataType::NoData, 0));
    head[4..8].copy_from_slice(&header(GdsRecordType::Layer, GdsDataType::I16, 2));
    head[8..10].copy_from_slice(&polygon.layer.number.to_be_bytes());
    head[10..14].copy_from_slice(&header(GdsRecordType::DataType, GdsDataType::I16, 2));
    head[14..].copy_from_slice(&polygon.layer.datatype.to_be_bytes());
    head
}

fn put_boundary(head: &[u8], corners: &[Corner], properties: &[u8], bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(head);
    let size = (corners.len() + 1) * 8;
    let size_word = u16::try_from(size).expect("invariant: an outline has at most 8190 corners");
    bytes.extend_from_slice(&header(GdsRecordType::Xy, GdsDataType::I32, size_word));
    let start = bytes.len();
    bytes.resize(start + size, 0);
    // GDSII repeats the first corner at the end.
    for (place, corner) in bytes[start..].chunks_exact_mut(8).zip(corners.iter().chain(corners.first())) {
        place[..4].copy_from_slice(&corner[0].to_be_bytes());
        place[4..].copy_from_slice(&corner[1].to_be_bytes());
    }
    bytes.extend_from_slice(properties);
    bytes.extend_from_slice(&header(GdsRecordType::EndElement, GdsDataType::NoData, 0));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_points_enclose_nothing() {
        assert!(is_collapsed(&[[1, 1], [1, 1], [1, 1]]));
        assert!(is_collapsed(&[[1, 1], [1, 2], [1, 1], [1, 2]]));
        assert!(!is_collapsed(&[[1, 1], [1, 2], [2, 2]]));
    }
}
