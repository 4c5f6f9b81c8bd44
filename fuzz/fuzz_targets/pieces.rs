//! Opening holes and cutting any region.
#![no_main]

#[expect(dead_code, reason = "each target tests one law")]
#[path = "../../phidl-boolean/tests/it/check.rs"]
mod check;
#[expect(dead_code, reason = "each target tests one law")]
#[path = "../../phidl-boolean/tests/it/fuzzed.rs"]
mod fuzzed;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::parts_lose_nothing(bytes));
