//! The records of a file: length, kind, data type, content.
//!
//! Reading copies and decodes nothing. Every record lies inside the bytes of the file, so a length that a file states
//! cannot ask for memory.

use super::real;

/// The kinds of records, by the names of the format's manual.
pub(super) mod kind {
    macro_rules! kinds {
        ($($name:ident = $value:literal),* $(,)?) => { $(pub(in crate::gds) const $name: u8 = $value;)* };
    }
    kinds! {
        HEADER = 0x00, BGNLIB = 0x01, LIBNAME = 0x02, UNITS = 0x03, ENDLIB = 0x04, BGNSTR = 0x05, STRNAME = 0x06,
        ENDSTR = 0x07, BOUNDARY = 0x08, PATH = 0x09, SREF = 0x0a, AREF = 0x0b, TEXT = 0x0c, LAYER = 0x0d,
        DATATYPE = 0x0e, WIDTH = 0x0f, XY = 0x10, ENDEL = 0x11, SNAME = 0x12, COLROW = 0x13, NODE = 0x15,
        TEXTTYPE = 0x16, PRESENTATION = 0x17, STRING = 0x19, STRANS = 0x1a, MAG = 0x1b, ANGLE = 0x1c, PATHTYPE = 0x21,
        ELFLAGS = 0x26, NODETYPE = 0x2a, PROPATTR = 0x2b, PROPVALUE = 0x2c, BOX = 0x2d, BOXTYPE = 0x2e, PLEX = 0x2f,
        BGNEXTN = 0x30, ENDEXTN = 0x31, STRCLASS = 0x34,
    }
}

/// The data types of records.
mod data {
    pub(super) const NONE: u8 = 0;
    pub(super) const BITS: u8 = 1;
    pub(super) const I16: u8 = 2;
    pub(super) const I32: u8 = 3;
    pub(super) const REAL: u8 = 5;
    pub(super) const TEXT: u8 = 6;
}

/// The longest text that a record holds (bytes).
pub(super) const MOST_TEXT: usize = 65_530;

/// A rule of the format that a file breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FormatError {
    /// Where (bytes).
    pub(super) offset: usize,
    pub(super) problem: Box<str>,
}

impl FormatError {
    pub(super) fn new(offset: usize, problem: impl Into<Box<str>>) -> Self {
        Self { offset, problem: problem.into() }
    }
}

/// One record of a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record<'a> {
    /// Where it begins in the file.
    pub(super) offset: usize,
    pub(super) kind: u8,
    pub(super) content: &'a [u8],
}

impl<'a> Record<'a> {
    /// The bytes of a text, without the zeros that pad it.
    pub(super) fn trimmed(&self) -> &'a [u8] {
        let end = self.content.iter().rposition(|byte| *byte != 0).map_or(0, |last| last + 1);
        &self.content[..end]
    }

    /// The content as one 16-bit number.
    pub(super) fn u16(&self) -> Result<u16, FormatError> {
        self.array().map(u16::from_be_bytes)
    }

    /// The content as one signed 32-bit number.
    pub(super) fn i32(&self) -> Result<i32, FormatError> {
        self.array().map(i32::from_be_bytes)
    }

    /// The content as one real number.
    pub(super) fn real(&self) -> Result<f64, FormatError> {
        self.array().map(real::decode)
    }

    fn array<const N: usize>(&self) -> Result<[u8; N], FormatError> {
        self.content.try_into().map_err(|_| {
            let problem = format!("record {:#04x} holds {} bytes instead of {N}", self.kind, self.content.len());
            FormatError::new(self.offset, problem)
        })
    }

    /// The content as a text, and whether it had to be read as Latin-1.
    pub(super) fn text(&self) -> (String, bool) {
        let bytes = self.trimmed();
        match std::str::from_utf8(bytes) {
            Ok(text) => (text.to_owned(), false),
            Err(_) => (bytes.iter().map(|byte| char::from(*byte)).collect(), true),
        }
    }

    /// Whether the record can only stand outside of elements.
    pub(super) fn is_outside_elements(&self) -> bool {
        matches!(self.kind, kind::HEADER..=kind::TEXT | kind::NODE | kind::BOX)
    }
}

/// The records of a file, one after the other.
pub(super) struct Records<'a> {
    bytes: &'a [u8],
    pub(super) offset: usize,
}

impl<'a> Records<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0 }
    }

    /// The next record. The end of the file is an error: the library states its end.
    #[inline]
    pub(super) fn next(&mut self) -> Result<Record<'a>, FormatError> {
        let offset = self.offset;
        let rest = &self.bytes[offset..];
        let &[high, low, kind, _, ..] = rest else {
            return Err(FormatError::new(offset, "the file ends inside the library"));
        };
        let length = usize::from(u16::from_be_bytes([high, low]));
        if length < 4 || !length.is_multiple_of(2) {
            let problem = format!("a record states a length of {length} bytes, which is not an even number from 4");
            return Err(FormatError::new(offset, problem));
        }
        let Some(content) = rest.get(4..length) else {
            let problem = format!("a record states a length of {length} bytes, of which the file has {}", rest.len());
            return Err(FormatError::new(offset, problem));
        };
        self.offset += length;
        Ok(Record { offset, kind, content })
    }

    /// What follows the last record.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.offset..]
    }
}

