//! Damaged files: an error or a device, never a panic.

use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use proptest::prelude::any;
use proptest::proptest;

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

fn try_to_read(bytes: &[u8]) {
    match gds::read_bytes(bytes, &ReadOptions::default()) {
        // What can be read can be looked at.
        Ok(import) => assert!(import.device.bbox().is_none_or(|b| b.min.is_finite() && b.max.is_finite())),
        Err(error) => assert!(!error.in_full().is_empty()),
    }
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
    for place in 0..sample.len() {
        for value in [0, 1, 2, 4, 5, 7, 8, 0x11, 0x7f, 0x80, 0xff] {
            let mut damaged = sample.clone();
            damaged[place] = value;
            try_to_read(&damaged);
        }
    }
}

proptest! {
    #[test]
    fn several_bytes_may_be_any_others(changes in proptest::collection::vec((any::<proptest::sample::Index>(), any::<u8>()), 1..12)) {
        let mut damaged = sample();
        for (place, value) in changes {
            let place = place.index(damaged.len());
            damaged[place] = value;
        }
        try_to_read(&damaged);
    }

    #[test]
    fn any_bytes_are_no_reason_to_panic(bytes in proptest::collection::vec(any::<u8>(), 0..600)) {
        try_to_read(&bytes);
    }
}
