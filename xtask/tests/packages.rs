//! What a registry asks of a package: metadata, a README, a license, and nothing from outside the package.
//!
//! `cargo package --workspace --exclude xtask --exclude testkit`, which `.ci/run` calls, packs them.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// The packages that are published, dependencies first.
const PUBLISHED: [&str; 8] =
    ["phidl-macros", "phidl-core", "phidl-path", "phidl-boolean", "phidl-geometry", "phidl-route", "phidl-io", "phidl"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the workspace")
}

fn manifest(krate: &str) -> toml::Table {
    let path = root().join(krate).join("Cargo.toml");
    fs::read_to_string(&path).expect("a manifest").parse().unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn packages_have_the_metadata_of_a_registry() {
    for krate in PUBLISHED {
        let package = manifest(krate)["package"].as_table().expect("a table").clone();
        let text = |key: &str| package.get(key).and_then(toml::Value::as_str).unwrap_or_default().to_owned();
        assert!(text("description").len() > 20, "{krate}: description");
        assert_eq!(text("documentation"), format!("https://docs.rs/{krate}"));
        assert!(root().join(krate).join(text("readme")).is_file(), "{krate}: README");
        for key in ["version", "edition", "rust-version", "license"] {
            assert_eq!(package[key]["workspace"].as_bool(), Some(true), "{krate}: {key}");
        }
        let list = |key: &str| -> Vec<String> {
            package[key]
                .as_array()
                .expect("a list")
                .iter()
                .map(|item| item.as_str().expect("text").to_owned())
                .collect()
        };
        let keywords = list("keywords");
        assert!((1..=5).contains(&keywords.len()) && keywords.iter().all(|word| word.len() <= 20), "{krate}: keywords");
        assert!((1..=5).contains(&list("categories").len()), "{krate}: categories");
        assert_eq!(package["metadata"]["docs"]["rs"]["all-features"].as_bool(), Some(true), "{krate}: docs.rs");
        assert!(!package.contains_key("publish"), "{krate} is published");
    }
}

#[test]
fn dependencies_of_ours_are_published_before() {
    for (place, krate) in PUBLISHED.iter().enumerate() {
        let manifest = manifest(krate);
        let ours =
            manifest["dependencies"].as_table().expect("a table").keys().filter(|name| name.starts_with("phidl"));
        for name in ours {
            assert!(PUBLISHED[..place].contains(&name.as_str()), "{krate} needs {name}, which is published later");
        }
    }
}

/// The sources of a package, tests and examples included.
fn sources(folder: PathBuf) -> Vec<PathBuf> {
    let (mut files, mut stack) = (Vec::new(), vec![folder]);
    while let Some(folder) = stack.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                stack.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                files.push(path);
            }
        }
    }
    files
}

/// How many folders above the file's own a relative path climbs.
fn climbs(path: &str) -> usize {
    Path::new(path).components().take_while(|part| *part == Component::ParentDir).count()
}

#[test]
fn no_library_includes_a_file_from_outside_its_package() {
    for krate in PUBLISHED {
        let source = root().join(krate).join("src");
        for file in sources(source.clone()) {
            let depth = file.strip_prefix(root().join(krate)).expect("inside").components().count() - 1;
            let text = fs::read_to_string(&file).expect("a source");
            for included in text.split("include_str!(\"").skip(1).chain(text.split("include_bytes!(\"").skip(1)) {
                let path = included.split('"').next().unwrap_or_default();
                assert!(climbs(path) <= depth, "{} includes {path}", file.display());
            }
        }
    }
}
