//! The cells of a file, with references by name: the first half of reading.

use std::collections::HashMap;

use gds21::GdsFloat64;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Device, DeviceBuilder, Polygon};

use super::boundary;
use super::options::is_real;
use super::problem::{Problem, ProblemKind};
use super::rest::{Element, FaultIn, Rest};
use super::scan::{Fault, Record, Records, kind};
use super::single::{self, Placement};
use crate::error::{IoError, Result};

/// A file as it stands there.
pub(super) struct Library {
    pub(super) name: String,
    /// The grid of the file, with its step in µm.
    pub(super) grid: Grid,
    /// The user unit of the file (µm).
    pub(super) user_unit: f64,
    pub(super) cells: Vec<OpenCell>,
    pub(super) problems: Vec<Problem>,
}

/// A cell whose references wait for the cells that they place.
pub(super) struct OpenCell {
    pub(super) name: String,
    pub(super) builder: DeviceBuilder,
    /// Boxes and paths: after the boundaries.
    pub(super) outlines: Vec<Polygon>,
    /// In the order of the file.
    pub(super) references: Vec<Placement>,
}

/// Reads all cells of a file. `file` is what errors call it.
pub(super) fn parse(bytes: &[u8], file: &str) -> Result<Library> {
    let mut records = Records::new(bytes);
    let malformed = |fault: Fault, cell: Option<&str>| IoError::Malformed {
        file: file.into(),
        offset: fault.offset,
        cell: cell.map(Into::into),
        problem: fault.problem,
    };
    let head = Head::read(&mut records).map_err(|fault| malformed(fault, None))?;
    let grid = head.grid;
    let mut parser = Parser { file, grid: &grid, records, rest: Rest::new(), cells: Vec::new(), problems: Vec::new() };
    let mut places = HashMap::new();
    let outcome = parser.cells(&mut places);
    let Parser { mut cells, mut problems, .. } = parser;
    outcome.map_err(|stop| match stop {
        Stop::Fault(fault) => malformed(fault, cells.last().map(|cell| cell.name.as_str())),
        Stop::FaultIn(FaultIn { cell, fault }) => malformed(fault, cells.get(cell).map(|cell| cell.name.as_str())),
        Stop::Error(error) => error,
    })?;
    problems.sort_by_key(|problem| problem.offset);
    for cell in &mut cells {
        cell.references.sort_by_key(|placement| placement.offset);
    }
    Ok(Library { name: head.name, grid, user_unit: head.user_unit, cells, problems })
}

/// What comes before the cells.
struct Head {
    name: String,
    grid: Grid,
    user_unit: f64,
}

impl Head {
    fn read(records: &mut Records<'_>) -> Result<Self, Fault> {
        let first = records.next()?;
        if first.kind != kind::HEADER {
            return Err(Fault::new(0, "not a GDSII file: it does not begin with a header"));
        }
        let mut name = String::new();
        loop {
            let record = records.next()?;
            match record.kind {
                kind::LIBNAME => name = record.text().0,
                kind::UNITS => {
                    let (grid, user_unit) = units(&record)?;
                    return Ok(Self { name, grid, user_unit });
                }
                kind::BGNSTR | kind::ENDLIB => return Err(Fault::new(record.offset, "no units are stated before it")),
                // Dates, other libraries, fonts, masks: nothing of these is drawn.
                _ => {}
            }
        }
    }
}

/// The grid, and the user unit (µm).
fn units(record: &Record<'_>) -> Result<(Grid, f64), Fault> {
    let bad = |problem: String| Fault::new(record.offset, problem);
    let Some((user, meters)) = record.content().split_first_chunk::<8>() else {
        return Err(bad("units of less than 16 bytes".to_owned()));
    };
    let Ok(meters) = <[u8; 8]>::try_from(meters) else {
        return Err(bad("units that do not have 16 bytes".to_owned()));
    };
    let [in_user_units, in_meters] = [*user, meters].map(|bytes| GdsFloat64::decode(u64::from_be_bytes(bytes)));
    let step = in_meters * 1e6;
    if !is_real(step) || !is_real(in_user_units) {
        return Err(bad(format!("a database unit of {in_meters} m and {in_user_units} user units")));
    }
    let grid = Grid::new(step).map_err(|error| bad(error.to_string()))?;
    Ok((grid, grid.um(1) / in_user_units))
}

/// Why reading stopped.
enum Stop {
    /// In the cell that is being read.
    Fault(Fault),
    /// In an earlier cell, whose elements were decoded later.
    FaultIn(FaultIn),
    Error(IoError),
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl From<FaultIn> for Stop {
    fn from(fault: FaultIn) -> Self {
        Self::FaultIn(fault)
    }
}

struct Parser<'a> {
    file: &'a str,
    grid: &'a Grid,
    records: Records<'a>,
    rest: Rest,
    cells: Vec<OpenCell>,
    problems: Vec<Problem>,
}

