//! The end of reading: numbers become names, strings and properties.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;
use std::sync::Arc;

use phidl_core::scene::Properties;

use super::super::cursor::{Fault, Position, Result};
use super::super::label;
use super::super::record::standard;
use super::elements::Target;
use super::file::{Parser, PendingProperty, Tables};
use super::malformed;
use super::names;
use super::property::{RawProperty, Value};
use crate::error::IoError;
use crate::model::{Cell, CellId, CellNames, Layout, ProblemKind, Problems};

/// The layout of a file that has been read to its end.
pub(super) fn resolve(mut parser: Parser<'_>, file: &str) -> crate::error::Result<Layout> {
    let names = cell_names(&mut parser).map_err(|(fault, cell)| malformed(&fault, file, cell.as_deref()))?;
    parser.layout.names = names;
    let mut defined = vec![false; parser.layout.names.len()];
    for cell in &parser.layout.cells {
        if std::mem::replace(&mut defined[cell.name.index()], true) {
            let name = parser.layout.names.name(cell.name).into();
            return Err(IoError::DuplicateCell { file: file.into(), name, offset: cell.offset });
        }
    }
    let outcome = Resolver::of(&mut parser).all();
    outcome.map_err(|(fault, cell)| {
        let cell = parser.layout.cells.get(cell).map(|cell| parser.layout.names.name(cell.name));
        malformed(&fault, file, cell)
    })?;
    Ok(parser.layout)
}

/// Gives all cells their final names. A fault comes with the name of its cell.
fn cell_names(parser: &mut Parser<'_>) -> std::result::Result<CellNames, (Fault, Option<String>)> {
    let mut names = CellNames::default();
    let mut known: Vec<Option<CellId>> = vec![None; parser.cell_keys.len()];
    let mut latin1 = Vec::new();
    let Parser { cell_keys, tables, layout, .. } = parser;
    let mut rename = |id: CellId, offset: usize| -> Result<CellId> {
        if let Some(id) = known[id.index()] {
            return Ok(id);
        }
        let position = Position { file: offset, inflated: None };
        let bytes = tables.cells.resolve(&cell_keys[id.index()], position)?;
        let (name, is_latin1) = names::text(&bytes);
        if name.is_empty() {
            return Err(Fault::new(position, "a cell has an empty name"));
        }
        if is_latin1 {
            latin1.push((name.clone(), offset));
        }
        Ok(*known[id.index()].insert(names.intern(&name)))
    };
    let mut last = None;
    for cell in &mut layout.cells {
        let outcome = rename(cell.name, cell.offset).and_then(|id| {
            cell.name = id;
            last = Some(id);
            cell.placements.iter_mut().try_for_each(|placement| {
                placement.child = rename(placement.child, placement.offset)?;
                Ok(())
            })
        });
        if let Err(fault) = outcome {
            let cell = last.map(|id| names.name(id).to_owned());
            return Err((fault, cell));
        }
    }
    for (name, offset) in latin1 {
        layout.problems.push(&name, offset, ProblemKind::Latin1);
    }
    Ok(names)
}

/// A fault, and the index of its cell.
type Located<T> = std::result::Result<T, (Fault, usize)>;

struct Resolver<'a> {
    tables: &'a Tables,
    cells: &'a mut [Cell],
    names: &'a CellNames,
    problems: &'a mut Problems,
    strings: Vec<(usize, Range<usize>, names::Name, Position)>,
    properties: Vec<PendingProperty>,
    unplaced: Vec<(String, RawProperty, Position)>,
    /// Names of properties that were listed as problems.
    listed: BTreeSet<String>,
    /// What the options still allow, and allow in all.
    elements_left: u64,
    max_elements: u64,
}

/// What a property says.
enum Meaning {
    Gds(u16, String),
    Label(String),
    Other(String),
}

impl<'a> Resolver<'a> {
    fn of(parser: &'a mut Parser<'_>) -> Self {
        let Layout { names, cells, problems, .. } = &mut parser.layout;
        Self {
            tables: &parser.tables,
            cells,
            names,
            problems,
            strings: std::mem::take(&mut parser.pending.strings),
            properties: std::mem::take(&mut parser.pending.properties),
            unplaced: std::mem::take(&mut parser.pending.unplaced),
            listed: BTreeSet::new(),
            elements_left: parser.elements_left,
            max_elements: parser.options.max_elements,
        }
    }

    fn all(mut self) -> Located<()> {
        self.texts()?;
        for pending in std::mem::take(&mut self.properties) {
            let cell = pending.cell;
            self.property(pending).map_err(|fault| (fault, cell))?;
        }
        for (cell, property, position) in std::mem::take(&mut self.unplaced) {
            let name = self.tables.property_names.resolve(&property.name, position);
            let name = name.map_err(|fault| (fault, usize::MAX))?;
            let (name, _) = names::text(&name);
            if !name.starts_with("S_") {
                self.unknown(&cell, name, position);
            }
        }
        Ok(())
    }