fn header(kind: u8, data: u8, size: u16) -> [u8; 4] {
    let [high, low] = (size + 4).to_be_bytes();
    [high, low, kind, data]
}

/// Appends a record without content.
pub(super) fn put_mark(kind: u8, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(kind, data::NONE, 0));
}

/// Appends a record of one 16-bit number.
pub(super) fn put_u16(kind: u8, number: u16, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(kind, data::I16, 2));
    bytes.extend_from_slice(&number.to_be_bytes());
}

/// Appends a record of several 16-bit numbers.
pub(super) fn put_u16s<const N: usize>(kind: u8, numbers: [u16; N], bytes: &mut Vec<u8>) {
    let size = u16::try_from(2 * N).expect("invariant: records of 16-bit numbers are short");
    bytes.extend_from_slice(&header(kind, data::I16, size));
    numbers.iter().for_each(|number| bytes.extend_from_slice(&number.to_be_bytes()));
}

/// Appends a record of 16 bits.
pub(super) fn put_bits(kind: u8, bits: u16, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(kind, data::BITS, 2));
    bytes.extend_from_slice(&bits.to_be_bytes());
}

/// Appends a record of one 32-bit number.
pub(super) fn put_i32(kind: u8, number: i32, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(kind, data::I32, 4));
    bytes.extend_from_slice(&number.to_be_bytes());
}

/// Appends a record of real numbers.
pub(super) fn put_reals<const N: usize>(kind: u8, numbers: [f64; N], bytes: &mut Vec<u8>) {
    let size = u16::try_from(8 * N).expect("invariant: records of real numbers are short");
    bytes.extend_from_slice(&header(kind, data::REAL, size));
    numbers.iter().for_each(|number| bytes.extend_from_slice(&real::encode(*number)));
}

/// Appends a record of a text, in UTF-8; in Latin-1 if only that fits.
pub(super) fn put_text(kind: u8, text: &str, bytes: &mut Vec<u8>) {
    if text.len() > MOST_TEXT {
        let latin1: Vec<u8> = text.chars().filter_map(|c| u8::try_from(c).ok()).collect();
        return put_padded(kind, &latin1, bytes);
    }
    put_padded(kind, text.as_bytes(), bytes);
}

fn put_padded(kind: u8, text: &[u8], bytes: &mut Vec<u8>) {
    let padded = text.len() + text.len() % 2;
    let size = u16::try_from(padded).expect("invariant: lengths of texts are checked before");
    bytes.extend_from_slice(&header(kind, data::TEXT, size));
    bytes.extend_from_slice(text);
    bytes.resize(bytes.len() + padded - text.len(), 0);
}

/// Appends an XY record.
pub(super) fn put_xy<'a>(corners: impl ExactSizeIterator<Item = &'a [i32; 2]>, bytes: &mut Vec<u8>) {
    let size = corners.len() * 8;
    let stated = u16::try_from(size).expect("invariant: an outline has at most 8190 corners");
    bytes.extend_from_slice(&header(kind::XY, data::I32, stated));
    let start = bytes.len();
    bytes.resize(start + size, 0);
    for (target, corner) in bytes[start..].chunks_exact_mut(8).zip(corners) {
        target[..4].copy_from_slice(&corner[0].to_be_bytes());
        target[4..].copy_from_slice(&corner[1].to_be_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn incomplete_records_are_errors_with_their_offset() {
        let mut records = Records::new(&[0, 4, 0x08, 0, 0, 6, 0x0d, 2, 0]);
        assert_eq!(records.next().unwrap().kind, kind::BOUNDARY);
        assert_eq!(records.next().unwrap_err().offset, 4);
        for bad in [&[0, 3, 0, 0][..], &[0, 5, 0, 0, 0], &[0, 0, 0, 0], &[0, 4, 0], &[]] {
            assert!(Records::new(bad).next().is_err(), "{bad:?}");
        }
    }

    #[test]
    fn texts_lose_their_padding_and_any_bytes_are_a_text() {
        let text = |content: &'static [u8]| Record { offset: 0, kind: 0, content }.text();
        assert_eq!(text(b"a\0"), ("a".to_owned(), false));
        assert_eq!(text(b""), (String::new(), false));
        assert_eq!(text(&[0xb5, b'm']), ("µm".to_owned(), true));
    }

    #[test]
    fn texts_of_odd_length_are_padded() {
        let mut bytes = Vec::new();
        put_text(kind::PROPVALUE, "abc", &mut bytes);
        assert_eq!(bytes, [0, 8, 0x2c, 6, b'a', b'b', b'c', 0]);
    }

    #[test]
    fn a_text_that_fits_as_latin_1_only_is_written_so() {
        let mut bytes = Vec::new();
        put_text(kind::STRING, &"µ".repeat(40_000), &mut bytes);
        assert_eq!((bytes.len(), bytes[4]), (40_004, 0xb5));
    }
}
