//! Numbers and strings of a file, read one after the other.
//!
//! A cursor never leaves its bytes and allocates nothing. Every length that a file states is compared with the bytes that
//! are left before memory is taken.

use std::fmt::Display;

/// Where a byte of a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Position {
    /// Bytes from the start of the file; inside a compressed block, the start of the block.
    pub(super) file: usize,
    /// Bytes from the start of the inflated content, inside a compressed block.
    pub(super) inflated: Option<usize>,
}

/// A rule of the format that a file breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault(Box<(Position, Box<str>)>);

impl Fault {
    #[cold]
    pub(super) fn new(position: Position, problem: impl Into<Box<str>>) -> Self {
        Self(Box::new((position, problem.into())))
    }

    pub(super) fn position(&self) -> Position {
        self.0.0
    }

    pub(super) fn problem(&self) -> &str {
        &self.0.1
    }
}

pub(super) type Result<T> = std::result::Result<T, Fault>;

/// A position in the bytes of a file, or of a compressed block of it.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Where the compressed block starts in the file, if the bytes are one.
    block: Option<usize>,
}

impl<'a> Cursor<'a> {
    /// The bytes of a whole file.
    pub(super) fn of_file(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, block: None }
    }

    /// The inflated bytes of the compressed block that starts at a byte of the file.
    pub(super) fn of_block(bytes: &'a [u8], start: usize) -> Self {
        Self { bytes, at: 0, block: Some(start) }
    }

    /// The same bytes, from another byte on. Beyond the end there is nothing to read.
    pub(super) fn at(&self, at: usize) -> Self {
        Self { at: at.min(self.bytes.len()), ..self.clone() }
    }

    pub(super) fn position(&self) -> Position {
        self.position_of(self.at)
    }

    fn position_of(&self, at: usize) -> Position {
        match self.block {
            None => Position { file: at, inflated: None },
            Some(start) => Position { file: start, inflated: Some(at) },
        }
    }

    /// Bytes from the start of these bytes.
    pub(super) fn offset(&self) -> usize {
        self.at
    }

    /// Whether these are the bytes of a compressed block.
    pub(super) fn is_block(&self) -> bool {
        self.block.is_some()
    }

    /// How many bytes are left.
    pub(super) fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// The fault that the bytes end too early.
    #[cold]
    fn ended(&self) -> Fault {
        let bytes = if self.block.is_some() { "the compressed block" } else { "the file" };
        Fault::new(self.position_of(self.bytes.len()), format!("{bytes} ends inside a record"))
    }

    #[inline]
    pub(super) fn byte(&mut self) -> Result<u8> {
        let Some(byte) = self.bytes.get(self.at) else { return Err(self.ended()) };
        self.at += 1;
        Ok(*byte)
    }

    /// This number of bytes, as they are.
    pub(super) fn take(&mut self, length: usize) -> Result<&'a [u8]> {
        let rest = self.bytes.get(self.at..).and_then(|rest| rest.get(..length));
        let Some(taken) = rest else { return Err(self.ended()) };
        self.at += length;
        Ok(taken)
    }

    /// An unsigned integer: seven bits in a byte, the lowest first.
    #[inline]
    pub(super) fn unsigned(&mut self) -> Result<u64> {
        match self.bytes.get(self.at) {
            Some(byte) if *byte < 0x80 => {
                self.at += 1;
                Ok(u64::from(*byte))
            }
            _ => self.long_unsigned(),
        }
    }

    fn long_unsigned(&mut self) -> Result<u64> {
        let start = self.at;
        let (mut value, mut shift) = (0_u64, 0_u32);
        loop {
            let byte = self.byte()?;
            let bits = u64::from(byte & 0x7f);
            if bits != 0 {
                let shifted = bits.checked_shl(shift).filter(|shifted| shifted >> shift == bits);
                let Some(shifted) = shifted else {
                    return Err(Fault::new(self.position_of(start), "an integer has more than 64 bits"));
                };
                value |= shifted;
            }
            if byte < 0x80 {
                return Ok(value);
            }
            shift = shift.saturating_add(7);
        }
    }

    /// An unsigned integer that counts what follows: each of it takes at least one byte.
    pub(super) fn count(&mut self, what: impl Display) -> Result<usize> {
        let start = self.position();
        let count = self.unsigned()?;
        match usize::try_from(count) {
            Ok(count) if count <= self.left() => Ok(count),
            _ => {
                let left = self.left();
                Err(Fault::new(start, format!("the record states {count} {what}, but only {left} bytes follow")))
            }
        }
    }

    /// An integer with its sign in the lowest bit; also the 1-delta of the standard.
    #[inline]
    pub(super) fn signed(&mut self) -> Result<i64> {
        let bits = self.unsigned()?;
        Ok(with_sign(bits >> 1, bits & 1 == 1))
    }

    /// A real number, in any of its eight forms.
    pub(super) fn real(&mut self) -> Result<f64> {
        let kind = self.unsigned()?;
        self.real_of_kind(kind)
    }

    /// A real number whose form is known already.
    pub(super) fn real_of_kind(&mut self, kind: u64) -> Result<f64> {
        let start = self.position();
        let value = match kind {
            0 => whole(self.unsigned()?),
            1 => -whole(self.unsigned()?),
            2 => 1.0 / whole(self.unsigned()?),
            3 => -1.0 / whole(self.unsigned()?),
            4 => whole(self.unsigned()?) / whole(self.unsigned()?),
            5 => -whole(self.unsigned()?) / whole(self.unsigned()?),
            6 => f64::from(f32::from_le_bytes(self.array()?)),
            7 => f64::from_le_bytes(self.array()?),
            _ => return Err(Fault::new(start, format!("a real number has the form {kind}, but forms are 0 to 7"))),
        };
        if value.is_finite() {
            return Ok(value);
        }
        Err(Fault::new(start, "a real number is infinite or not a number"))
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let bytes = self.take(N)?;
        bytes.try_into().map_err(|_| self.ended())
    }

    /// A string: its length and its bytes, which may be any.
    pub(super) fn string(&mut self) -> Result<&'a [u8]> {
        let length = self.count("bytes of a string")?;
        self.take(length)
    }

    /// A step to the east, north, west or south.
    #[inline]
    pub(super) fn two_delta(&mut self) -> Result<[i64; 2]> {
        let bits = self.unsigned()?;
        Ok(step(bits & 3, bits >> 2))
    }

    /// A step in one of eight directions.
    #[inline]
    pub(super) fn three_delta(&mut self) -> Result<[i64; 2]> {
        let bits = self.unsigned()?;
        Ok(step(bits & 7, bits >> 3))
    }

    /// A step in any direction.
    #[inline]
    pub(super) fn g_delta(&mut self) -> Result<[i64; 2]> {
        let bits = self.unsigned()?;
        if bits & 1 == 0 {
            return Ok(step((bits >> 1) & 7, bits >> 4));
        }
        let x = with_sign(bits >> 2, bits & 2 != 0);
        Ok([x, self.signed()?])
    }
}

