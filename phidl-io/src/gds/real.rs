//! The real numbers of the format: sign, exponent of 16 in excess 64, and 56 bits of a fraction.
//!
//! ```text
//!   S EEEEEEE  FFFFFFFF × 7          value = (−1)^S · F / 2⁵⁶ · 16^(E − 64)
//! ```
//!
//! A double has 53 bits, so every double within the exponents is written without loss, except where the leading digit
//! of the fraction leaves fewer than 53 bits: never, since that digit costs three bits at most. Reading rounds to the
//! nearest double.

/// Bits of the fraction.
const FRACTION_BITS: i32 = 56;

/// The exponent that stands for 16⁰.
const EXCESS: i32 = 64;

/// The number as the format's eight bytes. It must be 0 or within [`is_representable`].
pub(super) fn encode(number: f64) -> [u8; 8] {
    let magnitude = number.abs();
    if magnitude == 0.0 {
        return [0; 8];
    }
    // `magnitude` = m · 2^e with 2⁵² ≤ m < 2⁵³.
    let bits = magnitude.to_bits();
    let binary_exponent = i32::try_from(bits >> 52).expect("invariant: 11 bits") - 1075;
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    // The least exponent of 16 whose fraction is below 1: 16^k ≥ 2^(e + 53).
    let hex_exponent = (binary_exponent + 53).div_euclid(4) + i32::from((binary_exponent + 53).rem_euclid(4) != 0);
    let shift = FRACTION_BITS + binary_exponent - 4 * hex_exponent;
    let fraction = mantissa << u32::try_from(shift).expect("invariant: a fraction of 56 bits holds 53 and three more");
    let exponent = u64::try_from(hex_exponent + EXCESS).expect("invariant: the range was checked before");
    let sign = u64::from(number < 0.0);
    ((sign << 63) | (exponent << 56) | fraction).to_be_bytes()
}

/// The number of eight bytes.
pub(super) fn decode(bytes: [u8; 8]) -> f64 {
    let bits = u64::from_be_bytes(bytes);
    let exponent = i32::try_from((bits >> 56) & 0x7f).expect("invariant: 7 bits") - EXCESS;
    let fraction = bits & ((1 << FRACTION_BITS) - 1);
    // The fraction is rounded to a double once; scaling by a power of two is exact.
    let magnitude = fraction as f64 * 2_f64.powi(4 * exponent - FRACTION_BITS);
    if bits >> 63 == 1 { -magnitude } else { magnitude }
}

/// Whether a positive number is within the format's exponents (16⁻⁶⁵ to 16⁶³), with a margin.
pub(super) fn is_representable(number: f64) -> bool {
    (1e-70..1e70).contains(&number)
}

#[cfg(test)]
mod tests {
    use gds21::GdsFloat64;
    use proptest::{prop_assert_eq, proptest};

    use super::*;

    /// Known encodings: powers of 16 and halves by hand, the others as gdspy writes them.
    #[test]
    fn known_numbers_have_known_bytes() {
        let cases: [(f64, u64); 11] = [
            (0.0, 0),
            (1.0, 0x4110_0000_0000_0000),
            (2.0, 0x4120_0000_0000_0000),
            (0.5, 0x4080_0000_0000_0000),
            (90.0, 0x425a_0000_0000_0000),
            (30.0, 0x421e_0000_0000_0000),
            (-180.0, 0xc2b4_0000_0000_0000),
            (360.0, 0x4316_8000_0000_0000),
            (0.001, 0x3e41_8937_4bc6_a7f0),
            (1e-9, 0x3944_b82f_a09b_5a54),
            (1e-6, 0x3c10_c6f7_a0b5_ed8d),
        ];
        for (number, bits) in cases {
            assert_eq!(u64::from_be_bytes(encode(number)), bits, "{number}");
            assert_eq!(decode(bits.to_be_bytes()), number);
        }
    }

    proptest! {
        #[test]
        fn doubles_come_back_with_the_same_bits(mantissa in 1.0..10.0_f64, exponent in -69..69_i32, negative: bool) {
            let number = if negative { -mantissa } else { mantissa } * 10_f64.powi(exponent);
            prop_assert_eq!(decode(encode(number)).to_bits(), number.to_bits());
        }

        #[test]
        fn gds21_decodes_what_is_encoded(number in -1e6..1e6_f64) {
            let decoded = GdsFloat64::decode(u64::from_be_bytes(encode(number)));
            prop_assert_eq!(decoded, number);
        }
    }
}
