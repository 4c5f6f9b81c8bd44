//! Files of other programs, record by record: what the reader makes of them.

use expect_test::expect;
use phidl_core::prelude::*;
use phidl_io::IoError;
use phidl_io::gds::{Import, Problem, ProblemKind, ReadOptions, read_bytes};

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
fn unknown_records_are_left_out_and_listed() {
    let odd = record(0x77, 2, &[1, 2]);
    let inside = element(0x08, &[number(0x0d, 1), odd.clone(), number(0x0e, 0), xy(&[(0, 0), (1, 0), (0, 1)])]);
    let read = import(&[cell("a", &[odd, inside, boundary(&[(0, 0), (1, 1)])])]);
    assert_eq!(kinds(&read), [ProblemKind::Record(0x77), ProblemKind::Record(0x77), ProblemKind::Empty]);
    assert!(read.problems.windows(2).all(|pair| pair[0].offset < pair[1].offset));
    assert_eq!(read.device.polygons().len(), 1);
}

#[test]
fn files_without_a_single_top_cell_say_why() {
    assert!(matches!(refused(&[]), IoError::NoTopCell { .. }));
    let several = refused(&[cell("a", &[]), cell("b", &[])]);
    assert!(matches!(several, IoError::SeveralTopCells { cells, .. } if cells == ["a", "b"]));
    let twice = refused(&[cell("a", &[]), cell("a", &[])]);
    assert!(matches!(twice, IoError::DuplicateCell { name, .. } if &*name == "a"));
}

#[test]
fn a_cell_that_is_not_in_the_file_is_read_as_an_empty_one() {
    let read = import(&[cell("a", &[sref("nowhere"), sref("nowhere"), boundary(&[(0, 0), (1, 0), (0, 1)])])]);
    assert_eq!(kinds(&read), [ProblemKind::MissingCell("nowhere".into())]);
    let children: Vec<&str> = read.device.references().iter().map(|r| r.device().name()).collect();
    assert_eq!((children, read.device.polygons().len()), (vec!["nowhere", "nowhere"], 1));
}

#[test]
fn circles_of_cells_are_named() {
    let circle = [cell("a", &[sref("b")]), cell("b", &[sref("c")]), cell("c", &[sref("b")]), cell("d", &[])];
    match refused(&circle[..3]) {
        IoError::CyclicCells { chain, .. } => assert_eq!(chain, ["b", "c", "b"]),
        other => panic!("{other}"),
    }
    match refused(&circle[1..3]) {
        IoError::NoTopCell { cells, .. } => assert_eq!(cells, ["b", "c"]),
        other => panic!("{other}"),
    }
    // A circle elsewhere in the file does not matter.
    let read = read_bytes(&library(&circle), &ReadOptions { cellname: Some("d".into()), ..ReadOptions::default() });
    assert_eq!(read.unwrap().device.name(), "d");
}

#[test]
fn cells_nested_without_end_are_refused() {
    let chain: Vec<Vec<u8>> = (0..2000).map(|i| cell(&format!("c{i}"), &[sref(&format!("c{}", i + 1))])).collect();
    let chain = [chain, vec![cell("c2000", &[])]].concat();
    assert!(matches!(refused(&chain), IoError::TooDeep { .. }));
}

/// The rule that an element breaks.
fn defects(import: &Import) -> Vec<String> {
    let defect = |problem: &Problem| match &problem.kind {
        ProblemKind::Element(rule) => rule.to_string(),
        other => format!("{other:?}"),
    };
    import.problems.iter().map(defect).collect()
}

/// A single reference to "a" with some records before its coordinates.
fn sref_with(records: &[Vec<u8>]) -> Vec<u8> {
    element(0x0a, &[text(0x12, b"a"), records.concat(), xy(&[(0, 0)])])
}

