//! Layout files between phidl, KLayout and gdstk: what each of them writes, read by the others.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use phidl_core::geom::Rect;
use phidl_core::place::Movable;
use phidl_core::scene::{Anchor, Device, Label, Polygon};
use phidl_io::IoError;
use phidl_io::layout::{self, ReadOptions, WriteOptions};
use testkit::loads;

use crate::compare::script;
use crate::demo;
use crate::python::Python;

/// Writes some layouts in both formats, has KLayout and gdstk write them with all their settings, reads those, and has
/// KLayout compare everything with the first file.
pub(crate) fn agree(python: &Python, folder: &Path) -> anyhow::Result<()> {
    let layouts = [
        ("elements", elements().map_err(crate::report)?),
        ("demo", demo::demo_chip(1000).map_err(crate::report)?),
        ("squares", loads::squares(2000)),
        ("placements", loads::placements(10, 100)),
    ];
    for (name, device) in layouts {
        println!("{name}");
        check(python, &folder.join(name), &device)?;
    }
    Ok(())
}

fn check(python: &Python, folder: &Path, device: &Device) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    let [gds, oas, packed] = ["phidl.gds", "phidl.oas", "phidl_gzip.gds.gz"].map(|name| folder.join(name));
    for file in [&gds, &oas, &packed] {
        layout::write(device, file, &WriteOptions::default()).map_err(report)?;
    }
    python.run(&script("agree_files.py"), &["write", &text(&gds)?, &text(folder)?])?;
    let mut files = vec![text(&oas)?, text(&packed)?];
    for other in others(folder)? {
        let (_, layout) = layout::read_layout(&other, &ReadOptions::default()).map_err(report)?;
        let name = other.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        for ending in ["oas", "gds"] {
            let again = folder.join(format!("phidl_of_{name}.{ending}"));
            layout::write_layout(&layout, &again, &WriteOptions::default()).map_err(report)?;
            files.push(text(&again)?);
        }
    }
    let gds = text(&gds)?;
    let arguments: Vec<&str> = ["check", &gds].into_iter().chain(files.iter().map(String::as_str)).collect();
    println!("{}", python.run(&script("agree_files.py"), &arguments)?.trim_end());
    Ok(())
}

/// The OASIS files that other tools have written.
fn others(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        let is_ours = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("phidl"));
        if !is_ours && path.extension().is_some_and(|ending| ending == "oas") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn text(path: &Path) -> anyhow::Result<String> {
    path.to_str().map(str::to_owned).with_context(|| format!("{} is not UTF-8", path.display()))
}

/// A cell with every kind of element, placed at quarter turns and odd angles, mirrored, magnified, and in arrays.
fn elements() -> phidl_core::Result<Device> {
    let mut d = Device::builder("leaf");
    d.add(Polygon::new([(0, 0), (3, 1), (1, 4)], (3, 7)).with_property(3, "text").with_property(70, "µ"));
    d.add_polygon(Rect::new((2, 2), (5, 4)), 1)?;
    d.add_polygon([(0, 0), (6, 0), (6, 4), (3, 4), (3, 2), (0, 2)], 1)?;
    d.add_polygon([(0, 0), (6, 0), (4, 2), (2, 2)], 2)?;
    for (i, name) in ["name", "µm Ω", "two parts", "name"].into_iter().enumerate() {
        d.add(Label::new(name, (i as f64, 1.5), (9, 1)).anchored(Anchor::Center));
    }
    let leaf = d.build()?;
    let mut d = Device::builder("branch");
    for quarter in 0..4 {
        let turned = leaf.place().rotated(90.0 * f64::from(quarter)).moved_by((20 * quarter, 0));
        d.add(turned.clone().mirrored((0, -10), (1, -10)));
        d.add(turned);
    }
    d.add(leaf.array(5, 3, (10, 20)).moved_by((0, 100)));
    d.add(leaf.array(4, 2, (10, 20)).rotated(90).moved_by((0, 300)));
    let branch = d.build()?;
    let mut d = Device::builder("tree");
    d.add(branch.place());
    d.add(branch.place().rotated(33.3).moved_by((500, 0)));
    d.build()
}

#[expect(clippy::needless_pass_by_value, reason = "it stands in map_err")]
fn report(error: IoError) -> anyhow::Error {
    anyhow!(error.report())
}
