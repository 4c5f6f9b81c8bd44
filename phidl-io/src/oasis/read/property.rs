//! PROPERTY records: a name and a list of values.

use std::sync::Arc;

use super::super::cursor::{Cursor, Fault, Result};
use super::modal::{Modal, needed};
use super::names::Name;

/// A value of a property.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    Real(f64),
    Unsigned(u64),
    Signed(i64),
    /// A string, or its number among the PROPSTRING records.
    String(Name),
}

/// A property as it stands in the file.
#[derive(Debug, Clone)]
pub(super) struct RawProperty {
    pub(super) name: Name,
    pub(super) values: Arc<[Value]>,
}

impl RawProperty {
    /// Whether a value is a string that is not referred to by number.
    pub(super) fn has_text(&self) -> bool {
        self.values.iter().any(|value| matches!(value, Value::String(Name::Text(_))))
    }
}

/// Reads a PROPERTY record; with all bits of `flags` unset, it repeats the last one.
pub(super) fn read(cursor: &mut Cursor<'_>, modal: &mut Modal) -> Result<RawProperty> {
    let flags = cursor.byte()?;
    let bit = |bit: u8| flags & (1 << bit) != 0;
    if bit(2) {
        let name = Name::read(cursor, bit(1))?;
        modal.property = Some(name);
    }
    // Bit 0 says that the standard defines the name. Tools set it or not; the name says it anyway.
    if bit(3) {
        if flags >> 4 != 0 {
            return Err(Fault::new(cursor.position(), "a property repeats its values and states a number of them"));
        }
    } else {
        let count = match flags >> 4 {
            15 => cursor.count("property values")?,
            few => usize::from(few),
        };
        let values: Result<Vec<Value>> = (0..count).map(|_| value(cursor)).collect();
        modal.values = Some(values?.into());
    }
    repeated(cursor, modal)
}

/// The last property once more.
pub(super) fn repeated(cursor: &Cursor<'_>, modal: &Modal) -> Result<RawProperty> {
    let name = needed(&modal.property, "last property name", cursor)?;
    let values = needed(&modal.values, "last value list", cursor)?;
    Ok(RawProperty { name, values })
}

fn value(cursor: &mut Cursor<'_>) -> Result<Value> {
    let start = cursor.position();
    Ok(match cursor.unsigned()? {
        kind @ 0..=7 => Value::Real(cursor.real_of_kind(kind)?),
        8 => Value::Unsigned(cursor.unsigned()?),
        9 => Value::Signed(cursor.signed()?),
        10..=12 => Value::String(Name::read(cursor, false)?),
        13..=15 => Value::String(Name::read(cursor, true)?),
        other => return Err(Fault::new(start, format!("a property value has type {other}, but types are 0 to 15"))),
    })
}
