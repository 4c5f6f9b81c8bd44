//! The stand-alone user workspaces below `examples/`, built and run as a user would.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use phidl_boolean::{OffsetOptions, Operation, Options, boolean, offset};
use phidl_core::prelude::*;
use phidl_io::gds::{self, ReadOptions};

const CORE: u16 = 1;
const TRENCH: u16 = 2;
const DUMMY: u16 = 3;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the workspace")
}

fn example() -> PathBuf {
    root().join("examples/coupler_chip")
}

/// Our crates, which the example has optimized and the test builds quickly instead.
const OURS: [&str; 7] = ["core", "macros", "path", "boolean", "geometry", "route", "io"];

/// The program, built in the target folder of this workspace, whose dependencies it shares.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    let target = Path::new(env!("CARGO_BIN_EXE_xtask")).ancestors().nth(2).expect("TARGET/PROFILE/xtask");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--locked", "--offline", "--target-dir"]).arg(target).current_dir(example());
    cargo.args(OURS.map(|krate| format!("--config=profile.dev.package.phidl-{krate}.opt-level=0")));
    let built = cargo.output().expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    target.join("debug").join(format!("coupler_chip{}", std::env::consts::EXE_SUFFIX))
});

/// A folder with masks to build: their names with what the files say.
fn folder(masks: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("masks")).expect("a folder");
    for (name, text) in masks {
        fs::write(folder.path().join("masks").join(name).with_extension("json"), text).expect("a file");
    }
    folder
}

fn run(folder: &Path, names: &[&str]) -> Output {
    Command::new(&*PROGRAM).args(names).current_dir(folder).env("RUST_BACKTRACE", "0").output().expect("it runs")
}

fn on(device: &Device, layer: u16) -> Device {
    let mut d = device.edit();
    d.keep_layers(layer, LayerTarget::All);
    d.build().expect("a cell")
}

/// The grid of the files.
fn on_the_grid() -> Options<'static> {
    Options { precision: 0.001, ..Options::default() }
}

#[track_caller]
fn assert_apart(a: &Device, b: &Device) {
    let both = boolean(a, b, Operation::And, 0, &on_the_grid()).expect("an intersection");
    assert!(both.is_empty() && !a.is_empty() && !b.is_empty(), "{:?}", both.bbox());
}

#[test]
fn the_coupler_chip_builds_its_masks_and_they_keep_their_rules() {
    let described: Vec<(String, String)> = fs::read_dir(example().join("masks"))
        .expect("masks")
        .map(|entry| entry.expect("an entry").path())
        .map(|path| (path.file_stem().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap()))
        .collect();
    let masks: Vec<(&str, &str)> = described.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let folder = folder(&masks);
    let output = run(folder.path(), &[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(masks.len() >= 2);
    for (name, _) in masks {
        let built = folder.path().join("target/mask").join(name);
        assert!(built.join(name).with_extension("svg").exists() && built.join("metadata.json").exists());
        let gds = built.join(name).with_extension("gds");
        let chip = gds::read(gds, &ReadOptions::default()).expect("what it wrote").device;
        let core = on(&chip, CORE);
        assert_eq!((core.bbox().map(|b| b.min.x), core.bbox().map(|b| b.max.x)), (Some(-600.0), Some(600.0)));
        assert_apart(&core, &on(&chip, TRENCH));
        let near = offset(&core, 9.99, &OffsetOptions::default(), 0, &on_the_grid()).expect("an offset");
        assert_apart(&near, &on(&chip, DUMMY));
    }
}

#[test]
fn a_mask_that_cannot_be_drawn_says_what_is_wrong_with_which_file() {
    let gap = r#"{"device": "coupler_chip", "params": {"gaps": [0.2, 0]}}"#;
    let folder = folder(&[("gap", gap), ("name", r#"{"device": "couplr_chip"}"#), ("text", "{")]);
    for (mask, told) in [
        ("gap", "coupler_chip: gaps[1] is 0 µm, but it must be greater than 0 µm"),
        ("name", "there is no generator \"couplr_chip\"; known are"),
        ("text", "EOF while parsing"),
        ("nix", "No such file"),
    ] {
        let output = run(folder.path(), &[mask]);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && output.stdout.is_empty(), "{mask}");
        assert!(error.contains(told) && error.contains(&format!("masks/{mask}.json")), "{error}");
    }
}

#[test]
fn the_devices_of_the_example_are_listed_and_drawn_by_name() {
    let folder = folder(&[]);
    let listed = run(folder.path(), &["devices", "coupler"]);
    let text = String::from_utf8_lossy(&listed.stdout).into_owned();
    assert!(listed.status.success() && text.contains("coupler_chip") && text.contains("gap"), "{text}");
    let drawn = run(folder.path(), &["device", "coupler", "--params", r#"{"gap": 0.3}"#, "--out", "coupler.gds"]);
    assert!(drawn.status.success(), "{}", String::from_utf8_lossy(&drawn.stderr));
    let coupler = gds::read(folder.path().join("coupler.gds"), &ReadOptions::default()).expect("a file").device;
    assert_eq!(coupler.layers(), [Layer::new(CORE, 0)]);
    let refused = run(folder.path(), &["device", "coupler", "--params", r#"{"gap": 0}"#, "--out", "no.gds"]);
    let error = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(error, "error: coupler: gap is 0 µm, but it must be greater than 0 µm\n");
}

#[test]
fn an_example_needs_no_package_that_the_workspace_has_not() {
    let packages = |folder: &Path| -> BTreeSet<(String, String)> {
        let lock: toml::Table = fs::read_to_string(folder.join("Cargo.lock")).unwrap().parse().unwrap();
        let all = lock["package"].as_array().unwrap().iter();
        let word = |package: &toml::Value, key: &str| package[key].as_str().unwrap().to_owned();
        all.map(|package| (word(package, "name"), word(package, "version"))).collect()
    };
    let own = ("coupler_chip".to_owned(), "0.1.0".to_owned());
    let (example, workspace) = (packages(&example()), packages(root()));
    let missing: Vec<_> = example.difference(&workspace).filter(|package| **package != own).collect();
    assert!(missing.is_empty(), "`cargo update` in one of them moved {missing:?}");
}
