//! Files on the disk, and errors that name them.

use phidl_core::prelude::*;
use phidl_io::gds::{self, FileLimits, GdsOptions, ReadOptions};
use phidl_io::{IoError, Item};

fn cell(edit: impl FnOnce(&mut DeviceBuilder)) -> Device {
    let mut d = Device::builder("chip");
    edit(&mut d);
    d.build().unwrap()
}

fn triangle(name: &str) -> Device {
    let mut d = Device::builder(name);
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.build().unwrap()
}

#[test]
fn a_refused_device_leaves_the_old_file_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("chip.gds");
    gds::write(&triangle("a"), &path, &GdsOptions::default()).unwrap();
    let before = std::fs::read(&path).unwrap();
    let far = cell(|d| {
        d.add_polygon([(0, 0), (3_000_000, 0), (0, 1)], 1).unwrap();
    });
    let error = gds::write(&far, &path, &GdsOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "cell \"chip\", polygon 0 on 1/0: coordinate 3000000 µm is outside the grid, which reaches ±2147483.647 µm in \
         steps of 0.001 µm"
    );
    assert_eq!(std::fs::read(&path).unwrap(), before);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn what_the_format_cannot_say_is_refused_with_cell_and_element() {
    let write = |device: &Device, options: &GdsOptions| gds::to_bytes(device, options).unwrap_err();
    let manual = GdsOptions { limits: FileLimits::MANUAL, ..GdsOptions::default() };
    let text = cell(|d| {
        d.add_label("5 µm", (0, 0), 1).unwrap();
    });
    assert!(
        matches!(write(&text, &manual), IoError::Refused { item, .. } if matches!(*item, Item::Label { index: 0, .. }))
    );
    let layer = cell(|d| {
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 300).unwrap();
    });
    assert!(matches!(write(&layer, &manual), IoError::Refused { what: "layer", .. }));
    let property = cell(|d| {
        d.add(triangle("a").place().with_property(200, "x"));
    });
    assert!(matches!(write(&property, &manual), IoError::Refused { what: "property attribute", .. }));
    let tiny = cell(|d| {
        d.add(Reference::new(triangle("a"), Transform::scaling(1e-80)));
    });
    assert!(matches!(write(&tiny, &GdsOptions::default()), IoError::Refused { what: "magnification", .. }));
    let far = cell(|d| {
        d.add(triangle("a").place().moved_by((1e9, 0)));
    });
    assert!(
        matches!(write(&far, &GdsOptions::default()), IoError::OutOfRange { item, .. } if matches!(*item, Item::Reference { .. }))
    );
}

#[test]
fn an_empty_mask_is_a_file_if_that_is_allowed() {
    let nothing = Device::builder("nothing").build().unwrap();
    let refused = gds::to_bytes(&nothing, &GdsOptions::default()).unwrap_err();
    assert_eq!(refused.to_string(), "cell \"nothing\": the mask is empty");
    let dust = cell(|d| {
        d.add_polygon([(0.0, 0.0), (1e-9, 0.0), (0.0, 1e-9)], 1).unwrap();
    });
    let refused = gds::to_bytes(&dust, &GdsOptions::default()).unwrap_err();
    assert_eq!(refused.to_string(), "cell \"chip\": the mask is empty: its only polygon encloses nothing on the grid");
    let options = GdsOptions { allow_empty: true, ..GdsOptions::default() };
    let bytes = gds::to_bytes(&nothing, &options).unwrap();
    let import = gds::read_bytes(&bytes, &ReadOptions::default()).unwrap();
    assert_eq!((import.device.name(), import.device.is_empty()), ("nothing", true));
}

#[test]
fn the_report_says_what_was_cut_and_left_out() {
    let device = cell(|d| {
        d.add_polygon([(0.0, 0.0), (1e-4, 0.0), (0.0, 1e-4)], 1).unwrap();
        d.add_polygon((0..100).map(|i| Point::polar(10.0, 3.6 * f64::from(i))).collect::<Vec<_>>(), 1).unwrap();
        d.add_polygon([(0, 0), (5, 0), (9, 0), (5, 0), (5, 5), (5, 5)], 1).unwrap();
        d.add(triangle("a").array(3, 3, (0.3333, 0.3333)));
        d.add(triangle("a").array(3, 3, (3, 3)));
    });
    let folder = tempfile::tempdir().unwrap();
    let options = GdsOptions { max_points: 40, ..GdsOptions::default() };
    let report = gds::write(&device, folder.path().join("a.gds"), &options).unwrap();
    let changes = (report.cut_polygons, report.collapsed_polygons, report.cleaned_polygons, report.arrays_taken_apart);
    assert_eq!(changes, (1, 1, 1, 1));
    assert_eq!(report.cells, ["a", "chip"]);
    assert_eq!(report.bytes, std::fs::metadata(folder.path().join("a.gds")).unwrap().len());
}

#[test]
fn any_cell_of_a_file_can_be_read_by_name() {
    let device = cell(|d| {
        d.add(triangle("a"));
    });
    let bytes = gds::to_bytes(&device, &GdsOptions::default()).unwrap();
    let read =
        |name: &str| gds::read_bytes(&bytes, &ReadOptions { cellname: Some(name.into()), ..ReadOptions::default() });
    assert_eq!(read("a").unwrap().device.name(), "a");
    match read("b") {
        Err(IoError::UnknownCell { name, cells, .. }) => {
            assert_eq!((&*name, cells), ("b", vec!["a".into(), "chip".into()]))
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let error = gds::read("no/such/file.gds", &ReadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("no/such/file.gds"), "{error}");
}

#[test]
fn what_a_placement_brings_out_of_range_is_refused_and_what_fits_is_written() {
    let far = |name: &str, child: &Device, transform: Transform| {
        let mut d = Device::builder(name);
        d.add(Reference::new(child.clone(), transform));
        d.build().unwrap()
    };
    let shift = |x: f64| Transform::translation(Point::new(x, 0.0));
    let inner = far("inner", &triangle("a"), shift(2_000_000.0));
    let refused = [
        far("nested", &inner, shift(200_000.0)),
        far("scaled", &inner, Transform::scaling(2.0)),
        cell(|d| {
            d.add(triangle("a").array(3000, 1, (1000, 1000)));
        }),
    ];
    for device in refused {
        let error = gds::to_bytes(&device, &GdsOptions::default()).unwrap_err();
        // The element of an array is a coordinate of the file itself.
        assert!(matches!(error, IoError::Extent(_) | IoError::OutOfRange { .. }), "{error}");
        assert!(error.to_string().contains(device.name()), "{error}");
    }
    let fits = [
        far("nested", &inner, shift(147_482.0)),
        far("turned", &far("corner", &triangle("a"), shift(2_147_482.0)), Transform::rotation(45.0)),
        far("back", &inner, shift(-2_147_483.648)),
    ];
    assert!(fits.iter().all(|device| gds::to_bytes(device, &GdsOptions::default()).is_ok()));
}

#[test]
fn a_file_is_read_flat_on_request() {
    let device = cell(|d| {
        d.add(triangle("a").array(3, 2, (5, 5)));
    });
    let bytes = gds::to_bytes(&device, &GdsOptions::default()).unwrap();
    let flat = gds::read_bytes(&bytes, &ReadOptions { flatten: true, ..ReadOptions::default() }).unwrap().device;
    assert_eq!((flat.references().len(), flat.polygons().len()), (0, 6));
}
