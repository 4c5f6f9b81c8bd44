//! Reading any bytes as an OASIS file.
#![no_main]

#[path = "../../phidl-io/tests/it/fuzzed_oasis.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::an_oasis_file_is_a_layout_or_an_error(bytes));
