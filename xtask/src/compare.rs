//! `cargo xtask compare`: booleans and offsets of ours and of other tools, on the same files, in one sitting.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::Context;
use phidl_boolean::grid::{self, Contours};
use phidl_boolean::{Growth, Operation, Options, RunOptions};
use phidl_core::layer::Layer;
use phidl_core::scene::Device;
use testkit::scenes::{self, Outlines};

use crate::flags::CompareFlags;
use crate::layer_file;
use crate::python::Python;

/// The grid of all scenes (µm).
pub(crate) const PRECISION: f64 = 1e-4;

/// Ours is timed this often; the best counts, as for the others.
const REPEATS: usize = 5;

/// Everyone who takes part beside us, by the names that `benches/compare_boolean.py` knows.
const PEERS: [&str; 4] = ["klayout", "klayout, tiled", "gdstk", "phidl"];

/// Shapes to work on, and what to do with them.
struct Scene {
    name: &'static str,
    layers: [Outlines; 2],
    work: Vec<Work>,
    /// PHIDL takes part in small scenes only: it needs minutes for the others.
    is_small: bool,
}

#[derive(Clone, Copy)]
enum Work {
    Boolean(Operation, &'static str),
    Offset(f64),
}

impl Work {
    fn name(self) -> String {
        match self {
            Self::Boolean(_, name) => name.to_owned(),
            Self::Offset(distance) => format!("offset {distance:+}"),
        }
    }
}

/// Runs all scenes and prints a line for each kind of work.
pub(crate) fn run(flags: &CompareFlags) -> anyhow::Result<()> {
    std::fs::create_dir_all(&flags.out).with_context(|| flags.out.display().to_string())?;
    let python = Python::with_peers(&flags.out.join("peers"))?;
    println!("times in ms, {} threads for everyone who can; ratio: the fastest other over ours", flags.threads);
    println!("{:<44} {:>9} {:>9} {:>18} {:>6}", "", "on grid", "devices", "fastest other", "ratio");
    for scene in scenes(flags.quick) {
        if flags.filter.as_ref().is_none_or(|filter| scene.name.contains(filter.as_str())) {
            compare(&scene, flags, python.as_ref())?;
        }
    }
    Ok(())
}

fn scenes(quick: bool) -> Vec<Scene> {
    let size = |full: usize| if quick { full / 100 } else { full };
    let crowded = |name, n: usize, is_small| Scene {
        name,
        layers: [scenes::confetti(n, 1), scenes::confetti(n, 2)],
        work: [
            &BOOLEANS.map(|(operation, name)| Work::Boolean(operation, name))[..],
            &[Work::Offset(0.5), Work::Offset(-0.3)],
        ]
        .concat(),
        is_small,
    };
    let (squares, cross) = scenes::squares_and_cross(if quick { 30 } else { 300 });
    vec![
        crowded("confetti, n = 1,000", size(1_000), true),
        crowded("confetti, n = 10,000", size(10_000), false),
        Scene {
            name: "300 × 300 squares minus a cross",
            layers: [squares, cross],
            work: vec![Work::Boolean(Operation::Not, "not")],
            is_small: false,
        },
        Scene {
            name: "95,000 72-gons",
            layers: [scenes::dots(size(95_000), 72), Vec::new()],
            work: vec![Work::Boolean(Operation::Or, "or"), Work::Offset(0.3)],
            is_small: false,
        },
    ]
}

const BOOLEANS: [(Operation, &str); 4] =
    [(Operation::Or, "or"), (Operation::And, "and"), (Operation::Not, "not"), (Operation::Xor, "xor")];

fn compare(scene: &Scene, flags: &CompareFlags, python: Option<&Python>) -> anyhow::Result<()> {
    let file = flags.out.join("scene.gds");
    let devices = draw(&scene.layers)?;
    layer_file::write(&both(&devices)?, &file, PRECISION)?;
    for &work in &scene.work {
        let (on_grid, on_devices) = ours(&devices, work, flags.threads)?;
        let mut others = Vec::new();
        for peer in PEERS.into_iter().filter(|&peer| scene.is_small || peer != "phidl") {
            if let Some(python) = python {
                others.push((peer, theirs(python, &file, work, flags.threads, peer)?));
            }
        }
        print_line(scene.name, work, on_grid, on_devices, &others);
    }
    Ok(())
}

fn print_line(scene: &str, work: Work, on_grid: f64, on_devices: f64, others: &[(&str, f64)]) {
    let fastest = others.iter().map(|&(_, time)| time).fold(f64::INFINITY, f64::min);
    let named: Vec<String> = others.iter().map(|(peer, time)| format!("{peer} {:.1}", time * 1e3)).collect();
    println!(
        "{:<44} {:>9.1} {:>9.1} {:>18.1} {:>6.1}   {}",
        format!("{scene}: {}", work.name()),
        on_grid * 1e3,
        on_devices * 1e3,
        fastest * 1e3,
        fastest / on_grid,
        named.join(", ")
    );
}

/// Seconds for the work on integers, as KLayout does it, and from devices to a device, as gdstk and PHIDL do it.
fn ours(devices: &[Device; 2], work: Work, threads: usize) -> anyhow::Result<(f64, f64)> {
    let run = RunOptions { threads: Some(threads), ..RunOptions::default() };
    let options = Options { precision: PRECISION, max_points: None, run };
    let steps = grid::with_step(PRECISION)?;
    let [a, b] = devices;
    let contours: [Contours; 2] = [grid::snap_device(&steps, a, None)?, grid::snap_device(&steps, b, None)?];
    let on_grid = best(|| match work {
        Work::Boolean(operation, _) => grid::boolean(&contours[0], &contours[1], operation, &run),
        Work::Offset(distance) => grid::offset(&contours[0], steps.scaled(distance), &Growth::default(), &run),
    })?;
    let on_devices = best(|| match work {
        Work::Boolean(operation, _) => phidl_boolean::boolean(a, b, operation, 3, &options),
        Work::Offset(distance) => phidl_boolean::offset(a, distance, &Growth::default(), 3, &options),
    })?;
    Ok((on_grid, on_devices))
}

/// The shortest of a few times (s).
pub(crate) fn best<T, E: std::error::Error + Send + Sync + 'static>(
    work: impl Fn() -> Result<T, E>,
) -> anyhow::Result<f64> {
    let mut shortest = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        let result = work()?;
        shortest = shortest.min(start.elapsed().as_secs_f64());
        drop(result);
    }
    Ok(shortest)
}

