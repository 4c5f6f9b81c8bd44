//! OASIS files made byte by byte from the rules of SEMI P39, and what is written of them.

use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_io::IoError;
use phidl_io::model::{Cell, Corner, Lattice, Layout, Path, PathEnd, Placement, ProblemKind, Text};
use phidl_io::oasis::{Checksum, DecodeOptions, EncodeOptions, Shapes, Validation, decode, encode};

/// A file of some records, on a grid of a nanometer, with an END record that keeps its rules.
pub(crate) fn file(records: &[&[u8]]) -> Vec<u8> {
    let start = b"%SEMI-OASIS\r\n\x01\x031.0\x00\xe8\x07\x01";
    let end = [&[2][..], &[0; 12], &[0xf0, 1], &[0; 240], &[0]].concat();
    assert_eq!(end.len(), 256);
    [start, &records.concat()[..], &end].concat()
}

/// Records of a cell A.
fn in_cell(records: &[&[u8]]) -> Vec<u8> {
    file(&[&[14, 1, b'A'], &records.concat()])
}

fn read(bytes: &[u8]) -> Layout {
    decode(bytes, "test", &DecodeOptions::default()).unwrap()
}

fn refused(bytes: &[u8]) -> String {
    decode(bytes, "test", &DecodeOptions::default()).unwrap_err().to_string()
}

fn polygons(layout: &Layout) -> Vec<(Layer, Vec<Corner>)> {
    layout.cells.iter().flat_map(|cell| cell.polygons.iter()).map(|p| (p.layer, p.corners.to_vec())).collect()
}

fn kinds(layout: &Layout) -> Vec<ProblemKind> {
    layout.problems.as_slice().iter().map(|problem| problem.kind.clone()).collect()
}

/// The example of a whole file: KLayout 0.30 opens it in strict mode without a warning, gdstk 1.0 finds its checksum.
fn example() -> Vec<u8> {
    let head =
        b"%SEMI-OASIS\r\n\x01\x031.0\x00\xe8\x07\x01\x0d\x00\x14\x7b\x01\x00\xa0\x1f\xd0\x0f\xe9\x07\x00\x03\x01A";
    let end = [&[2, 1, 0x23][..], &[1, 0, 1, 0, 1, 0, 1, 0, 1, 0], &[0xec, 1], &[0; 236], &[1]].concat();
    [&head[..], &end, &[0x52, 0xd1, 0x57, 0x87]].concat()
}

#[test]
fn a_whole_file_is_read_without_a_problem() {
    let layout = read(&example());
    assert_eq!(kinds(&layout), []);
    assert_eq!(layout.names.name(layout.cells[0].name), "A");
    let corners = vec![[-500, 0], [3500, 0], [3500, 2000], [-500, 2000]];
    assert_eq!(polygons(&layout), [(Layer::new(1, 0), corners)]);
    assert_eq!(layout.grid.step(), 1e-3);
}

#[test]
fn a_wrong_checksum_is_a_problem_an_error_or_nothing() {
    let mut bytes = example();
    // The high byte of the width.
    bytes[29] = 0x2f;
    let checked = |checksum| decode(&bytes, "test", &DecodeOptions { checksum, ..Default::default() });
    let layout = checked(Checksum::Report).unwrap();
    assert!(matches!(kinds(&layout)[..], [ProblemKind::Checksum { stated: 0x8757_d152, .. }]));
    assert!(matches!(checked(Checksum::Refuse), Err(IoError::Malformed { .. })));
    assert_eq!(kinds(&checked(Checksum::Skip).unwrap()), []);
}

#[test]
fn rectangles_take_what_they_leave_out_from_the_last_one() {
    let layout = read(&in_cell(&[
        // Layer 1, datatype 2, 10 by 20 at (5, 6).
        &[20, 0b0111_1011, 1, 2, 10, 20, 10, 12],
        // The same at x = 7; then a square of 4.
        &[20, 0b0001_0000, 14],
        &[20, 0b1100_0000, 4],
        // Relative: 3 to the right.
        &[16, 20, 0b0001_0000, 6],
    ]));
    let boxed = |x, y, w, h| (Layer::new(1, 2), vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]]);
    assert_eq!(polygons(&layout), [boxed(5, 6, 10, 20), boxed(7, 6, 10, 20), boxed(7, 6, 4, 4), boxed(10, 6, 4, 4)]);
}

