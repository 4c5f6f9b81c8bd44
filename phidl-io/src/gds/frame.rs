//! The library record that gds21 reads and writes around cells.

use gds21::{GdsDateTime, GdsDateTimes, GdsElement, GdsError, GdsLibrary, GdsStruct, GdsUnits, Unsupported};

use super::options::GdsDate;

/// The stream version that every reader takes.
const VERSION: i16 = 600;

/// Bytes of a record without content: ENDSTR, ENDLIB.
const END: usize = 4;

/// Bytes of BGNSTR, and of the header of STRNAME.
const BEGIN_CELL: usize = 28 + 4;

/// Everything around the elements of a file.
///
/// gds21 can only write a whole library. So one library per cell is written, with that cell and without its outlines,
/// and what lies between the library's head and tail is the cell.
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

    /// What comes before the outlines of a cell, and what comes after.
    pub(super) fn cell(&self, name: &str, elems: Vec<GdsElement>) -> Result<(Vec<u8>, Vec<u8>), GdsError> {
        let cell = GdsStruct { name: name.to_owned(), dates: self.dates.clone(), elems };
        let mut bytes = self.encode(vec![cell])?;
        bytes.truncate(bytes.len() - END);
        bytes.drain(..self.head.len());
        let tail = bytes.split_off(BEGIN_CELL + name.len() + name.len() % 2);
        Ok((bytes, tail))
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
    use super::*;

    #[test]
    fn a_cell_is_what_lies_between_head_and_tail() {
        let frame = Frame::new("odd", GdsDate::default(), (1e-3, 1e-9)).unwrap();
        for name in ["even", "odd"] {
            let (head, tail) = frame.cell(name, Vec::new()).unwrap();
            let whole = [&frame.head[..], &head, &tail, &frame.tail].concat();
            let read = GdsLibrary::from_bytes(&whole).unwrap();
            assert_eq!(read.structs[0].name, name);
            assert_eq!(tail, [0, 4, 7, 0]);
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
