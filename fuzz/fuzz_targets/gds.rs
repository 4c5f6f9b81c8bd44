//! Reading any bytes as a GDSII file.
#![no_main]

#[path = "../../phidl-io/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::reading_is_a_device_or_an_error(bytes));
