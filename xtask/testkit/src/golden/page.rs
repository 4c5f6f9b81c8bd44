//! `docs/differences.md`, generated from the table of differences.

use super::differences::differences;

const HEAD: &str = "# Differences from PHIDL

Names, parameters, ports and drawn points are those of PHIDL 1.7.2 (`route_basic`: 1.5.2), except for what this page lists:
where PHIDL's behavior is wrong, ours is right. A script or a mask that relies on one of these draws something else with
phidl. Devices of phidl may record more info than PHIDL's. \"Compared instead\" says what the tests check in such a case.

This page is generated from the table in `xtask/testkit/src/golden/differences`, which the tests read.
";

/// The deliberate differences for readers, by function.
fn page() -> String {
    let mut page = HEAD.to_owned();
    let mut table = differences();
    table.sort_by_key(|difference| difference.functions);
    let mut functions: &[&str] = &[];
    for difference in table {
        if difference.functions != functions {
            functions = difference.functions;
            let title =
                if functions == ["*"] { "every shape".to_owned() } else { format!("`{}`", functions.join("`, `")) };
            page += &format!("\n## {title}\n");
        }
        let (condition, reason, instead) = (difference.condition, difference.reason, difference.instead);
        page += &format!("\n- **{condition}**: {reason}.\n  Compared instead: {instead}.\n");
    }
    page
}

/// `UPDATE_EXPECT=1 cargo test -p testkit` updates the page.
#[test]
fn the_page_lists_what_the_tests_read() {
    expect_test::expect_file!["../../../../docs/differences.md"].assert_eq(&page());
}
