//! What stands around the cells: START, tables of names, END.

use std::collections::HashSet;

use phidl_core::layer::LayerSet;

use super::super::record::{self, standard};
use super::super::{checksum, encode};
use super::blocks;
use super::options::{EncodeOptions, Validation, is_name};
use super::strings::Tables;
use crate::model::Layout;

/// The longest cell name that readers take.
const LONGEST_NAME: usize = 1024;

/// The cell names of a file.
pub(super) struct CellNames {
    /// By the index of the name in the layout: the number in the file.
    numbers: Vec<u64>,
    /// By the number in the file.
    names: Vec<String>,
}

impl CellNames {
    pub(super) fn numbers(&self) -> &[u64] {
        &self.numbers
    }

    /// The name of a cell, by its index in the layout.
    pub(super) fn name_of(&self, layout: &Layout, cell: usize) -> String {
        self.names[self.number_of(layout, cell)].clone()
    }

    fn number_of(&self, layout: &Layout, cell: usize) -> usize {
        usize::try_from(self.numbers[layout.cells[cell].name.index()]).expect("invariant: a number of a name in memory")
    }
}

/// Numbers the cell names: cells first, in their order. Returns how many names had to be changed.
pub(super) fn cell_names(layout: &Layout) -> (CellNames, u64) {
    let mut order: Vec<usize> = layout.cells.iter().map(|cell| cell.name.index()).collect();
    let mut numbers = vec![u64::MAX; layout.names.len()];
    for (number, name) in order.iter().enumerate() {
        numbers[*name] = number as u64;
    }
    for (name, number) in numbers.iter_mut().enumerate() {
        if *number == u64::MAX {
            *number = order.len() as u64;
            order.push(name);
        }
    }
    let all: Vec<&str> = layout.names.iter().collect();
    let given: Vec<&str> = order.iter().map(|name| all[*name]).collect();
    let legal = |name: &str| is_name(name) && name.len() <= LONGEST_NAME;
    let mut taken: HashSet<String> = given.iter().filter(|name| legal(name)).map(|name| (*name).to_owned()).collect();
    let mut renamed = 0;
    let mut names = Vec::with_capacity(given.len());
    for name in given {
        if legal(name) {
            names.push(name.to_owned());
            continue;
        }
        renamed += 1;
        let base: String =
            name.chars().map(|c| if c.is_ascii_graphic() { c } else { '_' }).take(LONGEST_NAME - 24).collect();
        let base = if base.is_empty() { "_".to_owned() } else { base };
        let numbered = (2_u64..).map(|number| format!("{base}_{number}"));
        let free = std::iter::once(base.clone()).chain(numbered).find(|name| !taken.contains(name));
        let name = free.expect("invariant: among endless numbers, one is free");
        taken.insert(name.clone());
        names.push(name);
    }
    (CellNames { numbers, names }, renamed)
}

/// A file that is being put together.
pub(super) struct Frame {
    bytes: Vec<u8>,
    /// Where each table begins; 0 if there is none.
    tables: [u64; 6],
    /// Where each cell begins, by the number of its name.
    offsets: Vec<u64>,
}

impl Frame {
    /// Writes everything before the cells.
    pub(super) fn begin(layout: &Layout, options: &EncodeOptions, tables: &Tables<'_>, tops: &[String]) -> Self {
        let mut bytes = record::MAGIC.to_vec();
        encode::unsigned(record::START, &mut bytes);
        encode::string(b"1.0", &mut bytes);
        encode::real(1.0 / layout.grid.um(1), &mut bytes);
        // The offsets of the tables stand in END.
        bytes.push(1);
        for top in tops {
            property(tables, standard::TOP_CELL, &[15], Some(tables.property_strings.number(top)), &mut bytes);
        }
        if options.bounding_boxes {
            property(tables, standard::BOUNDING_BOXES_AVAILABLE, &[8], Some(1), &mut bytes);
        }
        let mut frame = Self { bytes, tables: [0; 6], offsets: Vec::new() };
        frame.table(2, options, |out| {
            tables.property_names.iter().for_each(|name| named(record::PROPNAME, name, out));
        });
        frame.table(3, options, |out| {
            tables.property_strings.iter().for_each(|name| named(record::PROPSTRING, name, out));
        });
        frame.table(1, options, |out| {
            tables.texts.iter().for_each(|name| named(record::TEXTSTRING, name, out));
        });
        frame.table(4, options, |out| {
            for layer in options.layers.iter().flat_map(LayerSet::iter) {
                for kind in [record::LAYERNAME, record::LAYERNAME_OF_TEXTS] {
                    named(kind, &layer.name, out);
                    for number in [layer.layer.number, layer.layer.datatype] {
                        out.push(3);
                        encode::unsigned(u64::from(number), out);
                    }
                }
            }
        });
        frame
    }

