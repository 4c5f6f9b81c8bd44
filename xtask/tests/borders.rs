//! The borders between the crates that ARCHITECTURE.md promises, read off the manifests and sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Which crates of ours each one may depend on.
const ARROWS: [(&str, &[&str]); 8] = [
    ("phidl-macros", &[]),
    ("phidl-core", &[]),
    ("phidl-path", &["phidl-core"]),
    ("phidl-boolean", &["phidl-core"]),
    ("phidl-geometry", &["phidl-core", "phidl-macros", "phidl-path", "phidl-boolean"]),
    ("phidl-route", &["phidl-core", "phidl-macros", "phidl-path"]),
    ("phidl-io", &["phidl-core", "phidl-boolean"]),
    (
        "phidl",
        &["phidl-boolean", "phidl-core", "phidl-geometry", "phidl-io", "phidl-macros", "phidl-path", "phidl-route"],
    ),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the workspace").to_owned()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn manifest(krate: &str) -> toml::Table {
    read(&root().join(krate).join("Cargo.toml")).parse().unwrap_or_else(|error| panic!("{krate}: {error}"))
}

/// All Rust sources below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

/// The lines of code that name something, without comments and unit tests, which stand at the foot of a file.
fn lines_naming<'a>(source: &'a str, word: &str) -> Vec<&'a str> {
    let code = source.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    code.lines().filter(|line| !line.trim_start().starts_with("//") && line.contains(word)).collect()
}

/// Every place below the source folders of our crates that names something, by file.
fn places_naming(word: &str) -> BTreeMap<PathBuf, usize> {
    let mut places = BTreeMap::new();
    for (krate, _) in ARROWS {
        for file in sources(&root().join(krate).join("src")) {
            let count = lines_naming(&read(&file), word).len();
            if count > 0 {
                places.insert(file.strip_prefix(root()).expect("a file of ours").to_owned(), count);
            }
        }
    }
    places
}

#[test]
fn crates_depend_on_no_more_of_ours_than_the_arrows_show() {
    for (krate, allowed) in ARROWS {
        let manifest = manifest(krate);
        let dependencies: BTreeSet<&str> = manifest["dependencies"]
            .as_table()
            .expect("a table")
            .keys()
            .map(String::as_str)
            .filter(|name| name.starts_with("phidl-"))
            .collect();
        let allowed: BTreeSet<&str> = allowed.iter().copied().collect();
        assert!(dependencies.is_subset(&allowed), "{krate} depends on {dependencies:?}, may on {allowed:?}");
    }
}

#[test]
fn every_crate_inherits_the_lints_of_the_workspace() {
    let lints = read(&root().join("Cargo.toml"));
    assert!(lints.contains("unsafe_code = \"forbid\""));
    for krate in ARROWS.map(|(krate, _)| krate).into_iter().chain(["xtask", "xtask/testkit"]) {
        assert_eq!(manifest(krate)["lints"]["workspace"].as_bool(), Some(true), "{krate}");
    }
}

#[test]
fn foreign_engines_are_met_in_one_place() {
    let gds: Vec<_> = places_naming("gds21").into_keys().collect();
    assert!(gds.iter().all(|file| file.starts_with("phidl-io/src/gds")), "{gds:?}");
    let overlay: Vec<_> = places_naming("i_overlay").into_keys().collect();
    assert!(overlay.is_empty(), "it only checks results, in tests: {overlay:?}");
}

#[test]
fn core_knows_no_clock_and_no_format_and_never_prints() {
    for word in ["SystemTime", "Instant::", "println!", "eprintln!", "serde_json", "std::fs", "std::io"] {
        let places: Vec<_> = places_naming(word).into_keys().filter(|file| file.starts_with("phidl-core")).collect();
        assert!(places.is_empty(), "{word} in {places:?}");
    }
    let rayon: Vec<_> = places_naming("rayon").into_keys().filter(|file| file.starts_with("phidl-core")).collect();
    let behind_the_feature = ["phidl-core/src/runtime/stack.rs", "phidl-core/src/scene/parallel.rs"].map(Path::new);
    assert_eq!(rayon, behind_the_feature);
}

#[test]
fn nothing_of_ours_reads_the_clock() {
    for word in ["SystemTime::now", "Instant::now"] {
        let places = places_naming(word);
        assert!(places.is_empty(), "{word} in {places:?}");
    }
}

#[test]
fn every_module_says_what_it_is_for() {
    for (krate, _) in ARROWS {
        for file in sources(&root().join(krate).join("src")) {
            assert!(read(&file).starts_with("//!"), "{} has no module docs", file.display());
        }
    }
}

#[test]
fn the_changelog_has_an_open_section() {
    assert!(read(&root().join("CHANGELOG.md")).contains("## Unreleased"));
}
