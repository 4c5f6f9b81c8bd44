//! gzip, in and out.
//!
//! All members of a file are read, one after the other; lengths and checksums are looked at. What is written is one member
//! without name and time, so that the same layout gives the same bytes.

use std::io::{Read, Write};

use flate2::bufread::GzDecoder;
use flate2::{Compression, GzBuilder};

use crate::error::{IoError, Result};

/// The byte that stands for an unknown system in the head of a member.
const UNKNOWN_SYSTEM: u8 = 255;

/// Inflates all members of a file. More than `most` bytes are refused before they are there. Bytes after the last member
/// that are not zero are counted.
pub(super) fn inflate(bytes: &[u8], file: &str, most: u64) -> Result<(Vec<u8>, usize)> {
    let mut all = Vec::new();
    let mut rest = bytes;
    while rest.starts_with(&[0x1f, 0x8b]) {
        let offset = bytes.len() - rest.len();
        let mut member = GzDecoder::new(rest);
        // One byte more than is allowed, to tell a file that is too large from one that just fits.
        let left = most.saturating_sub(all.len() as u64).saturating_add(1);
        let read = (&mut member).take(left).read_to_end(&mut all);
        if all.len() as u64 > most {
            return Err(malformed(file, offset, format!("the file holds more than {most} inflated bytes")));
        }
        read.map_err(|error| malformed(file, offset, format!("the gzip member that begins here is damaged: {error}")))?;
        rest = member.into_inner();
    }
    let trailing = if rest.iter().all(|byte| *byte == 0) { 0 } else { rest.len() };
    Ok((all, trailing))
}

fn malformed(file: &str, offset: usize, problem: String) -> IoError {
    IoError::Malformed { file: file.into(), offset, cell: None, problem: problem.into() }
}

/// Some bytes as a gzip file of one member.
pub(super) fn deflate(bytes: &[u8], level: u32) -> Vec<u8> {
    let head = GzBuilder::new().mtime(0).operating_system(UNKNOWN_SYSTEM);
    let mut encoder = head.write(Vec::with_capacity(bytes.len() / 4), Compression::new(level));
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.expect("invariant: writing into memory does not fail")
}
