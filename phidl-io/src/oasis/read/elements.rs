//! Elements of cells: which fields a record has, and where its copies go.

use std::ops::Range;

use super::super::cursor::{Cursor, Fault, Position, Result};
use super::super::record;
use super::super::repetition::Repetition;
use super::file::{Parser, record_number};
use super::modal;
use crate::model::{Cell, ProblemKind};
use phidl_core::layer::Layer;

/// The elements that a record made, by their indices in the cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Target {
    Polygons(Range<usize>),
    Paths(Range<usize>),
    Texts(Range<usize>),
    Placements(Range<usize>),
}

/// The byte of flags that says which fields a record has.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flags(u8);

impl Flags {
    pub(super) fn read(cursor: &mut Cursor<'_>) -> Result<Self> {
        cursor.byte().map(Self)
    }

    #[inline]
    pub(super) fn has(self, bit: u8) -> bool {
        self.0 & (1 << bit) != 0
    }

    /// Two bits as a number.
    pub(super) fn pair(self, lowest: u8) -> u8 {
        (self.0 >> lowest) & 3
    }
}

impl Parser<'_> {
    /// Reads the rest of an element. `None` if it made nothing.
    pub(super) fn read_element(
        &mut self,
        kind: u64,
        cursor: &mut Cursor<'_>,
        start: Position,
    ) -> Result<Option<Target>> {
        match kind {
            record::PLACEMENT | record::PLACEMENT_AT_ANY_ANGLE => {
                self.placement(kind == record::PLACEMENT_AT_ANY_ANGLE, cursor, start).map(Some)
            }
            record::TEXT => self.text(cursor, start).map(Some),
            record::RECTANGLE => self.rectangle(cursor, start),
            record::POLYGON => self.polygon(cursor, start),
            record::PATH => self.path(cursor, start),
            record::TRAPEZOID => self.trapezoid(cursor, start, [true, true]),
            record::TRAPEZOID_OF_A => self.trapezoid(cursor, start, [true, false]),
            record::TRAPEZOID_OF_B => self.trapezoid(cursor, start, [false, true]),
            record::CTRAPEZOID => self.compact_trapezoid(cursor, start),
            record::CIRCLE => self.circle(cursor, start),
            record::XELEMENT => {
                cursor.unsigned()?;
                cursor.string()?;
                self.problem(start, ProblemKind::Record(record_number(kind)));
                Ok(None)
            }
            _ => {
                let flags = Flags::read(cursor)?;
                cursor.unsigned()?;
                self.layer(flags, cursor)?;
                cursor.string()?;
                self.geometry_position(flags, cursor)?;
                self.repetition(flags.has(2), cursor)?;
                self.problem(start, ProblemKind::Record(record_number(kind)));
                Ok(None)
            }
        }
    }

    /// Layer and datatype of a geometry: bits 0 and 1.
    #[inline]
    pub(super) fn layer(&mut self, flags: Flags, cursor: &mut Cursor<'_>) -> Result<Layer> {
        let modal = &mut self.modal;
        let layer = modal::update(&mut modal.layer, flags.has(0), "layer", cursor, modal::layer_number)?;
        let datatype = modal::update(&mut modal.datatype, flags.has(1), "datatype", cursor, modal::layer_number)?;
        Ok(Layer::new(layer, datatype))
    }

    /// Position of a geometry: bits 4 and 3.
    #[inline]
    pub(super) fn geometry_position(&mut self, flags: Flags, cursor: &mut Cursor<'_>) -> Result<[i64; 2]> {
        let modal = &mut self.modal;
        modal::position(&mut modal.geometry, modal.relative, [flags.has(4), flags.has(3)], cursor)
    }

    /// The repetition of an element, if it has one.
    #[inline]
    pub(super) fn repetition(&mut self, present: bool, cursor: &mut Cursor<'_>) -> Result<Option<Repetition>> {
        if !present {
            return Ok(None);
        }
        let repetition = Repetition::read(cursor, self.modal.repetition.as_ref())?;
        self.modal.repetition = Some(repetition.clone());
        Ok(Some(repetition))
    }

    /// Counts the copies of an element, each of a size, against what the options allow.
    pub(super) fn spend(&mut self, copies: u128, size: usize, start: Position) -> Result<()> {
        let left = copies.checked_mul(size as u128).and_then(|cost| u128::from(self.elements_left).checked_sub(cost));
        match left.and_then(|left| u64::try_from(left).ok()) {
            Some(left) => {
                self.elements_left = left;
                Ok(())
            }
            None => {
                let problem = format!(
                    "a repetition of {copies} elements exceeds what the option max_elements allows ({} in the file)",
                    self.options.max_elements
                );
                Err(Fault::new(start, problem))
            }
        }
    }

    /// The cell that is being read.
    #[inline]
    pub(super) fn open_cell(&mut self) -> &mut Cell {
        self.layout.cells.last_mut().expect("invariant: elements are refused outside of cells")
    }
}

/// A point of 32 bits.
#[inline]
pub(super) fn corner(at: [i64; 2], start: Position) -> Result<[i32; 2]> {
    match (i32::try_from(at[0]), i32::try_from(at[1])) {
        (Ok(x), Ok(y)) => Ok([x, y]),
        _ => Err(out_of_range(start)),
    }
}

#[cold]
pub(super) fn out_of_range(start: Position) -> Fault {
    Fault::new(start, "an element has a coordinate beyond 32 bits")
}

/// A point moved by a vector of a repetition.
#[inline]
pub(super) fn moved(at: [i64; 2], vector: Option<[i64; 2]>, start: Position) -> Result<[i64; 2]> {
    let sum = vector.and_then(|v| Some([at[0].checked_add(v[0])?, at[1].checked_add(v[1])?]));
    sum.ok_or_else(|| out_of_range(start))
}
