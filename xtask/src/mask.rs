//! `cargo xtask mask`: builds the masks of this repository.

use std::time::Instant;

use anyhow::{Context, ensure};
use phidl_core::cache;
use phidl_core::scene::Device;
use phidl_io::mask::{self, MaskOptions, MaskReport};
use phidl_io::svg::SvgOptions;

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
    draw: || demo::demo_chip(10_000).map_err(crate::report),
    options: || {
        let svg = SvgOptions { layers: demo::layer_set()?, label_height: Some(30.0), ..SvgOptions::default() };
        Ok(MaskOptions { svg, ..MaskOptions::default() })
    },
}];

/// The names of all masks.
pub(crate) fn names() -> [&'static str; MASKS.len()] {
    MASKS.map(|mask| mask.name)
}

/// Builds the masks that are named, or all, and prints a summary of each.
pub(crate) fn run(flags: &MaskFlags) -> anyhow::Result<()> {
    let known = names().join(", ");
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
        .map_err(|error| anyhow::anyhow!(error.report()))?;
    drop(progress);
    let after = cache::stats();
    print(mask.name, &report);
    println!("cache      {} hits, {} drawn", after.hits - before.hits, after.misses - before.misses);
    println!("time       {:.2} s\n", start.elapsed().as_secs_f64());
    Ok(())
}

fn print(name: &str, report: &MaskReport) {
    println!("mask       {name}");
    for file in &report.files {
        println!("           {}", file.display());
    }
    println!("{}", report.summary);
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;
    use std::path::Path;

    use phidl_core::prelude::*;

    use super::*;

    /// Draws and builds a mask again, and reads its files.
    fn files(mask: &Mask, threads: usize) -> BTreeMap<String, Vec<u8>> {
        let folder = tempfile::tempdir().unwrap();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        cache::clear();
        pool.install(|| {
            let device = (mask.draw)().unwrap();
            mask::build(mask.name, &device, folder.path(), &(mask.options)().unwrap(), |_| {}).unwrap();
        });
        let read = |path: &Path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(path).unwrap());
        fs::read_dir(folder.path()).unwrap().map(|entry| read(&entry.unwrap().path())).collect()
    }

    #[test]
    fn masks_have_the_same_bytes_whenever_and_on_any_number_of_threads() {
        for mask in &MASKS {
            let first = files(mask, 1);
            let names: Vec<&str> = first.keys().map(String::as_str).collect();
            assert_eq!(names, ["demo.gds", "demo.svg", "devices.csv", "metadata.json"]);
            for threads in [1, 2, 5] {
                assert!(files(mask, threads) == first, "{} on {threads} threads", mask.name);
            }
        }
    }

    #[test]
    fn the_demo_is_the_chip_that_its_docs_promise() {
        let chip = (MASKS[0].draw)().unwrap();
        assert_eq!(chip.bbox().unwrap().size(), Size::new(10_000.0, 10_000.0));
        let below = chip.descendant_info();
        let rings: Vec<&Value> = below.iter().filter_map(|(_, info)| info.get("rings")).collect();
        assert_eq!(rings, [&Value::from(240)]);
        assert!(chip.layers().len() >= 5);
        assert!(chip.cells().iter().any(|cell| cell.references().iter().any(|r| r.array().is_some())));
    }

    #[test]
    fn ring_filters_are_connected_port_to_port() {
        let filter = demo::ring_filter(50, 0.2, 1, 400, 100, 8, 1).unwrap();
        let bus = filter.get("bus").unwrap();
        let facets: Vec<&Reference> = filter.references().iter().filter(|r| r.device().name() == "taper").collect();
        assert_eq!(facets.len(), 2);
        for (facet, end) in facets.iter().zip(["1", "2"]) {
            let (ours, theirs) = (facet.port("2").unwrap(), bus.port(end).unwrap());
            assert!(ours.midpoint().distance(theirs.midpoint()) < 1e-9);
            assert_eq!(ours.width(), theirs.width());
        }
    }
}
