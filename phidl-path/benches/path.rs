//! Extrusions and bends. The figures, beside those of other tools, are in the crate's README.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::prelude::*;
use phidl_path::{CrossSection, EulerBend, Extrusion, Overlaps, Path, Section};
use testkit::loads;

/// Three strips of constant width side by side.
fn three_strips() -> CrossSection {
    CrossSection::new()
        .add(Section::new(0.5).layer(1).ports("in", "out"))
        .add(Section::new(1.0).offset(2).layer(2))
        .add(Section::new(1.0).offset(-2).layer(3))
}

/// One strip with a width that is a function.
fn wavy_strip() -> CrossSection {
    CrossSection::new().add(Section::new(|t: f64| 1.0 + 0.2 * (50.0 * t).cos()).layer(1))
}

fn extrude(c: &mut Criterion) {
    let path = Path::from_points(loads::winding()).expect("the points are finite");
    let mut group = c.benchmark_group("extrude 10,000 points");
    group.throughput(Throughput::Elements(loads::POINTS.into()));
    let (three, wavy) = (three_strips(), wavy_strip());
    group.bench_function("three sections", |b| b.iter(|| black_box(&path).extrude(&three)));
    let unchecked = || Extrusion::new(black_box(&path), &three).overlaps(Overlaps::Keep).build();
    group.bench_function("three sections, unchecked", |b| b.iter(unchecked));
    group.bench_function("a width that is a function", |b| b.iter(|| black_box(&path).extrude(&wavy)));
    group.finish();
}

fn bends(c: &mut Criterion) {
    let radii = loads::radii();
    let mut group = c.benchmark_group("1,000 Euler bends");
    group.sample_size(20).throughput(Throughput::Elements(1000));
    let bend = EulerBend::new();
    group.bench_function("720 points per turn", |b| {
        b.iter(|| radii.iter().map(|r| bend.path(*r, 90)).collect::<Vec<_>>());
    });
    group.bench_function("720 points per turn, extruded", |b| {
        b.iter(|| radii.iter().map(|r| bend.path(*r, 90)?.extrude_width(0.5, 1)).collect::<Result<Vec<_>>>());
    });
    group.bench_function("within 1 nm", |b| {
        let few = bend.num_pts(1);
        b.iter(|| radii.iter().map(|r| few.path(*r, 90)?.with_tolerance(1e-3)).collect::<Result<Vec<_>>>());
    });
    group.bench_function("within 1 nm, extruded", |b| {
        let drawn = |r: &f64| bend.num_pts(1).path(*r, 90)?.with_tolerance(1e-3)?.extrude_width(0.5, 1);
        b.iter(|| radii.iter().map(drawn).collect::<Result<Vec<_>>>());
    });
    group.finish();
}

fn smooth(c: &mut Criterion) {
    let corners = loads::corners();
    c.bench_function("smooth 1,000 corners", |b| b.iter(|| Path::smooth(black_box(&corners), 5, EulerBend::new())));
}

criterion_group!(benches, extrude, bends, smooth);
criterion_main!(benches);
