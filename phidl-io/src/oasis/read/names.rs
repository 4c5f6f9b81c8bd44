//! Names by number: the tables of cells, texts, property names and property strings.
//!
//! A number may be used before its name is in the file, so nothing is looked up before the end of it.

use std::collections::HashMap;
use std::sync::Arc;

use super::super::cursor::{Cursor, Fault, Position, Result};

/// A name in the file: itself, or its number in a table.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Name {
    Text(Arc<[u8]>),
    Number(u64),
}

impl Name {
    /// Reads a number or a string.
    pub(super) fn read(cursor: &mut Cursor<'_>, by_number: bool) -> Result<Self> {
        Ok(if by_number { Self::Number(cursor.unsigned()?) } else { Self::Text(cursor.string()?.into()) })
    }
}

/// The names of one kind.
#[derive(Debug)]
pub(super) struct Table {
    /// The record of the kind, for errors.
    kind: &'static str,
    names: HashMap<u64, Arc<[u8]>>,
    /// Whether numbers stand in the records; unknown before the first one.
    numbered: Option<bool>,
    pub(super) run: Run,
}

/// Where the names of one kind stand in the file: what strict mode promises.
#[derive(Debug, Default)]
pub(super) struct Run {
    /// The first record of the kind, or the compressed block that it is in.
    pub(super) first: Option<usize>,
    /// Whether another record has followed the last one.
    ended: bool,
    /// Whether the records of the kind stand in more than one run.
    pub(super) broken: bool,
    /// Whether something says its name instead of a number.
    pub(super) by_text: bool,
}

impl Run {
    /// A record of the kind.
    pub(super) fn extend(&mut self, position: Position) {
        self.first.get_or_insert(position.file);
        self.broken |= self.ended;
    }

    /// A record of another kind, which is not a property of a name.
    pub(super) fn end(&mut self) {
        self.ended |= self.first.is_some();
    }
}

impl Table {
    pub(super) fn new(kind: &'static str) -> Self {
        Self { kind, names: HashMap::new(), numbered: None, run: Run::default() }
    }

    /// Reads a record of the kind, with its number if `numbered`.
    pub(super) fn read(&mut self, cursor: &mut Cursor<'_>, start: Position, numbered: bool) -> Result<u64> {
        self.run.extend(start);
        let name = cursor.string()?;
        if *self.numbered.get_or_insert(numbered) != numbered {
            let problem = format!("{} records with and without numbers are mixed", self.kind);
            return Err(Fault::new(start, problem));
        }
        let number = if numbered { cursor.unsigned()? } else { self.names.len() as u64 };
        if self.names.insert(number, name.into()).is_some() {
            return Err(Fault::new(start, format!("a second {} record has the number {number}", self.kind)));
        }
        Ok(number)
    }

    /// The bytes of a name that is used at a position.
    pub(super) fn resolve(&self, name: &Name, position: Position) -> Result<Arc<[u8]>> {
        match name {
            Name::Text(text) => Ok(text.clone()),
            Name::Number(number) => self.names.get(number).cloned().ok_or_else(|| {
                Fault::new(position, format!("no {} record of the file has the number {number}", self.kind))
            }),
        }
    }
}

/// Bytes as a text, and whether they had to be read as Latin-1.
pub(super) fn text(bytes: &[u8]) -> (String, bool) {
    match std::str::from_utf8(bytes) {
        Ok(text) => (text.to_owned(), false),
        Err(_) => (bytes.iter().map(|byte| char::from(*byte)).collect(), true),
    }
}
