//! The promise of welding: chains joined port to port, nested, mirrored and magnified, are one polygon per layer in the
//! file, with the area and the outline of the true chain.

use phidl_boolean::{Options, RunOptions, union_by_layer};
use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use phidl_io::weld::WeldOptions;

/// A small generator of numbers: the same chains in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn chance(&mut self, share: f64) -> bool {
        self.next() < share
    }

    /// A number below `count`.
    fn below(&mut self, count: u16) -> u16 {
        let share = self.next() * f64::from(count);
        (1..count).rev().find(|i| f64::from(*i) <= share).unwrap_or(0)
    }

    fn one_of(&mut self, list: &[f64]) -> f64 {
        let share = self.next() * list.len() as f64;
        (1..list.len()).rev().find(|i| *i as f64 <= share).map_or(list[0], |i| list[i])
    }
}

/// A layer of a chain: how far its edges are from the centerline.
type Strips = [(u16, f64, f64)];

/// One link: a straight, or an arc that turns by `turn` degrees.
fn link(strips: &Strips, length: f64, turn: f64) -> Device {
    let mut d = Device::builder(if turn == 0.0 { "straight" } else { "arc" });
    let steps = if turn == 0.0 { 1 } else { 12 };
    let radius = length / turn.to_radians();
    let at = |i: i32, offset: f64| {
        let part = f64::from(i) / f64::from(steps);
        match turn == 0.0 {
            true => Point::new(length * part, offset),
            false => Point::new(0.0, radius) + Point::polar(radius - offset, turn * part - 90.0),
        }
    };
    for &(layer, low, high) in strips {
        let there = (0..=steps).map(|i| at(i, low));
        let back = (0..=steps).rev().map(|i| at(i, high));
        d.add_polygon(there.chain(back).collect::<Vec<Point>>(), layer).unwrap();
    }
    d.add_port("1", (at(0, 0.0), 0.5, 180)).unwrap();
    d.add_port("2", (at(steps, 0.0), 0.5, turn)).unwrap();
    d.build().unwrap()
}

/// Parts in a row, each joined to the one before, as one cell with the ports of its ends.
fn row(parts: &[Device], mirror: bool, random: &mut Random) -> Device {
    let mut d = Device::builder("row");
    let mut last: Option<Reference> = None;
    for part in parts {
        let mut placed = part.place();
        if mirror && random.chance(0.3) {
            placed.mirror((0, 0), (1, 0));
        }
        match &last {
            Some(last) => {
                placed.connect("1", &last.port("2").unwrap()).unwrap();
            }
            None => {
                placed
                    .rotate(random.between(0.0, 360.0))
                    .move_by((random.between(-9.0, 9.0), random.between(-9.0, 9.0)));
                d.add_port("1", placed.port("1").unwrap()).unwrap();
            }
        }
        d.add(placed.clone());
        last = Some(placed);
    }
    d.add_port("2", last.unwrap().port("2").unwrap()).unwrap();
    d.build().unwrap()
}

/// A chain of some links, grouped into cells of cells.
fn chain(random: &mut Random, strips: &Strips) -> (Device, usize) {
    // Strips that lie on one side only would be on the other side of a mirrored neighbor: such chains are mirrored whole.
    let mirror = strips.iter().all(|strip| strip.1 == -strip.2);
    let links = 3 + usize::from(random.below(18));
    let most = 70.0 / links as f64;
    let mut parts: Vec<Device> = (0..links)
        .map(|_| {
            let turn = if random.chance(0.4) { 0.0 } else { random.between(-most, most) };
            link(strips, random.between(1.0, 6.0), turn)
        })
        .collect();
    while parts.len() > 1 {
        let size = 2 + usize::from(random.below(4));
        parts = parts.chunks(size).map(|chunk| row(chunk, mirror, random)).collect();
    }
    let top = parts.pop().unwrap();
    let angle = if random.chance(0.3) { 15.0 * (random.next() * 24.0).floor() } else { random.between(0.0, 360.0) };
    let mut d = Device::builder("top");
    let top = if random.chance(0.5) { top.place().mirrored((0, 0), (1, 2)) } else { top.place() };
    d.add(top.rotated(angle).moved_by((random.between(-50.0, 50.0), random.between(-50.0, 50.0))));
    (d.build().unwrap(), links)
}

