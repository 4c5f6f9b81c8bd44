//! The front of all layout formats: recognized formats, gzip, several top cells, conversions.

use std::io::Write;
use std::path::Path;

use flate2::{Compression, GzBuilder};
use phidl_core::prelude::*;
use phidl_io::IoError;
use phidl_io::gds::GdsOptions;
use phidl_io::layout::{self, ConvertOptions, Detected, Format, ReadOptions, WriteOptions, detect};
use phidl_io::model::{PathEnd, ProblemKind};

const ENDINGS: [(&str, Format, bool); 4] = [
    ("gds", Format::Gds, false),
    ("oas", Format::Oasis, false),
    ("gds.gz", Format::Gds, true),
    ("OAS.GZ", Format::Oasis, true),
];

/// A cell with polygons, labels, properties, references and arrays on the grid.
fn chip() -> Device {
    let mut d = Device::builder("dot");
    d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], (3, 7)).with_property(3, "text"));
    d.add_polygon(Rect::new((2, 2), (5, 4)), 1).unwrap();
    let dot = d.build().unwrap();
    let mut d = Device::builder("chip");
    d.add(dot.place().rotated(33).moved_by((7, 8)).with_property(4, "x"));
    d.add(dot.array(3, 2, (10, 20)).mirrored((0, 0), (1, 0)));
    d.add(Label::new("first\nsecond", (1, 1), 2).rotated(90).anchored(Anchor::SouthEast));
    d.build().unwrap()
}

/// What a device draws, in an order that does not depend on that of its elements.
fn drawn(device: &Device) -> Vec<String> {
    let mut lines = Vec::new();
    for cell in device.cells() {
        let name = cell.name();
        lines.extend(cell.polygons().map(|p| {
            let properties: Vec<_> = p.properties().collect();
            format!("{name} {} {:.6} {properties:?}", p.layer, p.area())
        }));
        lines.extend(cell.labels().iter().map(|label| format!("{name} {label:?}")));
        lines.extend(cell.references().iter().map(|reference| {
            format!(
                "{name} {} {:?} {:?} {:?}",
                reference.device().name(),
                reference.transform(),
                reference.array(),
                reference.properties
            )
        }));
    }
    lines.sort();
    lines
}

fn written(folder: &Path, ending: &str) -> std::path::PathBuf {
    let path = folder.join(format!("chip.{ending}"));
    layout::write(&chip(), &path, &WriteOptions::default()).unwrap();
    path
}

#[test]
fn all_formats_hold_the_same_and_are_told_by_their_content() {
    let folder = tempfile::tempdir().unwrap();
    for (ending, format, gzip) in ENDINGS {
        let path = written(folder.path(), ending);
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(detect(&bytes), Some(if gzip { Detected::Gzip } else { Detected::Layout(format) }));
        // The name does not count on reading.
        let renamed = folder.path().join("name.without.meaning");
        std::fs::copy(&path, &renamed).unwrap();
        let import = layout::read(&renamed, &ReadOptions::default()).unwrap();
        assert_eq!((import.format, import.problems, import.grid), (format, Vec::new(), 1e-3));
        assert_eq!(drawn(&import.device), drawn(&chip()), "{ending}");
    }
}

#[test]
fn gdsii_to_oasis_and_back_has_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), "gds");
    let (_, first) = layout::read_layout(&path, &ReadOptions::default()).unwrap();
    let keep = |layout: &layout::Layout, format| layout::encode(layout, format, &WriteOptions::default()).unwrap().0;
    let oasis = keep(&first, Format::Oasis);
    let (_, mut back) = layout::decode(&oasis, "test", &ReadOptions::default()).unwrap();
    // OASIS has no names of libraries and no dates.
    (back.name, back.modified) = (first.name.clone(), first.modified);
    for (cell, other) in back.cells.iter_mut().zip(&first.cells) {
        cell.modified = other.modified;
    }
    let (_, again) = layout::decode(&keep(&back, Format::Gds), "test", &ReadOptions::default()).unwrap();
    assert_eq!(again.cells.len(), first.cells.len());
    for (a, b) in first.cells.iter().zip(&again.cells) {
        let layers = |cell: &phidl_io::model::Cell| {
            let mut all: Vec<_> = cell.polygons.iter().map(|p| (p.layer, p.corners.len())).collect();
            all.sort_unstable();
            all
        };
        assert_eq!(layers(a), layers(b));
        assert_eq!(a.texts.len(), b.texts.len());
        for (a, b) in a.texts.iter().zip(&b.texts) {
            assert_eq!(
                (&a.string, a.anchor, a.rotation, a.magnification),
                (&b.string, b.anchor, b.rotation, b.magnification)
            );
        }
    }
}

