//! `cargo xtask figure`: the figure of the PHIDL paper, redone. Time of a set operation against the number of parts that
//! the plane is divided into, ours beside KLayout's tiling processor, measured now and drawn with our own shapes.

mod chart;

use std::path::Path;

use anyhow::Context;
use phidl_boolean::{Operation, RunOptions, StripCount, grid};
use phidl_core::prelude::*;
use phidl_io::svg::{self, SvgOptions};
use testkit::scenes;

use crate::compare::{PRECISION, best, both, draw, script};
use crate::flags::FigureFlags;
use crate::layer_file;
use crate::progress::Progress;
use crate::python::Python;
use chart::{Chart, Series};

/// Ours is divided into so many strips.
const STRIPS: [usize; 13] = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/// KLayout's plane is divided into so many tiles along each side.
const TILES: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];

const OURS: Layer = Layer::new(1, 0);
const THEIRS: Layer = Layer::new(2, 0);

/// Measures and draws the figure.
pub(crate) fn run(flags: &FigureFlags) -> anyhow::Result<()> {
    std::fs::create_dir_all(&flags.scratch).with_context(|| flags.scratch.display().to_string())?;
    let progress = Progress::new();
    let devices = draw(&[scenes::confetti(flags.shapes, 1), scenes::confetti(flags.shapes, 2)])?;
    let mut series = vec![Series { name: "phidl", layer: OURS, points: ours(&devices, flags.threads, &progress)? }];
    if let Some(python) = Python::with_peers(&flags.scratch.join("peers"))? {
        let file = flags.scratch.join("scene.gds");
        layer_file::write(&both(&devices)?, &file, PRECISION)?;
        series.push(Series {
            name: "KLayout",
            layer: THEIRS,
            points: theirs(&python, &file, flags.threads, &progress)?,
        });
    }
    drop(progress);
    for Series { name, points, .. } in &series {
        println!("{name}");
        points.iter().for_each(|(parts, seconds)| println!("{parts:>9} parts {:>9.1} ms", seconds * 1e3));
    }
    let chart = Chart {
        title: format!("A - B, {} vertices, {} threads", 52 * flags.shapes, flags.threads),
        x: "parts that the plane is divided into",
        y: "time in seconds",
        series,
    };
    let device = chart.draw().map_err(crate::report)?;
    svg::write(&device, &flags.out, &SvgOptions { layers: colors().map_err(crate::report)?, ..SvgOptions::default() })?;
    println!("{}", flags.out.display());
    Ok(())
}

fn colors() -> Result<LayerSet> {
    let mut set = LayerSet::new();
    for (name, layer, color) in [
        ("phidl", OURS, "#c0392b"),
        ("KLayout", THEIRS, "#2c6fbb"),
        ("axes", chart::AXES, "#444444"),
        ("grid", chart::GRID, "#dddddd"),
    ] {
        set.add(NamedLayer { alpha: 1.0, ..NamedLayer::new(name, layer).color(color.parse()?) })?;
    }
    Ok(set)
}

/// Parts and seconds of ours, from integer outlines to a merged region.
fn ours(devices: &[Device; 2], threads: usize, progress: &Progress) -> anyhow::Result<Vec<(usize, f64)>> {
    let steps = grid::with_step(PRECISION)?;
    let [a, b] = [grid::snap_device(&steps, &devices[0], None)?, grid::snap_device(&steps, &devices[1], None)?];
    let timed = |strips: usize| {
        progress.step(format!("phidl, {strips} strips"));
        let run = RunOptions { strips: StripCount::Fixed(strips), threads: Some(threads), monitor: None };
        Ok((strips, best(|| grid::boolean(&a, &b, Operation::Not, &run))?))
    };
    STRIPS.into_iter().map(timed).collect()
}

/// The same of KLayout's tiling processor, the merging of the tiles included.
fn theirs(python: &Python, file: &Path, threads: usize, progress: &Progress) -> anyhow::Result<Vec<(usize, f64)>> {
    let file = file.to_str().context("the path of a scene is text")?;
    let timed = |tiles: usize| {
        progress.step(format!("KLayout, {tiles} × {tiles} tiles"));
        let peer = format!("klayout, tiled={tiles}");
        let printed = python.run(&script("compare_boolean.py"), &[file, "not", "0", &threads.to_string(), &peer])?;
        let seconds = serde_json::from_str(&printed).with_context(|| format!("{peer} printed {printed:?}"))?;
        Ok((tiles * tiles, seconds))
    };
    TILES.into_iter().map(timed).collect()
}
