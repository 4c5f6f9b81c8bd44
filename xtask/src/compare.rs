//! `cargo xtask compare`: booleans and offsets of ours and of other tools, on the same files, in one sitting.
//!
//! Prints a table in Markdown, as in `benches/README.md`, then time and memory of our command on the file of each scene, the
//! growth of the time with the work, and the lines with the worst ratios first. `--suite` takes scenes of many kinds in
//! three sizes, so that no kind is overlooked.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};
use phidl_boolean::grid::{self, Contours};
use phidl_boolean::{OffsetOptions, Operation, Options, RunOptions};
use phidl_core::layer::Layer;
use phidl_core::scene::Device;
use testkit::scenes::{self, Outlines};

use crate::flags::CompareFlags;
use crate::layer_file;
use crate::python::Python;

/// The grid of all scenes (µm).
pub(crate) const PRECISION: f64 = 1e-4;

/// Ours is timed this often, and for this long; the best counts, as for the others.
const REPEATS: u32 = 5;
const PATIENCE: Duration = Duration::from_millis(500);

/// Everyone who takes part beside us, by the names that `benches/compare_boolean.py` knows.
const PEERS: [&str; 4] = ["klayout", "klayout, tiled", "gdstk", "phidl"];

/// Shapes to work on, and what to do with them.
struct Scene {
    name: String,
    layers: [Outlines; 2],
    work: Vec<Work>,
    /// Shapes of each kind, where scenes of several sizes are to be compared.
    size: Option<usize>,
    /// PHIDL takes part in small scenes only: it needs minutes for the others.
    is_small: bool,
}

#[derive(Clone, Copy, PartialEq)]
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
    println!(
        "Times in ms; {} threads for everyone who can, and one for ours in the last column but one.\n",
        flags.threads
    );
    println!("| scene and work | on grid | devices | {} | ratio | one thread | gain |", PEERS.join(" | "));
    println!("|{}", "---|".repeat(PEERS.len() + 6));
    let (mut growth, mut files) = (Growths::default(), Vec::new());
    let mut ratios = Vec::new();
    let chosen_scenes = if flags.suite { suite(flags.quick) } else { scenes(flags.quick) };
    for scene in chosen_scenes {
        let scene = chosen(scene, flags.filter.as_deref().unwrap_or_default());
        if !scene.work.is_empty() {
            ratios.extend(compare(&scene, flags, python.as_ref(), &mut growth)?);
            if !flags.suite && scene.work.iter().any(|work| matches!(work, Work::Boolean(..))) {
                files.push(format!("{}: or, from file to file: {}", scene.name, on_file(&scene, flags)?));
            }
        }
    }
    println!();
    files.iter().for_each(|line| println!("{line}"));
    growth.print();
    print_worst_first(ratios);
    Ok(())
}

/// Prints how many times as fast as the fastest peer ours is, from devices to a device, worst first.
fn print_worst_first(mut ratios: Vec<(f64, String)>) {
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    ratios.iter().for_each(|(ratio, line)| println!("{ratio:.1} times the fastest peer: {line}"));
}

/// The scene with the work whose line would contain a text.
fn chosen(mut scene: Scene, filter: &str) -> Scene {
    scene.work.retain(|work| line_name(&scene.name, *work).contains(filter));
    scene
}

/// Times of the same work on scenes of different sizes.
#[derive(Default)]
struct Growths(Vec<(Work, usize, f64)>);

impl Growths {
    /// Prints by how much the time grew from each crowded scene to the next larger one.
    fn print(&self) {
        let Self(times) = self;
        for (position, &(work, size, time)) in times.iter().enumerate() {
            if let Some(&(_, smaller, before)) = times[..position].iter().rfind(|(other, ..)| *other == work) {
                let more = size as f64 / smaller as f64;
                println!(
                    "{more:.0} times the work of n = {smaller}, {}: {:.1} times the time",
                    work.name(),
                    time / before
                );
            }
        }
    }
}

