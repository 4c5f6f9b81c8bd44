//! The picture of the stages in the docs shows the current engine.

use expect_test::expect_file;

#[path = "../../examples/support/mod.rs"]
mod drawing;

#[test]
fn the_picture_in_the_docs_shows_the_current_stages() {
    expect_file!["../../docs/stages.svg"].assert_eq(&drawing::picture());
}
