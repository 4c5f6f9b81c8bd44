//! END, and what a file says of itself: offsets of its tables, strict mode, a checksum.
//!
//! A file is read by its records. What it says of them is compared with what was found, and a difference is a problem.

use super::super::checksum;
use super::super::cursor::{Cursor, Fault, Position, Result};
use super::super::record;
use super::Checksum;
use super::file::Parser;
use crate::model::ProblemKind;

/// Whether each table is strict, and where it begins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Offsets([(bool, u64); 6]);

impl Offsets {
    pub(super) fn read(cursor: &mut Cursor<'_>) -> Result<Self> {
        let mut offsets = [(false, 0); 6];
        for (strict, offset) in &mut offsets {
            let start = cursor.position();
            *strict = match cursor.unsigned()? {
                0 => false,
                1 => true,
                other => return Err(Fault::new(start, format!("a strict flag is {other}, but it must be 0 or 1"))),
            };
            *offset = cursor.unsigned()?;
        }
        Ok(Self(offsets))
    }
}

/// The END record.
#[derive(Debug)]
pub(super) struct End {
    position: Position,
    /// Offsets, if they stand here and not in START.
    offsets: Option<Offsets>,
    /// Length of the record.
    length: usize,
    scheme: u64,
    /// How many bytes of the file the checksum is made of.
    covered: usize,
    stated: u32,
    /// Bytes after the record.
    trailing: usize,
}

impl End {
    pub(super) fn read(cursor: &mut Cursor<'_>, begin: usize, has_offsets: bool) -> Result<Self> {
        let position = cursor.at(begin).position();
        let offsets = has_offsets.then(|| Offsets::read(cursor)).transpose()?;
        cursor.string()?;
        let start = cursor.position();
        let scheme = cursor.unsigned()?;
        let covered = cursor.offset();
        let stated = match scheme {
            0 => 0,
            1 | 2 => {
                let bytes = cursor.take(4)?;
                bytes.iter().rev().fold(0, |sum, byte| (sum << 8) | u32::from(*byte))
            }
            other => {
                return Err(Fault::new(start, format!("the validation scheme is {other}, but schemes are 0 to 2")));
            }
        };
        let length = cursor.offset() - begin;
        Ok(Self { position, offsets, length, scheme, covered, stated, trailing: cursor.left() })
    }

    /// Compares what the file says of itself with what was found.
    pub(super) fn check(self, bytes: &[u8], parser: &mut Parser<'_>) -> Result<()> {
        if self.length != record::END_LENGTH {
            let what = format!("the END record has {} bytes, but it must have 256", self.length);
            self.problem(parser, ProblemKind::Strict(what.into()));
        }
        if self.trailing > 0 {
            self.problem(parser, ProblemKind::Trailing(self.trailing));
        }
        self.check_tables(parser);
        self.check_sum(bytes, parser)
    }

    fn check_tables(&self, parser: &mut Parser<'_>) {
        let Some(Offsets(offsets)) = self.offsets.clone().or_else(|| parser.take_offsets()) else { return };
        let found = parser.tables.all().map(|table| (table.run.first, table.run.broken, table.run.by_text));
        for (((strict, offset), (first, broken, by_text)), kind) in offsets.into_iter().zip(found).zip(record::TABLES) {
            let at = first.map_or(0, |first| first as u64);
            let what = if offset != 0 && offset != at || strict && offset == 0 && first.is_some() {
                format!("the {kind} table is stated to begin at byte {offset}, but it begins at byte {at}")
            } else if strict && broken {
                format!("the {kind} table is stated to be strict, but it is in several parts")
            } else if strict && by_text {
                format!("the {kind} table is stated to be strict, but a record does not refer to it by number")
            } else {
                continue;
            };
            self.problem(parser, ProblemKind::Strict(what.into()));
        }
    }

    fn check_sum(&self, bytes: &[u8], parser: &mut Parser<'_>) -> Result<()> {
        if parser.options.checksum == Checksum::Skip || self.scheme == 0 {
            return Ok(());
        }
        let covered = bytes.get(..self.covered).unwrap_or(bytes);
        let found = if self.scheme == 1 { checksum::crc32(covered) } else { checksum::sum32(covered) };
        if found == self.stated {
            return Ok(());
        }
        if parser.options.checksum == Checksum::Refuse {
            let problem = format!("the checksum is {:08x}, but that of the bytes is {found:08x}", self.stated);
            return Err(Fault::new(self.position, problem));
        }
        self.problem(parser, ProblemKind::Checksum { stated: self.stated, found });
        Ok(())
    }

    fn problem(&self, parser: &mut Parser<'_>, kind: ProblemKind) {
        parser.layout.problems.push("", self.position.file, kind);
    }
}