/// What a layer looks like in the written file: number of polygons after merging, area and length of the outline (µm).
#[derive(Debug)]
struct Merged {
    polygons: usize,
    area: f64,
    outline: f64,
    shortest_edge: f64,
}

fn merged(device: &Device, weld: WeldOptions) -> Vec<(u16, Merged)> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("chain.gds");
    gds::write(device, &path, &GdsOptions { weld, ..GdsOptions::default() }).unwrap();
    let read = gds::read(&path, &ReadOptions::default()).unwrap().device;
    let options = Options { precision: 1e-3, run: RunOptions::default(), ..Options::default() };
    let union = union_by_layer(&read, &options).unwrap();
    union
        .layers()
        .into_iter()
        .map(|layer| {
            let polygons: Vec<Vec<Point>> = union.flat_polygons().on(layer).map(|p| p.points().collect()).collect();
            let edges: Vec<f64> =
                polygons.iter().flat_map(|p| (0..p.len()).map(|i| p[i].distance(p[(i + 1) % p.len()]))).collect();
            let merged = Merged {
                polygons: polygons.len(),
                area: union.flat_polygons().on(layer).map(|p| p.area()).sum(),
                outline: edges.iter().sum(),
                shortest_edge: edges.iter().copied().fold(f64::INFINITY, f64::min),
            };
            (layer.number, merged)
        })
        .collect()
}

/// Area and length of the outline of the true chain: sums over the links, less both sides of every seam.
fn truth(device: &Device, strip: (u16, f64, f64), links: usize) -> (f64, f64) {
    let polygons: Vec<Vec<Point>> = device.flat_polygons().on(strip.0).map(|p| p.points().collect()).collect();
    let area = device.flat_polygons().on(strip.0).map(|p| p.area()).sum();
    let length = |p: &Vec<Point>| (0..p.len()).map(|i| p[i].distance(p[(i + 1) % p.len()])).sum::<f64>();
    let outlines: f64 = polygons.iter().map(length).sum();
    (area, outlines - 2.0 * (links - 1) as f64 * (strip.2 - strip.1))
}

fn check(strips: &Strips, chains: u64, seed: u64) {
    let (mut open_without, mut checked, mut expected) = (0_u64, 0, 0);
    for number in 0..chains {
        expected += strips.len();
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(number + 1));
        random.next();
        let (device, links) = chain(&mut random, strips);
        let sound = |(layer, merged): &(u16, Merged)| {
            let strip = *strips.iter().find(|strip| strip.0 == *layer).unwrap();
            let (area, outline) = truth(&device, strip, links);
            merged.polygons == 1
                && (merged.area - area).abs() <= 0.75e-3 * outline
                // Rounding moves every corner by less than a step; a notch along a seam would add twice the width.
                && (merged.outline - outline).abs() <= 2.0 * (strip.2 - strip.1) * 0.9
                && merged.shortest_edge > 2e-3
        };
        for layer in merged(&device, WeldOptions::default()) {
            checked += 1;
            assert!(sound(&layer), "chain {number}, {layer:?}, true: {:?}", {
                truth(&device, *strips.iter().find(|strip| strip.0 == layer.0).unwrap(), links)
            });
        }
        open_without += u64::from(!merged(&device, false.into()).iter().all(sound));
    }
    assert_eq!(checked, expected);
    // The check has teeth: without welding most chains fail it.
    assert!(open_without * 10 >= chains * 7, "{open_without} of {chains} open without welding");
}

#[test]
fn chains_of_one_layer_have_neither_gap_nor_overlap() {
    let mut random = Random(7);
    random.next();
    for seed in 0..6 {
        let half = random.one_of(&[0.4, 0.415, 0.45, 0.5, 1.0]) / 2.0;
        check(&[(1, -half, half)], 25, seed + 1);
    }
}

#[test]
fn chains_of_three_layers_have_neither_gap_nor_overlap() {
    check(&[(1, -0.25, 0.25), (2, -1.5, 1.5), (3, 1.9, 2.1)], 40, 99);
}
