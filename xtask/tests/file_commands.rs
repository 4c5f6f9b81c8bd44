//! `cargo xtask boolean` and `cargo xtask offset`, from the command line to the files.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use phidl_boolean::{Join, OffsetOptions, Options, boolean, offset, xor_diff};
use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};

/// A folder with `in.gds`: a cell `pad` with a square on layer 1 and a turned one on layer 2/1, and a cell `top` with
/// an array of it.
fn folder() -> tempfile::TempDir {
    let mut d = Device::builder("pad");
    d.add_polygon(Rect::new((0, 0), (10, 10)), 1).unwrap();
    d.add_polygon([(5, 2), (8, 5), (5, 8), (2, 5)], (2, 1)).unwrap();
    let pad = d.build().unwrap();
    let mut d = Device::builder("top");
    d.add(pad.array(3, 2, (8, 20)));
    let folder = tempfile::tempdir().unwrap();
    gds::write(&d.build().unwrap(), folder.path().join("in.gds"), &GdsOptions::default()).unwrap();
    folder
}

/// Runs the program in a folder with a line of arguments.
fn xtask(folder: &Path, line: &str) -> Output {
    let words = line.split_whitespace();
    Command::new(env!("CARGO_BIN_EXE_xtask")).args(words).current_dir(folder).output().unwrap()
}

/// What a successful run prints.
#[track_caller]
fn succeeds(folder: &Path, line: &str) -> String {
    let output = xtask(folder, line);
    assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty(), "{line}: nothing is to be complained about");
    String::from_utf8(output.stdout).unwrap()
}

/// The line that a refused run prints.
#[track_caller]
fn fails(folder: &Path, line: &str) -> String {
    let output = xtask(folder, line);
    assert_eq!(output.status.code(), Some(1), "{line}");
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(text.lines().count(), 1, "{text}");
    assert!(text.starts_with("error: ") && output.stdout.is_empty(), "{text}");
    text
}

fn read(folder: &Path, file: &str, cell: Option<&str>) -> Device {
    let options = ReadOptions { cellname: cell.map(Into::into), ..ReadOptions::default() };
    gds::read(folder.join(file), &options).unwrap().device
}

fn on(device: &Device, layer: impl Into<Layers>) -> Device {
    let mut d = device.edit();
    d.keep_layers(layer, LayerTarget::All);
    d.build().unwrap()
}

#[track_caller]
fn assert_same(result: &Device, expected: &Device) {
    let difference = xor_diff(result, expected, &Options::default()).unwrap();
    assert!(difference.is_empty(), "{:?}", difference.bbox());
    assert!(!expected.is_empty());
}

#[test]
fn every_operation_writes_what_the_library_draws() {
    let folder = folder();
    let top = read(folder.path(), "in.gds", None);
    for operation in ["or", "and", "not", "A-B", "B-A", "xor"] {
        succeeds(folder.path(), &format!("boolean in.gds:1 in.gds:2/1 --op {operation} --out out.gds:7/3"));
        let result = read(folder.path(), "out.gds", None);
        let expected = boolean(&on(&top, 1), &on(&top, (2, 1)), operation, (7, 3), &Options::default()).unwrap();
        if operation == "B-A" {
            assert!(result.is_empty() && expected.is_empty());
            continue;
        }
        assert_eq!((result.name(), result.layers()), ("out", vec![Layer::new(7, 3)]));
        assert_same(&result, &expected);
    }
}

#[test]
fn one_cell_of_a_file_is_read_by_its_name() {
    let folder = folder();
    let [pad, top] = [Some("pad"), None].map(|cell| read(folder.path(), "in.gds", cell));
    succeeds(folder.path(), "boolean in.gds:1 in.gds:2/1 --op not --cell pad --out out.gds:1");
    let expected = boolean(&on(&pad, 1), &on(&pad, (2, 1)), "not", 1, &Options::default()).unwrap();
    assert_same(&read(folder.path(), "out.gds", None), &expected);
    succeeds(folder.path(), "boolean in.gds:1 in.gds:2/1 --op not --cell top --cell-b pad --out out.gds:1");
    let expected = boolean(&on(&top, 1), &on(&pad, (2, 1)), "not", 1, &Options::default()).unwrap();
    assert_same(&read(folder.path(), "out.gds", None), &expected);
}

#[test]
fn every_join_is_drawn_as_by_the_library_in_both_directions() {
    let folder = folder();
    let squares = on(&read(folder.path(), "in.gds", None), (2, 1));
    for (flags, join) in [
        ("", Join::default()),
        ("--miter-limit 1", Join::Miter { limit: 1.0 }),
        ("--join bevel", Join::Bevel),
        ("--join round --points-per-turn 16", Join::Round { points_per_turn: 16.0 }),
    ] {
        for distance in [1.25, -0.5] {
            succeeds(folder.path(), &format!("offset in.gds:2/1 --distance {distance} {flags} --out out.gds:4"));
            let growth = OffsetOptions { join, ..OffsetOptions::default() };
            let expected = offset(&squares, distance, &growth, 4, &Options::default()).unwrap();
            assert_same(&read(folder.path(), "out.gds", None), &expected);
        }
    }
}

