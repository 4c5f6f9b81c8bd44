//! Writing and reading of a million squares in one cell, and of a thousand cells placed a thousand times.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use testkit::loads::{placements, squares};

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
