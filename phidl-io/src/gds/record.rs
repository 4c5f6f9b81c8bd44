//! Records as bytes, for the elements that do not go by way of gds21.

use gds21::{GdsDataType, GdsFloat64, GdsRecordType};

/// The four bytes in front of a record's content.
pub(super) fn header(record: GdsRecordType, data: GdsDataType, size: u16) -> [u8; 4] {
    let [high, low] = (size + 4).to_be_bytes();
    [high, low, record as u8, data as u8]
}

/// A record without content.
pub(super) fn put_mark(record: GdsRecordType, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(record, GdsDataType::NoData, 0));
}

/// A record of a text, which was measured before.
pub(super) fn put_text(record: GdsRecordType, text: &str, bytes: &mut Vec<u8>) {
    let padded = text.len() + text.len() % 2;
    let size = u16::try_from(padded).expect("invariant: texts were measured");
    bytes.extend_from_slice(&header(record, GdsDataType::Str, size));
    bytes.extend_from_slice(text.as_bytes());
    bytes.resize(bytes.len() + padded - text.len(), 0);
}

/// A record of a real number.
pub(super) fn put_real(record: GdsRecordType, v: f64, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(record, GdsDataType::F64, 8));
    bytes.extend_from_slice(&GdsFloat64::encode(v).to_be_bytes());
}

/// PROPATTR and PROPVALUE.
pub(super) fn put_property(attribute: u16, text: &str, bytes: &mut Vec<u8>) {
    bytes.extend_from_slice(&header(GdsRecordType::PropAttr, GdsDataType::I16, 2));
    bytes.extend_from_slice(&attribute.to_be_bytes());
    put_text(GdsRecordType::PropValue, text, bytes);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_odd_length_are_filled_up() {
        let mut bytes = Vec::new();
        put_property(1, "abc", &mut bytes);
        assert_eq!(bytes, [0, 6, 0x2b, 2, 0, 1, 0, 8, 0x2c, 6, b'a', b'b', b'c', 0]);
    }

    /// From `spec/core.md` §15.4.
    #[test]
    fn real_numbers_are_those_of_the_format() {
        let mut bytes = Vec::new();
        put_real(GdsRecordType::Angle, -180.0, &mut bytes);
        assert_eq!(bytes, [0, 12, 0x1c, 5, 0xc2, 0xb4, 0, 0, 0, 0, 0, 0]);
    }
}