#[test]
fn every_modal_variable_must_be_set_before_it_is_used() {
    let records: [(&[u8], &str); 12] = [
        (&[20, 0b0110_0010, 1, 9, 9], "layer"),
        (&[20, 0b0110_0001, 1, 9, 9], "datatype"),
        (&[20, 0b0010_0011, 1, 1, 9], "geometry width"),
        (&[20, 0b0100_0011, 1, 1, 9], "geometry height"),
        (&[21, 0b0000_0011, 1, 1], "polygon point list"),
        (&[22, 0b1100_0011, 1, 1, 4, 0b0101], "path point list"),
        (&[22, 0b1010_0011, 1, 1, 0b0101, 4, 1, 0x50], "path half width"),
        (&[26, 0b0110_0011, 1, 1, 9, 9], "ctrapezoid type"),
        (&[27, 0b0000_0011, 1, 1], "circle radius"),
        (&[19, 0b0000_0011, 1, 1], "text string"),
        (&[17, 0], "placement cell"),
        (&[29], "last property name"),
    ];
    for (record, variable) in records {
        let message = refused(&in_cell(&[record]));
        assert!(message.contains(&format!("the modal variable \"{variable}\" is used before it is set")), "{message}");
        // What is set in one cell does not count in the next one.
    }
    let twice = file(&[&[14, 1, b'A'], &[20, 0b0111_1011, 1, 2, 10, 20, 10, 12], &[14, 1, b'B'], &[20, 0]]);
    assert!(refused(&twice).contains("in cell \"B\""), "{}", refused(&twice));
}

#[test]
fn polygons_paths_trapezoids_and_circles_are_read() {
    let layout = read(&in_cell(&[
        // A triangle of g-deltas, three copies in a row.
        &[21, 0b0011_1111, 1, 0, 4, 2, 0x50, 0x5a, 0, 0, 2, 1, 10],
        // Horizontal trapezoid, 30 by 10, a = 4, b = -5.
        &[23, 0b0111_1011, 1, 0, 30, 10, 8, 11, 0, 0],
        // Triangle of type 16 with legs of 10.
        &[26, 0b1101_1011, 1, 0, 16, 10, 0, 0],
        // Circle of radius 100.
        &[27, 0b0011_1011, 1, 0, 100, 0, 0],
        // Path of half width 3: start flush, end 5 further.
        &[22, 0b1111_1011, 1, 0, 3, 0b0111, 10, 2, 1, 0x28, 0, 0],
    ]));
    let all = polygons(&layout);
    assert_eq!(all[1].1, [[10, 0], [15, 0], [10, 5]]);
    assert_eq!(all[3].1, [[4, 10], [25, 10], [30, 0], [0, 0]]);
    assert_eq!(all[4].1, [[0, 0], [0, 10], [10, 0]]);
    assert!(all[5].1.len() > 8 && all[5].1.iter().all(|[x, y]| (f64::from(x * x + y * y).sqrt() - 100.0).abs() < 0.8));
    assert_eq!(kinds(&layout), [ProblemKind::Circle]);
    let [path] = &layout.cells[0].paths[..] else { panic!("one path") };
    assert_eq!((path.width, path.start, path.end), (6, PathEnd::Flush, PathEnd::Extended(5)));
    assert_eq!(path.points, [[0, 0], [10, 0]]);
}

#[test]
fn extension_schemes_set_each_end_or_leave_it() {
    let path = |scheme: &[u8]| [&[22, 0b1110_0011, 1, 0, 3][..], scheme, &[2, 1, 0x28]].concat();
    let layout = read(&in_cell(&[&path(&[0b1001]), &path(&[0b0010]), &path(&[0b1100, 7]), &path(&[0])]));
    let ends: Vec<_> = layout.cells[0].paths.iter().map(|path| (path.start, path.end)).collect();
    use PathEnd::{Extended, Flush, Square};
    assert_eq!(ends, [(Square, Flush), (Square, Square), (Extended(-3), Square), (Extended(-3), Square)]);
}

