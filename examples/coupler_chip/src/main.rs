//! Builds the masks that are described in `masks/`, or those that are named.
//!
//! `cargo run -- first_light` reads `masks/first_light.json`: a generator of this program or of phidl with its parameters.
//! It writes `target/mask/first_light/`: GDSII, a picture, and what was drawn with which parameters.
//!
//! `cargo run -- devices coupler` lists generators, `cargo run -- device coupler --out coupler.svg` draws one, and
//! `cargo run -- gallery` draws all.

mod chip;
mod coupler;
mod layers;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use anyhow::Context;
use phidl::io::cli;
use phidl::io::mask::{self, MaskOptions};
use phidl::io::svg::SvgOptions;
use phidl::runtime::Partial;

fn main() -> ExitCode {
    let names: Vec<String> = env::args().skip(1).collect();
    if matches!(names.first().map(String::as_str), Some("devices" | "device" | "gallery")) {
        return cli::main();
    }
    match masks(&names) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error:?}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the masks that are named, or all that are described.
fn masks(names: &[String]) -> anyhow::Result<()> {
    let files = match names.is_empty() {
        true => described()?,
        false => names.iter().map(|name| Path::new("masks").join(name).with_extension("json")).collect(),
    };
    files.iter().try_for_each(|file| build(file).with_context(|| file.display().to_string()))
}

/// The files of all masks.
fn described() -> anyhow::Result<Vec<PathBuf>> {
    let entries = fs::read_dir("masks").context("masks")?;
    let mut files = entries.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

fn build(file: &Path) -> anyhow::Result<()> {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let call: Partial = serde_json::from_str(&fs::read_to_string(file)?)?;
    let device = call.build()?;
    let svg = SvgOptions { layers: layers::layer_set()?, ..SvgOptions::default() };
    let folder = Path::new("target/mask").join(&*name);
    let report = mask::build(&name, &device, &folder, &MaskOptions { svg, ..MaskOptions::default() }, |_| {})?;
    println!("{name}\n{}", report.summary);
    Ok(())
}
