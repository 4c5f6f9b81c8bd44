//! A [`Layout`] into the bytes of a file, cell by cell.
//!
//! The writer takes cells as they come, so that the cells of a large mask need not be in the model all at once.

use std::path::Path as FilePath;

use super::element::{boundary, box_element, node, path, reference, text};
use super::options::MOST_POINTS;
use super::real::is_representable;
use super::record::{MOST_TEXT, kind, put_mark, put_reals, put_text, put_u16, put_u16s};
use crate::atomic::AtomicFile;
use crate::error::{IoError, Item, Result, real};
use crate::model::{Cell, CellNames, Date, Lattice, Layout, Placement};

/// The stream version that every reader takes.
const VERSION: u16 = 600;

/// Bytes are handed on in portions of about this size.
const PORTION: usize = 1 << 20;

/// What precedes the cells of a file.
pub(super) struct Head<'a> {
    pub(super) name: &'a str,
    pub(super) date: Date,
    /// The grid step in user units and in meters.
    pub(super) units: (f64, f64),
}

/// Writes the records of a file; `put` takes the bytes.
pub(super) struct Writer<P> {
    put: P,
    buffer: Vec<u8>,
    /// Bytes that were handed on.
    written: u64,
    date: Date,
}

impl<P: FnMut(&[u8]) -> Result<()>> Writer<P> {
    /// Begins a file.
    pub(super) fn new(head: &Head<'_>, put: P) -> Self {
        let mut buffer = Vec::with_capacity(PORTION + PORTION / 8);
        put_u16(kind::HEADER, VERSION, &mut buffer);
        put_dates(kind::BGNLIB, head.date, &mut buffer);
        put_text(kind::LIBNAME, head.name, &mut buffer);
        put_reals(kind::UNITS, [head.units.0, head.units.1], &mut buffer);
        Self { put, buffer, written: 0, date: head.date }
    }

    /// Writes a cell: boundaries, paths, boxes, nodes, texts, references, as PHIDL orders them.
    pub(super) fn cell(&mut self, cell: &Cell, names: &CellNames) -> Result<()> {
        put_dates(kind::BGNSTR, cell.modified.unwrap_or(self.date), &mut self.buffer);
        put_text(kind::STRNAME, names.name(cell.name), &mut self.buffer);
        self.each(cell.polygons.iter(), |polygon, bytes| boundary::write(&polygon, bytes))?;
        self.each(&cell.paths, path::write)?;
        self.each(&cell.boxes, box_element::write)?;
        self.each(&cell.nodes, node::write)?;
        self.each(&cell.texts, text::write)?;
        self.each(&cell.placements, |placement, bytes| {
            reference::write(placement, names.name(placement.child), bytes);
        })?;
        put_mark(kind::ENDSTR, &mut self.buffer);
        Ok(())
    }

