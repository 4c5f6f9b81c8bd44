//! `docs/differences.md`, made of `differences.toml`.

use super::differences::{Difference, differences};

const HEAD: &str = "# Differences from PHIDL

Names, parameters, ports and drawn points are those of PHIDL 1.7.2 (`route_basic`: 1.5.2), except for what stands here: where
PHIDL's behavior is wrong, ours does the right thing. \"Quirk\" is the word of the specification for such behavior. A script or a
mask that relies on one of these draws something else with phidl.

This page is made of `xtask/testkit/golden/differences.toml`, which the tests read.
";

/// The deliberate differences for readers, by function.
fn page() -> String {
    let mut page = HEAD.to_owned();
    let mut differences = differences();
    differences.sort_by_key(|difference| difference.function.list().join(", "));
    let mut function = String::new();
    for difference in differences {
        let names = difference.function.list();
        let title = if names == ["*"] { "every shape".to_owned() } else { format!("`{}`", names.join("`, `")) };
        if title != function {
            page += &format!("\n## {title}\n");
            function = title;
        }
        let Difference { condition, reason, instead, .. } = difference;
        let [reason, instead] = [&reason, &instead].map(|text| text.trim_end_matches('.'));
        page += &format!("\n- **{condition}**: {reason}.\n  Compared instead: {instead}.\n");
    }
    page
}

/// `UPDATE_EXPECT=1 cargo test -p testkit` writes the page anew.
#[test]
fn the_page_says_what_the_tests_read() {
    expect_test::expect_file!["../../../../docs/differences.md"].assert_eq(&page());
}
