//! Every shape against its reference results.

use phidl_core::runtime::registry;
use serde_json::Value as Json;
use testkit::golden::{Case, Kind, assert_all, compare_device, load};

/// Cases of `geometry.json` whose shapes are not written yet are left to the change that writes them.
fn written() -> Vec<Case> {
    let is_written = |case: &Case| registry::find(&case.device).is_ok() && case.params.values().all(operand_is_written);
    load(Kind::Geometry).into_iter().filter(is_written).collect()
}

/// Whether a parameter that names a device names one that is written.
fn operand_is_written(param: &Json) -> bool {
    param.get("device").and_then(Json::as_str).is_none_or(|name| registry::find(name).is_ok())
}

#[test]
fn shapes_are_those_of_the_reference() {
    assert_all(&written(), |case| registry::find(&case.device)?.build(&case.values()));
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
