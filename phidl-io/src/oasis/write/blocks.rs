//! Records of a cell as compressed blocks.

use flate2::{Compress, Compression, FlushCompress, Status};

use super::super::encode;
use super::super::record;

/// The most bytes of a block, inflated: KLayout before 2024-03 does not read larger ones.
pub(super) const MOST_BYTES: usize = 16 << 20;

/// The shortest run of bytes that is worth a try.
const LEAST_BYTES: usize = 32;

/// Appends records as a CBLOCK record, or as they are where that is shorter. Returns whether it is a block.
pub(super) fn append(records: &[u8], level: u32, out: &mut Vec<u8>) -> bool {
    if let Some(deflated) = deflate(records, level) {
        let mut head = vec![u8::try_from(record::CBLOCK).unwrap_or(0), 0];
        encode::unsigned(records.len() as u64, &mut head);
        encode::unsigned(deflated.len() as u64, &mut head);
        if head.len() + deflated.len() < records.len() {
            out.extend_from_slice(&head);
            out.extend_from_slice(&deflated);
            return true;
        }
    }
    out.extend_from_slice(records);
    false
}

/// The bytes as a raw deflate stream, if that is shorter.
fn deflate(bytes: &[u8], level: u32) -> Option<Vec<u8>> {
    if bytes.len() < LEAST_BYTES {
        return None;
    }
    let mut deflated = Vec::with_capacity(bytes.len());
    let mut stream = Compress::new(Compression::new(level), false);
    // The buffer is no longer than the bytes: what does not fit is not worth a block.
    let status = stream.compress_vec(bytes, &mut deflated, FlushCompress::Finish);
    matches!(status, Ok(Status::StreamEnd)).then_some(deflated)
}