/// The number with its sign. Its lowest bits were flags, so it has at most 63 of them.
#[inline]
fn with_sign(magnitude: u64, negative: bool) -> i64 {
    let magnitude = magnitude.cast_signed();
    if negative { -magnitude } else { magnitude }
}

/// A step in one of the directions E, N, W, S, NE, NW, SW, SE.
#[inline]
fn step(direction: u64, length: u64) -> [i64; 2] {
    let length = length.cast_signed();
    match direction {
        0 => [length, 0],
        1 => [0, length],
        2 => [-length, 0],
        3 => [0, -length],
        4 => [length, length],
        5 => [-length, length],
        6 => [-length, -length],
        _ => [length, -length],
    }
}

/// A whole number as a real one.
#[expect(clippy::cast_precision_loss, reason = "a real number of the format is a double")]
fn whole(value: u64) -> f64 {
    value as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is read of bytes that it uses up.
    fn all<'a, T>(bytes: &'a [u8], read: impl FnOnce(&mut Cursor<'a>) -> Result<T>) -> T {
        let mut cursor = Cursor::of_file(bytes);
        let value = read(&mut cursor).unwrap();
        assert_eq!(cursor.left(), 0, "{bytes:02x?}");
        value
    }

    /// Section 7 of SEMI P39 has these examples.
    #[test]
    fn integers_and_reals_are_those_of_the_standard() {
        let unsigned: [(&[u8], u64); 5] =
            [(&[0], 0), (&[0x7f], 127), (&[0x80, 1], 128), (&[0xff, 0x7f], 16_383), (&[0x80, 0x80, 1], 16_384)];
        for (bytes, value) in unsigned {
            assert_eq!(all(bytes, Cursor::unsigned), value);
        }
        let signed: [(&[u8], i64); 6] =
            [(&[0], 0), (&[2], 1), (&[3], -1), (&[0x7e], 63), (&[0x81, 1], -64), (&[0xfe, 0x7f], 8191)];
        for (bytes, value) in signed {
            assert_eq!(all(bytes, Cursor::signed), value);
        }
        let reals: [(&[u8], f64); 8] = [
            (&[0, 0xe8, 7], 1000.0),
            (&[1, 3], -3.0),
            (&[2, 2], 0.5),
            (&[3, 3], -1.0 / 3.0),
            (&[4, 2, 3], 2.0 / 3.0),
            (&[5, 5, 8], -0.625),
            (&[6, 0, 0, 0xc0, 0x3f], 1.5),
            (&[7, 0, 0, 0, 0, 0, 0, 0xf8, 0xbf], -1.5),
        ];
        for (bytes, value) in reals {
            assert_eq!(all(bytes, Cursor::real), value);
        }
    }

    #[test]
    fn deltas_are_those_of_the_standard() {
        let east_north_west_south = [[5, 0], [0, 5], [-5, 0], [0, -5]];
        for (byte, step) in (0x14..).zip(east_north_west_south) {
            assert_eq!(all(&[byte], Cursor::two_delta), step);
        }
        let diagonal = [[5, 5], [-5, 5], [-5, -5], [5, -5]];
        for (byte, step) in (0x28..).zip(east_north_west_south.into_iter().chain(diagonal)) {
            assert_eq!(all(&[byte], Cursor::three_delta), step);
        }
        let general: [(&[u8], [i64; 2]); 4] =
            [(&[0x50], [5, 0]), (&[0x5a], [-5, 5]), (&[0xe9, 3, 0x6c], [122, 54]), (&[0x0f, 9], [-3, -4])];
        for (bytes, step) in general {
            assert_eq!(all(bytes, Cursor::g_delta), step);
        }
    }

    #[test]
    fn integers_of_more_than_64_bits_are_faults_and_padding_is_not() {
        let most = [&[0xff; 9][..], &[1]].concat();
        assert_eq!(all(&most, Cursor::unsigned), u64::MAX);
        let padded = [&[0x81][..], &[0x80; 20], &[0]].concat();
        assert_eq!(all(&padded, Cursor::unsigned), 1);
        for beyond in [[&[0xff; 9][..], &[2]].concat(), [&[0x80; 20][..], &[1]].concat()] {
            assert!(Cursor::of_file(&beyond).unsigned().is_err(), "{beyond:02x?}");
        }
    }

    #[test]
    fn reals_that_are_no_numbers_are_faults() {
        let infinite = [&[7][..], &f64::INFINITY.to_le_bytes()].concat();
        for bytes in [&[2, 0][..], &[4, 1, 0], &[4, 0, 0], &[8, 0], &infinite, &[7, 0]] {
            assert!(Cursor::of_file(bytes).real().is_err(), "{bytes:02x?}");
        }
    }

    #[test]
    fn a_string_is_never_longer_than_its_file() {
        assert_eq!(all(&[2, b'h', b'i'], Cursor::string), b"hi");
        let mut cursor = Cursor::of_block(&[0xff, 0xff, 0xff, 0xff, 0x7f, b'a'], 40);
        let fault = cursor.string().unwrap_err();
        assert_eq!(fault.position(), Position { file: 40, inflated: Some(0) });
        assert!(fault.problem().contains("only 1 bytes follow"), "{fault:?}");
    }
}
