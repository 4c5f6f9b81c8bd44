//! What does not compile, and with which messages; by theme in `ui/`.
//!
//! The wording of the compiler changes with its version, so these are pinned to `rust-toolchain.toml`. After a change,
//! run with `TRYBUILD=overwrite` and read the difference.

#[test]
fn correct_code_compiles_and_mistakes_are_reported_at_their_token() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/pass/*.rs");
    cases.compile_fail("tests/ui/fail/*/*.rs");
}
