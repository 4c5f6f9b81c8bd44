//! Valid files with damaged records: every record is whole, so the reader gets past the first check, and what it states is
//! odd. The fuzz target of the repository (`fuzz/`) and the tests call the same function.

use phidl_core::prelude::*;
use phidl_core::scene::TextStyle;
use phidl_io::gds;
use phidl_io::model::{BoxElement, Cell, Layout, Node, Path, PathEnd};

use crate::fuzzed::reading_is_a_device_or_an_error;

/// The file that the choices make of a valid file: three bytes each choose a record, what is done to it, and with what.
pub(crate) fn a_file_with_damaged_records_is_a_device_or_an_error(choices: &[u8]) {
    let mut records = records(&every_element());
    for choice in choices.chunks_exact(3) {
        let index = usize::from(choice[0]) % records.len();
        damage(&mut records, index, choice[1], choice[2]);
        if records.is_empty() {
            return;
        }
    }
    reading_is_a_device_or_an_error(&records.concat());
}

fn damage(records: &mut Vec<Vec<u8>>, index: usize, how: u8, with: u8) {
    let record = &mut records[index];
    match how % 9 {
        0 => drop(records.remove(index)),
        1 => records.insert(index, records[index].clone()),
        2 => {
            let other = usize::from(with) % records.len();
            records.swap(index, other);
        }
        // Another kind, known or not, with the same content.
        3 => record[2] = with % 0x48,
        // Another data type.
        4 => record[3] = with % 8,
        // Shorter or longer content.
        5 => record.truncate(4 + usize::from(with) % (record.len() - 3)),
        6 => record.extend_from_slice(&vec![with; usize::from(with % 24)]),
        // Other content.
        7 if record.len() > 4 => {
            let byte = 4 + usize::from(with) % (record.len() - 4);
            record[byte] = record[byte].wrapping_mul(31).wrapping_add(with | 1);
        }
        _ => record[4..].fill(with),
    }
    for record in records {
        if !record.len().is_multiple_of(2) {
            record.push(0);
        }
        let length = u16::try_from(record.len()).expect("records of the sample are short");
        record[..2].copy_from_slice(&length.to_be_bytes());
    }
}

/// The records of a file.
fn records(mut bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut records = Vec::new();
    while bytes.len() >= 4 {
        let (record, rest) = bytes.split_at(usize::from(u16::from_be_bytes([bytes[0], bytes[1]])));
        records.push(record.to_vec());
        bytes = rest;
    }
    records
}

/// A file with every kind of element and record that is read.
fn every_element() -> Vec<u8> {
    let mut d = Device::builder("dot");
    d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], 1).with_property(3, "text"));
    let dot = d.build().unwrap();
    let mut d = Device::builder("top");
    d.add(dot.place().rotated(33).mirrored((0, 0), (1, 0)).with_property(4, "x"));
    d.add(Reference::new(dot.clone(), Transform::scaling(2.5)));
    d.add(dot.array(3, 2, (5, 5)).rotated(90));
    let style = TextStyle { font: 1, path_type: Some(2), width: Some(0.1), ..TextStyle::default() };
    d.add(Label::new("label", (1, 1), 2).rotated(90).with_style(style));
    let bytes = gds::to_bytes(&d.build().unwrap(), &gds::GdsOptions::default()).unwrap();
    let mut layout: Layout = gds::decode_layout(&bytes).unwrap();
    let top: &mut Cell = layout.cells.last_mut().unwrap();
    let (layer, properties) = (Layer::new(2, 0), Properties::from([(1, "p".to_owned())]));
    let points = vec![[0, 0], [1000, 0], [1000, 1000], [0, 1000]];
    let path = |start, end| Path {
        layer,
        points: points.clone(),
        width: 100,
        fixed_width: false,
        start,
        end,
        properties: properties.clone(),
        offset: 0,
    };
    top.paths = vec![path(PathEnd::Round, PathEnd::Round), path(PathEnd::Extended(10), PathEnd::Extended(-10))];
    top.boxes = vec![BoxElement { layer, corners: points.clone(), properties: properties.clone(), offset: 0 }];
    top.nodes = vec![Node { layer, points, properties, offset: 0 }];
    gds::encode_layout(&layout).unwrap()
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::any;
    use proptest::proptest;

    use super::*;

    #[test]
    fn the_sample_is_read_without_an_error() {
        reading_is_a_device_or_an_error(&every_element());
    }

    #[test]
    fn any_single_damage_is_a_device_or_an_error() {
        let count = u8::try_from(records(&every_element()).len()).unwrap();
        for index in 0..count {
            for how in 0..9 {
                for with in [0, 1, 5, 0x11, 0x7f, 0x80, 0xff] {
                    a_file_with_damaged_records_is_a_device_or_an_error(&[index, how, with]);
                }
            }
        }
    }

    proptest! {
        #[test]
        fn several_damages_are_a_device_or_an_error(choices in vec(any::<u8>(), 3..30)) {
            a_file_with_damaged_records_is_a_device_or_an_error(&choices);
        }
    }
}
