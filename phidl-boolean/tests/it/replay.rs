//! The laws of [`fuzzed`](crate::fuzzed) on bytes that the fuzzer found worth keeping, and on random ones.

use std::{fs, path::Path};

use proptest::prelude::*;

use crate::fuzzed;

/// Calls a law with every file that is kept for a fuzz target.
fn replay(target: &str, law: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds").join(target);
    let files = fs::read_dir(&folder).unwrap().map(|file| file.unwrap().path());
    let replayed = files.map(|file| law(&fs::read(file).unwrap())).count();
    assert!(replayed > 0, "{} is empty", folder.display());
}

#[test]
fn operations_on_kept_bytes_obey_set_algebra() {
    replay("region", fuzzed::operations_obey_set_algebra);
}

#[test]
fn offsets_of_kept_bytes_keep_their_side() {
    replay("offset", fuzzed::offsets_keep_their_side);
}

#[test]
fn parts_of_kept_bytes_lose_nothing() {
    replay("pieces", fuzzed::parts_lose_nothing);
}

fn any_bytes() -> impl Strategy<Value = Vec<u8>> {
    prop::collection::vec(any::<u8>(), 0..500)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn operations_on_any_bytes_obey_set_algebra(bytes in any_bytes()) {
        fuzzed::operations_obey_set_algebra(&bytes);
    }

    #[test]
    fn offsets_of_any_bytes_keep_their_side(bytes in any_bytes()) {
        fuzzed::offsets_keep_their_side(&bytes);
    }

    #[test]
    fn parts_of_any_bytes_lose_nothing(bytes in any_bytes()) {
        fuzzed::parts_lose_nothing(&bytes);
    }
}
