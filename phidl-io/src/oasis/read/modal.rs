//! Modal variables: what a record leaves out is what the last one said.

use std::sync::Arc;

use super::super::cursor::{Cursor, Fault, Result};
use super::super::repetition::Repetition;
use super::names::Name;
use super::property::Value;

/// The modal variables of the standard. A variable that no record has set yet is `None`.
#[derive(Debug, Default)]
pub(super) struct Modal {
    /// Whether coordinates are added to those of the last record.
    pub(super) relative: bool,
    pub(super) placement: [i64; 2],
    pub(super) text: [i64; 2],
    pub(super) geometry: [i64; 2],
    pub(super) placement_cell: Option<Name>,
    pub(super) text_string: Option<Name>,
    pub(super) layer: Option<u16>,
    pub(super) datatype: Option<u16>,
    pub(super) textlayer: Option<u16>,
    pub(super) texttype: Option<u16>,
    pub(super) width: Option<i64>,
    pub(super) height: Option<i64>,
    pub(super) polygon: PointList,
    pub(super) path: PointList,
    pub(super) half_width: Option<i64>,
    pub(super) start_extension: Option<Extension>,
    pub(super) end_extension: Option<Extension>,
    pub(super) ctrapezoid: Option<u64>,
    pub(super) radius: Option<i64>,
    pub(super) repetition: Option<Repetition>,
    /// Name of the last property.
    pub(super) property: Option<Name>,
    pub(super) values: Option<Arc<[Value]>>,
}

/// The corners of the last polygon or path, from its first one. Empty until there is one.
#[derive(Debug, Default)]
pub(super) struct PointList {
    pub(super) corners: Vec<[i64; 2]>,
    /// Whether the number of deltas obeys the rule for polygons.
    pub(super) even: bool,
}

/// How far a path goes beyond one of its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Extension {
    None,
    HalfWidth,
    By(i64),
}

/// The value of a modal variable that a record needs.
pub(super) fn needed<T: Clone>(variable: &Option<T>, name: &str, cursor: &Cursor<'_>) -> Result<T> {
    variable.clone().ok_or_else(|| undefined(name, cursor))
}

#[cold]
pub(super) fn undefined(name: &str, cursor: &Cursor<'_>) -> Fault {
    Fault::new(cursor.position(), format!("the modal variable \"{name}\" is used before it is set"))
}

/// Sets a variable from the record if `present`, and returns its value.
#[inline]
pub(super) fn update<T: Clone>(
    variable: &mut Option<T>,
    present: bool,
    name: &str,
    cursor: &mut Cursor<'_>,
    read: impl FnOnce(&mut Cursor<'_>) -> Result<T>,
) -> Result<T> {
    if present {
        *variable = Some(read(cursor)?);
    }
    needed(variable, name, cursor)
}

/// Sets a position from the record, in the mode of the file.
#[inline]
pub(super) fn position(
    at: &mut [i64; 2],
    relative: bool,
    present: [bool; 2],
    cursor: &mut Cursor<'_>,
) -> Result<[i64; 2]> {
    for (at, present) in at.iter_mut().zip(present) {
        if present {
            let start = cursor.position();
            let value = cursor.signed()?;
            let sum = if relative { at.checked_add(value) } else { Some(value) };
            *at = sum.ok_or_else(|| Fault::new(start, "a relative coordinate reaches beyond 64 bits"))?;
        }
    }
    Ok(*at)
}

/// A layer number, datatype or texttype.
pub(super) fn layer_number(cursor: &mut Cursor<'_>) -> Result<u16> {
    let start = cursor.position();
    let number = cursor.unsigned()?;
    let fault = || Fault::new(start, format!("a layer or datatype number is {number}, but it must be at most 65535"));
    u16::try_from(number).map_err(|_| fault())
}

/// A width, height, half width or radius.
pub(super) fn length(cursor: &mut Cursor<'_>) -> Result<i64> {
    let start = cursor.position();
    let length = cursor.unsigned()?;
    let fits = i64::try_from(length).ok().filter(|length| *length <= 2 * i64::from(u32::MAX));
    fits.ok_or_else(|| Fault::new(start, format!("a length of {length} grid steps reaches beyond 32-bit coordinates")))
}