#[test]
fn an_odd_element_is_left_out_and_the_rest_is_read() {
    let mag = |bytes: [u8; 8]| sref_with(&[record(0x1a, 1, &[0, 0]), record(0x1b, 5, &bytes)]);
    let elements = [
        mag([0; 8]),
        mag([0xc1, 0x10, 0, 0, 0, 0, 0, 0]),
        element(0x0a, &[text(0x12, b"a")]),
        element(0x0a, &[xy(&[(0, 0)])]),
        element(0x08, &[number(0x0e, 0), xy(&[(0, 0), (1, 0), (0, 1)])]),
        element(0x08, &[number(0x0d, 1), number(0x0e, 0)]),
        element(0x08, &[number(0x0d, 1), record(0x10, 3, &[0; 12])]),
        element(0x08, &[record(0x0d, 2, &[0; 4]), number(0x0e, 0), xy(&[(0, 0), (1, 0), (0, 1)])]),
        element(0x0c, &[number(0x0d, 1), xy(&[(0, 0)])]),
        element(0x0b, &[text(0x12, b"a"), record(0x13, 2, &[0, 0, 0, 2]), xy(&[(0, 0), (1, 0), (0, 1)])]),
        element(0x0b, &[text(0x12, b"a"), record(0x13, 2, &[0, 1, 0, 2]), xy(&[(0, 0), (1, 0)])]),
        sref("a"),
        boundary(&[(0, 0), (1, 0), (0, 1)]),
    ];
    let read = import(&[cell("a", &[]), cell("b", &elements)]);
    expect![[r#"
        its magnification is 0
        its magnification is -1
        it has no coordinates
        it names no cell
        it states no layer
        it has no coordinates
        its coordinates are not pairs of 32-bit numbers
        record 0x0d holds 4 bytes instead of 2
        it has no string
        it is an array of 0 columns and 2 rows
        it has 2 points instead of 3"#]]
    .assert_eq(&defects(&read).join("\n"));
    assert!(read.problems.iter().all(|problem| problem.cell == "b"));
    assert_eq!((read.device.references().len(), read.device.polygons().len()), (1, 1));
}

#[test]
fn magnification_and_angle_count_without_strans() {
    let half = record(0x1b, 5, &[0x40, 0x80, 0, 0, 0, 0, 0, 0]);
    let quarter_turn = record(0x1c, 5, &[0x42, 0x5a, 0, 0, 0, 0, 0, 0]);
    let read = import(&[cell("a", &[]), cell("b", &[sref_with(&[half, quarter_turn])])]);
    let transform = *read.device.references()[0].transform();
    assert_eq!((transform.magnification, transform.rotation, transform.x_reflection), (0.5, 90.0, false));
    assert_eq!(kinds(&read), []);
}

#[test]
fn types_that_are_not_stated_are_0_and_boxes_need_not_be_closed() {
    let square = [(0, 0), (1000, 0), (1000, 1000), (0, 1000)];
    let elements = [
        element(0x0c, &[number(0x0d, 7), xy(&[(0, 0)]), text(0x19, b"x")]),
        element(0x08, &[number(0x0d, 7), xy(&square)]),
        element(0x2d, &[number(0x0d, 7), xy(&square)]),
        element(0x2d, &[number(0x0d, 7), xy(&[(0, 0), (2000, 1000)])]),
    ];
    let read = import(&[cell("a", &elements)]);
    assert_eq!(read.device.labels()[0].layer, Layer::new(7, 0));
    let areas: Vec<f64> = read.device.polygons().map(|p| p.area()).collect();
    assert_eq!((areas, kinds(&read)), (vec![1.0, 1.0, 2.0], vec![ProblemKind::Box, ProblemKind::Box]));
    assert!(read.device.polygons().all(|p| p.layer == Layer::new(7, 0)));
}

#[test]
fn arrays_have_up_to_65535_columns() {
    let colrow = record(0x13, 2, &[0x9c, 0x40, 0, 1]);
    let array = element(0x0b, &[text(0x12, b"a"), colrow, xy(&[(0, 0), (40_000, 0), (0, 1)])]);
    let read = import(&[cell("a", &[]), cell("b", &[array])]);
    let array = read.device.references()[0].array().unwrap();
    assert_eq!((array.columns, array.rows, array.column_step), (40_000, 1, Point::new(0.001, 0.0)));
}

#[test]
fn the_first_of_two_properties_of_one_attribute_is_kept() {
    let property = |value: &[u8]| [number(0x2b, 5), text(0x2c, value)].concat();
    let other = [number(0x2b, 6), text(0x2c, b"other")].concat();
    let records =
        [number(0x0d, 1), number(0x0e, 0), xy(&[(0, 0), (1, 0), (0, 1)]), property(b"1st"), property(b"2nd"), other];
    let read = import(&[cell("a", &[element(0x08, &records)])]);
    let properties: Vec<(u16, String)> = read
        .device
        .polygons()
        .flat_map(|p| p.properties().map(|(k, v)| (k, v.to_owned())).collect::<Vec<_>>())
        .collect();
    assert_eq!(properties, [(5, "1st".to_owned()), (6, "other".to_owned())]);
    assert_eq!(kinds(&read), [ProblemKind::RepeatedProperty(5)]);
}

#[test]
fn properties_outside_of_elements_and_bytes_after_the_end_are_listed() {
    let property = [number(0x2b, 5), text(0x2c, b"x")].concat();
    let mut bytes = library(&[property.clone(), cell("a", &[property])]);
    bytes.extend_from_slice(&[0, 0, 7, 0, 0]);
    let read = read_bytes(&bytes, &ReadOptions::default()).unwrap();
    assert_eq!(kinds(&read), [ProblemKind::CellProperty, ProblemKind::CellProperty, ProblemKind::Trailing(3)]);
}

/// KLayout notes there where the cells of other libraries come from; it need not place anything that is drawn.
#[test]
fn klayouts_notes_are_no_cell() {
    let context = cell("$$$CONTEXT_INFO$$$", &[sref("a"), sref("b")]);
    let cells = [cell("a", &[boundary(&[(0, 0), (1, 0), (0, 1)])]), cell("b", &[sref("a")]), context];
    let read = import(&cells);
    assert_eq!((read.device.name(), kinds(&read)), ("b", vec![ProblemKind::ContextInfo]));
}

#[test]
fn a_path_of_one_point_is_a_disc_or_a_square() {
    let dot = |kind: i16, points: &[(i32, i32)]| {
        let width = record(0x0f, 3, &1000_i32.to_be_bytes());
        element(0x09, &[number(0x0d, 1), number(0x0e, 0), number(0x21, kind), width, xy(points)])
    };
    let elements = [dot(1, &[(0, 0)]), dot(2, &[(0, 0)]), dot(2, &[(5, 5), (5, 5)]), dot(0, &[(0, 0)])];
    let read = import(&[cell("a", &elements)]);
    let areas: Vec<f64> = read.device.polygons().map(|p| p.area()).collect();
    assert!((areas[0] - PI / 4.0).abs() < 1e-3, "{areas:?}");
    assert_eq!((&areas[1..], kinds(&read)), (&[1.0, 1.0][..], vec![ProblemKind::Empty]));
}

#[test]
fn an_element_that_does_not_end_is_an_error_with_byte_and_cell() {
    let open = [record(0x0a, 0, &[]), text(0x12, b"a"), xy(&[(0, 0)])].concat();
    let before = [cell("a", &[]), cell("b", &[sref("a"), sref("a")])].concat();
    let start = library(&[]).len() - 4 + before.len() + 28 + 8 + sref("a").len() + open.len();
    match refused(&[before, cell("open", &[sref("a"), open, sref("a")])]) {
        IoError::Malformed { offset, cell, .. } => assert_eq!((offset, cell.as_deref()), (start, Some("open"))),
        other => panic!("{other:?}"),
    }
}

#[test]
fn only_the_layers_that_are_asked_for_are_read() {
    let label = element(0x0c, &[number(0x0d, 2), number(0x16, 0), xy(&[(0, 0)]), text(0x19, b"x")]);
    let bytes = library(&[cell("a", &[boundary(&[(0, 0), (1, 0), (0, 1)]), label])]);
    let layers = |number: u16| ReadOptions { layers: Some(Layers::from(number)), ..ReadOptions::default() };
    let read = |number: u16| read_bytes(&bytes, &layers(number)).unwrap();
    let counts = |import: &Import| (import.device.polygons().len(), import.device.labels().len(), import.left_out);
    assert_eq!((counts(&read(1)), counts(&read(2))), ((1, 0, 1), (0, 1, 1)));
}
