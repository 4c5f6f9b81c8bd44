//! What the benches of the crates and `cargo xtask bench` give our functions to do: the same there and here. What
//! `benches/peers.py` gives other tools is written to match.

use phidl_core::geom::Point;
use phidl_core::place::Movable as _;
use phidl_core::port::Port;
use phidl_core::scene::Device;

/// Points of [`winding`].
pub const POINTS: u32 = 10_000;

/// A winding line of many points. Strips within 5 µm of it do not fold.
#[must_use]
pub fn winding() -> Vec<Point> {
    (0..POINTS).map(|i| f64::from(i) * 0.01).map(|t| Point::new(5.0 * t, 5.0 * t.sin())).collect()
}

/// The radii of a thousand bends (µm).
#[must_use]
pub fn radii() -> Vec<f64> {
    (0..1000).map(|i| 3.0 + 0.01 * f64::from(i)).collect()
}

/// A thousand right-angled corners, 40 µm apart.
#[must_use]
pub fn corners() -> Vec<Point> {
    let corner = |i: i32| Point::new(f64::from(i / 2) * 40.0, if i % 4 == 0 || i % 4 == 3 { 0.0 } else { 40.0 });
    (0..1000).map(corner).collect()
}

/// Ten thousand pairs of ports in all directions and all relative placements, from near to far.
#[must_use]
pub fn pairs() -> Vec<[Port; 2]> {
    let pair = |i: u32| {
        let (x, y) = (f64::from(i % 101) * 7.0 - 350.0, f64::from(i / 101) * 7.0 - 350.0);
        [Port::new((0, 0), 2, 90 * (i % 4)), Port::new((x, y), 2, 90 * (i / 4 % 4))]
    };
    (0..10_000).map(pair).collect()
}

/// A thousand characters in lines of fifty.
#[must_use]
pub fn lines() -> String {
    ["The quick brown fox jumps over the lazy dog 012345"; 20].join("\n")
}

/// A cell of a million rectangles, each added on its own.
///
/// # Panics
/// If the cell cannot be built.
#[must_use]
pub fn rectangles() -> Device {
    let mut d = Device::builder("field");
    for i in 0..1_000_000 {
        let (x, y) = (f64::from(i % 1000) * 3.0, f64::from(i / 1000) * 3.0);
        let corners = [(x, y), (x + 2.0, y), (x + 2.0, y + 1.0), (x, y + 1.0)];
        std::hint::black_box(d.add_polygon(corners, 1).expect("a rectangle is an outline"));
    }
    d.build().expect("the rectangles are finite")
}

/// A cell of ten rectangles.
fn ten_rectangles() -> Device {
    let mut d = Device::builder("ten");
    for i in 0..10 {
        let x = f64::from(i) * 0.1;
        d.add_polygon([(x, 0.0), (x + 0.05, 0.0), (x + 0.05, 1.0), (x, 1.0)], 1).expect("a rectangle is an outline");
    }
    d.build().expect("ten rectangles are a cell")
}

/// A turned array of 1000 × 1000 cells of ten rectangles.
///
/// # Panics
/// If the cell cannot be built.
#[must_use]
pub fn turned_array() -> Device {
    let mut d = Device::builder("array");
    d.add(ten_rectangles().array(1000, 1000, (2, 2)).rotated(30));
    d.build().expect("an array is a cell")
}

/// Six levels of ten turned references each: a million turned placements. New cells in every call: nothing is remembered.
///
/// # Panics
/// If the cell cannot be built.
#[must_use]
pub fn turned_hierarchy() -> Device {
    let mut cell = ten_rectangles();
    for level in 0..6 {
        let mut d = Device::builder(format!("level {level}"));
        for i in 0..10 {
            d.add(cell.place().rotated(f64::from(7 * i + level)).moved_by((20.0 * f64::from(i), 3.0 * f64::from(i))));
        }
        cell = d.build().expect("ten references are a cell");
    }
    cell
}

/// A field of squares of 10 nm, 20 nm apart.
///
/// # Panics
/// If the cell cannot be built.
#[must_use]
pub fn squares(count: u32) -> Device {
    let mut d = Device::builder("squares");
    for i in 0..count {
        let (x, y) = (f64::from(i % 1000) * 0.02, f64::from(i / 1000) * 0.02);
        d.add_polygon([(x, y), (x + 0.01, y), (x + 0.01, y + 0.01), (x, y + 0.01)], 1).expect("a square is an outline");
    }
    d.build().expect("squares are a cell")
}

/// Different cells, each placed often at odd angles.
///
/// # Panics
/// If a cell cannot be built.
#[must_use]
pub fn placements(cells: u32, each: u32) -> Device {
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
