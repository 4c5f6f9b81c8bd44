//! Writing and reading of a million squares in one cell, and of a thousand cells placed a thousand times.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};

/// A field of squares of 10 nm, 20 nm apart.
fn squares(count: u32) -> Device {
    let mut d = Device::builder("squares");
    for i in 0..count {
        let (x, y) = (f64::from(i % 1000) * 0.02, f64::from(i / 1000) * 0.02);
        d.add_polygon([(x, y), (x + 0.01, y), (x + 0.01, y + 0.01), (x, y + 0.01)], 1).expect("a square is an outline");
    }
    d.build().expect("squares are a cell")
}

/// Different cells, each placed often at odd angles.
fn placements(cells: u32, each: u32) -> Device {
    let mut top = Device::builder("placements");
    for number in 0..cells {
        let mut d = Device::builder(format!("cell{number}"));
        let size = f64::from(number + 1) * 0.01;
        d.add_polygon([(0.0, 0.0), (size, 0.0), (0.0, size)], 1).expect("a triangle is an outline");
        let cell = d.build().expect("a triangle is a cell");
        for i in 0..each {
            top.add(cell.place().rotated(f64::from(i)).moved_by((f64::from(i), f64::from(number))));
        }
    }
    top.build().expect("placements are a cell")
}

fn files(c: &mut Criterion) {
    for (name, device) in [("squares", squares(1_000_000)), ("placements", placements(1000, 1000))] {
        let options = GdsOptions::default();
        let bytes = gds::to_bytes(&device, &options).expect("it can be written");
        let mut group = c.benchmark_group(name);
        group.sample_size(10).throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function("write", |b| b.iter(|| gds::to_bytes(black_box(&device), &options)));
        group.bench_function("read", |b| b.iter(|| gds::read_bytes(black_box(&bytes), &ReadOptions::default())));
        group.finish();
    }
}

criterion_group!(benches, files);
criterion_main!(benches);