fn member(content: &[u8]) -> Vec<u8> {
    let mut encoder = GzBuilder::new().filename("name").mtime(7).write(Vec::new(), Compression::fast());
    encoder.write_all(content).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn gzip_files_may_have_several_members_and_are_checked() {
    let bytes = layout::to_bytes(&chip(), Format::Gds, &WriteOptions::default()).unwrap();
    let (head, tail) = bytes.split_at(bytes.len() / 3);
    let three = [member(head), member(b""), member(tail)].concat();
    let read = |bytes: &[u8]| layout::read_bytes(bytes, &ReadOptions::default());
    assert_eq!(drawn(&read(&three).unwrap().device), drawn(&chip()));
    let kinds = |bytes: &[u8]| read(bytes).unwrap().problems.into_iter().map(|p| p.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&[&three[..], &[0; 512]].concat()), []);
    assert_eq!(kinds(&[&three[..], b"more"].concat()), [ProblemKind::Trailing(4)]);
    let one = member(&bytes);
    for length in 0..one.len() {
        assert!(read(&one[..length]).is_err(), "{length}");
    }
    // Checksum and length stand in the last eight bytes.
    for index in one.len() - 8..one.len() {
        let mut damaged = one.clone();
        damaged[index] ^= 1;
        let error = read(&damaged).unwrap_err();
        assert!(matches!(error, IoError::Malformed { offset: 0, .. }), "{error}");
    }
    let nested = read(&member(&one)).unwrap_err().to_string();
    assert_eq!(nested, "these bytes: it is no layout file that phidl reads: it holds another gzip file");
}

#[test]
fn a_gzip_file_inflates_to_no_more_than_is_allowed() {
    let bomb = member(&vec![0; 1 << 22]);
    let options = ReadOptions { max_bytes: 1 << 20, ..ReadOptions::default() };
    let error = layout::read_bytes(&bomb, &options).unwrap_err().to_string();
    assert!(error.contains("more than 1048576 inflated bytes"), "{error}");
}

#[test]
fn a_file_that_is_no_layout_says_what_it_is() {
    let refused = |bytes: &[u8]| layout::read_bytes(bytes, &ReadOptions::default()).unwrap_err().to_string();
    let prefix = "these bytes: it is no layout file that phidl reads: ";
    assert_eq!(refused(b""), format!("{prefix}it is empty"));
    assert_eq!(refused(b"PK\x03\x04"), format!("{prefix}it begins with 50 4b 03 04"));
    assert_eq!(refused(b"<?xml?><layer-properties/>"), format!("{prefix}it holds layer properties (LYP)"));
    let error = layout::write(&chip(), "chip.txt", &WriteOptions::default()).unwrap_err().to_string();
    assert!(error.contains("the option path is \"chip.txt\"") && error.contains(".oas"), "{error}");
}

#[test]
fn several_top_cells_are_one_library_in_both_formats() {
    let folder = tempfile::tempdir().unwrap();
    let other = {
        let mut d = Device::builder("other");
        d.add_polygon(Rect::new((0, 0), (1, 1)), 9).unwrap();
        d.build().unwrap()
    };
    for ending in ["gds", "oas"] {
        let path = folder.path().join(format!("two.{ending}"));
        layout::write(&vec![chip(), other.clone()], &path, &WriteOptions::default()).unwrap();
        let library = layout::read_library(&path, &ReadOptions::default()).unwrap();
        let tops: Vec<&str> = library.tops.iter().map(|top| library.cells[*top].name()).collect();
        assert_eq!((tops, library.cells.len()), (vec!["chip", "other"], 3), "{ending}");
        assert!(matches!(layout::read(&path, &ReadOptions::default()), Err(IoError::SeveralTopCells { .. })));
        let one = ReadOptions { cellname: Some("other".into()), ..ReadOptions::default() };
        assert_eq!(drawn(&layout::read(&path, &one).unwrap().device), drawn(&other));
        let flat = ReadOptions { cellname: Some("chip".into()), flatten: true, ..ReadOptions::default() };
        let flat = layout::read(&path, &flat).unwrap().device;
        assert_eq!((flat.references().len(), flat.polygons().len()), (0, 14));
    }
}

