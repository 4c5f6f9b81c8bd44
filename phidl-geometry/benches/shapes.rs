//! Every registered shape, drawn again each time. `cargo xtask bench shapes` puts the times beside PHIDL's.
//!
//! Nothing comes from the cache: not the shape, and not the shapes that it is made of.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use phidl_core::{cache, registry};
use phidl_geometry::TextParams;
use testkit::loads;

fn shapes(c: &mut Criterion) {
    let mut group = c.benchmark_group("shapes");
    group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(800)).sample_size(20);
    for entry in registry::all().filter(|entry| entry.module.starts_with("phidl_geometry")) {
        let example = entry.example().expect("examples can be read").by_name();
        group.bench_function(entry.name, |b| b.iter(|| cache::bypass(|| entry.build(&example))));
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
        c.bench_function(&format!("1,000 characters, {name}"), |b| b.iter(|| cache::bypass(|| params.build())));
    }
}

criterion_group!(benches, shapes, lettering);
criterion_main!(benches);
