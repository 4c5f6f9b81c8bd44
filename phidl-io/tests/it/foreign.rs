//! Files of other programs, record by record: what the reader makes of them.

use phidl_core::prelude::*;
use phidl_io::IoError;
use phidl_io::gds::{Import, ProblemKind, ReadOptions, read_bytes};

/// A record: kind, data type, content.
fn record(kind: u8, data: u8, content: &[u8]) -> Vec<u8> {
    let length = u16::try_from(content.len() + 4).unwrap().to_be_bytes();
    [&length[..], &[kind, data], content].concat()
}

fn number(kind: u8, number: i16) -> Vec<u8> {
    record(kind, 2, &number.to_be_bytes())
}

fn text(kind: u8, text: &[u8]) -> Vec<u8> {
    let padding: &[u8] = if text.len().is_multiple_of(2) { &[] } else { &[0] };
    record(kind, 6, &[text, padding].concat())
}

fn xy(points: &[(i32, i32)]) -> Vec<u8> {
    let bytes: Vec<u8> = points.iter().flat_map(|(x, y)| [x.to_be_bytes(), y.to_be_bytes()].concat()).collect();
    record(0x10, 3, &bytes)
}

/// An element of a kind with its records.
fn element(kind: u8, records: &[Vec<u8>]) -> Vec<u8> {
    [record(kind, 0, &[]), records.concat(), record(0x11, 0, &[])].concat()
}

fn boundary(points: &[(i32, i32)]) -> Vec<u8> {
    element(0x08, &[number(0x0d, 1), number(0x0e, 0), xy(points)])
}

fn sref(child: &str) -> Vec<u8> {
    element(0x0a, &[text(0x12, child.as_bytes()), xy(&[(0, 0)])])
}

fn cell(name: &str, elements: &[Vec<u8>]) -> Vec<u8> {
    [record(0x05, 2, &[0; 24]), text(0x06, name.as_bytes()), elements.concat(), record(0x07, 0, &[])].concat()
}

fn library(cells: &[Vec<u8>]) -> Vec<u8> {
    let units = [0x3e, 0x41, 0x89, 0x37, 0x4b, 0xc6, 0xa7, 0xf0, 0x39, 0x44, 0xb8, 0x2f, 0xa0, 0x9b, 0x5a, 0x54];
    let head =
        [number(0, 600), record(0x01, 2, &[0; 24]), text(0x1f, b"other"), text(0x02, b"lib"), record(3, 5, &units)];
    [head.concat(), cells.concat(), record(0x04, 0, &[])].concat()
}

fn import(cells: &[Vec<u8>]) -> Import {
    read_bytes(&library(cells), &ReadOptions::default()).unwrap()
}

fn refused(cells: &[Vec<u8>]) -> IoError {
    read_bytes(&library(cells), &ReadOptions::default()).unwrap_err()
}

fn kinds(import: &Import) -> Vec<ProblemKind> {
    import.problems.iter().map(|problem| problem.kind.clone()).collect()
}

fn points(device: &Device) -> Vec<Vec<Point>> {
    device.polygons().map(|p| p.points.to_vec()).collect()
}

fn um(list: &[(f64, f64)]) -> Vec<Point> {
    list.iter().map(|p| Point::from(*p)).collect()
}

#[test]
fn an_outline_that_is_not_closed_keeps_its_last_corner() {
    let open = [(0, 0), (1000, 0), (1000, 1000), (0, 1000)];
    let closed = [(0, 0), (1000, 0), (1000, 1000), (0, 1000), (0, 0)];
    let read = import(&[cell("a", &[boundary(&open), boundary(&closed)])]);
    let square = um(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)]);
    assert_eq!(points(&read.device), [square.clone(), square]);
    assert_eq!(read.library_name, "lib");
}

#[test]
fn a_long_outline_may_go_on_in_further_records() {
    let records = [number(0x0d, 1), number(0x0e, 0), xy(&[(0, 0), (1000, 0)]), xy(&[(0, 1000), (0, 0)])];
    let read = import(&[cell("a", &[element(0x08, &records)])]);
    assert_eq!(points(&read.device), [um(&[(0., 0.), (1., 0.), (0., 1.)])]);
}