#[test]
fn placements_are_references_and_arrays() {
    let layout = read(&file(&[
        &[14, 1, b'B'],
        &[14, 1, b'A'],
        // B by name, mirrored and a quarter turn, at (1, 2).
        &[17, 0b1011_0011, 1, b'B', 2, 4],
        // The same cell: twice as large, at 45°.
        &[18, 0b0011_0110, 0, 2, 0, 45, 0, 0],
        // 3 columns at (5, 0), 2 rows at (-5, 5).
        &[17, 0b0000_1000, 8, 1, 0, 0x50, 0x5a],
        // A list: two single references.
        &[17, 0b0000_1000, 10, 0, 0x50],
    ]));
    let placements = &layout.cells[1].placements;
    assert!(placements.iter().all(|placement| layout.names.name(placement.child) == "B"));
    assert_eq!((placements[0].origin, placements[0].x_reflection, placements[0].rotation), ([1, 2], true, 90.0));
    assert_eq!((placements[1].magnification, placements[1].rotation), (2.0, 45.0));
    let lattice = Lattice { columns: 3, rows: 2, column_extent: [15, 0], row_extent: [-10, 10] };
    assert_eq!(placements[2].lattice.as_deref(), Some(&lattice));
    assert_eq!(placements[3..].iter().map(|placement| placement.origin).collect::<Vec<_>>(), [[0, 0], [5, 0]]);
}

#[test]
fn names_may_stand_behind_their_use_and_have_numbers_of_their_own() {
    let layout = read(&file(&[
        &[13, 7],
        &[19, 0b0111_1011, 3, 1, 2, 0, 0],
        &[28, 0b0010_0111, 1, 8, 5, 15, 9],
        &[4, 1, b'A', 7],
        &[6, 2, b'h', b'i', 3],
        &[8, 14, b'S', b'_', b'G', b'D', b'S', b'_', b'P', b'R', b'O', b'P', b'E', b'R', b'T', b'Y', 1],
        &[10, 1, b'x', 9],
    ]));
    assert_eq!(layout.names.name(layout.cells[0].name), "A");
    let [text] = &layout.cells[0].texts[..] else { panic!("one text") };
    assert_eq!((text.string.as_str(), text.layer), ("hi", Layer::new(1, 2)));
    assert_eq!(text.properties.get(&5).map(String::as_str), Some("x"));
    assert_eq!(kinds(&layout), []);
}

#[test]
fn names_that_are_missing_mixed_or_repeated_are_errors() {
    assert!(refused(&file(&[&[13, 7]])).contains("no CELLNAME record of the file has the number 7"));
    assert!(refused(&file(&[&[3, 1, b'A', 4, 1, b'B', 1]])).contains("with and without numbers are mixed"));
    assert!(refused(&file(&[&[4, 1, b'A', 1, 4, 1, b'B', 1]])).contains("a second CELLNAME record has the number 1"));
    let twice = decode(&file(&[&[14, 1, b'A', 14, 1, b'A']]), "test", &DecodeOptions::default());
    assert!(matches!(twice, Err(IoError::DuplicateCell { name, .. }) if &*name == "A"));
}

#[test]
fn records_without_a_counterpart_are_listed_and_the_rest_is_read() {
    let layout = read(&in_cell(&[
        &[30, 1, 1, b'x'],
        &[14, 1, b'B'],
        &[32, 1, 1, b'x'],
        &[33, 0b0001_1011, 1, 1, 0, 1, b'x', 0, 0],
        // A property that only others know, twice, on a square.
        &[20, 0b1101_1011, 1, 0, 9, 0, 0],
        &[28, 0b0001_0100, 1, b'p', 8, 1],
        &[29],
        // A rectangle without height.
        &[20, 0b0110_0000, 9, 0],
    ]));
    let property = ProblemKind::Property("p".into());
    let record = ProblemKind::Record;
    assert_eq!(kinds(&layout), [record(30), record(32), record(33), ProblemKind::Empty, property]);
    assert_eq!(polygons(&layout).len(), 1);
}

