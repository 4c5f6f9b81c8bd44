//! Reading reference results.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use phidl_core::param::Value;
use serde::Deserialize;
use serde_json::Value as Json;

/// Which kind of case a test wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A registered generator with parameters.
    Geometry,
    /// A small script on one device.
    Placement,
    /// Path segments with operations and perhaps an extrusion.
    Path,
    /// A route or the waypoints of one.
    Routing,
}

/// One reference result.
#[derive(Debug, Clone, Deserialize)]
pub struct Case {
    /// Its name.
    pub id: String,
    /// The generator (geometry).
    #[serde(default)]
    pub device: String,
    /// The function (routing).
    #[serde(default, rename = "fn")]
    pub function: String,
    /// The parameters, by their registered names.
    #[serde(default)]
    pub params: BTreeMap<String, Json>,
    /// What came out.
    pub expect: Json,
    /// `region` where only the covered area counts.
    #[serde(default)]
    pub compare: Option<String>,
    /// Whether the reference was drawn without its glyphs.
    #[serde(default)]
    pub text: bool,
    /// Everything else that the kind has.
    #[serde(flatten)]
    pub rest: BTreeMap<String, Json>,
}

impl Case {
    /// The parameters as values that the registry takes.
    ///
    /// # Panics
    /// If the file holds what no value can.
    #[must_use]
    pub fn values(&self) -> BTreeMap<String, Value> {
        let value = |json: &Json| Value::deserialize(json).expect("any JSON is a value");
        self.params.iter().map(|(name, json)| (name.clone(), value(json))).collect()
    }

    fn kind(&self) -> Kind {
        if self.rest.contains_key("ops") && !self.rest.contains_key("segments") && !self.rest.contains_key("smooth") {
            Kind::Placement
        } else if !self.function.is_empty() {
            Kind::Routing
        } else if self.device.is_empty() {
            Kind::Path
        } else {
            Kind::Geometry
        }
    }
}

/// All cases of a kind, in the order of file names and of the files.
///
/// # Panics
/// If there is no case of this kind, or a file cannot be read: a test that compares nothing must not pass.
#[must_use]
pub fn load(kind: Kind) -> Vec<Case> {
    let folder = folder();
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    let cases: Vec<Case> = files.iter().flat_map(|file| read(file)).filter(|case| case.kind() == kind).collect();
    assert!(!cases.is_empty(), "{} holds no case of the kind {kind:?}", folder.display());
    cases
}

fn folder() -> PathBuf {
    std::env::var_os("PHIDL_GOLDEN").map_or_else(own_folder, PathBuf::from)
}

/// The project's own copy of the reference results.
pub(super) fn own_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

fn read(file: &Path) -> Vec<Case> {
    let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}
