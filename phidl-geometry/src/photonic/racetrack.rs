//! [`racetrack_gradual`].

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;

/// Points of the curve before it is refined.
const COARSE_POINTS: usize = 99;
/// Largest distance of the middle of a chord from the curve (µm).
const TOLERANCE: f64 = 0.01;
/// Smallest step of a finite difference along the parameter; below it, cosines lose their digits.
const SMALLEST_STEP: f64 = 1e-6;

/// Draws a quarter turn with gradual curvature: a superellipse whose tightest part is an arc.
///
/// It starts at (R − c, 0) along y with low curvature and ends on the y axis, where the arc ends. The superellipse is
/// shifted to the left by c so that the arc continues it smoothly: c = 1.98 µm for R = 5 µm and N = 3.
///
/// # Ports
/// None.
///
/// # Errors
/// The wire must not be wider than twice the radius of its tightest bend.
///
/// # Numerics
/// 99 points evenly spaced along the parameter of the curve, and more where a chord would leave the curve by more than
/// 10 nm. Edges are set off along normals by finite differences; the ends are tilted by less than 0.001 rad.
///
/// # Differences from PHIDL
/// `R` and `N` count; PHIDL always draws `R = 5`, `N = 3`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let bend = pg::racetrack_gradual(0.3, 5, 3, 1)?;
/// assert_eq!(bend.polygons().next().map(|p| p.points.len()), Some(204));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `racetrack_gradual`.
#[device(picture = "docs/racetrack_gradual.svg")]
pub fn racetrack_gradual(
    /// Width of the wire.
    #[default(0.3)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// Half axis of the superellipse.
    #[default(5.0)]
    #[param(name = "R", unit = "um", above = 0.0, max = 1e6)]
    r: f64,
    /// Exponent of the superellipse: 2 is a circle, more is closer to a square with a round corner.
    #[default(3.0)]
    #[param(name = "N", min = 2.0, max = 20.0)]
    n: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let curve = Curve::new(r, n);
    check.at_most("width", width, ("twice the tightest radius", 2.0 * curve.tightest))?;
    let (samples, finest) = curve.samples();
    let step = (finest / 2.0).max(SMALLEST_STEP);
    let edges: Vec<(Point, Point)> =
        samples.iter().map(|t| (curve.at(*t), curve.normal(*t, step) * (width / 2.0))).collect();
    let left = edges.iter().map(|(p, normal)| *p + *normal);
    let right = edges.iter().rev().map(|(p, normal)| *p - *normal);

    let mut d = Device::builder("racetrack");
    d.add_polygon(left.chain(right).collect::<Vec<_>>(), layer)?;
    d.build()
}

/// The middle line, for a parameter from 0 (on the x axis) to 1 (on the y axis).
struct Curve {
    r: f64,
    n: f64,
    /// Radius of the arc that ends the superellipse at 45°.
    tightest: f64,
    /// Shift of both halves towards the axes.
    shift: f64,
}

impl Curve {
    fn new(r: f64, n: f64) -> Self {
        let diagonal = r / 2.0_f64.powf(1.0 / n);
        let tightest = 2.0_f64.powf(0.5 - 1.0 / n) * r / (n - 1.0);
        Self { r, n, tightest, shift: diagonal - tightest / 2.0_f64.sqrt() }
    }

    fn at(&self, t: f64) -> Point {
        let Self { r, n, tightest, shift } = *self;
        let half = r - shift;
        let x = half * (PI * t / 2.0).cos();
        let y = if x > tightest / 2.0_f64.sqrt() {
            // (rⁿ − (x + shift)ⁿ)^(1/n), written so that it keeps its digits where x + shift is close to r.
            let missing = 2.0 * half * (PI * t / 4.0).sin().powi(2) / r;
            r * (-(n * (-missing).ln_1p()).exp_m1()).powf(1.0 / n)
        } else {
            shift + (tightest * tightest - x * x).sqrt()
        };
        Point::new(x, y)
    }