fn scenes(quick: bool) -> Vec<Scene> {
    let size = |full: usize| if quick { full / 100 } else { full };
    let crowded = |name: &str, n: usize, is_small| Scene {
        name: name.to_owned(),
        layers: [scenes::confetti(n, 1), scenes::confetti(n, 2)],
        work: [
            &BOOLEANS.map(|(operation, name)| Work::Boolean(operation, name))[..],
            &[Work::Offset(0.5), Work::Offset(-0.3)],
        ]
        .concat(),
        size: Some(n),
        is_small,
    };
    let (squares, cross) = scenes::squares_and_cross(if quick { 30 } else { 300 });
    vec![
        crowded("confetti, n = 1,000", size(1_000), true),
        crowded("confetti, n = 10,000", size(10_000), false),
        Scene {
            name: "300 × 300 squares minus a cross".to_owned(),
            layers: [squares, cross],
            work: vec![Work::Boolean(Operation::Not, "not")],
            size: None,
            is_small: false,
        },
        Scene {
            name: "95,000 72-gons".to_owned(),
            layers: [scenes::dots(size(95_000), 72), Vec::new()],
            work: vec![Work::Boolean(Operation::Or, "or"), Work::Offset(0.3)],
            size: None,
            is_small: false,
        },
    ]
}

/// Scenes of all kinds in three sizes.
fn suite(quick: bool) -> Vec<Scene> {
    let sizes: &[usize] = if quick { &[1] } else { &[1, 10, 100] };
    let scene = |(name, layers): scenes::Kind, size: usize| {
        let layers = layers(size);
        let booleans = BOOLEANS.map(|(operation, name)| Work::Boolean(operation, name));
        let offsets = [Work::Offset(0.3), Work::Offset(-0.2)];
        let work = if layers[1].is_empty() { offsets.to_vec() } else { [&booleans[..], &offsets].concat() };
        Scene { name: format!("{name}, size {size}"), layers, work, size: None, is_small: false }
    };
    scenes::KINDS.iter().flat_map(|&kind| sizes.iter().map(move |&size| scene(kind, size))).collect()
}

const BOOLEANS: [(Operation, &str); 4] =
    [(Operation::Or, "or"), (Operation::And, "and"), (Operation::Not, "not"), (Operation::Xor, "xor")];

/// Prints a line of the table for each kind of work on a scene, whose file stays; returns the ratios to the fastest peer.
fn compare(
    scene: &Scene,
    flags: &CompareFlags,
    python: Option<&Python>,
    growth: &mut Growths,
) -> anyhow::Result<Vec<(f64, String)>> {
    let file = scene_file(flags);
    let devices = draw(&scene.layers)?;
    layer_file::write(&both(&devices)?, &file, PRECISION)?;
    let mut ratios = Vec::new();
    for &work in &scene.work {
        let ours = ours(&devices, work, flags.threads)?;
        growth.0.extend(scene.size.map(|size| (work, size, ours.on_grid)));
        let time = |peer| match python {
            Some(python) if scene.is_small || peer != "phidl" => {
                theirs(python, &file, work, flags.threads, peer).map(Some)
            }
            _ => Ok(None),
        };
        let others = PEERS.into_iter().map(time).collect::<anyhow::Result<Vec<_>>>()?;
        println!("{}", table_line(&scene.name, work, &ours, &others));
        let fastest = others.iter().flatten().copied().reduce(f64::min);
        ratios.extend(fastest.map(|fastest| (fastest / ours.on_devices, line_name(&scene.name, work))));
    }
    Ok(ratios)
}

fn scene_file(flags: &CompareFlags) -> PathBuf {
    flags.out.join("scene.gds")
}

