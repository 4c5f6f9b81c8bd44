//! `cargo xtask golden`: further reference results, drawn by PHIDL with random parameters.

use std::path::{Path, PathBuf};

use anyhow::Context;
use phidl_core::registry;
use phidl_io::cli;

use crate::flags::GoldenFlags;
use crate::python::Python;

/// What draws everything but `route_basic`; the curves without crowding need scipy.
const PHIDL: &[&str] = &["phidl==1.7.2", "scipy==1.17.1"];

/// The release of PHIDL that has `route_basic`.
const OLD_PHIDL: &[&str] = &["phidl==1.5.2"];

/// Draws as many cases as the flags ask for, and says how to run the tests on them.
pub(crate) fn run(flags: &GoldenFlags) -> anyhow::Result<()> {
    std::fs::create_dir_all(&flags.peers).with_context(|| flags.peers.display().to_string())?;
    let Some(new) = Python::with(&flags.peers.join("phidl-1.7"), PHIDL)? else { return Ok(()) };
    let Some(old) = Python::with(&flags.peers.join("phidl-1.5"), OLD_PHIDL)? else { return Ok(()) };
    let registry = flags.peers.join("registry.json");
    let entries: Vec<_> = registry::all().collect();
    std::fs::write(&registry, cli::devices::to_json(&entries).to_string())
        .with_context(|| registry.display().to_string())?;
    let mut arguments = vec![text(&registry)?, text(&flags.out)?];
    match &flags.redraw {
        Some(folder) => arguments.extend(["--redraw".to_owned(), text(folder)?]),
        None => arguments.extend([format!("--seed={}", flags.seed), format!("--count={}", flags.count)]),
    }
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    for python in [new, old] {
        print!("{}", python.run(&script(), &arguments)?);
    }
    let out = std::path::absolute(&flags.out)?;
    println!("PHIDL_GOLDEN={} cargo test -p phidl-geometry -p phidl-path -p phidl-route", out.display());
    Ok(())
}

fn script() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/draw.py")
}

fn text(path: &Path) -> anyhow::Result<String> {
    path.to_str().map(str::to_owned).context("the path of a folder is text")
}
