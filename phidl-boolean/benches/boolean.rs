//! Booleans and offsets on seeded scenes, on one thread and on two; throughput is in vertices of the input.
//!
//! `confetti` is the crowded case: rectangles, discs and stars, turned at random, at constant density. `confetti/10000`
//! has 0.52 million vertices in two layers. `strips` compares the sizes of strips, `isolated shapes` is a layer in which
//! nothing touches. `hierarchy` keeps a cell of 100 corners in arrays and among single placements; the flat result of a
//! million of them would need more memory than most machines have.

mod support;

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use phidl_boolean::{
    Hierarchy, OffsetOptions, Operation, Options, RunOptions, StripCount,
    grid::{Contours, boolean, offset},
};
use phidl_core::prelude::*;
use support::{confetti, dots};

const THREADS: [usize; 2] = [1, 2];

fn on(threads: usize) -> RunOptions<'static> {
    RunOptions { threads: Some(threads), ..RunOptions::default() }
}

fn vertices(a: &Contours, b: &Contours) -> Throughput {
    Throughput::Elements((a.point_count() + b.point_count()) as u64)
}

fn operations(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("confetti");
    group.sample_size(10);
    for n in [1_000, 10_000, 100_000] {
        let (a, b) = (confetti(n, 1), confetti(n, 2));
        group.throughput(vertices(&a, &b));
        for threads in THREADS {
            for operation in [Operation::Or, Operation::And, Operation::Xor] {
                let id = BenchmarkId::new(format!("{operation:?}, {threads} threads"), n);
                group.bench_function(id, |bench| bench.iter(|| boolean(black_box(&a), &b, operation, &on(threads))));
            }
        }
    }
    group.finish();
}

fn offsets(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("offset");
    group.sample_size(10);
    let mut scene = confetti(10_000, 1);
    scene.append(&confetti(10_000, 2));
    group.throughput(vertices(&scene, &Contours::new()));
    for (name, distance) in [("+0.5 µm", 5_000.0), ("-0.3 µm", -3_000.0)] {
        for threads in THREADS {
            let id = BenchmarkId::new(name, format!("{threads} threads"));
            let options = OffsetOptions::default();
            group
                .bench_function(id, |bench| bench.iter(|| offset(black_box(&scene), distance, &options, &on(threads))));
        }
    }
    group.finish();
}

fn strips(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("strips");
    group.sample_size(10);
    let (a, b) = (confetti(10_000, 1), confetti(10_000, 2));
    group.throughput(vertices(&a, &b));
    for strip_vertices in [1_000, 2_000, 4_000, 8_000, 16_000, usize::MAX] {
        let options = RunOptions { strips: StripCount::VerticesPerStrip(strip_vertices), ..on(2) };
        let id = BenchmarkId::from_parameter(strip_vertices);
        group.bench_function(id, |bench| bench.iter(|| boolean(black_box(&a), &b, Operation::Or, &options)));
    }
    group.finish();
}

fn files(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("outlines for files");
    group.sample_size(10);
    let (a, b) = (confetti(3_000, 1), confetti(3_000, 2));
    group.throughput(vertices(&a, &b));
    for operation in [Operation::Or, Operation::And] {
        let region = boolean(&a, &b, operation, &RunOptions::default()).expect("the scene is in range");
        let id = BenchmarkId::new("without holes", format!("{operation:?}"));
        group.bench_function(id, |bench| bench.iter(|| black_box(&region).without_holes()));
    }
    group.finish();
}

fn isolated_shapes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("isolated shapes");
    group.sample_size(10);
    let scene = dots(100_000);
    group.throughput(vertices(&scene, &Contours::new()));
    for threads in THREADS {
        let id = BenchmarkId::from_parameter(format!("{threads} threads"));
        let nothing = Contours::new();
        group.bench_function(id, |bench| {
            bench.iter(|| boolean(black_box(&scene), &nothing, Operation::Or, &on(threads)))
        });
    }
    group.finish();
}

/// A disc of 100 corners on layer 1 with a square on layer 2, placed in an array of `side` × `side`, or that often one
/// by one.
fn discs(side: u32, layer: u16, one_by_one: bool) -> Device {
    let build = |cell: DeviceBuilder| cell.build().expect("its shapes are valid");
    let mut disc = Device::builder("disc");
    let corners: Vec<Point> = (0..100).map(|i| Point::polar(4.0, 3.6 * f64::from(i))).collect();
    match layer {
        1 => disc.add_polygon(corners, layer).map(drop).expect("a disc"),
        _ => disc.add_polygon(Rect::new((-1, -1), (1, 1)), layer).map(drop).expect("a square"),
    }
    let disc = build(disc);
    let mut top = Device::builder("top");
    if one_by_one {
        (0..side * side).for_each(|i| {
            let (x, y) = (i % side, i / side);
            top.add(disc.place().moved_by((f64::from(10 * x), f64::from(12 * y + x % 3))));
        });
    } else {
        top.add(disc.array(side, side, (10, 12)));
    }
    build(top)
}

fn hierarchies(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("hierarchy");
    group.sample_size(10);
    let options = Options { run: on(2), ..Options::default() };
    let keep = Options { hierarchy: Hierarchy::Keep, ..options };
    let growth = OffsetOptions::default();
    for (name, side, one_by_one) in
        [("array", 100, false), ("array", 1000, false), ("one by one", 100, true), ("one by one", 1000, true)]
    {
        let (a, b) = (discs(side, 1, one_by_one), discs(side, 2, one_by_one));
        let cells = u64::from(side) * u64::from(side);
        group.throughput(Throughput::Elements(cells));
        let id = |work: &str| BenchmarkId::new(format!("{name}, {work}"), cells);
        let kept = || phidl_boolean::boolean(black_box(&a), &b, "not", 3, &keep);
        group.bench_function(id("not, kept"), |bench| bench.iter(kept));
        group.bench_function(id("offset, kept"), |bench| {
            bench.iter(|| phidl_boolean::offset(black_box(&a), 0.25, &growth, 3, &keep))
        });
        if side == 100 {
            let flat = || phidl_boolean::boolean(black_box(&a), &b, "not", 3, &options);
            group.bench_function(id("not, flat"), |bench| bench.iter(flat));
            group.bench_function(id("offset, flat"), |bench| {
                bench.iter(|| phidl_boolean::offset(black_box(&a), 0.25, &growth, 3, &options))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, operations, offsets, strips, files, isolated_shapes, hierarchies);
criterion_main!(benches);
