//! The gallery and the listing of the libraries' own devices.

use std::collections::BTreeSet;

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_io::cli::{devices, first_paragraph, gallery};
use phidl_io::gds::{self, GdsOptions, ReadOptions};

use super::plates;

/// What a generator draws and labels must be what a file can say: a sweep labels its cells in several lines.
#[test]
fn every_plate_can_be_written_to_a_file_and_read_back() {
    for plate in plates(|_| {}).unwrap() {
        let bytes = gds::to_bytes(&plate.device, &GdsOptions { allow_empty: true, ..GdsOptions::default() });
        let bytes = bytes.unwrap_or_else(|error| panic!("{}: {}", plate.name, error.report()));
        let back = gds::read_bytes(&bytes, &ReadOptions::default()).unwrap();
        assert_eq!(back.problems, [], "{}", plate.name);
        let texts = |device: &Device| -> BTreeSet<String> {
            device.cells().iter().flat_map(|cell| cell.labels().iter().map(|label| label.text.clone())).collect()
        };
        assert_eq!(texts(&back.device), texts(&plate.device), "{}", plate.name);
    }
}

#[test]
fn every_device_is_on_the_page_with_both_calls() {
    let plates = plates(|_| {}).unwrap();
    let page = gallery::html(&plates, "cargo xtask");
    for plate in &plates {
        assert!(page.contains(&format!("<article id=\"{}\">", plate.name)), "{}", plate.name);
        assert!(page.contains(&plate.figure), "{}", plate.name);
        assert!(
            page.contains(&plate.rust.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")),
            "{}",
            plate.name
        );
    }
}

#[test]
fn calls_by_name_draw_what_the_example_draws() {
    for plate in plates(|_| {}).unwrap() {
        let params = serde_json::from_str(&plate.json).unwrap();
        let again = registry::find(plate.name).unwrap().build(&params).unwrap();
        assert_eq!(again.drawing_hash(), plate.device.drawing_hash(), "{}: {}", plate.name, plate.json);
    }
}

#[test]
fn no_listing_has_a_link_or_half_a_sentence() {
    for entry in registry::all() {
        let params = entry.params().into_iter().map(|param| first_paragraph(param.docs));
        for docs in std::iter::once(first_paragraph(entry.docs)).chain(params) {
            assert!(docs.ends_with('.') && !docs.contains("]("), "{}: {docs:?}", entry.name);
            assert!(devices::list(entry.name, false).unwrap().contains(&docs), "{}: {docs:?}", entry.name);
        }
    }
}
