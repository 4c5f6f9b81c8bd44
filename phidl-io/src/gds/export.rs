//! Devices into a file.

use std::path::Path;

use phidl_core::num::grid::Grid;
use phidl_core::scene::Device;

use super::options::{GdsOptions, units};
use super::writer::{Head, Writer};
use crate::atomic::AtomicFile;
use crate::error::{IoError, Result};
use crate::model::{Cell, CellTable, Changes, Content, Converter};
#[cfg(feature = "oasis")]
use crate::model::{Layout, Rules};
use crate::weld::{self, WeldReport};

/// What the writer did.
#[derive(Debug, Clone, PartialEq)]
pub struct GdsReport {
    /// The names of the cells in the file, the top cells last.
    pub cells: Vec<String>,
    /// Outlines in the file, each cell counted once.
    pub outlines: u64,
    /// Polygons with more corners than [`GdsOptions::max_points`], which were cut into several outlines.
    pub cut_polygons: u64,
    /// Polygons that are smaller than the grid, a line or a point on it, and were left out.
    pub collapsed_polygons: u64,
    /// Polygons from which repeated corners and there-and-back edges were taken out.
    pub cleaned_polygons: u64,
    /// Arrays whose elements are not a lattice on the grid, which are several references in the file.
    pub arrays_taken_apart: u64,
    /// Length of the file (bytes).
    pub bytes: u64,
    /// What was done about joints.
    pub weld: WeldReport,
}

/// Writes a device, or several, with all that they place as a GDSII file.
///
/// The path is taken as it is. A file of this name is replaced when the new file is complete, and not before.
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
/// [`IoError::Option`]; [`IoError::Refused`] and [`IoError::OutOfRange`] for what the format cannot state, with cell and
/// element; [`IoError::Extent`] for what placements bring out of range; [`IoError::EmptyMask`]; [`IoError::File`].
pub fn write<'a>(content: impl Into<Content<'a>>, path: impl AsRef<Path>, options: &GdsOptions) -> Result<GdsReport> {
    options.check()?;
    into_file(content.into(), AtomicFile::create(path)?, options)
}

/// Writes a file of a folder of results, as [`write()`] does; a link that leads out of the folder is refused.
pub(crate) fn write_in(top: &Device, folder: &Path, name: &str, options: &GdsOptions) -> Result<GdsReport> {
    options.check()?;
    into_file(top.into(), AtomicFile::create_in(folder, name)?, options)
}

fn into_file(content: Content<'_>, mut file: AtomicFile, options: &GdsOptions) -> Result<GdsReport> {
    let report = encode(content, options, |bytes| file.put(bytes))?;
    file.commit()?;
    Ok(report)
}

/// The bytes that [`write()`] writes.
///
/// # Errors
/// As for [`write()`], files aside.
pub fn to_bytes<'a>(content: impl Into<Content<'a>>, options: &GdsOptions) -> Result<Vec<u8>> {
    let mut all = Vec::new();
    encode(content.into(), options, |bytes| {
        all.extend_from_slice(bytes);
        Ok(())
    })?;
    Ok(all)
}

fn encode(content: Content<'_>, options: &GdsOptions, put: impl FnMut(&[u8]) -> Result<()>) -> Result<GdsReport> {
    let grid = options.check()?;
    let (tops, weld) = welded(content, &grid, options)?;
    let table = CellTable::of(Content::from(&tops), &options.naming());
    let head = Head { name: &options.library_name, date: options.date, units: units(&grid, options.user_unit) };
    let mut writer = Writer::new(&head, put);
    let mut converter = Converter::new(&table, options.rules(grid));
    let mut cell: Option<Cell> = None;
    for (device, _) in table.iter() {
        let cell = cell.get_or_insert_with(|| Cell::new(table.id_of(device)));
        converter.convert(device, cell)?;
        writer.cell(cell, table.names())?;
    }
    tops.iter().try_for_each(|top| check_extent(top, &grid))?;
    let changes = converter.changes;
    check_not_empty(content, options, &changes)?;
    Ok(GdsReport {
        cells: table.iter().map(|(_, name)| name.to_owned()).collect(),
        outlines: changes.outlines,
        cut_polygons: changes.cut_polygons,
        collapsed_polygons: changes.collapsed_polygons,
        cleaned_polygons: changes.cleaned_polygons,
        arrays_taken_apart: changes.arrays_taken_apart,
        bytes: writer.finish()?,
        weld,
    })
}

/// Refuses what placements bring out of the 32 bits of a file, nested, magnified and arrayed. Readers would show it elsewhere.
fn check_extent(top: &Device, grid: &Grid) -> Result<()> {
    let Err(error) = top.check_extent(grid) else { return Ok(()) };
    // 32 bits reach one step further down than up.
    let lowest = -(1_i64 << 31);
    let wider = grid.reaching(-lowest);
    let is_lowest = |um: f64| wider.steps(um).is_ok_and(|steps| (lowest..-lowest).contains(&steps));
    if top.check_extent(&wider).is_ok() && is_lowest(error.point.x) && is_lowest(error.point.y) {
        return Ok(());
    }
    Err(IoError::Extent(error))
}

/// The layout of some devices: welded, rounded and named as for a GDSII file, with polygons of any size.
#[cfg(feature = "oasis")]
pub(crate) fn to_layout(content: Content<'_>, options: &GdsOptions) -> Result<Layout> {
    let grid = options.check()?;
    let (tops, _) = welded(content, &grid, options)?;
    let table = CellTable::of(Content::from(&tops), &options.naming());
    let mut converter = Converter::new(&table, Rules { max_points: usize::MAX, ..options.rules(grid) });
    let mut layout = Layout::new(grid);
    layout.name.clone_from(&options.library_name);
    layout.user_unit = options.user_unit;
    layout.names = table.names().clone();
    for (device, _) in table.iter() {
        let mut cell = Cell::new(table.id_of(device));
        converter.convert(device, &mut cell)?;
        layout.cells.push(cell);
    }
    tops.iter().try_for_each(|top| check_extent(top, &grid))?;
    check_not_empty(content, options, &converter.changes)?;
    Ok(layout)
}

/// Refuses an empty mask, unless the options allow it.
fn check_not_empty(content: Content<'_>, options: &GdsOptions, changes: &Changes) -> Result<()> {
    if options.allow_empty || changes.outlines > 0 || changes.labels > 0 {
        return Ok(());
    }
    let name = content.tops().first().map_or("", |top| top.name());
    Err(IoError::EmptyMask { cell: name.into(), collapsed: changes.collapsed_polygons })
}

/// The top devices with welded joints.
pub(super) fn welded(content: Content<'_>, grid: &Grid, options: &GdsOptions) -> Result<(Vec<Device>, WeldReport)> {
    let mut report = WeldReport::default();
    let mut tops = Vec::with_capacity(content.tops().len());
    for top in content.tops() {
        let (welded, done) = weld::weld(top, grid, &options.weld, options.max_cellname_length)?;
        tops.push(welded);
        report.add(done);
    }
    Ok((tops, report))
}