    /// Parameters of the points, refined where the curve is tight, and the smallest step between them.
    fn samples(&self) -> (Vec<f64>, f64) {
        let mut coarse = linspace(0.0, 1.0, COARSE_POINTS);
        let mut finest = 1.0 / (COARSE_POINTS - 1) as f64;
        let mut samples: Vec<f64> = coarse.next().into_iter().collect();
        let mut from = 0.0;
        for next in coarse {
            // Ends of the steps still to be taken, the nearest last.
            let mut ahead = vec![next];
            while let Some(&to) = ahead.last() {
                let middle = (from + to) / 2.0;
                let chord = (self.at(from) + self.at(to)) / 2.0;
                if self.at(middle).distance(chord) > TOLERANCE {
                    finest = finest.min((to - from) / 2.0);
                    ahead.push(middle);
                } else {
                    ahead.pop();
                    samples.push(to);
                    from = to;
                }
            }
        }
        (samples, finest)
    }

    /// Unit normal to the left of the curve, by central differences inside the curve.
    fn normal(&self, t: f64, step: f64) -> Point {
        let along = self.at((t + step).min(1.0)) - self.at((t - step).max(0.0));
        Point::new(-along.y, along.x) / along.norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn the_default_is_that_of_the_specification() {
        let curve = Curve::new(5.0, 3.0);
        assert!((curve.tightest - 2.80615512).abs() < 1e-8 && (curve.shift - 1.98425131).abs() < 1e-8);
        let (samples, finest) = curve.samples();
        assert_eq!(samples.len(), 102);
        assert!((finest - 0.00127551).abs() < 1e-8);
        let d = racetrack_gradual(0.3, 5, 3, 0).unwrap();
        let points = d.polygons().next().unwrap().points.to_vec();
        for (i, x, y) in [(0, 2.86574868, -0.00000469), (101, -0.00008075, 4.64040644), (203, 3.16574868, 0.00000469)] {
            assert!(points[i].distance(Point::new(x, y)) < 1e-7, "{i} {}", points[i]);
        }
    }

    #[test]
    fn the_halves_meet_smoothly_on_the_diagonal() {
        let curve = Curve::new(8.0, 4.0);
        let corner = curve.tightest / 2.0_f64.sqrt();
        let t = (corner / (8.0 - curve.shift)).acos() * 2.0 / PI;
        let (before, after) = (curve.at(t - 1e-6), curve.at(t + 1e-6));
        assert!(before.distance(after) < 1e-4);
        let slope = (after - before).direction();
        assert!((slope - 135.0).abs() < 0.01, "{slope}");
    }

    #[test]
    fn an_exponent_of_two_is_a_circle() {
        let curve = Curve::new(5.0, 2.0);
        assert!(linspace(0.0, 1.0, 30).all(|t| (curve.at(t).norm() - 5.0).abs() < 1e-6));
    }

    #[test]
    fn wires_wider_than_their_bend_are_refused() {
        let error = racetrack_gradual(6, 5, 3, 0).unwrap_err().to_string();
        assert!(
            error.starts_with("racetrack_gradual: width is 6 µm, but it must be at most twice the tightest radius")
        );
    }

    proptest! {
        #[test]
        fn edges_keep_the_width_and_chords_the_tolerance(r in 1.0..200.0_f64, n in 2.0..8.0_f64) {
            let curve = Curve::new(r, n);
            let d = racetrack_gradual(1.5 * curve.tightest, r, n, 0).unwrap();
            prop_assert!(outlines_are_simple(&d));
            let points = d.polygons().next().unwrap().points.to_vec();
            let half = points.len() / 2;
            for i in 0..half {
                let across = points[i].distance(points[2 * half - 1 - i]);
                prop_assert!((across / (1.5 * curve.tightest) - 1.0).abs() < 1e-9);
            }
            let (samples, _) = curve.samples();
            for pair in samples.windows(2) {
                let middle = curve.at((pair[0] + pair[1]) / 2.0);
                prop_assert!(middle.distance((curve.at(pair[0]) + curve.at(pair[1])) / 2.0) <= TOLERANCE);
            }
        }
    }
}
