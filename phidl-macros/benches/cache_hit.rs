//! What a call costs when the cell is in the cache.
#![allow(missing_docs, reason = "criterion makes public items without documentation")]

use criterion::{Criterion, criterion_group, criterion_main};
use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn five_numbers(
    #[default(1)] a: f64,
    #[default(2)] b: f64,
    #[default(3)] c: f64,
    #[default(4)] d: f64,
    #[default(0)] layer: Layers,
) -> Result<Device> {
    let mut cell = Device::builder("five_numbers");
    cell.add_polygon([(a, b), (c, b), (c, d)], layer)?;
    cell.build()
}

#[device]
fn mixed(
    #[default((4, 2))] size: Size,
    #[default("p")] text: String,
    #[default([1, 2, 3])] list: Vec<f64>,
    #[default(None)] port: Option<Port>,
    #[default([1, 2])] layer: Layers,
) -> Result<Device> {
    let mut cell = Device::builder(text);
    let x = list.len() as f64 + port.map_or(0.0, |port| port.width());
    cell.add_polygon([(x, 0.0), (size.width, 0.0), (0.0, size.height)], layer)?;
    cell.build()
}

fn hits(c: &mut Criterion) {
    // Something else in the cache, as in a real program.
    let others: Vec<Device> = (0..10_000).filter_map(|i| five_numbers(i, 0, 1, 2, 0).ok()).collect();
    assert_eq!(others.len(), 10_000);
    c.bench_function("five numbers", |b| b.iter(|| five_numbers(7, 0, 1, 2, 0)));
    let params = MixedParams::default();
    c.bench_function("size, text, list, port and layers", |b| b.iter(|| params.build()));
}

criterion_group!(benches, hits);
criterion_main!(benches);