#[test]
fn blocks_hold_records_and_nothing_else() {
    // A stored deflate block (RFC 1951) of a cell with a square.
    let content = [14, 1, b'A', 20, 0b1101_1011, 1, 0, 9, 0, 0];
    let length = u8::try_from(content.len()).unwrap();
    let stored = [&[1, length, 0, !length, 0xff][..], &content].concat();
    let block = |stored: &[u8], size: u8| [&[34, 0, size, u8::try_from(stored.len()).unwrap()][..], stored].concat();
    let layout = read(&file(&[&block(&stored, length), &[20, 0b0001_0000, 2]]));
    assert_eq!(polygons(&layout).len(), 2);
    assert!(refused(&file(&[&block(&stored, 5)])).contains("a compressed block"));
    let nested = [&[1, 4, 0, 0xfb, 0xff][..], &[34, 0, 0, 0]].concat();
    assert!(refused(&file(&[&block(&nested, 4)])).contains("record 34 stands where the format does not allow it"));
    let cut = [&[1, 2, 0, 0xfd, 0xff][..], &[14, 5]].concat();
    let message = refused(&file(&[&block(&cut, 2)]));
    assert!(
        message.contains("malformed at byte 22") && message.contains("of the compressed block, inflated"),
        "{message}"
    );
}

#[test]
fn bombs_are_refused_before_they_cost_anything() {
    let most = [0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f];
    let copies = [&[20, 0b1101_1111, 1, 0, 9, 0, 0, 1][..], &most, &most, &[1, 1]].concat();
    assert!(refused(&in_cell(&[&copies])).contains("exceeds what the option max_elements allows"));
    // 2²⁶ squares are allowed by default; this is one column more.
    let texts = [&[19, 0b0101_1111, 1, b'x', 1, 1, 0, 0, 2][..], &[0x80, 0x80, 0x80, 0x20], &[1]].concat();
    assert!(refused(&in_cell(&[&texts])).contains("max_elements"));
    let name = [&[14][..], &most, b"A"].concat();
    assert!(refused(&file(&[&name])).contains("bytes of a string"));
    let far = [&[20, 0b1101_1011, 1, 0, 9][..], &[0xfe, 0xff, 0xff, 0xff, 0x1f], &[0]].concat();
    assert!(refused(&in_cell(&[&far])).contains("a coordinate beyond 32 bits"));
    // An array of cells costs nothing.
    let array = [&[17, 0b1000_1000, 1, b'B', 1, 0xfe, 0xff, 3, 0xfe, 0xff, 3, 1, 1][..]].concat();
    let layout = read(&in_cell(&[&array]));
    assert_eq!(layout.cells[0].placements[0].lattice.as_ref().unwrap().columns, 65_536);
}

#[test]
fn what_a_file_says_of_its_tables_is_compared() {
    let offsets = |strict: u8, offset: u8| {
        let start = b"%SEMI-OASIS\r\n\x01\x031.0\x00\xe8\x07\x00";
        let table = [&[strict, offset][..], &[0; 10]].concat();
        let end = [&[2][..], &[0xfc, 1], &[0; 252], &[0]].concat();
        [&start[..], &table, &[3, 1, b'A', 13, 0], &end].concat()
    };
    assert_eq!(kinds(&read(&offsets(1, 34))), []);
    let wrong = kinds(&read(&offsets(1, 35)));
    let [ProblemKind::Strict(what)] = &wrong[..] else { panic!("{wrong:?}") };
    assert_eq!(&**what, "the CELLNAME table is stated to begin at byte 35, but it begins at byte 34");
    let trailing = [&offsets(0, 0)[..], b"more"].concat();
    assert_eq!(kinds(&read(&trailing)), [ProblemKind::Trailing(4)]);
}

#[test]
fn files_that_are_none_say_why() {
    assert!(refused(b"GDS").contains("not an OASIS file"));
    assert!(refused(b"%SEMI-OASIS\r\n\x02").contains("the first record is not START"));
    assert!(refused(b"%SEMI-OASIS\r\n\x01\x032.0\x00\x01\x01").contains("the version is \"2.0\""));
    assert!(refused(b"%SEMI-OASIS\r\n\x01\x031.0\x00\x00\x01").contains("the unit is 0 grid steps"));
    assert!(refused(b"%SEMI-OASIS\r\n\x01\x031.0\x00\xe8\x07\x01").contains("without an END record"));
    assert!(refused(&file(&[&[20, 0]])).contains("stands outside of cells"));
    assert!(refused(&file(&[&[35]])).contains("record 35 is unknown"));
}

