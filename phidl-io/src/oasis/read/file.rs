//! The records of a file: START, names, cells, blocks, END.

use phidl_core::num::grid::Grid;

use super::super::cursor::{Cursor, Fault, Position, Result};
use super::super::record;
use super::DecodeOptions;
use super::block;
use super::elements::Target;
use super::modal::Modal;
use super::names::{Name, Table};
use super::property::{self, RawProperty};
use super::strict::{End, Offsets};
use crate::model::{Cell, Layout, ProblemKind};

/// What is known of a file while its records are read.
pub(super) struct Parser<'a> {
    pub(super) options: &'a DecodeOptions,
    pub(super) modal: Modal,
    pub(super) layout: Layout,
    /// Cell names as the records say them. A cell has the same index in `layout.names`, under a provisional name.
    pub(super) cell_keys: Vec<Name>,
    pub(super) tables: Tables,
    pub(super) pending: Pending,
    /// What a PROPERTY record belongs to.
    owner: Owner,
    /// What the options still allow: inflated bytes, and elements of repetitions.
    pub(super) bytes_left: u64,
    pub(super) elements_left: u64,
    /// Offsets stated by START.
    offsets: Option<Offsets>,
}

/// The tables of names, and where those of layers and extensions stand.
pub(super) struct Tables {
    pub(super) cells: Table,
    pub(super) texts: Table,
    pub(super) property_names: Table,
    pub(super) property_strings: Table,
    pub(super) layers: Table,
    pub(super) extensions: Table,
}

impl Tables {
    fn new() -> Self {
        let [cells, texts, property_names, property_strings, layers, extensions] = record::TABLES.map(Table::new);
        Self { cells, texts, property_names, property_strings, layers, extensions }
    }

    pub(super) fn all(&self) -> [&Table; 6] {
        [&self.cells, &self.texts, &self.property_names, &self.property_strings, &self.layers, &self.extensions]
    }

    /// Ends the runs of all tables but one.
    fn end_runs(&mut self, except: Option<usize>) {
        let Self { cells, texts, property_names, property_strings, layers, extensions } = self;
        let all = [cells, texts, property_names, property_strings, layers, extensions];
        for (index, table) in all.into_iter().enumerate() {
            if Some(index) != except {
                table.run.end();
            }
        }
    }
}

/// What waits for names that may still come.
#[derive(Default)]
pub(super) struct Pending {
    /// Strings of texts: index of the cell, indices of the texts, the string.
    pub(super) strings: Vec<(usize, std::ops::Range<usize>, Name, Position)>,
    pub(super) properties: Vec<PendingProperty>,
    /// Properties of the file, of cells and of names: only their names matter.
    pub(super) unplaced: Vec<(String, RawProperty, Position)>,
}

/// A property of an element.
pub(super) struct PendingProperty {
    pub(super) cell: usize,
    pub(super) target: Target,
    pub(super) property: RawProperty,
    pub(super) position: Position,
}

/// What a PROPERTY record belongs to.
enum Owner {
    /// The file, a cell or a name.
    Unplaced,
    Element(Target),
    /// An element that was left out.
    Nothing,
}

impl<'a> Parser<'a> {
    pub(super) fn new(options: &'a DecodeOptions) -> Self {
        let grid = Grid::new(1e-3).expect("invariant: a nanometer is a grid");
        Self {
            options,
            modal: Modal::default(),
            layout: Layout::new(grid),
            cell_keys: Vec::new(),
            tables: Tables::new(),
            pending: Pending::default(),
            owner: Owner::Nothing,
            bytes_left: options.max_bytes,
            elements_left: options.max_elements,
            offsets: None,
        }
    }

    /// Reads a whole file up to its END record.
    pub(super) fn file(&mut self, bytes: &[u8]) -> Result<End> {
        if !bytes.starts_with(record::MAGIC) {
            let start = Cursor::of_file(bytes).position();
            return Err(Fault::new(start, "not an OASIS file: it does not begin with %SEMI-OASIS"));
        }
        let mut cursor = Cursor::of_file(bytes).at(record::MAGIC.len());
        self.start(&mut cursor)?;
        match self.records(&mut cursor)? {
            Some(end) => Ok(end),
            None => Err(Fault::new(cursor.position(), "the file ends without an END record")),
        }
    }

