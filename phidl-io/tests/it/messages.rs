//! All sentences of errors and problems, to be read by eye: each must be a grammatical sentence that is true of its case.

use std::path::Path;

use expect_test::expect;
use phidl_core::prelude::*;
use phidl_io::gds::{self, FileLimits, GdsOptions, ProblemKind, ReadOptions};
use phidl_io::model::{Cell, Layout, Problem};
use phidl_io::{IoError, atomic, json};

/// The sentences of all refusals, one a line.
fn report<T>(refusals: impl IntoIterator<Item = Result<T, IoError>>) -> String {
    let line = |refusal: Result<T, IoError>| match refusal {
        Ok(_) => "not refused".to_owned(),
        Err(error) => error.report(),
    };
    refusals.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

fn cell(edit: impl FnOnce(&mut DeviceBuilder)) -> Device {
    let mut d = Device::builder("chip");
    edit(&mut d);
    d.build().unwrap()
}

fn triangle() -> Device {
    let mut d = Device::builder("a");
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    d.build().unwrap()
}

#[test]
fn options() {
    let good = GdsOptions::default;
    let options = [
        GdsOptions { grid: 0.0, ..good() },
        GdsOptions { user_unit: f64::NAN, ..good() },
        GdsOptions { date: gds::Date::new(2000, 13, 1), ..good() },
        GdsOptions { max_cellname_length: 3, ..good() },
        GdsOptions { max_points: 8191, ..good() },
        GdsOptions { top_name: Some("a\u{1b}[31m".into()), ..good() },
        GdsOptions { library_name: String::new(), limits: FileLimits::MANUAL, ..good() },
    ];
    expect![[r#"
        the option grid is 0 µm, but it must be a positive length
        the option user_unit is NaN µm, but it must be a positive length
        the option date is 2000-13-01 00:00:00, but it must be a day of the calendar and a time of day
        the option max_cellname_length is 3, but it must be from 12 to 1024
        the option max_points is 8191, but it must be from 16 to 8190
        the option top_name is "a\u{1b}[31m", but it must be 1 to 1024 printable ASCII characters
        the option library_name is "", but it must be 1 to 32 of the characters A–Z, a–z, 0–9, _, ? and $"#]]
    .assert_eq(&report(options.map(|options| gds::to_bytes(&triangle(), &options))));
}

#[test]
fn elements_that_a_file_cannot_state() {
    let manual = GdsOptions { limits: FileLimits::MANUAL, ..GdsOptions::default() };
    let label = |text: &str| {
        cell(|d| {
            d.add_label(text, (0, 0), 1).unwrap();
        })
    };
    let strict = [
        label("5 µm"),
        label(&"x".repeat(600)),
        cell(|d| {
            d.add_polygon([(0, 0), (1, 0), (0, 1)], 300).unwrap();
        }),
        cell(|d| {
            d.add(triangle().place().with_property(200, "x"));
        }),
        cell(|d| {
            d.add(triangle().place().with_property(1, "x".repeat(127)));
        }),
    ];
    let refused = report(strict.iter().map(|device| gds::to_bytes(device, &manual)));
    let by_default = [
        label("a\0"),
        label(&"Ω".repeat(40_000)),
        cell(|d| {
            d.add(Reference::new(triangle(), Transform::scaling(1e-80)));
        }),
        cell(|d| {
            d.add(triangle().array(5000, 5000, (0.3333, 0.3333)));
        }),
        cell(|d| {
            d.add_polygon([(0, 0), (3_000_000, 0), (0, 1)], 1).unwrap();
        }),
        Device::builder("nothing").build().unwrap(),
        cell(|d| {
            d.add_polygon([(0.0, 0.0), (1e-9, 0.0), (0.0, 1e-9)], 1).unwrap();
        }),
    ];
    let refused =
        refused + "\n" + &report(by_default.iter().map(|device| gds::to_bytes(device, &GdsOptions::default())));
    expect![[r#"
        cell "chip", label 0 "5 µm": the text is "5 µm", but it must be of printable ASCII characters, without 'µ'
        cell "chip", label 0 "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…": the text is 600 bytes long, but it must have at most 512 bytes
        cell "chip", polygon 0 on 300/0: the layer is 300/0, but it must have numbers of at most 255
        cell "chip", reference 0 to "a": the property attribute is 200, but it must be from 1 to 127
        cell "chip", reference 0 to "a": the property is 127 bytes long, but it must have at most 126 bytes
        cell "chip", label 0 "a\0": the text is "a\0", but it must not end with a NUL character, which pads texts in files
        cell "chip", label 0 "ΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩΩ…": the text is 80000 bytes long, but it must have at most 65530 bytes
        cell "chip", reference 0 to "a": the magnification is 1e-80, but it must be from 1e-70 to 1e70
        cell "chip", reference 0 to "a": the array is of 25000000 elements that are not a lattice on the grid, but it must have at most 4194304 of these
        cell "chip", polygon 0 on 1/0: coordinate 3000000 µm is outside the grid, which reaches ±2147483.647 µm in steps of 0.001 µm
        cell "nothing": the mask is empty
        cell "chip": the mask is empty: its only polygon encloses nothing on the grid"#]].assert_eq(&refused);
}

/// A record: kind, data type, content.
fn record(kind: u8, data: u8, content: &[u8]) -> Vec<u8> {
    let length = u16::try_from(content.len() + 4).unwrap().to_be_bytes();
    [&length[..], &[kind, data], content].concat()
}

/// A library of these records, between its head and its end.
fn library(records: &[Vec<u8>]) -> Vec<u8> {
    let units = [0x3e, 0x41, 0x89, 0x37, 0x4b, 0xc6, 0xa7, 0xf0, 0x39, 0x44, 0xb8, 0x2f, 0xa0, 0x9b, 0x5a, 0x54];
    let head = [record(0, 2, &[2, 88]), record(1, 2, &[0; 24]), record(2, 6, b"lb"), record(3, 5, &units)];
    [head.concat(), records.concat(), record(4, 0, &[])].concat()
}

fn begin(name: &[u8]) -> Vec<u8> {
    [record(5, 2, &[0; 24]), record(6, 6, name)].concat()
}

fn end() -> Vec<u8> {
    record(7, 0, &[])
}

fn sref(child: &[u8]) -> Vec<u8> {
    [record(0x0a, 0, &[]), record(0x12, 6, child), record(0x10, 3, &[0; 8]), record(0x11, 0, &[])].concat()
}

#[test]
fn files_that_cannot_be_read() {
    let read = |bytes: &[u8]| gds::read_bytes(bytes, &ReadOptions::default());
    let named = |name: &str| ReadOptions { cellname: Some(name.into()), ..ReadOptions::default() };
    let two = library(&[begin(b"aa"), end(), begin(b"bb"), end()]);
    let whole = library(&[begin(b"aa"), end()]);
    let chain: Vec<Vec<u8>> = (100..500)
        .flat_map(|i: u32| [begin(format!("c{i}").as_bytes()), sref(format!("c{}", i + 1).as_bytes()), end()])
        .collect();
    let refused = [
        gds::read("no/such/file.gds", &ReadOptions::default()),
        gds::read("/dev/null", &ReadOptions::default()),
        gds::read("src", &ReadOptions::default()),
        read(b"%SEMI-OASIS\r\n"),
        read(&[0x1f, 0x8b, 8, 0]),
        read(b""),
        read(&whole[..whole.len() - 5]),
        read(&whole[..whole.len() - 4]),
        read(&[&whole[..46], &[0, 3, 0, 0]].concat()),
        read(&record(0, 2, &[2, 88])),
        read(&[record(0, 2, &[2, 88]), record(4, 0, &[])].concat()),
        read(&[record(0, 2, &[2, 88]), record(3, 5, &[0; 8])].concat()),
        read(&[record(0, 2, &[2, 88]), record(3, 5, &[0; 16])].concat()),
        read(&library(&[begin(b""), end()])),
        read(&library(&[begin(b"aa"), record(0x0a, 0, &[]), sref(b"bb"), end()])),
        read(&library(&[begin(b"aa"), begin(b"bb"), end()])),
        read(&library(&[])),
        read(&library(&[begin(b"aa"), sref(b"bb"), end(), begin(b"bb"), sref(b"aa"), end()])),
        gds::read_bytes(&library(&[begin(b"aa"), sref(b"bb"), end(), begin(b"bb"), sref(b"aa"), end()]), &named("aa")),
        read(&two),
        gds::read_bytes(&two, &named("c\u{1b}")),
        read(&library(&[begin(b"a\x1b"), end(), begin(b"a\x1b"), end()])),
        read(&library(&chain)),
    ];
    expect![[r#"
        no/such/file.gds: could not read it: No such file or directory (os error 2)
        /dev/null: it is not a regular file
        src: could not read it: is a directory
        these bytes: malformed at byte 0: it is an OASIS file and not GDSII
        these bytes: malformed at byte 0: it is a gzip file and not GDSII
        these bytes: malformed at byte 0: it is not a GDSII file, which begins with a HEADER record
        these bytes: malformed at byte 94 in cell "aa": the file ends inside the library
        these bytes: malformed at byte 98: the file ends inside the library
        these bytes: malformed at byte 40: a record states a length of 20 bytes, of which the file has 10
        these bytes: malformed at byte 6: the file ends inside the library
        these bytes: malformed at byte 6: the library states no units
        these bytes: malformed at byte 6: UNITS holds 8 bytes instead of 16
        these bytes: malformed at byte 6: the database unit is 0 m and 0 user units
        these bytes: malformed at byte 88: a cell has no name
        these bytes: malformed at byte 98 in cell "aa": record 0x0a stands inside an element, which has no ENDEL
        these bytes: malformed at byte 94 in cell "aa": record 0x05 stands inside a cell, which has no ENDSTR
        these bytes: there is no top cell; the file has no cells
        these bytes: there is no top cell; its cells are "aa", "bb"
        these bytes: cells place each other in a cycle: "aa" → "bb" → "aa"
        these bytes: there are several top cells, one must be chosen by name: "aa", "bb"
        these bytes: there is no cell "c\u{1b}"; its cells are "aa", "bb"
        these bytes: a second cell "a\u{1b}" begins at byte 98
        these bytes: cell "c243" is nested deeper than 256 levels"#]]
    .assert_eq(&report(refused));
}

#[test]
fn files_that_cannot_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let refused = [
        atomic::write("no/such/folder/file", b""),
        atomic::write("/dev/null", b""),
        atomic::write("src", b""),
        atomic::write_in(folder.path(), "../file", b""),
    ];
    let refused = report(refused).replace(&folder.path().display().to_string(), "FOLDER");
    expect![[r#"
        no/such/folder/file: could not create it: entity not found
        /dev/null: it is not a regular file
        src: could not write it: is a directory
        FOLDER/../file: it leads out of the folder FOLDER"#]]
    .assert_eq(&refused);
}

#[test]
fn devices_that_are_too_large() {
    let mut device = triangle();
    for _ in 0..3 {
        device = cell(|d| {
            d.add(device.array(60_000, 60_000, (1, 1)));
        });
    }
    let few = cell(|d| {
        d.add(triangle().array(10_000, 10_000, (1, 1)));
    });
    expect![[r#"
        cell "chip": it has more than 10¹⁹ instances with all levels below, but at most 67108864 are described or drawn one by one
        cell "chip": it has 100000000 instances with all levels below, but at most 67108864 are described or drawn one by one"#]].assert_eq(&report([&device, &few].map(json::describe)));
}

#[test]
fn layouts_that_cannot_be_encoded() {
    let layout = |edit: &dyn Fn(&mut Cell)| {
        let mut layout = Layout::new(phidl_core::num::grid::Grid::new(1e-3).unwrap());
        let mut cell = Cell::new(layout.names.intern("cell"));
        edit(&mut cell);
        layout.cells.push(cell);
        gds::encode_layout(&layout)
    };
    let refused = [
        layout(&|cell| cell.polygons.push(Layer::new(1, 0), (0..9000).map(|i| [i, i % 2]))),
        layout(&|cell| {
            let lattice =
                phidl_io::model::Lattice { columns: 70_000, rows: 1, column_extent: [1, 0], row_extent: [0, 1] };
            let mut placement = phidl_io::model::Placement::new(cell.name);
            placement.lattice = Some(Box::new(lattice));
            cell.placements.push(placement);
        }),
    ];
    expect![[r#"
        cell "cell", polygon 0 on 1/0: the outline is 9000 corners long, but it must have at most 8190 corners
        cell "cell", reference 0 to "cell": the lattice is of 70000 columns and 1 rows, but it must have at most 65535 of each, and ends within 32 bits"#]].assert_eq(&report(refused));
}

#[test]
fn problems() {
    let kinds = [
        ProblemKind::Node,
        ProblemKind::Box,
        ProblemKind::Empty,
        ProblemKind::Absolute,
        ProblemKind::Latin1,
        ProblemKind::Record(0x77),
        ProblemKind::Element("it states no layer".into()),
        ProblemKind::FurtherPoints,
        ProblemKind::RepeatedProperty(5),
        ProblemKind::CellProperty,
        ProblemKind::MissingCell("via\u{1b}[31m".into()),
        ProblemKind::ContextInfo,
        ProblemKind::Trailing(3),
    ];
    let sentence = |kind| Problem { cell: "chip".into(), offset: 120, kind }.to_string();
    let mut sentences: Vec<String> = kinds.map(sentence).to_vec();
    sentences.push(Problem { cell: String::new(), offset: 7, kind: ProblemKind::CellProperty }.to_string());
    expect![[r#"
        cell "chip", byte 120: a node is not drawn
        cell "chip", byte 120: a box is read as a polygon
        cell "chip", byte 120: an outline that encloses nothing is left out
        cell "chip", byte 120: an absolute angle or magnification is read as a relative one
        cell "chip", byte 120: a text that is not UTF-8 is read as Latin-1
        cell "chip", byte 120: a record of kind 0x77 is left out
        cell "chip", byte 120: an element is left out: it states no layer
        cell "chip", byte 120: points after the first ones are left out
        cell "chip", byte 120: a second property with the attribute 5 is left out
        cell "chip", byte 120: a property outside of elements is left out
        cell "chip", byte 120: cell "via\u{1b}[31m" is not in the file and is read as an empty cell
        cell "chip", byte 120: KLayout's notes on the origin of cells are left out
        cell "chip", byte 120: 3 bytes after the end of the library are left out
        byte 7: a property outside of elements is left out"#]]
    .assert_eq(&sentences.join("\n"));
    assert!(Path::new("src").exists(), "the tests run in the folder of the crate");
}

#[test]
fn problems_of_oasis_files() {
    let kinds = [
        ProblemKind::Property("p".into()),
        ProblemKind::Circle,
        ProblemKind::OddList,
        ProblemKind::Strict("the END record has 20 bytes, but it must have 256".into()),
        ProblemKind::Checksum { stated: 1, found: 0xabcd_ef01 },
    ];
    let sentences = kinds.map(|kind| Problem { cell: "chip".into(), offset: 7, kind }.to_string());
    expect![[r#"
        cell "chip", byte 7: the property "p" has no counterpart and is left out
        cell "chip", byte 7: a circle is read as a polygon
        cell "chip", byte 7: a polygon has an odd number of alternating edges, which some tools refuse
        cell "chip", byte 7: the END record has 20 bytes, but it must have 256
        cell "chip", byte 7: the checksum is 00000001, but that of the bytes is abcdef01"#]]
    .assert_eq(&sentences.join("\n"));
}

#[test]
fn files_of_other_formats() {
    let layout = |bytes: &[u8]| phidl_io::layout::read_bytes(bytes, &Default::default()).map(|_| ());
    let missing = IoError::NotCompiledIn { file: "a.oas".into(), format: "OASIS", feature: "oasis" };
    let style = phidl_io::lyp::from_str("<a/>").map(|_| ());
    expect![[r#"
        these bytes: it is no layout file that phidl reads: it is empty
        these bytes: it is no layout file that phidl reads: it begins with 50 4b 03 04
        these bytes: it is no layout file that phidl reads: it holds layer properties (LYP)
        a.oas: OASIS needs the feature "oasis" of phidl-io, which this program is compiled without
        this text, line 1, column 1: the root element is <a>, but it must be <layer-properties>"#]]
    .assert_eq(&report([layout(b""), layout(b"PK\x03\x04"), layout(b"<layer-properties/>"), Err(missing), style]));
}