#[test]
fn threads_and_divisions_change_no_byte() {
    let folder = folder();
    let bytes = |flags: &str| {
        succeeds(folder.path(), &format!("boolean in.gds:1 in.gds:2/1 --op xor --out out.gds:1 {flags}"));
        fs::read(folder.path().join("out.gds")).unwrap()
    };
    let first = bytes("");
    assert!(["--threads 1", "--threads 3 --divisions 7", "--divisions 1"].iter().all(|flags| bytes(flags) == first));
}

#[test]
fn vertices_stages_and_memory_are_told() {
    let folder = folder();
    let told = succeeds(folder.path(), "boolean in.gds:1 in.gds:2/1 --op not --out out.gds:1");
    let words: Vec<Vec<&str>> = told.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(words[0], ["A", "6", "polygons", "24", "vertices", "in.gds:1/0"]);
    assert_eq!(words[1], ["B", "6", "polygons", "24", "vertices", "in.gds:2/1"]);
    // The squares of a row overlap: two polygons, each with the holes of three turned squares.
    assert_eq!(words[2], ["result", "2", "polygons", "32", "vertices", "out.gds:1/0"]);
    let stages: Vec<&str> = words[3..].iter().map(|line| line[0]).collect();
    assert_eq!(stages, ["start", "read", "round", "combine", "draw", "write", "total"]);
    let megabytes = |line: &[&str]| line[3].parse::<f64>().unwrap();
    assert!(words[3..].windows(2).all(|pair| megabytes(&pair[0]) <= megabytes(&pair[1])), "peaks only grow: {told}");
    let told = succeeds(folder.path(), "offset in.gds:1 --distance 1 --out out.gds:1");
    assert!(told.contains("input") && told.contains("\noffset"), "{told}");
}

#[test]
fn what_cannot_be_done_is_one_line_and_leaves_the_old_result() {
    let folder = folder();
    fs::write(folder.path().join("out.gds"), "an old result").unwrap();
    fs::write(folder.path().join("text.gds"), "no layout").unwrap();
    for (line, told) in [
        ("boolean nix.gds:1 in.gds:1 --op or --out out.gds:1", "nix.gds: could not read it"),
        ("boolean text.gds:1 in.gds:1 --op or --out out.gds:1", "text.gds: "),
        ("boolean in.gds:9 in.gds:1 --op or --out out.gds:1", "in.gds:9/0: nothing is drawn on this layer"),
        ("boolean in.gds:1 in.gds:1 --op nor --out out.gds:1", "operation is \"nor\", but it must be one of or"),
        ("boolean in.gds:1 in.gds:1 --op or --precision -1 --out out.gds:1", "precision is -1 µm, but it must be"),
        ("boolean in.gds:1 in.gds:1 --op or --precision 1e-9 --out out.gds:1", "coordinate"),
        ("boolean in.gds:1 in.gds:1 --op or --cell nix --out out.gds:1", "no cell \"nix\"; its cells are"),
        ("boolean in.gds:1 in.gds:1 --op or --threads 0 --out out.gds:1", "threads is 0, but it must be"),
        ("boolean in.gds:1 in.gds:1 --op or --divisions 0 --out out.gds:1", "strips is 0, but it must be"),
        ("offset in.gds:1 --distance NaN --out out.gds:1", "distance is NaN"),
        ("offset in.gds:1 --distance 1 --miter-limit -2 --out out.gds:1", "miter limit is -2"),
        ("offset in.gds:1 --distance 1 --out nix/out.gds:1", "nix/out.gds: could not"),
    ] {
        let error = fails(folder.path(), line);
        assert!(error.contains(told), "{line}: {error}");
        assert_eq!(fs::read_to_string(folder.path().join("out.gds")).unwrap(), "an old result", "{line}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3, "no half file is left");
}

#[test]
fn a_file_that_is_read_is_not_replaced() {
    let folder = folder();
    let before = fs::read(folder.path().join("in.gds")).unwrap();
    for line in ["boolean in.gds:1 in.gds:2/1 --op or --out ./in.gds:3", "offset in.gds:1 --distance 1 --out in.gds:3"]
    {
        assert!(fails(folder.path(), line).contains("--out must be another file"));
    }
    assert_eq!(fs::read(folder.path().join("in.gds")).unwrap(), before);
}

#[test]
fn a_reader_that_has_read_enough_is_no_error() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let mut listing =
        command.arg("devices").stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    drop(listing.stdout.take());
    let output = listing.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn words_that_are_none_are_refused_with_the_usage() {
    let folder = folder();
    for line in ["boolean in.gds in.gds:1 --op or --out out.gds:1", "offset in.gds:1 --distance far --out out.gds:1"] {
        let output = xtask(folder.path(), line);
        assert_eq!(output.status.code(), Some(2), "{line}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("invalid value"), "{line}");
    }
}