#[test]
fn conversions_keep_paths_choose_cells_and_renumber_layers() {
    let folder = tempfile::tempdir().unwrap();
    let [gds, oas, back] = ["in.gds", "out.oas", "back.gds"].map(|name| folder.path().join(name));
    let mut file = phidl_io::model::Layout::new(phidl_core::num::grid::Grid::new(1e-3).unwrap());
    let [a, b, c] = ["a", "b", "c"].map(|name| file.names.intern(name));
    let path = phidl_io::model::Path {
        layer: Layer::new(1, 0),
        points: vec![[0, 0], [1000, 0], [1000, 700]],
        width: 100,
        fixed_width: false,
        start: PathEnd::Flush,
        end: PathEnd::Extended(30),
        properties: Default::default(),
        offset: 0,
    };
    let mut cell = phidl_io::model::Cell::new(a);
    cell.paths.push(path.clone());
    cell.polygons.push(Layer::new(2, 5), [[0, 0], [10, 0], [10, 10]]);
    cell.polygons.push(Layer::new(4, 0), [[0, 0], [10, 0], [10, 10]]);
    file.cells.push(cell);
    for (name, child) in [(b, a), (c, a)] {
        let mut cell = phidl_io::model::Cell::new(name);
        cell.placements.push(phidl_io::model::Placement::new(child));
        file.cells.push(cell);
    }
    layout::write_layout(&file, &gds, &WriteOptions::default()).unwrap();
    let options = ConvertOptions {
        read: ReadOptions { cellname: Some("b".into()), ..ReadOptions::default() },
        layers: Some("1, 2/5=20/6".parse().unwrap()),
        top_name: Some("renamed".into()),
        ..ConvertOptions::default()
    };
    let conversion = layout::convert(&gds, &oas, &options).unwrap();
    assert!(conversion.is_lossless());
    conversion.write(&oas).unwrap();
    layout::convert(&oas, &back, &ConvertOptions::default()).unwrap().write(&back).unwrap();
    let (format, found) = layout::read_layout(&back, &ReadOptions::default()).unwrap();
    assert_eq!(format, Format::Gds);
    let names: Vec<&str> = found.cells.iter().map(|cell| found.names.name(cell.name)).collect();
    assert_eq!(names, ["a", "renamed"]);
    assert_eq!(found.cells[0].polygons.iter().map(|p| p.layer).collect::<Vec<_>>(), [Layer::new(20, 6)]);
    let [kept] = &found.cells[0].paths[..] else { panic!("one path") };
    assert_eq!(
        (&kept.points, kept.width, kept.start, kept.end),
        (&path.points, 100, PathEnd::Flush, PathEnd::Extended(30))
    );
    assert!(layout::convert(&gds, &gds, &ConvertOptions::default()).is_err());
    let flat = ConvertOptions {
        read: ReadOptions { flatten: true, ..Default::default() },
        grid: Some(5e-3),
        ..Default::default()
    };
    layout::convert(&oas, &back, &flat).unwrap().write(&back).unwrap();
    let import = layout::read(&back, &ReadOptions::default()).unwrap();
    assert_eq!((import.grid, import.device.references().len(), import.device.polygons().len()), (5e-3, 0, 2));
}

#[test]
fn a_file_is_counted_without_being_expanded() {
    let dot = {
        let mut d = Device::builder("dot");
        d.add_polygon(Rect::new((0, 0), (1, 1)), 1).unwrap();
        d.build().unwrap()
    };
    let mut d = Device::builder("top");
    d.add(dot.array(1000, 1000, (2, 2)));
    d.add_label("here", (0, 0), (5, 1)).unwrap();
    let top = d.build().unwrap();
    for format in [Format::Gds, Format::Oasis] {
        let bytes = layout::to_bytes(&top, format, &WriteOptions::default()).unwrap();
        let found = layout::inspect_bytes(&bytes, &ReadOptions::default(), false).unwrap();
        assert_eq!((found.format, found.tops.as_slice(), found.cells.len()), (format, &["top".to_owned()][..], 2));
        let layer = &found.layers[&Layer::new(1, 0)];
        assert_eq!((layer.polygons, layer.vertices, layer.area, layer.merged_area), (1_000_000, 4_000_000, 1e6, None));
        assert_eq!(found.layers[&Layer::new(5, 1)].labels, 1);
        let dot = &found.cells[0];
        assert_eq!((dot.name.as_str(), dot.polygons, dot.vertices, dot.placed), ("dot", 1, 4, 1));
        assert_eq!(found.cells[1].bbox.unwrap(), top.bbox().unwrap());
        let json = found.to_json();
        assert_eq!(
            (&json["format"]["name"], &json["layers"]["1/0"]["polygons"]),
            (&format.to_string().into(), &1_000_000.into())
        );
        assert!(found.to_string().contains("1000000"));
    }
    let few =
        layout::to_bytes(&chip(), Format::Oasis, &WriteOptions { gds: GdsOptions::default(), ..Default::default() })
            .unwrap();
    let found = layout::inspect_bytes(&few, &ReadOptions::default(), true).unwrap();
    // One of the seven rectangles is turned by 33°, and its corners are rounded to 1e-4 µm.
    let area = found.layers[&Layer::new(1, 0)].merged_area.unwrap();
    assert!((area - 7.0 * 6.0).abs() < 10.0 * 1e-4, "{area}");
}
