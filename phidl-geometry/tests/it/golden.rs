//! Every shape against its reference results.

use phidl_core::prelude::*;
use phidl_core::runtime::registry;
use testkit::golden::{Case, Kind, assert_all, assert_differences_are_needed, load};

fn draw(case: &Case) -> Result<Device> {
    registry::find(&case.device)?.build(&case.values())
}

#[test]
fn shapes_are_those_of_the_reference() {
    assert_all(&load(Kind::Geometry), draw);
}

/// Of the project's own cases: other reference results need not have them all.
#[test]
fn deliberate_differences_are_needed_or_for_further_cases() {
    if std::env::var_os("PHIDL_GOLDEN").is_none() {
        let shapes: Vec<&str> = registry::all().map(|entry| entry.name).chain(["*"]).collect();
        assert_differences_are_needed(&load(Kind::Geometry), &shapes, draw);
    }
}
