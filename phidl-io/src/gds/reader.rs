//! The bytes of a file into a [`Layout`].
//!
//! Only what leaves no doubt about where records begin and which cell they belong to is an error: a record that is cut
//! off, an element or cell that does not end, a library without units. An element that breaks a rule of its own is a
//! problem, and the rest of the file is read: other tools wrote the file, and its user wants the mask.

use std::path::Path;

use phidl_core::num::grid::Grid;

use super::element::fields::{Defect, Fields, text_of};
use super::element::{boundary, box_element, node, path, reference, text};
use super::real::{decode, is_representable};
use super::record::{FormatError, Record, Records, kind};
use crate::error::{IoError, Result, real};
use crate::model::{Cell, Date, Layout, ProblemKind, Problems};

/// Where KLayout keeps the origin of library cells and parametric cells. It is not part of the layout.
const CONTEXT_INFO: &str = "$$$CONTEXT_INFO$$$";

/// Reads the bytes of a GDSII file as the file states them: paths stay paths, cells need not be there.
///
/// # Errors
/// [`IoError::Malformed`] with byte and cell, [`IoError::DuplicateCell`], in the name of "these bytes".
pub fn decode_layout(bytes: &[u8]) -> Result<Layout> {
    parse(bytes, "these bytes")
}

/// Reads a GDSII file as it stands, as [`decode_layout`] does.
///
/// # Errors
/// As for [`decode_layout`]; [`IoError::File`].
pub fn read_layout(path: impl AsRef<Path>) -> Result<Layout> {
    let path = path.as_ref();
    parse(&crate::input::read(path)?, &path.display().to_string())
}

/// Reads all cells. `file` is the name in errors.
pub(crate) fn parse(bytes: &[u8], file: &str) -> Result<Layout> {
    let mut reader =
        Reader { records: Records::new(bytes), layout: None, defined: Vec::new(), cell_name: String::new() };
    reader.library().map_err(|stop| match stop {
        Stop::Format(FormatError { offset, problem }) => {
            let cell = (!reader.cell_name.is_empty()).then(|| reader.cell_name.as_str().into());
            IoError::Malformed { file: file.into(), offset, cell, problem }
        }
        Stop::Duplicate(offset) => {
            IoError::DuplicateCell { file: file.into(), name: reader.cell_name.as_str().into(), offset }
        }
    })?;
    Ok(reader.layout.expect("invariant: a library that was read has a head"))
}

/// Why reading stopped.
enum Stop {
    Format(FormatError),
    /// A second cell of the current name begins here.
    Duplicate(usize),
}

impl From<FormatError> for Stop {
    fn from(error: FormatError) -> Self {
        Self::Format(error)
    }
}

struct Reader<'a> {
    records: Records<'a>,
    layout: Option<Layout>,
    /// Whether the cell of each name was read.
    defined: Vec<bool>,
    /// The cell that is being read.
    cell_name: String,
}

impl Reader<'_> {
    fn library(&mut self) -> Result<(), Stop> {
        let mut layout = head(&mut self.records)?;
        let outcome = self.cells(&mut layout);
        self.layout = Some(layout);
        outcome
    }

    fn cells(&mut self, layout: &mut Layout) -> Result<(), Stop> {
        loop {
            self.cell_name.clear();
            let record = self.records.next()?;
            match record.kind {
                kind::ENDLIB => break,
                kind::BGNSTR => self.cell(&record, layout)?,
                kind::PROPATTR => layout.problems.push("", record.offset, ProblemKind::CellProperty),
                kind::PROPVALUE => {}
                other => layout.problems.push("", record.offset, ProblemKind::Record(other)),
            }
        }
        let rest = self.records.rest();
        if let Some(last) = rest.iter().rposition(|byte| *byte != 0) {
            layout.problems.push("", self.records.offset, ProblemKind::Trailing(last + 1));
        }
        Ok(())
    }

    fn cell(&mut self, begin: &Record<'_>, layout: &mut Layout) -> Result<(), Stop> {
        let record = self.records.next()?;
        if record.kind != kind::STRNAME || record.trimmed().is_empty() {
            return Err(FormatError::new(record.offset, "a cell has no name").into());
        }
        self.cell_name = text_of(&record, "", &mut layout.problems);
        let id = layout.names.intern(&self.cell_name);
        if self.defined.len() <= id.index() {
            self.defined.resize(id.index() + 1, false);
        }
        if std::mem::replace(&mut self.defined[id.index()], true) {
            return Err(Stop::Duplicate(begin.offset));
        }
        let mut cell = Cell::new(id);
        (cell.offset, cell.modified) = (begin.offset, date(begin.content));
        self.elements(&mut cell, layout)?;
        if self.cell_name == CONTEXT_INFO {
            layout.problems.push(CONTEXT_INFO, begin.offset, ProblemKind::ContextInfo);
        } else {
            layout.cells.push(cell);
        }
        Ok(())
    }

    fn elements(&mut self, cell: &mut Cell, layout: &mut Layout) -> Result<(), FormatError> {
        let name = self.cell_name.clone();
        loop {
            let record = self.records.next()?;
            let kind = match record.kind {
                kind::ENDSTR => return Ok(()),
                kind::BOUNDARY | kind::PATH | kind::SREF | kind::AREF | kind::TEXT | kind::NODE | kind::BOX => {
                    let mut fields = Fields::read(record.offset, &mut self.records, &name, &mut layout.problems)?;
                    match element(record.kind, &mut fields, cell, &name, layout) {
                        Ok(()) => continue,
                        Err(defect) => ProblemKind::Element(defect),
                    }
                }
                kind::STRCLASS | kind::PROPVALUE => continue,
                kind::PROPATTR => ProblemKind::CellProperty,
                kind::BGNSTR | kind::ENDLIB => {
                    let problem = format!("record {:#04x} stands inside a cell, which has no ENDSTR", record.kind);
                    return Err(FormatError::new(record.offset, problem));
                }
                other => ProblemKind::Record(other),
            };
            layout.problems.push(&name, record.offset, kind);
        }
    }
}