    fn start(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let start = cursor.position();
        if cursor.unsigned()? != record::START {
            return Err(Fault::new(start, "the first record is not START"));
        }
        let version = cursor.string()?;
        if version != b"1.0" {
            let version = String::from_utf8_lossy(version);
            return Err(Fault::new(start, format!("the version is {version:?}, but it must be \"1.0\"")));
        }
        let unit = cursor.real()?;
        let grid = if unit > 0.0 { Grid::new(1.0 / unit) } else { Grid::new(unit) };
        let bad =
            |_| Fault::new(start, format!("the unit is {unit} grid steps in a micrometer, but it must be positive"));
        self.layout.grid = grid.map_err(bad)?;
        self.offsets = match cursor.unsigned()? {
            0 => Some(Offsets::read(cursor)?),
            1 => None,
            other => return Err(Fault::new(start, format!("the offset flag is {other}, but it must be 0 or 1"))),
        };
        self.owner = Owner::Unplaced;
        Ok(())
    }

    /// Reads records until END, or until a compressed block ends.
    fn records(&mut self, cursor: &mut Cursor<'_>) -> Result<Option<End>> {
        while cursor.left() > 0 {
            let start = cursor.position();
            let begin = cursor.offset();
            let kind = cursor.unsigned()?;
            match kind {
                record::PAD => {}
                record::END if !cursor.is_block() => {
                    return End::read(cursor, begin, self.offsets.is_none()).map(Some);
                }
                record::CBLOCK if !cursor.is_block() => {
                    let inflated = block::inflate(cursor, &mut self.bytes_left)?;
                    self.records(&mut Cursor::of_block(&inflated, start.file))?;
                }
                record::CELLNAME..=record::LAYERNAME_OF_TEXTS | record::XNAME | record::XNAME_NUMBERED => {
                    self.name(kind, cursor, start)?;
                }
                record::CELL_BY_NUMBER | record::CELL => self.cell(kind, cursor, start)?,
                record::PROPERTY | record::PROPERTY_REPEATED => self.property(kind, cursor, start)?,
                record::XYABSOLUTE | record::XYRELATIVE if !self.layout.cells.is_empty() => {
                    self.modal.relative = kind == record::XYRELATIVE;
                }
                record::PLACEMENT..=record::CIRCLE | record::XELEMENT | record::XGEOMETRY => {
                    self.element(kind, cursor, start)?;
                }
                record::START | record::END | record::CBLOCK => {
                    return Err(Fault::new(start, format!("record {kind} stands where the format does not allow it")));
                }
                other => return Err(Fault::new(start, format!("record {other} is unknown; records are 0 to 34"))),
            }
        }
        Ok(None)
    }

    fn name(&mut self, kind: u64, cursor: &mut Cursor<'_>, start: Position) -> Result<()> {
        let table = match kind {
            record::XNAME | record::XNAME_NUMBERED => 5,
            record::LAYERNAME | record::LAYERNAME_OF_TEXTS => 4,
            _ => usize::try_from((kind - record::CELLNAME) / 2).unwrap_or(0),
        };
        self.tables.end_runs(Some(table));
        let numbered = (kind - record::CELLNAME) % 2 == 1;
        match kind {
            record::CELLNAME | record::CELLNAME_NUMBERED => self.tables.cells.read(cursor, start, numbered)?,
            record::TEXTSTRING | record::TEXTSTRING_NUMBERED => self.tables.texts.read(cursor, start, numbered)?,
            record::PROPNAME | record::PROPNAME_NUMBERED => self.tables.property_names.read(cursor, start, numbered)?,
            record::PROPSTRING | record::PROPSTRING_NUMBERED => {
                self.tables.property_strings.read(cursor, start, numbered)?
            }
            record::LAYERNAME | record::LAYERNAME_OF_TEXTS => {
                self.tables.layers.run.extend(start);
                self.layer_name(kind == record::LAYERNAME_OF_TEXTS, cursor)?;
                0
            }
            _ => {
                self.tables.extensions.run.extend(start);
                cursor.unsigned()?;
                cursor.string()?;
                if kind == record::XNAME_NUMBERED {
                    cursor.unsigned()?;
                }
                self.problem(start, ProblemKind::Record(record_number(kind)));
                0
            }
        };
        // The standard sets the modal variables back at every name.
        self.modal = Modal::default();
        self.owner = Owner::Unplaced;
        Ok(())
    }

