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
    expect![[""]].assert_eq(&report(options.map(|options| gds::to_bytes(&triangle(), &options))));
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
    // Texts are long; their middle is not.
    let refused = refused.replace(&"x".repeat(590), "…").replace(&"Ω".repeat(39_990), "…");
    expect![[""]].assert_eq(&refused);
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
    expect![[""]].assert_eq(&report(refused));
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
    expect![[""]].assert_eq(&refused);
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
    expect![[""]].assert_eq(&report([&device, &few].map(json::describe)));
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
    expect![[""]].assert_eq(&report(refused));
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
    expect![[""]].assert_eq(&sentences.join("\n"));
    assert!(Path::new("src").exists(), "the tests run in the folder of the crate");
}
