//! The library record that gds21 reads and writes around cells.

use gds21::{GdsDateTime, GdsDateTimes, GdsElement, GdsError, GdsLibrary, GdsStruct, GdsUnits, Unsupported};

use super::options::GdsDate;

/// The stream version that every reader takes.
const VERSION: i16 = 600;

/// Bytes of a record without content: ENDSTR, ENDLIB.
const END: usize = 4;

/// Bytes of BGNSTR, and of the header of STRNAME.
const BEGIN_CELL: usize = 28 + 4;

/// What ends a cell: ENDSTR.
pub(super) const END_CELL: [u8; END] = [0, 4, gds21::GdsRecordType::EndStruct as u8, 0];

/// Everything around the outlines of a file.
///
/// gds21 can only write a whole library. So a library with one cell is written, and what is wanted cut out of it.
pub(super) struct Frame {
    library: String,
    dates: GdsDateTimes,
    units: (f64, f64),
    /// What comes before the first cell.
    pub(super) head: Vec<u8>,
    /// What comes after the last cell.
    pub(super) tail: Vec<u8>,
}

impl Frame {
    pub(super) fn new(library: &str, date: GdsDate, units: (f64, f64)) -> Result<Self, GdsError> {
        let (head, tail) = (Vec::new(), Vec::new());
        let mut frame = Self { library: library.to_owned(), dates: dates(date), units, head, tail };
        frame.head = frame.encode(Vec::new())?;
        frame.tail = frame.head.split_off(frame.head.len() - END);
        Ok(frame)
    }

    /// What a cell begins with.
    pub(super) fn cell(&self, name: &str) -> Result<Vec<u8>, GdsError> {
        let mut bytes = self.library_with(name, Vec::new())?;
        bytes.truncate(bytes.len() - 2 * END);
        Ok(bytes.split_off(self.head.len()))
    }

    /// Some elements of a cell.
    pub(super) fn elements(&self, elements: Vec<GdsElement>) -> Result<Vec<u8>, GdsError> {
        let mut bytes = self.library_with("", elements)?;
        bytes.truncate(bytes.len() - 2 * END);
        Ok(bytes.split_off(self.head.len() + BEGIN_CELL))
    }

    fn library_with(&self, name: &str, elems: Vec<GdsElement>) -> Result<Vec<u8>, GdsError> {
        self.encode(vec![GdsStruct { name: name.to_owned(), dates: self.dates.clone(), elems }])
    }

    fn encode(&self, structs: Vec<GdsStruct>) -> Result<Vec<u8>, GdsError> {
        // All fields by name: the defaults of gds21 ask the clock.
        let library = GdsLibrary {
            name: self.library.clone(),
            version: VERSION,
            dates: self.dates.clone(),
            units: GdsUnits(self.units.0, self.units.1),
            structs,
            libdirsize: Unsupported,
            srfname: Unsupported,
            libsecur: Unsupported,
            reflibs: Unsupported,
            fonts: Unsupported,
            attrtable: Unsupported,
            generations: Unsupported,
            format_type: Unsupported,
        };
        let mut bytes = Vec::new();
        library.write(&mut bytes)?;
        Ok(bytes)
    }
}

fn dates(date: GdsDate) -> GdsDateTimes {
    let GdsDate { year, month, day, hour, minute, second } = date;
    let [month, day, hour, minute, second] = [month, day, hour, minute, second].map(i16::from);
    let date = GdsDateTime { year, month, day, hour, minute, second };
    GdsDateTimes { modified: date.clone(), accessed: date }
}

#[cfg(test)]
mod tests {
    use gds21::{GdsNode, GdsPoint};

    use super::*;

    #[test]
    fn a_cell_is_what_lies_between_head_and_tail() {
        let frame = Frame::new("odd", GdsDate::default(), (1e-3, 1e-9)).unwrap();
        for name in ["even", "odd"] {
            let node = GdsNode { layer: 1, xy: GdsPoint::vec(&[(3, 4)]), ..GdsNode::default() };
            let elements = frame.elements(vec![node.clone().into()]).unwrap();
            let whole = [&frame.head[..], &frame.cell(name).unwrap(), &elements, &END_CELL, &frame.tail].concat();
            let read = GdsLibrary::from_bytes(&whole).unwrap();
            assert_eq!((read.structs[0].name.as_str(), &read.structs[0].elems), (name, &vec![node.into()]));
        }
    }

    /// The bytes that `spec/core.md` §15.4 gives for a file in micrometers and nanometers.
    #[test]
    fn units_are_written_as_the_reference_library_writes_them() {
        let frame = Frame::new("library", GdsDate::default(), (1e-3, 1e-9)).unwrap();
        let units: String = frame.head[frame.head.len() - 16..].iter().map(|b| format!("{b:02x}")).collect();
        assert_eq!(units, "3e4189374bc6a7f03944b82fa09b5a54");
    }
}
