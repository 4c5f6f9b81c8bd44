//! Reading valid GDSII files with damaged records.
#![no_main]

#[path = "../../phidl-io/tests/it/damaged_records.rs"]
mod damaged_records;
#[path = "../../phidl-io/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|choices: &[u8]| {
    damaged_records::a_file_with_damaged_records_is_a_device_or_an_error(choices);
});
