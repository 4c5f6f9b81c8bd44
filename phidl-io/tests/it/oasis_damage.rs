//! Damaged OASIS files: an error or a layout, never a panic.

use std::fs;
use std::path::Path;

use phidl_io::oasis::{DecodeOptions, EncodeOptions, decode, encode};
use proptest::prelude::any;
use proptest::proptest;

use crate::fuzzed_oasis::an_oasis_file_is_a_layout_or_an_error;
use crate::oasis::layout;

/// A small file with each kind of element; compressed, or as it is.
fn sample(compress: bool) -> Vec<u8> {
    encode(&layout(), &EncodeOptions { compress, ..Default::default() }).unwrap().0
}

#[test]
fn an_oasis_file_that_is_cut_off_anywhere_is_an_error() {
    for compress in [true, false] {
        let sample = sample(compress);
        for length in 0..sample.len() {
            assert!(decode(&sample[..length], "test", &DecodeOptions::default()).is_err(), "{length}");
        }
    }
}

#[test]
fn any_byte_of_an_oasis_file_may_be_any_other() {
    for compress in [true, false] {
        let sample = sample(compress);
        for index in 0..sample.len() {
            for value in [0, 1, 0x7f, 0x80, 0xff, sample[index] ^ 1, sample[index] ^ 0x10] {
                let mut damaged = sample.clone();
                damaged[index] = value;
                an_oasis_file_is_a_layout_or_an_error(&damaged);
            }
        }
    }
}

#[test]
fn oasis_seeds_of_the_fuzzer_are_a_layout_or_an_error() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds/oasis");
    let files = fs::read_dir(&folder).unwrap().map(|file| fs::read(file.unwrap().path()).unwrap());
    assert!(
        files.map(|bytes| an_oasis_file_is_a_layout_or_an_error(&bytes)).count() > 0,
        "{} is empty",
        folder.display()
    );
}

proptest! {
    #[test]
    fn several_bytes_of_an_oasis_file_may_be_any_others(
        changes in proptest::collection::vec((any::<proptest::sample::Index>(), any::<u8>()), 1..12),
        compress in any::<bool>(),
    ) {
        let mut damaged = sample(compress);
        for (index, value) in changes {
            let index = index.index(damaged.len());
            damaged[index] = value;
        }
        an_oasis_file_is_a_layout_or_an_error(&damaged);
    }

    /// Any records after a valid beginning.
    #[test]
    fn any_records_are_no_reason_to_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        an_oasis_file_is_a_layout_or_an_error(&crate::oasis::file(&[&[14, 1, b'A'], &bytes]));
    }
}