    fn table(&mut self, index: usize, options: &EncodeOptions, write: impl FnOnce(&mut Vec<u8>)) {
        let mut records = Vec::new();
        write(&mut records);
        if records.is_empty() {
            return;
        }
        self.tables[index] = self.bytes.len() as u64;
        if options.compress && records.len() <= blocks::MOST_BYTES {
            blocks::append(&records, options.level, &mut self.bytes);
        } else {
            self.bytes.extend_from_slice(&records);
        }
    }

    /// Appends a cell with its records.
    pub(super) fn cell(&mut self, number: u64, records: &[u8]) {
        self.offsets.push(self.bytes.len() as u64);
        encode::unsigned(record::CELL_BY_NUMBER, &mut self.bytes);
        encode::unsigned(number, &mut self.bytes);
        self.bytes.extend_from_slice(records);
    }

    /// Writes everything after the cells, and returns the file.
    pub(super) fn end(
        mut self,
        layout: &Layout,
        options: &EncodeOptions,
        tables: &Tables<'_>,
        names: &CellNames,
    ) -> Vec<u8> {
        let boxes = if options.bounding_boxes { super::boxes::of(layout) } else { Vec::new() };
        let offsets = std::mem::take(&mut self.offsets);
        self.table(0, options, |out| {
            for (number, name) in names.names.iter().enumerate() {
                named(record::CELLNAME, name, out);
                if let Some(Some(content)) = boxes.get(number) {
                    let mut values = Vec::new();
                    content.write(&mut values);
                    property_of(tables, standard::BOUNDING_BOX, 5, &values, out);
                }
                if let Some(offset) = offsets.get(number) {
                    property(tables, standard::CELL_OFFSET, &[8], Some(*offset), out);
                }
            }
        });
        self.last_record(options.validation)
    }

    fn last_record(mut self, validation: Validation) -> Vec<u8> {
        let mut end = Vec::with_capacity(record::END_LENGTH);
        encode::unsigned(record::END, &mut end);
        for offset in self.tables {
            end.push(1);
            encode::unsigned(offset, &mut end);
        }
        let tail = if validation == Validation::None { 1 } else { 5 };
        let rest = record::END_LENGTH - end.len() - tail;
        // The length of the padding takes one byte up to 127, then two. Offsets are too short for the case between.
        let padding = if rest <= 128 { rest - 1 } else { rest - 2 };
        encode::string(&vec![0; padding], &mut end);
        self.bytes.extend_from_slice(&end);
        self.bytes.push(match validation {
            Validation::None => 0,
            Validation::Crc32 => 1,
            Validation::Sum => 2,
        });
        let sum = match validation {
            Validation::None => return self.bytes,
            Validation::Crc32 => checksum::crc32(&self.bytes),
            Validation::Sum => checksum::sum32(&self.bytes),
        };
        self.bytes.extend_from_slice(&sum.to_le_bytes());
        self.bytes
    }
}

/// A record of a table, numbered by its position.
fn named(kind: u64, name: &str, out: &mut Vec<u8>) {
    encode::unsigned(kind, out);
    encode::string(name.as_bytes(), out);
}

/// A property of the standard with one value: its type, and a number.
fn property(tables: &Tables<'_>, name: &str, kind: &[u8], number: Option<u64>, out: &mut Vec<u8>) {
    let mut values = kind.to_vec();
    if let Some(number) = number {
        encode::unsigned(number, &mut values);
    }
    property_of(tables, name, 1, &values, out);
}

fn property_of(tables: &Tables<'_>, name: &str, count: u8, values: &[u8], out: &mut Vec<u8>) {
    encode::unsigned(record::PROPERTY, out);
    // Name by number, values, a name of the standard.
    out.push((count << 4) | 0b0111);
    encode::unsigned(tables.property_names.number(name), out);
    out.extend_from_slice(values);
}