/// What `cargo xtask boolean` says of its time and memory on the file of the last scene, in a process of its own: united
/// layers.
fn on_file(scene: &Scene, flags: &CompareFlags) -> anyhow::Result<String> {
    let file = scene_file(flags);
    let layer = |number: u8| format!("{}:{number}", file.display());
    // A scene of one layer is merged with itself.
    let second = if scene.layers[1].is_empty() { 1 } else { 2 };
    let command = Command::new(std::env::current_exe()?)
        .args(["boolean", &layer(1), &layer(second), "--op", "or", "--threads", &flags.threads.to_string()])
        .args(["--out", &format!("{}:3", flags.out.join("result.gds").display())])
        .output()?;
    let printed = String::from_utf8_lossy(&command.stdout);
    ensure!(command.status.success(), "boolean: {printed}{}", String::from_utf8_lossy(&command.stderr));
    let total = printed.lines().find_map(|line| line.strip_prefix("total")).context("boolean printed no total")?;
    Ok(total.trim().to_owned())
}

fn line_name(scene: &str, work: Work) -> String {
    format!("{scene}: {}", work.name())
}

/// A line of the table; the field of a peer that does not take part is empty.
fn table_line(scene: &str, work: Work, ours: &Ours, others: &[Option<f64>]) -> String {
    let fastest = others.iter().flatten().copied().reduce(f64::min);
    let times = [Some(ours.on_grid), Some(ours.on_devices)].into_iter().chain(others.iter().copied());
    let times = times.map(|time| time.map_or_else(String::new, |time| format!("{:.1}", time * 1e3)));
    let ratio = fastest.map_or_else(String::new, |fastest| format!("{:.1}", fastest / ours.on_grid));
    let alone = [format!("{:.1}", ours.on_one_thread * 1e3), format!("{:.2}", ours.on_one_thread / ours.on_grid)];
    let fields: Vec<String> = [line_name(scene, work)].into_iter().chain(times).chain([ratio]).chain(alone).collect();
    format!("| {} |", fields.join(" | "))
}

/// Our times (s).
struct Ours {
    /// On integers, as KLayout works.
    on_grid: f64,
    /// The same on one thread.
    on_one_thread: f64,
    /// From devices to a device, as gdstk and PHIDL work.
    on_devices: f64,
}

fn ours(devices: &[Device; 2], work: Work, threads: usize) -> anyhow::Result<Ours> {
    let run = RunOptions { threads: Some(threads), ..RunOptions::default() };
    let options = Options { precision: PRECISION, max_points: None, run, ..Options::default() };
    let steps = grid::with_step(PRECISION)?;
    let [a, b] = devices;
    let contours: [Contours; 2] = [grid::snap_device(&steps, a, None)?, grid::snap_device(&steps, b, None)?];
    let on_grid = |run: &RunOptions| {
        best(|| match work {
            Work::Boolean(operation, _) => grid::boolean(&contours[0], &contours[1], operation, run),
            Work::Offset(distance) => {
                grid::offset(&contours[0], steps.scaled(distance), &OffsetOptions::default(), run)
            }
        })
    };
    let on_devices = best(|| match work {
        Work::Boolean(operation, _) => phidl_boolean::boolean(a, b, operation, 3, &options),
        Work::Offset(distance) => phidl_boolean::offset(a, distance, &OffsetOptions::default(), 3, &options),
    })?;
    let one_thread = RunOptions { threads: Some(1), ..run };
    Ok(Ours { on_grid: on_grid(&run)?, on_one_thread: on_grid(&one_thread)?, on_devices })
}

/// The shortest of a few times (s).
pub(crate) fn best<T, E: std::error::Error + Send + Sync + 'static>(
    work: impl Fn() -> Result<T, E>,
) -> anyhow::Result<f64> {
    let (mut shortest, mut spent, mut times) = (Duration::MAX, Duration::ZERO, 0);
    while times < REPEATS || spent < PATIENCE {
        let start = Instant::now();
        let result = work()?;
        let time = start.elapsed();
        drop(result);
        (shortest, spent, times) = (shortest.min(time), spent + time, times + 1);
    }
    Ok(shortest.as_secs_f64())
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
    Ok([drawn(&layers[0], 1).map_err(crate::report)?, drawn(&layers[1], 2).map_err(crate::report)?])
}

/// One device with all that some devices draw.
pub(crate) fn both(devices: &[Device]) -> anyhow::Result<Device> {
    let mut cell = Device::builder("scene");
    for device in devices {
        cell.add(device);
    }
    cell.build().map_err(crate::report)
}