    fn texts(&mut self) -> Located<()> {
        let mut known: HashMap<*const u8, (String, bool)> = HashMap::new();
        for (cell, range, name, position) in std::mem::take(&mut self.strings) {
            let located = |fault| (fault, cell);
            let bytes = self.tables.texts.resolve(&name, position).map_err(located)?;
            let (string, latin1) = known.entry(bytes.as_ptr()).or_insert_with(|| names::text(&bytes)).clone();
            spend(&mut self.elements_left, self.max_elements, range.len(), string.len() / 64, position)
                .map_err(located)?;
            let cell = &mut self.cells[cell];
            if latin1 {
                self.problems.push(self.names.name(cell.name), position.file, ProblemKind::Latin1);
            }
            for text in &mut cell.texts[range] {
                text.string.clone_from(&string);
            }
        }
        Ok(())
    }

    fn property(&mut self, pending: PendingProperty) -> Result<()> {
        let PendingProperty { cell, target, property, position } = pending;
        match self.meaning(&property, position)? {
            Meaning::Other(name) => {
                let cell = self.names.name(self.cells[cell].name).to_owned();
                self.unknown(&cell, name, position);
                Ok(())
            }
            Meaning::Label(payload) => {
                if let Target::Texts(range) = target {
                    let understood = label::apply(&payload, &mut self.cells[cell].texts[range]);
                    if !understood {
                        let name = self.names.name(self.cells[cell].name).to_owned();
                        self.unknown(&name, label::NAME.to_owned(), position);
                    }
                }
                Ok(())
            }
            Meaning::Gds(attribute, text) => self.give(cell, target, attribute, &text, position),
        }
    }

    /// Gives a property to all copies of an element.
    fn give(&mut self, cell: usize, target: Target, attribute: u16, text: &str, position: Position) -> Result<()> {
        let range = match &target {
            Target::Polygons(range) | Target::Paths(range) | Target::Texts(range) | Target::Placements(range) => range,
        };
        spend(&mut self.elements_left, self.max_elements, range.len(), text.len() / 64, position)?;
        let cell = &mut self.cells[cell];
        let mut repeated = false;
        let mut insert = |properties: &mut Properties| match properties.entry(attribute) {
            std::collections::btree_map::Entry::Vacant(entry) => {
                entry.insert(text.to_owned());
            }
            std::collections::btree_map::Entry::Occupied(_) => repeated = true,
        };
        match target {
            Target::Polygons(range) => range.for_each(|index| insert(cell.polygons.properties_mut(index))),
            Target::Paths(range) => cell.paths[range].iter_mut().for_each(|path| insert(&mut path.properties)),
            Target::Texts(range) => cell.texts[range].iter_mut().for_each(|text| insert(&mut text.properties)),
            Target::Placements(range) => {
                cell.placements[range].iter_mut().for_each(|p| insert(p.properties.get_or_insert_default()));
            }
        }
        if repeated {
            let name = self.names.name(cell.name);
            self.problems.push(name, position.file, ProblemKind::RepeatedProperty(attribute));
        }
        Ok(())
    }

    fn meaning(&self, property: &RawProperty, position: Position) -> Result<Meaning> {
        let (name, _) = names::text(&self.tables.property_names.resolve(&property.name, position)?);
        let mut values = Vec::with_capacity(property.values.len());
        for value in property.values.iter() {
            values.push(match value {
                Value::String(name) => Known::Text(self.tables.property_strings.resolve(name, position)?),
                Value::Unsigned(number) => Known::Number(*number),
                Value::Signed(number) => u64::try_from(*number).map_or(Known::Other, Known::Number),
                Value::Real(_) => Known::Other,
            });
        }
        Ok(match &values[..] {
            [Known::Number(attribute), Known::Text(text)] if name == standard::GDS_PROPERTY => {
                match u16::try_from(*attribute) {
                    Ok(attribute) => Meaning::Gds(attribute, names::text(text).0),
                    Err(_) => Meaning::Other(name),
                }
            }
            [Known::Text(text)] if name == label::NAME => Meaning::Label(names::text(text).0),
            _ => Meaning::Other(name),
        })
    }

    /// Lists a property that has no counterpart, once for each name.
    fn unknown(&mut self, cell: &str, name: String, position: Position) {
        if self.listed.insert(name.clone()) {
            self.problems.push(cell, position.file, ProblemKind::Property(name.into()));
        }
    }
}

/// A value whose string is known.
enum Known {
    Text(Arc<[u8]>),
    Number(u64),
    Other,
}

/// Counts what copies of a text need against what the options allow.
fn spend(left: &mut u64, most: u64, copies: usize, size: usize, position: Position) -> Result<()> {
    let rest = (copies as u64).checked_mul(size as u64).and_then(|cost| left.checked_sub(cost));
    *left = rest.ok_or_else(|| {
        let problem =
            format!("texts of repeated elements exceed what the option max_elements allows ({most} in the file)");
        Fault::new(position, problem)
    })?;
    Ok(())
}
