//! `cargo xtask mask`: builds the masks of this repository.

use std::time::Instant;

use anyhow::{Context, ensure};
use phidl_core::cache;
use phidl_core::scene::Device;
use phidl_io::mask::{self, MaskOptions, MaskReport};

use crate::demo;
use crate::flags::MaskFlags;
use crate::progress::Progress;

/// A mask of this repository.
struct Mask {
    name: &'static str,
    draw: fn() -> anyhow::Result<Device>,
    options: fn() -> anyhow::Result<MaskOptions>,
}

/// All masks, in the order in which they are built.
const MASKS: [Mask; 1] = [Mask {
    name: "demo",
    draw: || demo::demo_chip(10_000).map_err(crate::in_full),
    options: || Ok(MaskOptions { layers: demo::layer_set()?, ..MaskOptions::default() }),
}];

/// Builds the masks that are named, or all, and prints a summary of each.
pub(crate) fn run(flags: &MaskFlags) -> anyhow::Result<()> {
    let known = MASKS.map(|mask| mask.name).join(", ");
    for name in &flags.names {
        ensure!(MASKS.iter().any(|mask| mask.name == name), "there is no mask {name:?}; known are {known}");
    }
    for mask in &MASKS {
        if flags.names.is_empty() || flags.names.iter().any(|name| name == mask.name) {
            build(mask, flags).with_context(|| format!("mask {:?}", mask.name))?;
        }
    }
    Ok(())
}

fn build(mask: &Mask, flags: &MaskFlags) -> anyhow::Result<()> {
    let start = Instant::now();
    let before = cache::stats();
    let progress = Progress::new();
    progress.step(format!("drawing {}", mask.name));
    let device = (mask.draw)()?;
    let options = (mask.options)()?;
    let folder = flags.out.join(mask.name);
    let report = mask::build(mask.name, &device, &folder, &options, |step| progress.step(step))
        .map_err(|error| anyhow::anyhow!(error.in_full()))?;
    drop(progress);
    let after = cache::stats();
    print(mask.name, &report);
    println!("cache        {} hits, {} drawn", after.hits - before.hits, after.misses - before.misses);
    println!("time         {:.2} s\n", start.elapsed().as_secs_f64());
    Ok(())
}

fn print(name: &str, report: &MaskReport) {
    println!("mask         {name}");
    for file in &report.files {
        println!("             {}", file.display());
    }
    println!("cells        {}", report.gds.cells.len());
    println!("{}", report.summary);
    println!("sha-256      {}", report.sha256);
}
