//! Every shape against its reference results.

use phidl_core::runtime::registry;
use testkit::golden::{Case, Kind, assert_all, compare_device, load};

#[test]
fn shapes_are_those_of_the_reference() {
    assert_all(&load(Kind::Geometry), |case| registry::find(&case.device)?.build(&case.values()));
}

/// The one shape whose points differ on purpose in every case can draw the others' too.
#[test]
fn meander_tapers_with_straight_sections_are_those_of_the_reference() {
    let mut cases: Vec<Case> = load(Kind::Geometry)
        .into_iter()
        .filter(|case| case.device == "meander_taper" && case.expect.get("error").is_none())
        .collect();
    for case in &mut cases {
        case.params.insert("straight_sections".to_owned(), true.into());
        let device = registry::find(&case.device).and_then(|entry| entry.build(&case.values())).expect("a taper");
        compare_device(&device, &case.expect).unwrap_or_else(|why| panic!("{}: {why}", case.id));
    }
}
