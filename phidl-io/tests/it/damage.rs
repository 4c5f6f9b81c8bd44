//! Damaged files: an error or a device, never a panic.

use std::fs;
use std::path::Path;

use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use proptest::prelude::any;
use proptest::proptest;

use crate::fuzzed::reading_is_a_device_or_an_error;

/// A small file with one of each kind of element.
fn sample() -> Vec<u8> {
    let mut d = Device::builder("dot");
    d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], 1).with_property(3, "text"));
    let dot = d.build().unwrap();
    let mut d = Device::builder("top");
    d.add(dot.place().rotated(33).with_property(4, "x"));
    d.add(dot.array(3, 2, (5, 5)).mirrored((0, 0), (1, 0)));
    d.add(Label::new("label", (1, 1), 2).rotated(90));
    gds::to_bytes(&d.build().unwrap(), &GdsOptions::default()).unwrap()
}

#[test]
fn a_file_that_is_cut_off_anywhere_is_an_error() {
    let sample = sample();
    for length in 0..sample.len() {
        assert!(gds::read_bytes(&sample[..length], &ReadOptions::default()).is_err(), "{length}");
    }
    assert!(gds::read_bytes(&sample, &ReadOptions::default()).is_ok());
}

#[test]
fn what_follows_the_library_is_padding() {
    let padded = [sample(), vec![0; 2048]].concat();
    assert!(gds::read_bytes(&padded, &ReadOptions::default()).is_ok());
}

#[test]
fn any_byte_may_be_any_other() {
    let sample = sample();
    for index in 0..sample.len() {
        for value in [0, 1, 2, 4, 5, 7, 8, 0x11, 0x7f, 0x80, 0xff] {
            let mut damaged = sample.clone();
            damaged[index] = value;
            reading_is_a_device_or_an_error(&damaged);
        }
    }
}

#[test]
fn bytes_that_the_fuzzer_kept_are_a_device_or_an_error() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds/gds");
    let files = fs::read_dir(&folder).unwrap().map(|file| fs::read(file.unwrap().path()).unwrap());
    assert!(files.map(|bytes| reading_is_a_device_or_an_error(&bytes)).count() > 0, "{} is empty", folder.display());
}

proptest! {
    #[test]
    fn several_bytes_may_be_any_others(changes in proptest::collection::vec((any::<proptest::sample::Index>(), any::<u8>()), 1..12)) {
        let mut damaged = sample();
        for (place, value) in changes {
            let place = place.index(damaged.len());
            damaged[place] = value;
        }
        reading_is_a_device_or_an_error(&damaged);
    }

    #[test]
    fn any_bytes_are_no_reason_to_panic(bytes in proptest::collection::vec(any::<u8>(), 0..600)) {
        reading_is_a_device_or_an_error(&bytes);
    }
}