impl<'a> Parser<'a> {
    fn cells(&mut self, places: &mut HashMap<String, usize>) -> Result<(), Stop> {
        loop {
            let record = self.records.next()?;
            match record.kind {
                kind::ENDLIB => return self.decode(),
                kind::BGNSTR => self.cell(record.offset, places)?,
                other => return Err(Fault::new(record.offset, format!("record {other:#04x} between cells")).into()),
            }
        }
    }

    fn cell(&mut self, start: usize, places: &mut HashMap<String, usize>) -> Result<(), Stop> {
        let record = self.records.next()?;
        let (name, latin1) = record.text();
        if record.kind != kind::STRNAME || name.is_empty() {
            return Err(Fault::new(record.offset, "a cell without a name").into());
        }
        if places.insert(name.clone(), self.cells.len()).is_some() {
            let (file, name) = (self.file.into(), name.into());
            return Err(Stop::Error(IoError::DuplicateCell { file, name, offset: start }));
        }
        let builder = Device::builder(&name);
        self.cells.push(OpenCell { name, builder, outlines: Vec::new(), references: Vec::new() });
        if latin1 {
            self.problem(record.offset, ProblemKind::Latin1);
        }
        loop {
            let record = self.records.next()?;
            match record.kind {
                kind::ENDSTR => return Ok(()),
                kind::BOUNDARY => self.boundary(record.offset)?,
                kind::SREF => self.single(record.offset)?,
                kind::BOX | kind::PATH | kind::TEXT | kind::AREF => self.other(record)?,
                kind::NODE => self.skip(record.offset)?,
                kind::STRCLASS => {}
                other if other > kind::LAST => self.problem(record.offset, ProblemKind::Record(other)),
                other => return Err(Fault::new(record.offset, format!("record {other:#04x} between elements")).into()),
            }
        }
    }

    fn boundary(&mut self, start: usize) -> Result<(), Stop> {
        let Some(cell) = self.cells.last_mut() else { return Ok(()) };
        let (name, problems) = (&cell.name, &mut self.problems);
        let mut problem = |offset, kind| problems.push(Problem { cell: name.clone(), offset, kind });
        let boundary = boundary::read(&mut self.records, self.grid, &mut problem)?;
        if boundary.corners.len() < 3 {
            problem(start, ProblemKind::Empty);
            return Ok(());
        }
        let added = cell.builder.add_polygon(&boundary.corners, boundary.layer);
        let kept = added.and_then(|key| match boundary.properties.is_empty() {
            true => Ok(()),
            false => cell.builder.set_properties(key, boundary.properties).map(|_| ()),
        });
        kept.map_err(|error| Fault::new(start, error.report()).into())
    }

    fn single(&mut self, start: usize) -> Result<(), Stop> {
        let Some(cell) = self.cells.last_mut() else { return Ok(()) };
        let (name, problems) = (&cell.name, &mut self.problems);
        let problem = |offset, kind| problems.push(Problem { cell: name.clone(), offset, kind });
        cell.references.push(single::read(start, &mut self.records, self.grid, problem)?);
        Ok(())
    }

    fn other(&mut self, first: Record<'a>) -> Result<(), Stop> {
        let number = self.cells.len() - 1;
        let (name, problems) = (&self.cells[number].name, &mut self.problems);
        let problem = |offset, kind| problems.push(Problem { cell: name.clone(), offset, kind });
        self.rest.collect(number, first, &mut self.records, problem)?;
        if self.rest.is_full() { self.decode() } else { Ok(()) }
    }

    /// Gives the elements that were collected to their cells.
    fn decode(&mut self) -> Result<(), Stop> {
        let decoded = self.rest.decode(self.grid)?;
        for (origin, kind) in decoded.problems {
            let cell = self.cells[origin.cell].name.clone();
            self.problems.push(Problem { cell, offset: origin.offset, kind });
        }
        for (origin, element) in decoded.elements {
            self.cells[origin.cell].take(element);
        }
        Ok(())
    }

    fn skip(&mut self, start: usize) -> Result<(), Stop> {
        self.problem(start, ProblemKind::Node);
        loop {
            let record = self.records.next()?;
            if record.kind == kind::ENDEL {
                return Ok(());
            }
            record.check_inside_element()?;
        }
    }

    fn problem(&mut self, offset: usize, kind: ProblemKind) {
        if let Some(cell) = self.cells.last() {
            self.problems.push(Problem { cell: cell.name.clone(), offset, kind });
        }
    }
}

impl OpenCell {
    fn take(&mut self, element: Element) {
        match element {
            Element::Polygon(polygon) => self.outlines.push(polygon),
            Element::Reference(placement) => self.references.push(placement),
            Element::Label(label) => {
                self.builder.add(label);
            }
        }
    }
}
