//! Ten thousand different Manhattan routes, as waypoints, as centerlines, and as devices.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::cache;
use phidl_core::prelude::*;
use phidl_route::{RouteBend, RouteManhattanParams, path_manhattan};
use testkit::loads;

fn routes(c: &mut Criterion) {
    let pairs = loads::pairs();
    let mut group = c.benchmark_group("manhattan");
    group.sample_size(10).throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function("waypoints", |b| {
        b.iter(|| pairs.iter().map(|[a, z]| path_manhattan(a, z, 10).expect("a right angle").length()).sum::<f64>());
    });
    for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
        group.bench_function(format!("centerlines, {bend:?}"), |b| {
            b.iter(|| pairs.iter().map(|[a, z]| length(a, z, bend)).sum::<f64>());
        });
    }
    group.bench_function("devices, Circular", |b| {
        let draw = |[a, z]: &[Port; 2]| route(a, z).build().expect("a route");
        b.iter_batched(
            || (),
            |()| cache::bypass(|| pairs.iter().map(|pair| black_box(draw(pair)).ports().len()).sum::<usize>()),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

fn length(a: &Port, z: &Port, bend: RouteBend) -> f64 {
    route(a, z).bend(bend).centerline().expect("a right angle").length()
}

/// A route of any kind: the pairs are in all positions.
fn route(a: &Port, z: &Port) -> RouteManhattanParams {
    RouteManhattanParams::new(a, z).radius(10).width(a.width()).allow_detour(true).allow_crossings(true)
}

criterion_group!(benches, routes);
criterion_main!(benches);
