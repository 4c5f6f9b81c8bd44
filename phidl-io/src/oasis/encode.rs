//! Numbers and strings of a file, written: every value in its shortest form.

/// An unsigned integer: seven bits in a byte, the lowest first.
#[inline]
pub(super) fn unsigned(mut value: u64, out: &mut Vec<u8>) {
    loop {
        let low = value.to_le_bytes()[0] & 0x7f;
        value >>= 7;
        if value == 0 {
            out.push(low);
            return;
        }
        out.push(low | 0x80);
    }
}

/// How many bytes [`unsigned`] takes.
#[inline]
pub(super) fn unsigned_length(value: u64) -> usize {
    let bits = u64::BITS - (value | 1).leading_zeros();
    bits.div_ceil(7) as usize
}

/// An integer with its sign in the lowest bit; also the 1-delta of the standard. It has at most 62 bits.
#[inline]
pub(super) fn signed(value: i64, out: &mut Vec<u8>) {
    unsigned(signed_bits(value), out);
}

/// What [`signed`] writes as an unsigned integer.
#[inline]
pub(super) fn signed_bits(value: i64) -> u64 {
    (value.unsigned_abs() << 1) | u64::from(value < 0)
}

/// A real number: a whole one, a reciprocal of one, or a double.
pub(super) fn real(value: f64, out: &mut Vec<u8>) {
    if let Some(whole) = small_whole(value.abs()) {
        out.push(u8::from(value < 0.0));
        return unsigned(whole, out);
    }
    let inverse = small_whole((1.0 / value).abs().round()).filter(|n| *n > 0 && 1.0 / as_real(*n) == value.abs());
    if let Some(inverse) = inverse {
        out.push(if value < 0.0 { 3 } else { 2 });
        return unsigned(inverse, out);
    }
    out.push(7);
    out.extend_from_slice(&value.to_le_bytes());
}

/// The number, if it is whole and takes fewer bytes than a double.
fn small_whole(value: f64) -> Option<u64> {
    let small = value.fract() == 0.0 && (0.0..=281_474_976_710_656.0).contains(&value);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 2⁴⁸")]
    let whole = value as u64;
    small.then_some(whole)
}

#[expect(clippy::cast_precision_loss, reason = "whole numbers up to 2⁴⁸ are exact")]
fn as_real(whole: u64) -> f64 {
    whole as f64
}

/// A string: its length and its bytes.
pub(super) fn string(text: &[u8], out: &mut Vec<u8>) {
    unsigned(text.len() as u64, out);
    out.extend_from_slice(text);
}

/// A step in any direction. Its lengths have at most 60 bits: four are flags.
#[inline]
pub(super) fn g_delta(step: [i64; 2], out: &mut Vec<u8>) {
    let (bits, rest) = g_delta_bits(step);
    unsigned(bits, out);
    if let Some(y) = rest {
        signed(y, out);
    }
}

/// How many bytes [`g_delta`] takes.
#[inline]
pub(super) fn g_delta_length(step: [i64; 2]) -> usize {
    let (bits, rest) = g_delta_bits(step);
    unsigned_length(bits) + rest.map_or(0, |y| unsigned_length(signed_bits(y)))
}

#[inline]
fn g_delta_bits([x, y]: [i64; 2]) -> (u64, Option<i64>) {
    match octant([x, y]) {
        Some((direction, length)) => ((length << 4) | (direction << 1), None),
        None => ((x.unsigned_abs() << 2) | (u64::from(x < 0) << 1) | 1, Some(y)),
    }
}

/// Direction (E, N, W, S, NE, NW, SW, SE) and length of a step along an axis or a diagonal.
#[inline]
pub(super) fn octant([x, y]: [i64; 2]) -> Option<(u64, u64)> {
    let direction = match (x.signum(), y.signum()) {
        (0 | 1, 0) => 0,
        (0, 1) => 1,
        (-1, 0) => 2,
        (0, _) => 3,
        _ if x.unsigned_abs() != y.unsigned_abs() => return None,
        (1, 1) => 4,
        (-1, 1) => 5,
        (-1, _) => 6,
        _ => 7,
    };
    Some((direction, x.unsigned_abs().max(y.unsigned_abs())))
}

#[cfg(test)]
mod tests {
    use super::super::cursor::Cursor;
    use super::*;

    fn written(write: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
        let mut out = Vec::new();
        write(&mut out);
        out
    }

    /// The examples of section 7 of SEMI P39, as in the tests of the cursor.
    #[test]
    fn values_have_the_bytes_of_the_standard() {
        let cases = [(0, vec![0]), (127, vec![0x7f]), (128, vec![0x80, 1]), (16_384, vec![0x80, 0x80, 1])];
        for (value, bytes) in cases {
            assert_eq!(written(|out| unsigned(value, out)), bytes);
            assert_eq!(unsigned_length(value), bytes.len());
        }
        for (value, bytes) in [(1, vec![2]), (-1, vec![3]), (63, vec![0x7e]), (-64, vec![0x81, 1])] {
            assert_eq!(written(|out| signed(value, out)), bytes);
        }
        let deltas =
            [([5, 0], vec![0x50]), ([-5, 5], vec![0x5a]), ([122, 54], vec![0xe9, 3, 0x6c]), ([-3, -4], vec![0x0f, 9])];
        for (step, bytes) in deltas {
            assert_eq!(written(|out| g_delta(step, out)), bytes);
            assert_eq!(g_delta_length(step), bytes.len());
        }
        assert_eq!(written(|out| real(1000.0, out)), [0, 0xe8, 7]);
        assert_eq!(written(|out| real(0.5, out)), [2, 2]);
    }

    #[test]
    fn the_cursor_reads_back_what_is_written() {
        let numbers = [0, 1, -1, 2, 63, 64, -64, 8191, -8192, 1 << 31, -(1 << 31), (1 << 62) - 1];
        for a in numbers {
            assert_eq!(Cursor::of_file(&written(|out| signed(a, out))).signed().unwrap(), a);
            for b in numbers {
                let step = [a >> 2, b >> 2];
                assert_eq!(Cursor::of_file(&written(|out| g_delta(step, out))).g_delta().unwrap(), step);
            }
        }
        for value in [0.0, 1.0, -7.0, 0.1, -0.25, 1e-3, 1e300, 33.3, -1e-300, 281_474_976_710_657.0] {
            assert_eq!(Cursor::of_file(&written(|out| real(value, out))).real().unwrap(), value);
        }
    }
}