    fn layer_name(&mut self, _of_texts: bool, cursor: &mut Cursor<'_>) -> Result<()> {
        cursor.string()?;
        for _ in 0..2 {
            interval(cursor)?;
        }
        Ok(())
    }

    fn cell(&mut self, kind: u64, cursor: &mut Cursor<'_>, start: Position) -> Result<()> {
        self.tables.end_runs(None);
        let name = Name::read(cursor, kind == record::CELL_BY_NUMBER)?;
        self.tables.cells.run.by_text |= kind == record::CELL;
        let id = self.cell_id(&name);
        let mut cell = Cell::new(id);
        cell.offset = start.file;
        self.layout.cells.push(cell);
        self.modal = Modal::default();
        self.owner = Owner::Unplaced;
        Ok(())
    }

    /// The provisional number of a cell name.
    pub(super) fn cell_id(&mut self, name: &Name) -> crate::model::CellId {
        let provisional = provisional(name);
        let id = self.layout.names.intern(&provisional);
        if id.index() == self.cell_keys.len() {
            self.cell_keys.push(name.clone());
        }
        id
    }

    fn element(&mut self, kind: u64, cursor: &mut Cursor<'_>, start: Position) -> Result<()> {
        if self.layout.cells.is_empty() {
            return Err(Fault::new(start, format!("an element (record {kind}) stands outside of cells")));
        }
        self.owner = match self.read_element(kind, cursor, start)? {
            Some(target) => Owner::Element(target),
            None => Owner::Nothing,
        };
        Ok(())
    }

    fn property(&mut self, kind: u64, cursor: &mut Cursor<'_>, start: Position) -> Result<()> {
        let property = match kind {
            record::PROPERTY => property::read(cursor, &mut self.modal)?,
            _ => property::repeated(cursor, &self.modal)?,
        };
        self.tables.property_names.run.by_text |= matches!(property.name, Name::Text(_));
        self.tables.property_strings.run.by_text |= property.has_text();
        match &self.owner {
            Owner::Unplaced => {
                let cell = self.cell_name().unwrap_or_default();
                self.pending.unplaced.push((cell, property, start));
            }
            Owner::Element(target) => {
                let (target, cell) = (target.clone(), self.layout.cells.len() - 1);
                self.pending.properties.push(PendingProperty { cell, target, property, position: start });
            }
            Owner::Nothing => {}
        }
        Ok(())
    }

    /// Offsets that START states.
    pub(super) fn take_offsets(&mut self) -> Option<Offsets> {
        self.offsets.take()
    }

    /// Lists a problem of the cell that is being read.
    pub(super) fn problem(&mut self, position: Position, kind: ProblemKind) {
        let cell = self.cell_name().unwrap_or_default();
        self.layout.problems.push(&cell, position.file, kind);
    }

    /// The name of the cell that is being read, as far as it is known.
    pub(super) fn cell_name(&self) -> Option<String> {
        let cell = self.layout.cells.last()?;
        let name = self.cell_keys.get(cell.name.index())?;
        let start = Position { file: cell.offset, inflated: None };
        Some(match self.tables.cells.resolve(name, start) {
            Ok(bytes) => super::names::text(&bytes).0,
            Err(_) => provisional(name),
        })
    }
}

/// What a cell is called until its name is known. Texts and numbers are never alike.
fn provisional(name: &Name) -> String {
    match name {
        Name::Text(text) => super::names::text(text).0,
        Name::Number(number) => format!("(cell number {number})"),
    }
}

/// The number of a record as problems state it.
pub(super) fn record_number(kind: u64) -> u8 {
    u8::try_from(kind).unwrap_or(u8::MAX)
}

/// Reads an interval of layers or datatypes: its bounds, both included.
fn interval(cursor: &mut Cursor<'_>) -> Result<(u64, u64)> {
    let start = cursor.position();
    Ok(match cursor.unsigned()? {
        0 => (0, u64::MAX),
        1 => (0, cursor.unsigned()?),
        2 => (cursor.unsigned()?, u64::MAX),
        3 => {
            let only = cursor.unsigned()?;
            (only, only)
        }
        4 => (cursor.unsigned()?, cursor.unsigned()?),
        other => return Err(Fault::new(start, format!("an interval has type {other}, but types are 0 to 4"))),
    })
}