#[test]
fn boxes_and_paths_are_polygons_and_nodes_are_left_out() {
    let square = [(0, 0), (1000, 0), (1000, 1000), (0, 1000), (0, 0)];
    let box_element = element(0x2d, &[number(0x0d, 2), number(0x2e, 7), xy(&square)]);
    let path = |kind: i16| {
        let width = record(0x0f, 3, &500_i32.to_be_bytes());
        element(0x09, &[number(0x0d, 3), number(0x0e, 0), number(0x21, kind), width, xy(&[(0, 0), (10_000, 0)])])
    };
    let node = element(0x15, &[number(0x0d, 1), number(0x2a, 0), xy(&[(0, 0)])]);
    let read = import(&[cell("a", &[box_element, path(0), node, path(2), boundary(&square)])]);
    assert_eq!(kinds(&read), [ProblemKind::Box, ProblemKind::Node]);
    let layers: Vec<Layer> = read.device.polygons().map(|p| p.layer).collect();
    assert_eq!(layers, [(1, 0), (2, 7), (3, 0), (3, 0)].map(Layer::from));
    let areas: Vec<f64> = read.device.polygons().map(|p| p.area()).collect();
    assert_eq!(areas, [1.0, 1.0, 5.0, 5.25]);
}

#[test]
fn lattices_keep_both_their_vectors_also_mirrored_and_turned() {
    let lattice = [(0, 0), (60_000, 15_000), (-6_000, 20_000)];
    let colrow = record(0x13, 2, &[0, 3, 0, 2]);
    let child = cell("dot", &[boundary(&[(0, 0), (1000, 0), (0, 1000)])]);
    let plain = element(0x0b, &[text(0x12, b"dot"), colrow.clone(), xy(&lattice)]);
    let angle = record(0x1c, 5, &[0x42, 0x5a, 0, 0, 0, 0, 0, 0]); // 90
    let strans = record(0x1a, 1, &[0x80, 0]);
    let turned = element(0x0b, &[text(0x12, b"dot"), strans, angle, colrow, xy(&lattice)]);
    let read = import(&[child, cell("top", &[plain, turned])]);
    for reference in read.device.references() {
        let at = |column, row| reference.element(column, row).origin;
        assert!(at(1, 0).distance(Point::new(20.0, 5.0)) < 1e-12, "{}", at(1, 0));
        assert!(at(0, 1).distance(Point::new(-3.0, 10.0)) < 1e-12, "{}", at(0, 1));
    }
    let array = read.device.references()[0].array().unwrap();
    assert_eq!((array.column_step, array.row_step), (Point::new(20.0, 5.0), Point::new(-3.0, 10.0)));
}

#[test]
fn texts_may_be_empty_or_in_latin_letters() {
    let label = |string: &[u8]| element(0x0c, &[number(0x0d, 1), number(0x16, 2), xy(&[(0, 0)]), text(0x19, string)]);
    let read = import(&[cell("a", &[label(b""), label(&[0xb5, b'm']), label("µ".as_bytes())])]);
    let texts: Vec<&str> = read.device.labels().iter().map(|label| label.text.as_str()).collect();
    assert_eq!(texts, ["", "µm", "µ"]);
    assert_eq!(kinds(&read), [ProblemKind::Latin1]);
    assert_eq!((read.device.labels()[0].rotation(), read.device.labels()[0].layer), (0.0, Layer::new(1, 2)));
}

#[test]
fn records_that_nobody_knows_are_left_out_and_listed() {
    let odd = record(0x77, 2, &[1, 2]);
    let inside = element(0x08, &[number(0x0d, 1), odd.clone(), number(0x0e, 0), xy(&[(0, 0), (1, 0), (0, 1)])]);
    let read = import(&[cell("a", &[odd, inside, boundary(&[(0, 0), (1, 1)])])]);
    assert_eq!(kinds(&read), [ProblemKind::Record(0x77), ProblemKind::Record(0x77), ProblemKind::Empty]);
    assert!(read.problems.windows(2).all(|pair| pair[0].offset < pair[1].offset));
    assert_eq!(read.device.polygons().len(), 1);
}

