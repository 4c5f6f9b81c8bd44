//! Every registered shape, drawn anew each time. `cargo xtask bench shapes` puts the times beside PHIDL's.
//!
//! Nothing comes from the cache: not the shape, and not the shapes that it is made of.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::{GeneratorInfo, Redraw, cache};
use phidl_geometry::TextParams;
use testkit::loads;

/// A shape with the parameters with which tests and galleries draw it.
fn redraw(entry: &'static GeneratorInfo) -> Result<Redraw> {
    let example = entry.example()?.by_name();
    entry.redraw(&example)
}

fn shapes(c: &mut Criterion) {
    cache::set_limit(0);
    let mut group = c.benchmark_group("shapes");
    group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(800)).sample_size(20);
    for entry in registry::all().filter(|entry| entry.module.starts_with("phidl_geometry")) {
        let draw = redraw(entry).expect("examples can be read");
        group.bench_function(entry.name, |b| b.iter(&draw));
    }
    group.finish();
}

/// A thousand characters in the stencil font and in an outline font.
fn lettering(c: &mut Criterion) {
    let folder = tempfile::tempdir().expect("there is a place for a file");
    let font = folder.path().join("DejaVuSans.ttf");
    std::fs::write(&font, dejavu::sans::regular()).expect("the file can be written");
    let font = font.to_str().expect("the path is text");
    for (name, font) in [("DEPLOF", "DEPLOF"), ("outline font", font)] {
        let params = TextParams::default().text(loads::lines()).font(font);
        c.bench_function(&format!("1,000 characters, {name}"), |b| b.iter(|| params.build_uncached()));
    }
}

criterion_group!(benches, shapes, lettering);
criterion_main!(benches);
