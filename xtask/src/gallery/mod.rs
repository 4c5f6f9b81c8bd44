//! `cargo xtask gallery`: the example of every registered device as a figure, all on one sheet, all calls on one page.
//!
//! The figures are in the documentation: `#[device(picture = …)]` names a file that is part of the repository. So they
//! can go stale, and a test here fails when one has; `--bless` draws them again.

mod paths;
mod sheet;
mod tutorials;

use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use phidl_core::runtime::GeneratorInfo;
use phidl_io::atomic;
use phidl_io::cli::gallery::{self, Plate, figure_options};

use crate::flags::GalleryFlags;
use crate::progress::Progress;

/// The sheet, as the README shows it.
const SHEET: &str = "docs/gallery.svg";
/// Width of the sheet as pixels, for programs that show no SVG.
const PIXELS: u32 = 1600;

/// A file of the repository that is drawn.
struct Drawn {
    /// From the folder of the workspace.
    path: PathBuf,
    text: String,
}

/// Draws the gallery, or checks what of it is in the repository.
pub(crate) fn run(flags: &GalleryFlags) -> anyhow::Result<()> {
    let progress = Progress::new();
    let plates = plates(|step| progress.step(step))?;
    progress.step("packing the sheet");
    let sheet = sheet::draw(&plates)?;
    let drawn = committed(&plates, &sheet)?;
    if flags.check {
        return check(&drawn);
    }
    if flags.bless {
        drawn.iter().try_for_each(|file| write(&root().join(&file.path), file.text.as_bytes()))?;
    }
    progress.step("writing");
    for plate in &plates {
        write(&flags.out.join(format!("{}.svg", plate.name)), plate.figure.as_bytes())?;
    }
    write(&flags.out.join("gallery.svg"), sheet.as_bytes())?;
    write(&flags.out.join("gallery.png"), &sheet::to_png(&sheet, PIXELS)?)?;
    write(&flags.out.join("index.html"), gallery::html(&plates, "cargo xtask").as_bytes())?;
    drop(progress);
    println!("{} figures, gallery.svg, gallery.png and index.html in {}", plates.len(), flags.out.display());
    Ok(())
}

/// The devices of our libraries, by name.
fn plates(step: impl FnMut(String)) -> anyhow::Result<Vec<Plate>> {
    let ours = |entry: &GeneratorInfo| ["phidl_geometry", "phidl_route"].contains(&gallery::krate(entry));
    Ok(gallery::all(ours, step)?)
}

/// All drawings of the repository as they are now: those of devices, of paths, of tutorials, and the sheet.
fn committed(plates: &[Plate], sheet: &str) -> anyhow::Result<Vec<Drawn>> {
    let figures =
        plates.iter().filter_map(|plate| Some(Drawn { path: plate.file.clone()?, text: plate.figure.clone() }));
    let mut all: Vec<Drawn> = figures.chain(paths::all()?).chain(tutorials::all()?).collect();
    all.push(Drawn { path: SHEET.into(), text: sheet.to_owned() });
    Ok(all)
}

fn check(drawn: &[Drawn]) -> anyhow::Result<()> {
    let stale: Vec<String> = drawn
        .iter()
        .filter(|file| std::fs::read_to_string(root().join(&file.path)).ok().as_ref() != Some(&file.text))
        .map(|file| file.path.display().to_string())
        .collect();
    if !stale.is_empty() {
        bail!("not what is drawn now: {}; `cargo xtask gallery --bless` draws them", stale.join(", "));
    }
    println!("{} drawings are up to date", drawn.len());
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    }
    atomic::write(path, bytes).map(drop).map_err(|error| anyhow::anyhow!(error.report()))
}

/// The folder of the workspace.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

#[cfg(test)]
mod listed;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_drawings_of_the_repository_are_what_is_drawn_now() {
        let plates = plates(|_| {}).unwrap();
        let sheet = sheet::draw(&plates).unwrap();
        check(&committed(&plates, &sheet).unwrap()).unwrap();
    }

    #[test]
    fn every_device_of_the_libraries_has_its_drawing() {
        for plate in plates(|_| {}).unwrap() {
            assert!(plate.file.is_some(), "{} has no #[device(picture = …)]", plate.name);
            // A blank line would end the HTML in the documentation; ids would meet those of other figures.
            assert!(!plate.figure.contains("\n\n") && !plate.figure.contains(" id="), "{}", plate.name);
        }
    }

    #[test]
    fn figures_are_small() {
        for plate in plates(|_| {}).unwrap() {
            assert!(plate.figure.len() < 24_000, "{}: {} bytes", plate.name, plate.figure.len());
        }
    }
}