#[test]
fn files_without_one_way_to_read_them_say_why() {
    assert!(matches!(refused(&[]), IoError::NoTopCell { .. }));
    let several = refused(&[cell("a", &[]), cell("b", &[])]);
    assert!(matches!(several, IoError::SeveralTopCells { cells, .. } if cells == ["a", "b"]));
    let twice = refused(&[cell("a", &[]), cell("a", &[])]);
    assert!(matches!(twice, IoError::DuplicateCell { name, .. } if &*name == "a"));
    let dangling = refused(&[cell("a", &[sref("nowhere")])]);
    assert!(matches!(dangling, IoError::MissingCell { missing, .. } if &*missing == "nowhere"));
}

#[test]
fn circles_of_cells_are_named() {
    let circle = [cell("a", &[sref("b")]), cell("b", &[sref("c")]), cell("c", &[sref("b")]), cell("d", &[])];
    match refused(&circle[..3]) {
        IoError::Circle { chain, .. } => assert_eq!(chain, ["b", "c", "b"]),
        other => panic!("{other}"),
    }
    match refused(&circle[1..3]) {
        IoError::NoTopCell { cells, .. } => assert_eq!(cells, ["b", "c"]),
        other => panic!("{other}"),
    }
    // A circle elsewhere in the file does not matter.
    let read = read_bytes(&library(&circle), &ReadOptions { cellname: Some("d".into()) });
    assert_eq!(read.unwrap().device.name(), "d");
}

#[test]
fn cells_nested_without_end_are_refused() {
    let chain: Vec<Vec<u8>> = (0..2000).map(|i| cell(&format!("c{i}"), &[sref(&format!("c{}", i + 1))])).collect();
    let chain = [chain, vec![cell("c2000", &[])]].concat();
    assert!(matches!(refused(&chain), IoError::TooDeep { .. }));
}

#[test]
fn a_reference_without_a_place_or_with_a_senseless_size_is_an_error() {
    let magnified = |bytes: [u8; 8]| {
        let records = [text(0x12, b"a"), record(0x1a, 1, &[0, 0]), record(0x1b, 5, &bytes), xy(&[(0, 0)])];
        refused(&[cell("a", &[]), cell("b", &[element(0x0a, &records)])])
    };
    assert!(matches!(magnified([0; 8]), IoError::Malformed { problem, .. } if problem.contains("magnification of 0")));
    assert!(matches!(magnified([0xc1, 0x10, 0, 0, 0, 0, 0, 0]), IoError::Malformed { .. }));
    let nowhere = refused(&[cell("a", &[]), cell("b", &[element(0x0a, &[text(0x12, b"a")])])]);
    assert!(matches!(nowhere, IoError::Malformed { cell: Some(cell), .. } if &*cell == "b"));
}

#[test]
fn a_broken_element_is_found_among_good_ones() {
    let label =
        |places: &[(i32, i32)]| element(0x0c, &[number(0x0d, 1), number(0x16, 0), xy(places), text(0x19, b"label")]);
    let (good, bad) = (label(&[(0, 0)]), label(&[(0, 0), (1, 1)]));
    let start = library(&[]).len() - 4;
    let before = [cell("a", &[]), cell("b", &[sref("a"), sref("a")])].concat();
    let bad_cell = cell("bad", &[good.clone(), sref("a"), bad, good.clone()]);
    match refused(&[before.clone(), bad_cell]) {
        IoError::Malformed { offset, cell, .. } => {
            let in_cell = 28 + 4 + 4 + good.len() + sref("a").len();
            assert_eq!((offset, cell.as_deref()), (start + before.len() + in_cell, Some("bad")));
        }
        other => panic!("{other}"),
    }
}