/// Adds one element to its cell.
fn element(
    element: u8,
    fields: &mut Fields<'_>,
    cell: &mut Cell,
    name: &str,
    layout: &mut Layout,
) -> Result<(), Defect> {
    let Layout { names, problems, .. } = layout;
    match element {
        kind::BOUNDARY => {
            if !boundary::read(fields, &mut cell.polygons)? {
                problems.push(name, fields.offset, ProblemKind::Empty);
            }
        }
        kind::SREF => cell.placements.push(reference::read(fields, names, name, problems)?),
        kind::AREF => cell.placements.push(reference::read_array(fields, names, name, problems)?),
        kind::TEXT => cell.texts.push(text::read(fields, name, problems)?),
        kind::PATH => cell.paths.push(path::read(fields)?),
        kind::NODE => {
            cell.nodes.push(node::read(fields)?);
            problems.push(name, fields.offset, ProblemKind::Node);
        }
        _ => match box_element::read(fields)? {
            Some(element) => {
                cell.boxes.push(element);
                problems.push(name, fields.offset, ProblemKind::Box);
            }
            None => problems.push(name, fields.offset, ProblemKind::Empty),
        },
    }
    Ok(())
}

/// What precedes the cells: name, dates, units. Other libraries, fonts, masks and the like do not change the drawing.
fn head(records: &mut Records<'_>) -> Result<Layout, FormatError> {
    let start = records.rest();
    let first = records.next().ok().filter(|record| record.kind == kind::HEADER);
    first.ok_or_else(|| FormatError::new(0, other_format(start)))?;
    let (mut name, mut modified, mut problems) = (String::new(), None, Problems::default());
    loop {
        let record = records.next()?;
        match record.kind {
            kind::LIBNAME => name = text_of(&record, "", &mut problems),
            kind::BGNLIB => modified = date(record.content),
            kind::UNITS => {
                let (grid, user_unit, stated) = units(&record)?;
                let gds_units = Some(stated);
                return Ok(Layout { name, user_unit, gds_units, modified, problems, ..Layout::new(grid) });
            }
            kind::BGNSTR | kind::ENDLIB => {
                return Err(FormatError::new(record.offset, "the library states no units"));
            }
            _ => {}
        }
    }
}

/// What a file is that is not GDSII.
fn other_format(start: &[u8]) -> &'static str {
    match start {
        [0x1f, 0x8b, ..] => "it is a gzip file and not GDSII",
        _ if start.starts_with(b"%SEMI-OASIS") => "it is an OASIS file and not GDSII",
        _ => "it is not a GDSII file, which begins with a HEADER record",
    }
}

/// The grid, the user unit (µm), and the two numbers that state them.
fn units(record: &Record<'_>) -> Result<(Grid, f64, [f64; 2]), FormatError> {
    let bad = |problem: String| FormatError::new(record.offset, problem);
    let (halves, []) = record.content.as_chunks::<8>() else {
        return Err(bad(format!("UNITS holds {} bytes instead of 16", record.content.len())));
    };
    let &[user, meters] = halves else {
        return Err(bad(format!("UNITS holds {} bytes instead of 16", record.content.len())));
    };
    let [in_user_units, in_meters] = [user, meters].map(decode);
    let step = in_meters * 1e6;
    if ![step, in_meters, in_user_units].into_iter().all(is_representable) {
        return Err(bad(format!("the database unit is {} m and {} user units", real(in_meters), real(in_user_units))));
    }
    let grid = Grid::new(step).map_err(|error| bad(error.to_string()))?;
    Ok((grid, grid.um(1) / in_user_units, [in_user_units, in_meters]))
}

/// The first of the two dates, if it is one. Old files count years from 1900.
fn date(content: &[u8]) -> Option<Date> {
    let numbers: Vec<i16> = content.as_chunks::<2>().0.iter().map(|pair| i16::from_be_bytes(*pair)).collect();
    let &[year, month, day, hour, minute, second, ..] = numbers.as_slice() else { return None };
    let year = if (0..1900).contains(&year) { year + 1900 } else { year };
    let small = |number: i16| u8::try_from(number).ok();
    let date = Date {
        year,
        month: small(month)?,
        day: small(day)?,
        hour: small(hour)?,
        minute: small(minute)?,
        second: small(second)?,
    };
    date.is_valid().then_some(date)
}
