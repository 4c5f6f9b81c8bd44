//! The two checksums of END.

/// CRC-32 of all bytes: scheme 1.
pub(super) fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = flate2::Crc::new();
    crc.update(bytes);
    crc.sum()
}

/// The sum of all bytes, of which 32 bits are kept: scheme 2.
pub(super) fn sum32(bytes: &[u8]) -> u32 {
    // Portions whose sum cannot overflow, so that the inner loop needs no wrapping addition.
    let portion = |bytes: &[u8]| bytes.iter().map(|byte| u32::from(*byte)).sum::<u32>();
    bytes.chunks(1 << 20).fold(0, |sum: u32, bytes| sum.wrapping_add(portion(bytes)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_the_standard() {
        // The check value of CRC-32 (ISO-HDLC) in the catalogues of such codes.
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
        assert_eq!(sum32(b"123456789"), 477);
        assert_eq!(sum32(&vec![0xff; 17_000_000]), u32::try_from(17_000_000_u64 * 255 % (1 << 32)).unwrap());
    }
}
