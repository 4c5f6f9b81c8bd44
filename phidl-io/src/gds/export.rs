//! A device into a file.

use std::path::Path;

use phidl_core::num::grid::Grid;
use phidl_core::scene::Device;

use super::cells::CellTable;
use super::elements::{Elements, unfit};
use super::frame::{END_CELL, Frame};
use super::limits::Limits;
use super::options::GdsOptions;
use super::outline::Outlines;
use crate::atomic::AtomicFile;
use crate::error::Result;
use crate::weld::{self, WeldReport};

/// Bytes are handed on in portions of about this size.
const PORTION: usize = 1 << 20;

/// What the writer did.
#[derive(Debug, Clone, PartialEq)]
pub struct GdsReport {
    /// The names of the cells in the file, the top cell last.
    pub cells: Vec<String>,
    /// Outlines in the file, each cell counted once.
    pub outlines: u64,
    /// Polygons with more corners than [`GdsOptions::max_points`], which were cut into several outlines.
    pub cut_polygons: u64,
    /// Polygons that are smaller than the grid, a line or a point on it, and were left out.
    pub collapsed_polygons: u64,
    /// Arrays whose elements do not lie on a lattice of the grid, and which are several references in the file.
    pub arrays_taken_apart: u64,
    /// Length of the file (bytes).
    pub bytes: u64,
    /// What was done about joints.
    pub weld: WeldReport,
}

/// Writes a device with all that it places as a GDSII file.
///
/// The path is taken as it is; whatever stood there is replaced when the new file is whole, and not before.
///
/// ```
/// # use phidl_core::prelude::*;
/// use phidl_io::gds;
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (40, 0), (40, 20), (0, 20)], 1)?;
/// let pad = d.build()?;
///
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("pad.gds");
/// let report = gds::write(&pad, &path, &gds::GdsOptions::default())?;
/// assert_eq!(report.cells, ["pad"]);
/// assert_eq!(gds::read(&path, &gds::ReadOptions::default())?.device, pad);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Option`](crate::IoError::Option); [`IoError::Refused`](crate::IoError::Refused) and
/// [`IoError::OutOfRange`](crate::IoError::OutOfRange) for what the format cannot say, with cell and element;
/// [`IoError::File`](crate::IoError::File).
pub fn write(device: &Device, path: impl AsRef<Path>, options: &GdsOptions) -> Result<GdsReport> {
    let grid = options.check()?;
    let mut file = AtomicFile::create(path)?;
    let report = encode(device, &grid, options, |bytes| file.put(bytes))?;
    file.commit()?;
    Ok(report)
}

/// The bytes that [`write()`] would write.
///
/// # Errors
/// As for [`write()`], files aside.
pub fn to_bytes(device: &Device, options: &GdsOptions) -> Result<Vec<u8>> {
    let grid = options.check()?;
    let mut all = Vec::new();
    encode(device, &grid, options, |bytes| {
        all.extend_from_slice(bytes);
        Ok(())
    })?;
    Ok(all)
}

fn encode(
    device: &Device,
    grid: &Grid,
    options: &GdsOptions,
    mut put: impl FnMut(&[u8]) -> Result<()>,
) -> Result<GdsReport> {
    let (device, weld) = weld::weld(device, grid, &options.weld, options.max_cellname_length)?;
    let table = CellTable::of(&device, options)?;
    let frame = Frame::new(&options.library_name, options.date, options.units(grid)).map_err(unfit)?;
    let limits = Limits(&options.limits);
    let mut outlines = Outlines::new(grid, options, &limits);
    let mut arrays_taken_apart = 0;
    let mut total = 0;
    let mut buffer = frame.head.clone();
    let mut flush = |buffer: &mut Vec<u8>, from: usize| {
        if buffer.len() < from {
            return Ok(());
        }
        total += buffer.len() as u64;
        put(buffer)?;
        buffer.clear();
        Ok(())
    };
    for (cell, name) in table.iter() {
        buffer.extend_from_slice(&frame.cell(name).map_err(unfit)?);
        outlines.write(cell, &mut buffer, |buffer| flush(buffer, PORTION))?;
        let elements = Elements { cell, table: &table, frame: &frame, grid, limits: &limits };
        arrays_taken_apart += elements.write(&mut buffer, |buffer| flush(buffer, PORTION))?;
        buffer.extend_from_slice(&END_CELL);
    }
    buffer.extend_from_slice(&frame.tail);
    flush(&mut buffer, 0)?;
    Ok(GdsReport {
        cells: table.iter().map(|(_, name)| name.to_owned()).collect(),
        outlines: outlines.written.outlines,
        cut_polygons: outlines.written.cut,
        collapsed_polygons: outlines.written.collapsed,
        arrays_taken_apart,
        bytes: total,
        weld,
    })
}

#[cfg(test)]
mod tests {
    use gds21::{GdsElement, GdsLibrary};
    use phidl_core::geom::Point;
    use phidl_core::layer::Layer;
    use phidl_core::place::Movable;
    use phidl_core::scene::{Anchor, Label, Polygon};

    use super::*;

    /// gds21's own reader knows nothing of the way that outlines take here.
    #[test]
    fn gds21_finds_every_element_with_all_it_has() {
        let mut d = Device::builder("dot");
        d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], (40_000, 3)).with_property(7, "odd"));
        let dot = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(Label::new("here", (1, 2), (5, 6)).anchored(Anchor::SouthWest));
        d.add(dot.place().rotated(90).moved_by((3, 4)));
        d.add(dot.array(2, 3, (10, 20)));
        let bytes = to_bytes(&d.build().unwrap(), &GdsOptions::default()).unwrap();

        let library = GdsLibrary::from_bytes(&bytes).unwrap();
        let names: Vec<&str> = library.structs.iter().map(|cell| cell.name.as_str()).collect();
        assert_eq!(names, ["dot", "top"]);
        let [GdsElement::GdsBoundary(b)] = &library.structs[0].elems[..] else { panic!("one boundary") };
        assert_eq!((b.layer, b.datatype, b.xy.len()), (-25_536, 3, 4));
        assert_eq!((b.properties[0].attr, b.properties[0].value.as_str()), (7, "odd"));
        let [GdsElement::GdsTextElem(t), GdsElement::GdsStructRef(s), GdsElement::GdsArrayRef(a)] =
            &library.structs[1].elems[..]
        else {
            panic!("a text, a reference, an array")
        };
        assert_eq!((t.string.as_str(), t.xy.x, t.texttype), ("here", 1000, 6));
        assert_eq!(t.presentation.as_ref().unwrap().1, 8);
        assert_eq!((s.xy.y, s.strans.as_ref().unwrap().angle), (4000, Some(90.0)));
        assert_eq!((a.cols, a.rows, a.xy[1].x, a.xy[2].y), (2, 3, 20_000, 60_000));
        assert_eq!(library.units.db_unit(), 1e-9);
    }

    #[test]
    fn portions_make_the_same_file_as_one_piece() {
        let mut d = Device::builder("many");
        for i in 0..20_000 {
            let at = Point::from((i % 200, i / 200));
            d.add_polygon([at, at + Point::new(0.5, 0.0), at + Point::new(0.0, 0.5)], Layer::new(1, 0)).unwrap();
        }
        let many = d.build().unwrap();
        let bytes = to_bytes(&many, &GdsOptions::default()).unwrap();
        assert!(bytes.len() > PORTION);
        let [cell] = &GdsLibrary::from_bytes(&bytes).unwrap().structs[..] else { panic!("one cell") };
        assert_eq!(cell.elems.len(), 20_000);
    }
}
