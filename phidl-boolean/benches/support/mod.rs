//! Named, seeded scenes for benchmarks and tests: the same shapes in every run, on every machine.

use phidl_boolean::grid::{Contours, GridPoint};

/// SplitMix64: a few lines, good enough to scatter shapes, and nothing to change under our feet.
struct Random(u64);

impl Random {
    /// The next number, uniform in `0..1`.
    #[expect(clippy::cast_precision_loss, reason = "53 bits are exact in an f64")]
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

/// Steps per µm in all scenes.
const STEPS: f64 = 1e4;

/// `n` rectangles, `n` discs and `n` stars, each turned at random, at constant density: a field of 3 µm a side for
/// each shape of up to 5 µm. Two of these with different seeds make the layers of the boolean benchmark; together
/// they have 52 vertices for each `n`.
#[expect(clippy::cast_precision_loss, reason = "numbers of shapes")]
pub(crate) fn confetti(n: usize, seed: u64) -> Contours {
    let mut random = Random(seed);
    let side = 3.0 * (3.0 * n as f64).sqrt();
    let mut scene = Contours::with_capacity(3 * n, 26 * n);
    for index in 0..3 * n {
        let center = (random.range(0.0, side), random.range(0.0, side));
        let turn = random.range(0.0, std::f64::consts::TAU);
        let outline: Vec<(f64, f64)> = match index % 3 {
            0 => {
                let (w, h) = (random.range(0.5, 2.5), random.range(0.2, 1.5));
                vec![(-w, -h), (w, -h), (w, h), (-w, h)]
            }
            1 => radial(12, |_| 1.0, random.range(0.5, 2.0)),
            _ => radial(10, |corner| if corner % 2 == 0 { 1.0 } else { 0.45 }, random.range(0.8, 2.5)),
        };
        scene.push(outline.into_iter().map(|p| placed(p, turn, center)));
    }
    scene
}

/// `n` discs of twelve points on a square lattice, none touching another.
#[expect(clippy::cast_precision_loss, reason = "numbers of shapes")]
pub(crate) fn apart(n: usize) -> Contours {
    let columns = (n as f64).sqrt().ceil();
    let place = |index: usize| ((index as f64 % columns) * 3.0, (index as f64 / columns).floor() * 3.0);
    (0..n)
        .map(|index| {
            radial(12, |_| 1.0, 1.0).into_iter().map(move |p| placed(p, 0.1, place(index))).collect::<Vec<_>>()
        })
        .collect()
}

#[expect(clippy::cast_precision_loss, reason = "a few corners")]
fn radial(corners: usize, shape: impl Fn(usize) -> f64, radius: f64) -> Vec<(f64, f64)> {
    let angle = |corner: usize| std::f64::consts::TAU * corner as f64 / corners as f64;
    (0..corners).map(|c| (radius * shape(c) * angle(c).cos(), radius * shape(c) * angle(c).sin())).collect()
}

#[expect(clippy::cast_possible_truncation, reason = "scenes are far smaller than the range")]
fn placed((x, y): (f64, f64), turn: f64, center: (f64, f64)) -> GridPoint {
    let (sin, cos) = turn.sin_cos();
    let (x, y) = (center.0 + x * cos - y * sin, center.1 + x * sin + y * cos);
    GridPoint::new((x * STEPS).round() as i64, (y * STEPS).round() as i64)
}
