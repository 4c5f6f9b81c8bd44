//! Ten thousand different manhattan routes, as ways, as centerlines, and as devices.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::cache;
use phidl_core::prelude::*;
use phidl_route::{RouteBend, RouteManhattanParams, manhattan_centerline, path_manhattan};
use testkit::loads;

fn routes(c: &mut Criterion) {
    let pairs = loads::pairs();
    let mut group = c.benchmark_group("manhattan");
    group.sample_size(10).throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function("ways", |b| {
        b.iter(|| pairs.iter().map(|[a, z]| path_manhattan(a, z, 10).expect("a right angle").length()).sum::<f64>());
    });
    for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
        group.bench_function(format!("centerlines, {bend:?}"), |b| {
            b.iter(|| pairs.iter().map(|[a, z]| length(a, z, bend)).sum::<f64>());
        });
    }
    group.bench_function("devices, Circular", |b| {
        let draw = |[a, z]: &[Port; 2]| RouteManhattanParams::new(a, z).radius(10).build().expect("a route");
        b.iter_batched(
            || (),
            |()| cache::bypass(|| pairs.iter().map(|pair| black_box(draw(pair)).ports().len()).sum::<usize>()),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

fn length(a: &Port, z: &Port, bend: RouteBend) -> f64 {
    manhattan_centerline(a, z, bend, 10).expect("a right angle").length()
}

criterion_group!(benches, routes);
criterion_main!(benches);