fn theirs(python: &Python, scene: &Path, work: Work, threads: usize, peer: &str) -> anyhow::Result<f64> {
    let (operation, distance) = match work {
        Work::Boolean(_, name) => (name, 0.0),
        Work::Offset(distance) => ("offset", distance),
    };
    let scene = scene.to_str().context("the path of a scene is text")?;
    let arguments = [scene, operation, &distance.to_string(), &threads.to_string(), peer];
    let printed = python.run(&script("compare_boolean.py"), &arguments)?;
    serde_json::from_str(&printed).with_context(|| format!("{peer} printed {printed:?}"))
}

/// A script of this repository.
pub(crate) fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches").join(name)
}

/// The layers of a scene, each in a device of its own.
pub(crate) fn draw(layers: &[Outlines; 2]) -> anyhow::Result<[Device; 2]> {
    let drawn = |outlines: &Outlines, number: u16| {
        let mut cell = Device::builder(format!("layer_{number}"));
        for outline in outlines {
            cell.add_polygon(outline, Layer::new(number, 0))?;
        }
        cell.build()
    };
    Ok([drawn(&layers[0], 1).map_err(crate::in_full)?, drawn(&layers[1], 2).map_err(crate::in_full)?])
}

/// One device with all that some devices draw.
pub(crate) fn both(devices: &[Device]) -> anyhow::Result<Device> {
    let mut cell = Device::builder("scene");
    for device in devices {
        cell.add(device);
    }
    cell.build().map_err(crate::in_full)
}