/// A layout with every kind of element.
pub(crate) fn layout() -> Layout {
    let mut layout = Layout::new(Grid::new(1e-3).unwrap());
    let [leaf, top, missing] = ["leaf", "top", "missing"].map(|name| layout.names.intern(name));
    let mut cell = Cell::new(leaf);
    for i in 0..40 {
        let (x, y) = (i % 8 * 100, i / 8 * 70);
        cell.polygons.push(Layer::new(1, 0), [[x, y], [x + 50, y], [x + 50, y + 20], [x, y + 20]]);
        cell.polygons.push(Layer::new(2, 3), [[x, y], [x + 31, y + 7 * i], [x + 9, y + 40]]);
    }
    cell.polygons.push(Layer::new(1, 0), [[0, 0], [0, 50], [20, 50], [20, 0]]);
    cell.polygons.set_properties([(7, "seven".to_owned()), (9, "µ".to_owned())].into());
    cell.polygons.push(Layer::new(1, 0), [[0, 0], [60, 0], [60, 40], [30, 40], [30, 20], [0, 20]]);
    let path = |end: PathEnd, width| Path {
        layer: Layer::new(4, 0),
        points: vec![[0, 0], [100, 0], [150, 80]],
        width,
        fixed_width: false,
        start: PathEnd::Flush,
        end,
        properties: [(1, "p".to_owned())].into(),
        offset: 0,
    };
    cell.paths = vec![path(PathEnd::Square, 20), path(PathEnd::Extended(-7), 20)];
    let text = |string: &str, x| Text {
        layer: Layer::new(5, 6),
        string: string.to_owned(),
        origin: [x, -x],
        x_reflection: false,
        magnification: None,
        rotation: 0.0,
        anchor: Some(phidl_core::scene::Anchor::Center),
        font: 0,
        path_type: None,
        width: None,
        properties: Default::default(),
        offset: 0,
    };
    cell.texts = vec![text("a", 0), text("b", 1), text("a", 2), text("two\nlines Ω", 3), text("", 4)];
    cell.texts[1].anchor = None;
    cell.texts[2].rotation = 30.5;
    cell.texts[2].properties = [(3, "t".to_owned())].into();
    layout.cells.push(cell);
    let mut cell = Cell::new(top);
    for i in 0..8 {
        let rotation = f64::from(i) * 45.0;
        let origin = [100 * i, i * i];
        cell.placements.push(Placement { origin, rotation, x_reflection: i % 2 == 0, ..Placement::new(leaf) });
    }
    let lattice = Lattice { columns: 3, rows: 4, column_extent: [300, 30], row_extent: [-40, 400] };
    cell.placements.push(Placement { lattice: Some(Box::new(lattice)), magnification: 2.5, ..Placement::new(leaf) });
    cell.placements
        .push(Placement { properties: Some(Box::new([(2, "r".to_owned())].into())), ..Placement::new(missing) });
    layout.cells.push(cell);
    layout
}

/// What a layout holds, in an order that does not depend on that of its elements.
fn sorted(layout: &Layout) -> Vec<String> {
    let mut lines = Vec::new();
    for cell in &layout.cells {
        let name = layout.names.name(cell.name);
        for polygon in cell.polygons.iter() {
            // From the lowest corner on, counter-clockwise.
            let mut corners = polygon.corners.to_vec();
            let next = corners[1..].iter().chain(&corners[..1]);
            let area: i128 = corners
                .iter()
                .zip(next)
                .map(|(a, b)| i128::from(a[0]) * i128::from(b[1]) - i128::from(b[0]) * i128::from(a[1]))
                .sum();
            if area < 0 {
                corners.reverse();
            }
            let lowest = (0..corners.len()).min_by_key(|i| corners[*i]).unwrap();
            corners.rotate_left(lowest);
            lines.push(format!("{name} polygon {} {corners:?} {:?}", polygon.layer, polygon.properties));
        }
        let text = |t: &Text| format!("{name} text {:?}", Text { offset: 0, ..t.clone() });
        lines.extend(cell.texts.iter().map(text));
        lines.extend(cell.paths.iter().map(|p| format!("{name} path {:?}", Path { offset: 0, ..p.clone() })));
        for p in &cell.placements {
            let child = layout.names.name(p.child);
            let Placement { origin, x_reflection, magnification, rotation, lattice, properties, .. } = p;
            lines.push(format!(
                "{name} {child} {origin:?} {x_reflection} {magnification} {rotation} {lattice:?} {properties:?}"
            ));
        }
    }
    lines.sort();
    lines
}

