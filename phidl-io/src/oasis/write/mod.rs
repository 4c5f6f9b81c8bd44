//! A [`Layout`] into a file.
//!
//! Strings are collected first, so that records refer to all of them by number and the tables stand in front of the cells.
//! Cells are encoded and deflated by several threads, in portions, and put into the file in their order: its bytes do not
//! depend on their number. Cell names come last, since each states where its cell begins.

mod blocks;
mod boxes;
mod cell;
mod frame;
mod groups;
mod modal;
mod options;
mod repeats;
mod strings;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use self::cell::Records;
use self::frame::Frame;
use self::strings::Tables;
use crate::error::Result;
use crate::model::{Corner, Layout, Path};

pub use options::{EncodeOptions, OasisReport, Shapes, Validation};

/// As many cells are encoded before they are put into the file.
const PORTION: usize = 256;

/// The polygons of a path that the format cannot express, within 32 bits.
fn outlines(path: &Path) -> Vec<Vec<Corner>> {
    let corner = |[x, y]: [i64; 2]| Some([i32::try_from(x).ok()?, i32::try_from(y).ok()?]);
    let outlines = crate::model::outlines(path).into_iter();
    outlines.filter_map(|outline| outline.into_iter().map(corner).collect()).collect()
}

/// Encodes a layout as an OASIS file in strict mode: all names in tables whose offsets the last record states.
///
/// # Errors
/// [`IoError::Option`](crate::IoError::Option).
pub fn encode(layout: &Layout, options: &EncodeOptions) -> Result<(Vec<u8>, OasisReport)> {
    options.check()?;
    let (names, renamed) = frame::cell_names(layout);
    let tops: Vec<String> = layout.tops().into_iter().map(|top| names.name_of(layout, top)).collect();
    let mut tables = Tables::of(layout, &tops);
    tables.add_standard(options);
    let mut frame = Frame::begin(layout, options, &tables, &tops);
    let mut report = OasisReport { renamed, ..OasisReport::default() };
    for (portion, cells) in layout.cells.chunks(PORTION).enumerate() {
        let encoded = in_parallel(cells.len(), |index| {
            let records = cell::records(&cells[index], options, &tables, names.numbers());
            let mut bytes = Vec::with_capacity(records.bytes.len());
            let blocks = compressed(&records, options, &mut bytes);
            (records.without_bytes(), bytes, blocks)
        });
        for (index, (records, bytes, blocks)) in encoded.into_iter().enumerate() {
            let cell = portion * PORTION + index;
            frame.cell(names.numbers()[layout.cells[cell].name.index()], &bytes);
            report.cells.push(names.name_of(layout, cell));
            report.add(&records, blocks);
        }
    }
    let bytes = frame.end(layout, options, &tables, &names);
    report.bytes = bytes.len() as u64;
    Ok((bytes, report))
}

impl OasisReport {
    fn add(&mut self, records: &Records, blocks: u64) {
        self.records += records.records;
        self.repeats_merged += records.repeats_merged;
        self.labels_simplified += records.labels_simplified;
        self.paths_outlined += records.paths_outlined;
        self.left_out += records.left_out;
        self.blocks += blocks;
    }
}

/// The records of a cell as blocks, if that is asked for. Returns how many blocks they are.
fn compressed(records: &Records, options: &EncodeOptions, out: &mut Vec<u8>) -> u64 {
    if !options.compress {
        out.extend_from_slice(&records.bytes);
        return 0;
    }
    let ends = records.cuts.iter().copied().chain([records.bytes.len()]);
    let mut start = 0;
    let mut blocks = 0;
    for end in ends {
        blocks += u64::from(blocks::append(&records.bytes[start..end], options.level, out));
        start = end;
    }
    blocks
}

/// The results of `work` for all indices, computed by as many threads as the machine has.
fn in_parallel<T: Send + Sync>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(count);
    if threads < 2 {
        return (0..count).map(work).collect();
    }
    let results: Vec<OnceLock<T>> = (0..count).map(|_| OnceLock::new()).collect();
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(result) = results.get(index) else { return };
                    let _ = result.set(work(index));
                }
            });
        }
    });
    results.into_iter().map(|result| result.into_inner().expect("invariant: every index was worked on")).collect()
}