    fn each<T>(&mut self, elements: impl IntoIterator<Item = T>, write: impl Fn(T, &mut Vec<u8>)) -> Result<()> {
        for element in elements {
            write(element, &mut self.buffer);
            if self.buffer.len() >= PORTION {
                self.flush()?;
            }
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<()> {
        self.written += self.buffer.len() as u64;
        (self.put)(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }

    /// Ends the file and returns its length in bytes.
    pub(super) fn finish(mut self) -> Result<u64> {
        put_mark(kind::ENDLIB, &mut self.buffer);
        self.flush()?;
        Ok(self.written)
    }
}

/// The date twice: last modified, last read.
fn put_dates(record: u8, date: Date, bytes: &mut Vec<u8>) {
    let Date { year, month, day, hour, minute, second } = date;
    let [month, day, hour, minute, second] = [month, day, hour, minute, second].map(u16::from);
    let date = [year.cast_unsigned(), month, day, hour, minute, second];
    put_u16s(record, [date, date].as_flattened().try_into().unwrap_or([0_u16; 12]), bytes);
}

/// The bytes of a layout as a GDSII file: paths as paths, boxes as boxes, cells in their order, dates as they are.
///
/// ```
/// # use phidl_core::num::grid::Grid;
/// use phidl_io::gds;
/// use phidl_io::model::{Cell, Layout, Path, PathEnd};
/// let mut layout = Layout::new(Grid::new(1e-3)?);
/// let mut wire = Cell::new(layout.names.intern("wire"));
/// wire.paths.push(Path {
///     layer: 1.into(),
///     points: vec![[0, 0], [10_000, 0]],
///     width: 500,
///     fixed_width: false,
///     start: PathEnd::Round,
///     end: PathEnd::Round,
///     properties: Default::default(),
///     offset: 0,
/// });
/// layout.cells.push(wire);
/// let again = gds::decode_layout(&gds::encode_layout(&layout)?)?;
/// assert_eq!(again.cells[0].paths[0].start, PathEnd::Round);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Refused`] with cell and element for what a record cannot hold; [`IoError::Option`] for a grid or user unit
/// that the format cannot state.
pub fn encode_layout(layout: &Layout) -> Result<Vec<u8>> {
    let mut all = Vec::new();
    encode(layout, |bytes| {
        all.extend_from_slice(bytes);
        Ok(())
    })?;
    Ok(all)
}

/// Writes a layout as a GDSII file, as [`encode_layout`] does. Returns its length in bytes.
///
/// # Errors
/// As for [`encode_layout`]; [`IoError::File`].
pub fn write_layout(layout: &Layout, path: impl AsRef<FilePath>) -> Result<u64> {
    let mut file = AtomicFile::create(path)?;
    encode(layout, |bytes| file.put(bytes))?;
    file.commit()
}

fn encode(layout: &Layout, put: impl FnMut(&[u8]) -> Result<()>) -> Result<u64> {
    let made = || super::options::units(&layout.grid, layout.user_unit);
    let units = layout.gds_units.map_or_else(made, |[in_user_units, in_meters]| (in_user_units, in_meters));
    if !is_representable(units.0) || !is_representable(units.1) {
        let value = format!("{} µm on a grid of {} µm", real(layout.user_unit), real(layout.grid.step()));
        return Err(IoError::option("user_unit", value, "be a positive length that the format can state"));
    }
    let date = layout.modified.unwrap_or_default();
    let name = if layout.name.is_empty() { "phidl" } else { &layout.name };
    let mut writer = Writer::new(&Head { name, date, units }, put);
    for cell in &layout.cells {
        check(cell, &layout.names)?;
        writer.cell(cell, &layout.names)?;
    }
    writer.finish()
}

/// Refuses what the records of a cell cannot hold. Cells that come from devices were cut to fit.
fn check(cell: &Cell, names: &CellNames) -> Result<()> {
    let refused = |item: Item, what, value: String, rule: String| {
        let cell = names.name(cell.name).into();
        Err(IoError::Refused { cell, item: Box::new(item), what, value: value.into(), rule: rule.into() })
    };
    for (index, polygon) in cell.polygons.iter().enumerate() {
        if polygon.corners.len() > MOST_POINTS {
            let (value, rule) =
                (format!("{} corners long", polygon.corners.len()), format!("have at most {MOST_POINTS} corners"));
            return refused(Item::Polygon { index, layer: polygon.layer }, "outline", value, rule);
        }
    }
    for (index, path) in cell.paths.iter().enumerate() {
        if path.points.len() > MOST_POINTS {
            let (value, rule) =
                (format!("{} points long", path.points.len()), format!("have at most {MOST_POINTS} points"));
            return refused(Item::Path { index, layer: path.layer }, "centerline", value, rule);
        }
        if path.width > i64::from(i32::MAX) {
            let (value, rule) = (format!("{} steps", path.width), format!("be at most {} steps", i32::MAX));
            return refused(Item::Path { index, layer: path.layer }, "width", value, rule);
        }
    }
    for (index, text) in cell.texts.iter().enumerate() {
        if text.string.len() > MOST_TEXT && !fits_as_latin1(&text.string) {
            let (value, rule) =
                (format!("{} bytes long", text.string.len()), format!("have at most {MOST_TEXT} bytes"));
            return refused(Item::Label { index, text: text.string.clone() }, "text", value, rule);
        }
    }
    for (index, placement) in cell.placements.iter().enumerate() {
        if let Some(lattice) = placement.lattice.as_deref().filter(|lattice| !fits(placement, lattice)) {
            let value = format!("of {} columns and {} rows", lattice.columns, lattice.rows);
            let child = names.name(placement.child).to_owned();
            let rule = "have at most 65535 of each, and ends within 32 bits".to_owned();
            return refused(Item::Reference { index, child }, "lattice", value, rule);
        }
    }
    Ok(())
}

fn fits(placement: &Placement, lattice: &Lattice) -> bool {
    let reach = |extent: [i64; 2]| {
        [0, 1]
            .into_iter()
            .all(|axis| i32::try_from(i64::from(placement.origin[axis]).saturating_add(extent[axis])).is_ok())
    };
    lattice.columns.max(lattice.rows) <= u32::from(u16::MAX)
        && reach(lattice.column_extent)
        && reach(lattice.row_extent)
}

/// Whether a text that is too long in UTF-8 fits a record in Latin-1.
pub(crate) fn fits_as_latin1(text: &str) -> bool {
    text.chars().all(|c| u32::from(c) <= 0xff) && text.chars().count() <= MOST_TEXT
}
