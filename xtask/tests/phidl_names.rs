//! `docs/guide/coming-from-phidl.md`: every public name of PHIDL and ours.
//!
//! `phidl-names.json` is PHIDL's own list, made by `xtask/golden/names.py`; `phidl-names.tsv` has ours beside it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use phidl_core::registry;
use phidl_geometry as _;
use phidl_route as _;

const HEAD: &str = "# Coming from PHIDL

Shapes, routes, their parameters, ports and points have PHIDL's names. This page lists every public name of PHIDL 1.7.2 and
ours. [Differences from PHIDL](../differences.md) lists where the results differ.

A script becomes a program like this:

```python
import phidl.geometry as pg
from phidl import Device

D = Device('chip')
ring = D << pg.ring(radius = 10, width = 0.5, layer = 1)
bus = D << pg.straight(size = (0.5, 60), layer = 1)
bus.rotate(90)
bus.center = (0, 0)
ring.x = 0
ring.ymin = bus.ymax + 0.2
D.write_gds('chip.gds')
```

```rust,no_run
use phidl::io::gds;
use phidl::prelude::*;
use phidl::shapes as pg;

fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let mut d = Device::builder(\"chip\");
    let ring = d.add(pg::RingParams::default().radius(10).width(0.5).layer(1).build()?);
    let bus = d.add(pg::StraightParams::default().size((0.5, 60)).layer(1).build()?);
    d[bus].rotate(90).set_center((0, 0));
    let top = d[bus].ymax();
    d[ring].set_x(0).set_ymin(top + 0.2);
    gds::write(&d.build()?, \"chip.gds\", &gds::GdsOptions::default())?;
    Ok(())
}
```

- A PHIDL `Device` is open all its life. Ours is open as a `DeviceBuilder`; `build()` finishes it, and a finished `Device` never
  changes. `edit()` opens a copy.
- `D << shape` is `d.add(shape)`; the key that it returns takes the place of the reference: `d[key]`.
- `ref.xmin = 5` is `set_xmin(5)`.
- A placement method that gets a bad value reports it with the next call that can fail, at the latest with `build()`.
";

fn guide() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide")
}

/// Owner, name and our spelling, in the order of the file.
fn table() -> Vec<(String, String, String)> {
    let text = fs::read_to_string(guide().join("phidl-names.tsv")).expect("a table");
    let row = |line: &str| -> Option<(String, String, String)> {
        let mut cells = line.split('\t').map(str::to_owned);
        Some((cells.next()?, cells.next()?, cells.next()?))
    };
    text.lines().map(|line| row(line).unwrap_or_else(|| panic!("three columns in {line:?}"))).collect()
}

fn page() -> String {
    let mut page = HEAD.to_owned();
    let mut owner = String::new();
    for (next, name, ours) in table() {
        if next != owner {
            owner = next;
            let is_class = owner.starts_with(char::is_uppercase);
            let title = if is_class { format!("`{owner}`") } else { format!("`phidl.{owner}`") };
            page += &format!("\n## {title}\n\n| PHIDL | phidl |\n|---|---|\n");
        }
        page += &format!("| `{name}` | {ours} |\n");
    }
    page
}

/// `UPDATE_EXPECT=1 cargo test -p xtask --test phidl_names` updates the page.
#[test]
fn the_page_shows_the_table() {
    expect_test::expect_file!["../../docs/guide/coming-from-phidl.md"].assert_eq(&page());
}

#[test]
fn every_name_of_phidl_is_in_the_table_once() {
    let text = fs::read_to_string(guide().join("phidl-names.json")).expect("PHIDL's list");
    let theirs: BTreeMap<String, BTreeSet<String>> = serde_json::from_str(&text).expect("names by owner");
    let mut ours: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (owner, name, _) in table() {
        assert!(ours.entry(owner.clone()).or_default().insert(name.clone()), "{owner}.{name} is there twice");
    }
    assert_eq!(ours, theirs);
}

#[test]
fn shapes_and_routes_are_registered_under_their_names() {
    for (owner, name, ours) in table() {
        if ours.starts_with("`shapes::") || ours.starts_with("`route::route_") {
            assert!(registry::find(&name).is_ok(), "{owner}.{name} is said to be {ours}");
        }
    }
}

/// The sources of all libraries in one text.
fn sources() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let crates =
        ["core", "macros", "path", "boolean", "geometry", "route", "io"].map(|name| format!("phidl-{name}/src"));
    let (mut text, mut stack) = (String::new(), crates.map(|path| root.join(path)).to_vec());
    while let Some(path) = stack.pop() {
        if path.is_dir() {
            stack.extend(fs::read_dir(path).expect("a folder").map(|entry| entry.expect("an entry").path()));
        } else {
            text += &fs::read_to_string(path).unwrap_or_default();
        }
    }
    text
}

#[test]
fn what_the_table_names_of_ours_exists() {
    let sources = sources();
    let defined = |name: &str| {
        ["fn ", "struct ", "pub ", "mod ", "field: "].iter().any(|kind| {
            sources
                .match_indices(&format!("{kind}{name}"))
                .any(|(at, found)| !sources[at + found.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_'))
        })
    };
    for (owner, name, ours) in table() {
        for code in ours.split('`').skip(1).step_by(2).filter(|code| !code.starts_with(['#', 'N']) && *code != "clone")
        {
            let last = code.rsplit(['.', ':']).next().unwrap_or_default();
            let derived = last.strip_suffix("Params").is_some();
            assert!(derived || last.len() == 1 || defined(last), "{owner}.{name}: there is no {last:?} for {code:?}");
        }
    }
}
