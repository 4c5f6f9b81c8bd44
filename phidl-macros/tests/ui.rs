//! What does not compile, and in which words; by theme in `ui/`.
//!
//! The wording of the compiler changes with its version, so these are pinned to `rust-toolchain.toml`. After a change,
//! run with `TRYBUILD=overwrite` and read the difference.

#[test]
fn what_is_right_compiles_and_what_is_wrong_is_told_under_the_guilty_token() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/pass/*.rs");
    cases.compile_fail("tests/ui/fail/*/*.rs");
}
