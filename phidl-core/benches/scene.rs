//! Building, flattening and measuring large cells. What the figures mean is in `benches/README.md` at the top.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::place::Bounded as _;
use testkit::loads;

/// A million rectangles, each added on its own, into one cell.
fn build_rectangles(c: &mut Criterion) {
    let mut group = c.benchmark_group("build");
    group.sample_size(10).throughput(Throughput::Elements(1_000_000));
    group.bench_function("a million rectangles", |b| b.iter(loads::rectangles));
    group.finish();
}

/// An array of 1000 × 1000 cells of ten polygons, into one cell of ten million.
fn flatten_array(c: &mut Criterion) {
    let array = loads::turned_array();
    let mut group = c.benchmark_group("flatten");
    group.sample_size(10).throughput(Throughput::Elements(10_000_000));
    group.bench_function("1000 x 1000 cells of 10 polygons", |b| {
        b.iter(|| black_box(array.flattened().expect("within the limit")))
    });
    group.finish();
}

fn bounding_box(c: &mut Criterion) {
    let mut group = c.benchmark_group("bbox");
    group.bench_function("6 levels, a million turned instances, first time", |b| {
        b.iter_batched(loads::turned_hierarchy, |top| black_box(top.bbox()), criterion::BatchSize::SmallInput);
    });
    let top = loads::turned_hierarchy();
    group.bench_function("6 levels, a million turned instances, again", |b| b.iter(|| black_box(top.bbox())));
    group.finish();
}

criterion_group!(benches, build_rectangles, flatten_array, bounding_box);
criterion_main!(benches);
