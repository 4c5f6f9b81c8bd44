//! Scenes of many kinds, so that no single kind decides how fast an engine seems to be.
//!
//! Each has two layers and grows in proportion to `n`; all are seeded or regular.

use phidl_core::geom::Point;

use super::{Outlines, Random, axis_parallel, confetti, crossbar, dots, placed, radial, rectangles};

/// A kind of scene: its name, and the layers for a size, where 1 is about a thousand vertices or crossings.
pub type Kind = (&'static str, fn(usize) -> [Outlines; 2]);

/// All kinds.
pub const KINDS: [Kind; 16] = [
    ("confetti", |n| [confetti(20 * n, 1), confetti(20 * n, 2)]),
    ("rectangles", |n| [rectangles(125 * n, 1), rectangles(125 * n, 2)]),
    ("octagons of 45°", octagons),
    ("crossing bars", |n| crossbar(root(1000 * n), 0.0)),
    ("crossing bars at 7.3°", |n| crossbar(root(250 * n), 7.3)),
    ("checkerboard", checkerboard),
    ("nested discs", nested_discs),
    ("long wires", |n| [wires(root(1000 * n), 1), wires(root(1000 * n), 2)]),
    ("spiral and stripes", spiral_and_stripes),
    ("one giant outline", giant_outline),
    ("bends with trenches", bends),
    ("stencil letters", letters),
    ("fill and layout", |n| [fill(250 * n), rectangles(20 * n, 3)]),
    ("dots", |n| [dots(14 * n, 72), Vec::new()]),
    ("piled-up array", pile),
    ("copies", |n| [vec![star(100, 30.0); 10 * n], vec![star(100, 29.0); 3]]),
];

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the root of a small count")]
fn root(n: usize) -> u32 {
    (n as f64).sqrt() as u32
}

/// Octagons and rectangles on a lattice of a tenth of a micrometer.
fn octagons(n: usize) -> [Outlines; 2] {
    let layer = |seed| {
        let mut random = Random(seed);
        let side = (62 * n) as f64 * 4.0;
        let mut octagon = || {
            let mut whole = |high: f64| (random.range(0.0, high) * 10.0).round() / 10.0;
            let (x, y, r) = (whole(side.sqrt()), whole(side.sqrt()), 0.4 + whole(1.6));
            let s = (r * 4.0).round() / 10.0;
            [(r, s), (s, r), (-s, r), (-r, s), (-r, -s), (-s, -r), (s, -r), (r, -s)]
                .map(|(dx, dy)| Point::new(x + dx, y + dy))
                .to_vec()
        };
        (0..62 * n).map(|_| octagon()).collect()
    };
    [layer(1), layer(2)]
}

/// Squares of 15 µm that overlap others of the second layer at their corners.
fn checkerboard(n: usize) -> [Outlines; 2] {
    let side = root(125 * n);
    let squares = |shift: f64| -> Outlines {
        let lattice = (0..side).flat_map(|i| (0..side).map(move |j| (20.0 * f64::from(i), 20.0 * f64::from(j))));
        lattice.map(|(x, y)| axis_parallel(x + shift, y + shift, 15.0, 15.0)).collect()
    };
    [squares(0.0), squares(10.0)]
}

/// Four discs of 180 corners in each other, at each site of a lattice; the second layer is shifted.
fn nested_discs(n: usize) -> [Outlines; 2] {
    let side = root(n);
    let layer = |shift: Point| -> Outlines {
        let sites =
            (0..side).flat_map(|i| (0..side).map(move |j| Point::new(30.0 * f64::from(i), 30.0 * f64::from(j))));
        sites
            .flat_map(|at| (1..5).map(move |r| placed(&radial(180, |_| 1.0, 3.0 * f64::from(r)), 0.5, at + shift)))
            .collect()
    };
    [layer(Point::ORIGIN), layer(Point::new(7.3, 3.1))]
}

/// Wires of 0.5 µm between random points of a square of 1 mm.
fn wires(count: u32, seed: u64) -> Outlines {
    let mut random = Random(seed);
    let mut end = || Point::new(random.range(0.0, 1000.0), random.range(0.0, 1000.0));
    (0..count).map(|_| wire(end(), end(), 0.5)).collect()
}

fn wire(a: Point, b: Point, width: f64) -> Vec<Point> {
    let side = Point::new(a.y - b.y, b.x - a.x) * (0.5 * width / a.distance(b));
    vec![a - side, b - side, b + side, a + side]
}

/// A spiral of straight wires and stripes across it.
fn spiral_and_stripes(n: usize) -> [Outlines; 2] {
    let corner = |i: usize| Point::polar(2.0 * i as f64, 87.0 * i as f64);
    let wires = (1..30 * n).map(|i| wire(corner(i), corner(i + 1), 1.0)).collect();
    let reach = 60.0 * n as f64;
    let stripes = (0..30 * n).map(|i| axis_parallel(-reach, 4.0 * i as f64 - reach, 2.0 * reach, 1.5)).collect();
    [wires, stripes]
}

/// One outline with `1000 n` corners, and stripes across it.
fn giant_outline(n: usize) -> [Outlines; 2] {
    let mut random = Random(5);
    let corners = 1000 * n;
    let mut corner = |i: usize| {
        let angle = 360.0 * i as f64 / corners as f64;
        Point::polar(1000.0 + 300.0 * (37.0 * angle).to_radians().sin() + random.range(0.0, 0.2), angle)
    };
    let outline = (0..corners).map(&mut corner).collect();
    let stripes = (0..200).map(|i| axis_parallel(-1500.0, 12.0 * f64::from(i) - 1200.0, 3000.0, 5.0)).collect();
    [vec![outline], stripes]
}

/// Bends of 64 chords and the wider bends around them, at random positions.
fn bends(n: usize) -> [Outlines; 2] {
    let bend = |radius: f64, width: f64| -> Vec<Point> {
        let arc = |r: f64| (0..=64).map(move |i| Point::polar(r, 90.0 * f64::from(i) / 64.0));
        arc(radius - width / 2.0).chain(arc(radius + width / 2.0).collect::<Vec<_>>().into_iter().rev()).collect()
    };
    let mut random = Random(6);
    let side = 12.0 * (4.0 * n as f64).sqrt();
    let mut sites: Vec<(Point, f64, f64)> = Vec::new();
    for _ in 0..4 * n {
        let at = Point::new(random.range(0.0, side), random.range(0.0, side));
        sites.push((at, random.range(0.0, 360.0), random.range(5.0, 12.0)));
    }
    let layer = |width: f64| sites.iter().map(|&(at, turn, radius)| placed(&bend(radius, width), turn, at)).collect();
    [layer(4.0), layer(0.5)]
}

/// Letters of strokes, in lines, over a second text that is shifted.
fn letters(n: usize) -> [Outlines; 2] {
    let strokes: [&[(f64, f64, f64, f64)]; 4] = [
        &[(0.0, 0.0, 1.0, 6.0), (0.0, 5.0, 4.0, 1.0), (0.0, 2.5, 3.0, 1.0)],
        &[(0.0, 0.0, 1.0, 6.0), (3.0, 0.0, 1.0, 6.0), (0.0, 2.5, 4.0, 1.0)],
        &[(0.0, 0.0, 1.0, 6.0), (0.0, 0.0, 4.0, 1.0)],
        &[(1.5, 0.0, 1.0, 6.0), (0.0, 5.0, 4.0, 1.0)],
    ];
    let columns = 100;
    let text = |shift: f64| -> Outlines {
        let letter = |i: usize| {
            let (x, y) = ((i % columns) as f64 * 5.0 + shift, (i / columns) as f64 * 8.0 + shift);
            strokes[i * 7 % 4].iter().map(move |&(dx, dy, w, h)| axis_parallel(x + dx, y + dy, w, h))
        };
        (0..50 * n).flat_map(letter).collect()
    };
    [text(0.0), text(1.3)]
}

/// Fill squares on a lattice.
fn fill(n: usize) -> Outlines {
    let side = root(n);
    let lattice = (0..side).flat_map(|i| (0..side).map(move |j| (f64::from(i), f64::from(j))));
    lattice.map(|(x, y)| axis_parallel(1.5 * x, 1.5 * y, 1.0, 1.0)).collect()
}

fn star(corners: usize, radius: f64) -> Vec<Point> {
    radial(corners, |corner| if corner % 2 == 0 { 1.0 } else { 0.8 }, radius)
}

/// One star many times, each shifted by a hundredth of a micrometer.
fn pile(n: usize) -> [Outlines; 2] {
    let star = star(40, 30.0);
    let shifted = |i: usize| placed(&star, 0.0, Point::new(0.03 * i as f64, 0.01 * i as f64));
    [(0..20 * n).map(shifted).collect(), vec![axis_parallel(0.0, -50.0, 3.0, 100.0)]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_draws_something_and_grows() {
        let size = |layers: [Outlines; 2]| layers.iter().flatten().map(Vec::len).sum::<usize>();
        for (name, kind) in KINDS {
            assert!(size(kind(1)) > 0 && size(kind(4)) > size(kind(1)), "{name}");
            assert!(kind(1) == kind(1), "{name}");
        }
    }
}