#[test]
fn what_is_written_is_read_back_whole() {
    let layout = layout();
    for shapes in [Shapes::Rectangles, Shapes::Polygons] {
        for merge_repeats in [true, false] {
            for compress in [true, false] {
                let options = EncodeOptions { shapes, merge_repeats, compress, ..Default::default() };
                let (bytes, report) = encode(&layout, &options).unwrap();
                let back = read(&bytes);
                assert_eq!(kinds(&back), [], "{options:?}");
                assert_eq!(sorted(&back), sorted(&layout), "{options:?}");
                assert_eq!(report.cells, ["leaf", "top"]);
                assert_eq!((report.left_out, report.labels_simplified, report.renamed), (0, 3, 0));
                // A fixed point after one trip.
                let again = encode(&back, &options).unwrap().0;
                assert_eq!(encode(&read(&again), &options).unwrap().0, again);
            }
        }
    }
}

#[test]
fn without_merging_polygons_keep_order_and_corners() {
    let layout = layout();
    let options = EncodeOptions { shapes: Shapes::Polygons, merge_repeats: false, ..Default::default() };
    let back = read(&encode(&layout, &options).unwrap().0);
    let of = |layer: u16, layout: &Layout| {
        polygons(layout).into_iter().filter(|(l, _)| l.number == layer).collect::<Vec<_>>()
    };
    for layer in [1, 2] {
        assert_eq!(of(layer, &back), of(layer, &layout));
    }
}

#[test]
fn repeated_shapes_share_a_record() {
    let (_, report) = encode(&layout(), &EncodeOptions::default()).unwrap();
    let (_, single) = encode(&layout(), &EncodeOptions { merge_repeats: false, ..Default::default() }).unwrap();
    assert_eq!(report.records + report.repeats_merged, single.records);
    assert!(report.repeats_merged >= 39, "{report:?}");
}

#[test]
fn all_checksums_are_right() {
    for validation in [Validation::Crc32, Validation::Sum, Validation::None] {
        let (bytes, report) = encode(&layout(), &EncodeOptions { validation, ..Default::default() }).unwrap();
        let options = DecodeOptions { checksum: Checksum::Refuse, ..Default::default() };
        assert!(decode(&bytes, "test", &options).is_ok());
        assert_eq!(report.bytes, bytes.len() as u64);
    }
}

#[test]
fn names_that_the_format_does_not_have_get_others() {
    let mut layout = Layout::new(Grid::new(1e-3).unwrap());
    for name in ["a b", "a_b", "µ", "ok"] {
        let id = layout.names.intern(name);
        layout.cells.push(Cell::new(id));
    }
    let (bytes, report) = encode(&layout, &EncodeOptions::default()).unwrap();
    assert_eq!(report.cells, ["a_b_2", "a_b", "_", "ok"]);
    assert_eq!(report.renamed, 2);
    assert_eq!(read(&bytes).cells.len(), 4);
}

#[test]
fn an_empty_layout_is_a_file() {
    let layout = Layout::new(Grid::new(5e-3).unwrap());
    let (bytes, _) = encode(&layout, &EncodeOptions::default()).unwrap();
    let back = read(&bytes);
    assert_eq!((back.cells.len(), back.grid.step(), kinds(&back)), (0, 5e-3, Vec::new()));
}

#[test]
fn coordinates_reach_all_32_bits() {
    let mut layout = Layout::new(Grid::new(1e-3).unwrap());
    let mut cell = Cell::new(layout.names.intern("far"));
    let (min, max) = (i32::MIN, i32::MAX);
    cell.polygons.push(Layer::new(u16::MAX, u16::MAX), [[min, min], [max, min], [max, max], [min, max]]);
    cell.polygons.push(Layer::new(0, 0), [[min, min], [max, max], [0, 1]]);
    layout.cells.push(cell);
    let back = read(&encode(&layout, &EncodeOptions::default()).unwrap().0);
    assert_eq!(sorted(&back), sorted(&layout));
}
