//! `cargo xtask interop`: masks opened in other tools, and results for random shapes checked by KLayout's region engine.

use std::path::Path;

use anyhow::{Context, ensure};
use phidl_boolean::{Join, OffsetOptions, Operation, Options, boolean, offset};
use phidl_core::scene::Device;
use testkit::scenes;

use crate::compare::{PRECISION, both, draw, script};
use crate::flags::{InteropFlags, MaskFlags};
use crate::interop_files;
use crate::layer_file;
use crate::mask;
use crate::python::Python;

/// Layers of the results, as `benches/agree_boolean.py` expects them.
const BOOLEANS: [(Operation, u16); 5] =
    [(Operation::Or, 11), (Operation::And, 12), (Operation::Not, 13), (Operation::BMinusA, 14), (Operation::Xor, 15)];

/// Distances (µm) of offsets, and their layers.
const OFFSETS: [(f64, u16); 2] = [(0.5, 21), (-0.3, 22)];

/// KLayout's own corners: extended by one distance at most.
const GROWTH: OffsetOptions = OffsetOptions { join: Join::Extended { extension: 1.0 }, merge_first: true };

/// Checks as many scenes as the flags ask for.
pub(crate) fn run(flags: &InteropFlags) -> anyhow::Result<()> {
    std::fs::create_dir_all(&flags.out).with_context(|| flags.out.display().to_string())?;
    let Some(python) = Python::with_peers(&flags.out.join("peers"))? else { return Ok(()) };
    masks_agree(&python, &flags.out.join("masks"))?;
    interop_files::agree(&python, &flags.out.join("files"))?;
    let (scene, result) = (flags.out.join("scene.gds"), flags.out.join("result.gds"));
    let text = |path: &Path| path.to_str().map(str::to_owned).context("the path of a scene is text");
    for seed in 0..flags.scenes {
        let devices = draw(&[scenes::confetti(flags.shapes, 2 * seed), scenes::confetti(flags.shapes, 2 * seed + 1)])?;
        layer_file::write(&both(&devices)?, &scene, PRECISION)?;
        layer_file::write(&results(&devices)?, &result, PRECISION)?;
        let printed = python.run(&script("agree_boolean.py"), &[&text(&scene)?, &text(&result)?])?;
        println!("scene {seed}\n{}", printed.trim_end());
    }
    ensure!(flags.scenes > 0, "no scene was checked");
    println!("all results agree");
    Ok(())
}

/// Builds the masks, and has KLayout, gdstk and gdspy count what their summaries state.
fn masks_agree(python: &Python, folder: &Path) -> anyhow::Result<()> {
    mask::run(&MaskFlags { names: Vec::new(), out: folder.to_owned() })?;
    for name in mask::names() {
        let files = [format!("{name}.gds"), "metadata.json".to_owned()].map(|file| folder.join(name).join(file));
        let [gds, metadata] = files.each_ref().map(|file| file.to_string_lossy());
        println!("{}\n", python.run(&script("agree_mask.py"), &[&gds, &metadata])?.trim_end());
    }
    Ok(())
}

fn results(devices: &[Device; 2]) -> anyhow::Result<Device> {
    let [a, b] = devices;
    let options = Options { precision: PRECISION, ..Options::default() };
    let mut drawn = Vec::new();
    for (operation, layer) in BOOLEANS {
        drawn.push(boolean(a, b, operation, layer, &options)?);
    }
    for (distance, layer) in OFFSETS {
        drawn.push(offset(a, distance, &GROWTH, layer, &options)?);
    }
    both(&drawn)
}
