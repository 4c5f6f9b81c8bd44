//! Building, flattening and measuring large cells. What the figures mean is in `benches/README.md` at the top.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::prelude::*;

/// A million rectangles, each added on its own, into one cell.
fn build_rectangles(c: &mut Criterion) {
    const COUNT: u32 = 1_000_000;
    let mut group = c.benchmark_group("build");
    group.sample_size(10).throughput(Throughput::Elements(COUNT.into()));
    group.bench_function("a million rectangles", |b| {
        b.iter(|| {
            let mut d = Device::builder("field");
            for i in 0..COUNT {
                let (x, y) = (f64::from(i % 1000) * 3.0, f64::from(i / 1000) * 3.0);
                let corners = [(x, y), (x + 2.0, y), (x + 2.0, y + 1.0), (x, y + 1.0)];
                black_box(d.add_polygon(corners, 1).expect("a rectangle is an outline"));
            }
            d.build().expect("the rectangles are finite")
        });
    });
    group.finish();
}

/// A cell of ten rectangles.
fn ten_rectangles() -> Device {
    let mut d = Device::builder("ten");
    for i in 0..10 {
        let x = f64::from(i) * 0.1;
        d.add_polygon([(x, 0.0), (x + 0.05, 0.0), (x + 0.05, 1.0), (x, 1.0)], 1).expect("a rectangle is an outline");
    }
    d.build().expect("ten rectangles are a cell")
}

/// An array of 1000 × 1000 cells of ten polygons, into one cell of ten million.
fn flatten_array(c: &mut Criterion) {
    let mut d = Device::builder("array");
    d.add(ten_rectangles().array(1000, 1000, (2, 2)).rotated(30));
    let array = d.build().expect("an array is a cell");
    let mut group = c.benchmark_group("flatten");
    group.sample_size(10).throughput(Throughput::Elements(10_000_000));
    group.bench_function("1000 x 1000 cells of 10 polygons", |b| b.iter(|| black_box(array.flattened())));
    group.finish();
}

/// Six levels of ten turned references each: a million turned placements. New cells in every round: nothing is remembered.
fn turned_hierarchy() -> Device {
    let mut cell = ten_rectangles();
    for level in 0..6 {
        let mut d = Device::builder(format!("level {level}"));
        for i in 0..10 {
            d.add(cell.place().rotated(f64::from(7 * i + level)).moved_by((20.0 * f64::from(i), 3.0 * f64::from(i))));
        }
        cell = d.build().expect("ten references are a cell");
    }
    cell
}

fn bounding_box(c: &mut Criterion) {
    let mut group = c.benchmark_group("bbox");
    group.bench_function("6 levels, a million turned instances, first time", |b| {
        b.iter_batched(turned_hierarchy, |top| black_box(top.bbox()), criterion::BatchSize::SmallInput);
    });
    let top = turned_hierarchy();
    group.bench_function("6 levels, a million turned instances, again", |b| b.iter(|| black_box(top.bbox())));
    group.finish();
}

criterion_group!(benches, build_rectangles, flatten_array, bounding_box);
criterion_main!(benches);
