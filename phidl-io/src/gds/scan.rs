//! The records of a file, one after the other: length, kind, content.
//!
//! Nothing is copied or decoded here. Every record is inside the file's bytes, so no length that a file states can ask
//! for memory.

use gds21::GdsRecordType;

use super::problem::ProblemKind;

/// A place in the file where its format is broken.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) offset: usize,
    pub(super) problem: Box<str>,
}

impl Fault {
    pub(super) fn new(offset: usize, problem: impl Into<Box<str>>) -> Self {
        Self { offset, problem: problem.into() }
    }
}

/// One record.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record<'a> {
    /// Where it begins in the file.
    pub(super) offset: usize,
    pub(super) kind: u8,
    /// Header and content.
    pub(super) whole: &'a [u8],
}

/// Kinds of records, by gds21's names.
pub(super) mod kind {
    use super::GdsRecordType as T;

    pub(in crate::gds) const HEADER: u8 = T::Header as u8;
    pub(in crate::gds) const LIBNAME: u8 = T::LibName as u8;
    pub(in crate::gds) const UNITS: u8 = T::Units as u8;
    pub(in crate::gds) const ENDLIB: u8 = T::EndLib as u8;
    pub(in crate::gds) const BGNSTR: u8 = T::BgnStruct as u8;
    pub(in crate::gds) const STRNAME: u8 = T::StructName as u8;
    pub(in crate::gds) const ENDSTR: u8 = T::EndStruct as u8;
    pub(in crate::gds) const BOUNDARY: u8 = T::Boundary as u8;
    pub(in crate::gds) const PATH: u8 = T::Path as u8;
    pub(in crate::gds) const SREF: u8 = T::StructRef as u8;
    pub(in crate::gds) const AREF: u8 = T::ArrayRef as u8;
    pub(in crate::gds) const TEXT: u8 = T::Text as u8;
    pub(in crate::gds) const LAYER: u8 = T::Layer as u8;
    pub(in crate::gds) const DATATYPE: u8 = T::DataType as u8;
    pub(in crate::gds) const XY: u8 = T::Xy as u8;
    pub(in crate::gds) const ENDEL: u8 = T::EndElement as u8;
    pub(in crate::gds) const SNAME: u8 = T::StructRefName as u8;
    pub(in crate::gds) const STRANS: u8 = T::Strans as u8;
    pub(in crate::gds) const MAG: u8 = T::Mag as u8;
    pub(in crate::gds) const ANGLE: u8 = T::Angle as u8;
    pub(in crate::gds) const NODE: u8 = T::Node as u8;
    pub(in crate::gds) const ELFLAGS: u8 = T::ElemFlags as u8;
    pub(in crate::gds) const PLEX: u8 = T::Plex as u8;
    pub(in crate::gds) const PROPATTR: u8 = T::PropAttr as u8;
    pub(in crate::gds) const PROPVALUE: u8 = T::PropValue as u8;
    pub(in crate::gds) const BOX: u8 = T::Box as u8;
    pub(in crate::gds) const STRCLASS: u8 = T::StrClass as u8;
    /// The last kind that the format knows.
    pub(in crate::gds) const LAST: u8 = T::LibSecur as u8;
}

impl<'a> Record<'a> {
    pub(super) fn content(&self) -> &'a [u8] {
        &self.whole[4..]
    }

    /// The content as one 16-bit number.
    pub(super) fn number(&self) -> Result<u16, Fault> {
        match self.content() {
            [high, low] => Ok(u16::from_be_bytes([*high, *low])),
            other => Err(Fault::new(self.offset, format!("a number of {} bytes, where 2 are due", other.len()))),
        }
    }

    /// The content as a text, and whether it had to be read as Latin-1. The zeros that fill it up are not part of it.
    pub(super) fn text(&self) -> (String, bool) {
        let content = self.content();
        let end = content.iter().rposition(|byte| *byte != 0).map_or(0, |last| last + 1);
        match std::str::from_utf8(&content[..end]) {
            Ok(text) => (text.to_owned(), false),
            Err(_) => (content[..end].iter().map(|byte| char::from(*byte)).collect(), true),
        }
    }

    /// Refuses a record that cannot stand inside an element.
    pub(super) fn check_inside_element(&self) -> Result<(), Fault> {
        let outside = matches!(self.kind, kind::HEADER..=kind::AREF | kind::TEXT | kind::NODE | kind::BOX);
        if outside {
            return Err(Fault::new(self.offset, format!("an element is not ended before record {:#04x}", self.kind)));
        }
        Ok(())
    }
}

/// The records of a file.
pub(super) struct Records<'a> {
    bytes: &'a [u8],
    pub(super) offset: usize,
}

impl<'a> Records<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0 }
    }

    /// The next record. The end of the file is a fault: a library says where it ends.
    pub(super) fn next(&mut self) -> Result<Record<'a>, Fault> {
        let offset = self.offset;
        let rest = &self.bytes[offset..];
        let &[high, low, kind, _, ..] = rest else {
            return Err(Fault::new(offset, "the file ends before its library does"));
        };
        let length = usize::from(u16::from_be_bytes([high, low]));
        if length < 4 || length % 2 != 0 {
            return Err(Fault::new(offset, format!("a record of {length} bytes, where an even number from 4 is due")));
        }
        let Some(whole) = rest.get(..length) else {
            return Err(Fault::new(offset, format!("a record of {length} bytes, of which {} are there", rest.len())));
        };
        self.offset += length;
        Ok(Record { offset, kind, whole })
    }

    /// Attribute and text of a property, of which the attribute's record was taken already.
    pub(super) fn property(
        &mut self,
        attribute: &Record<'_>,
        mut problem: impl FnMut(usize, ProblemKind),
    ) -> Result<(u16, String), Fault> {
        let number = attribute.number()?;
        let value = self.next()?;
        if value.kind != kind::PROPVALUE {
            return Err(Fault::new(value.offset, "a property without a value"));
        }
        let (text, latin1) = value.text();
        if latin1 {
            problem(value.offset, ProblemKind::Latin1);
        }
        Ok((number, text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_that_are_not_whole_are_faults_with_their_place() {
        let mut records = Records::new(&[0, 4, 0x08, 0, 0, 6, 0x0d, 2, 0]);
        assert_eq!(records.next().unwrap().kind, kind::BOUNDARY);
        assert_eq!(records.next().unwrap_err().offset, 4);
        for bad in [&[0, 3, 0, 0][..], &[0, 5, 0, 0, 0], &[0, 0, 0, 0], &[0, 4, 0], &[]] {
            assert!(Records::new(bad).next().is_err(), "{bad:?}");
        }
    }

    #[test]
    fn texts_lose_the_zeros_at_their_end_and_any_bytes_are_a_text() {
        let text = |whole: &'static [u8]| Record { offset: 0, kind: 0, whole }.text();
        assert_eq!(text(&[0, 0, 0, 0, b'a', 0]), ("a".to_owned(), false));
        assert_eq!(text(&[0, 0, 0, 0]), (String::new(), false));
        assert_eq!(text(&[0, 0, 0, 0, 0xb5, b'm']), ("µm".to_owned(), true));
    }
}
