//! CBLOCK records: a part of the file, deflated.

use flate2::{Decompress, FlushDecompress, Status};

use super::super::cursor::{Cursor, Fault, Result};

/// Deflate makes at most 1032 bytes of one (258 bytes of two bits), so a larger claim is false before it is tried.
const MOST_RATIO: usize = 1032;

/// Reads the rest of a CBLOCK record: its inflated bytes. They count towards `budget`.
pub(super) fn inflate(cursor: &mut Cursor<'_>, budget: &mut u64) -> Result<Vec<u8>> {
    let start = cursor.position();
    let method = cursor.unsigned()?;
    if method != 0 {
        return Err(Fault::new(start, format!("a compressed block uses method {method}, but only 0 (deflate) exists")));
    }
    let stated = cursor.unsigned()?;
    let length = cursor.count("compressed bytes")?;
    let deflated = cursor.take(length)?;
    let possible = |stated: &usize| *stated <= length.saturating_mul(MOST_RATIO);
    let Some(size) = usize::try_from(stated).ok().filter(possible) else {
        let problem = format!("a compressed block states {stated} bytes, which {length} deflated bytes cannot hold");
        return Err(Fault::new(start, problem));
    };
    *budget = budget.checked_sub(stated).ok_or_else(|| {
        Fault::new(start, "the compressed blocks of the file hold more than the option max_bytes allows")
    })?;
    let mut inflated = vec![0; size];
    let mut stream = Decompress::new(false);
    let status = stream.decompress(deflated, &mut inflated, FlushDecompress::Finish);
    let bad = |problem: String| Err(Fault::new(start, problem));
    match status {
        Ok(Status::StreamEnd) if stream.total_out() == stated && stream.total_in() == length as u64 => Ok(inflated),
        Ok(Status::StreamEnd) if stream.total_out() == stated => {
            let used = stream.total_in();
            bad(format!("a compressed block ends after {used} of its {length} deflated bytes"))
        }
        Ok(Status::StreamEnd) => {
            let found = stream.total_out();
            bad(format!("a compressed block holds {found} bytes, but its record states {stated}"))
        }
        Ok(Status::Ok | Status::BufError) => {
            bad(format!("a compressed block does not end within its {length} deflated and {stated} inflated bytes"))
        }
        Err(error) => bad(format!("a compressed block cannot be inflated: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stored block of raw deflate (RFC 1951, section 3.2.4).
    fn stored(content: &[u8]) -> Vec<u8> {
        let length = u16::try_from(content.len()).unwrap();
        [&[1][..], &length.to_le_bytes(), &(!length).to_le_bytes(), content].concat()
    }

    fn block(stated: u8, deflated: &[u8]) -> Vec<u8> {
        [&[0, stated, u8::try_from(deflated.len()).unwrap()][..], deflated].concat()
    }

    fn read(bytes: &[u8]) -> Result<Vec<u8>> {
        inflate(&mut Cursor::of_file(bytes), &mut 1000)
    }

    #[test]
    fn a_block_holds_what_was_deflated() {
        assert_eq!(read(&block(5, &stored(b"hello"))).unwrap(), b"hello");
        assert_eq!(read(&block(0, &stored(b""))).unwrap(), b"");
    }

    #[test]
    fn blocks_that_do_not_keep_their_numbers_are_faults() {
        let hello = stored(b"hello");
        let long = [&hello[..], &[0]].concat();
        let cut = &hello[..hello.len() - 1];
        for (stated, deflated) in [(4, &hello[..]), (6, &hello), (5, &long), (5, cut), (5, &[7, 7, 7])] {
            assert!(read(&block(stated, deflated)).is_err(), "{stated} {deflated:02x?}");
        }
        let method = [&[1][..], &block(5, &hello)[1..]].concat();
        assert!(read(&method).unwrap_err().problem().contains("method 1"));
    }

    #[test]
    fn a_block_cannot_ask_for_more_than_its_bytes_can_hold_or_than_is_allowed() {
        let claim = [0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f, 2, 3, 0];
        assert!(read(&claim).unwrap_err().problem().contains("cannot hold"));
        let mut budget = 4;
        let bytes = block(5, &stored(b"hello"));
        assert!(inflate(&mut Cursor::of_file(&bytes), &mut budget).unwrap_err().problem().contains("max_bytes"));
    }
}
