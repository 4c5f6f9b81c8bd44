//! Named, seeded scenes for benchmarks and comparisons: the same shapes in every run, on every machine.
//!
//! Outlines are in micrometers. Numbers of vertices grow in proportion to `n`, and density is constant.

mod kinds;

pub use kinds::{KINDS, Kind};

use phidl_core::geom::{Point, Transform};

/// The corners of shapes.
pub type Outlines = Vec<Vec<Point>>;

/// SplitMix64: a few lines, good enough to scatter shapes, and nothing to change under our feet.
struct Random(u64);

impl Random {
    /// The next number, uniform in `0..1`.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next number, uniform in `low..high`.
    fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// `n` rectangles, `n` discs and `n` stars, each turned at random: a field of 3 µm a side for each shape of up to 5 µm.
/// Two of these with different seeds make the layers of the boolean benchmark; together they have 52 vertices for
/// each `n`.
#[must_use]
pub fn confetti(n: usize, seed: u64) -> Outlines {
    let mut random = Random(seed);
    let side = 3.0 * (3.0 * n as f64).sqrt();
    let mut shape = |index: usize| {
        let center = Point::new(random.range(0.0, side), random.range(0.0, side));
        let turn = random.range(0.0, 360.0);
        let outline = match index % 3 {
            0 => {
                let (w, h) = (random.range(0.5, 2.5), random.range(0.2, 1.5));
                [(-w, -h), (w, -h), (w, h), (-w, h)].map(Point::from).to_vec()
            }
            1 => radial(12, |_| 1.0, random.range(0.5, 2.0)),
            _ => radial(10, |corner| if corner % 2 == 0 { 1.0 } else { 0.45 }, random.range(0.8, 2.5)),
        };
        placed(&outline, turn, center)
    };
    (0..3 * n).map(&mut shape).collect()
}

/// `n` discs of `corners` corners and 2 µm across on a square lattice of 3 µm: nothing touches.
#[must_use]
pub fn dots(n: usize, corners: usize) -> Outlines {
    let columns = (n as f64).sqrt().ceil();
    let dot = radial(corners, |_| 1.0, 1.0);
    let place = |index: usize| Point::new((index as f64 % columns) * 3.0, (index as f64 / columns).floor() * 3.0);
    (0..n).map(|index| placed(&dot, 5.0, place(index))).collect()
}

/// `n` axis-parallel rectangles with sides of 0.2 to 6 µm, about 1.3 deep.
#[must_use]
pub fn rectangles(n: usize, seed: u64) -> Outlines {
    let mut random = Random(seed);
    let side = (n as f64 * 3.1 * 3.1 / 1.3).sqrt();
    let mut rectangle = || {
        let (x, y) = (random.range(0.0, side), random.range(0.0, side));
        axis_parallel(x, y, random.range(0.2, 6.0), random.range(0.2, 6.0))
    };
    (0..n).map(|_| rectangle()).collect()
}

/// `n` closed polylines of 3 to 7 random corners, most of which cross themselves.
#[must_use]
pub fn scribbles(n: usize, seed: u64) -> Outlines {
    let mut random = Random(seed);
    let side = 3.0 * (n as f64).sqrt();
    let mut scribble = |index: usize| {
        let (x, y) = (random.range(0.0, side), random.range(0.0, side));
        let mut corner = || Point::new(x + random.range(0.0, 6.0), y + random.range(0.0, 6.0));
        (0..3 + index % 5).map(|_| corner()).collect()
    };
    (0..n).map(&mut scribble).collect()
}

/// `n` bars of 1 µm at a pitch of 2 µm in each of two layers, which cross at right angles; all turned by an angle.
#[must_use]
pub fn crossbar(n: u32, turn: f64) -> [Outlines; 2] {
    let length = 2.0 * f64::from(n) + 2.0;
    let bars = |bar: &dyn Fn(f64) -> Vec<Point>| -> Outlines {
        (0..n).map(|i| placed(&bar(2.0 * f64::from(i)), turn, Point::ORIGIN)).collect()
    };
    [bars(&|at| axis_parallel(at, -1.0, 1.0, length)), bars(&|at| axis_parallel(-1.0, at, length, 1.0))]
}

/// `side` × `side` squares of 1 µm at a pitch of 2 µm, and a cross of two bars over the whole field.
#[must_use]
pub fn squares_and_cross(side: u32) -> (Outlines, Outlines) {
    let lattice =
        (0..side).flat_map(|column| (0..side).map(move |row| (2.0 * f64::from(column), 2.0 * f64::from(row))));
    let squares = lattice.map(|(x, y)| axis_parallel(x, y, 1.0, 1.0)).collect();
    let (length, middle) = (2.0 * f64::from(side) + 1.0, f64::from(side));
    let cross = vec![axis_parallel(-1.0, middle - 5.3, length, 10.6), axis_parallel(middle - 5.3, -1.0, 10.6, length)];
    (squares, cross)
}

fn axis_parallel(x: f64, y: f64, width: f64, height: f64) -> Vec<Point> {
    [(x, y), (x + width, y), (x + width, y + height), (x, y + height)].map(Point::from).to_vec()
}

fn radial(corners: usize, shape: impl Fn(usize) -> f64, radius: f64) -> Vec<Point> {
    let step = 360.0 / corners as f64;
    (0..corners).map(|corner| Point::polar(radius * shape(corner), step * corner as f64)).collect()
}

fn placed(outline: &[Point], turn: f64, center: Point) -> Vec<Point> {
    let matrix = Transform { rotation: turn, origin: center, ..Transform::IDENTITY }.matrix();
    outline.iter().map(|&p| matrix.apply(p)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::Rect;

    #[test]
    fn scenes_are_the_same_in_every_run_and_grow_in_proportion() {
        assert_eq!(confetti(20, 7), confetti(20, 7));
        assert_ne!(confetti(20, 7), confetti(20, 8));
        let vertices = |scene: &Outlines| scene.iter().map(Vec::len).sum::<usize>();
        assert_eq!(vertices(&confetti(20, 1)) + vertices(&confetti(20, 2)), 20 * 52);
        assert_eq!(vertices(&dots(50, 72)), 50 * 72);
    }

    #[test]
    fn dots_do_not_touch() {
        let boxes: Vec<Rect> = dots(30, 12).into_iter().filter_map(Rect::around).collect();
        assert!(boxes.iter().enumerate().all(|(i, a)| boxes[..i].iter().all(|b| !a.touches(b))));
    }
}
