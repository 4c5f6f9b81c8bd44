//! Sampling by tolerance: the fewest points that keep every chord close to its curve.
//!
//! From the start on, every chord is made as long as the tolerance lets it be; no other choice of points on the curve
//! needs fewer chords. Then the tolerance is lowered until the last chord is as good as the others: the same number of
//! chords, evenly good, and a symmetric bend gets symmetric points. Spacing points by the root of the curvature, the
//! usual way, is wrong where the curvature goes to zero, which is how every Euler bend begins.

use phidl_core::geom::Point;

use crate::curve::WIDEST_CHORD;

/// A curve that turns one way only (or not at all).
pub(crate) trait Turning {
    /// The parameter of its end; it starts at 0.
    fn span(&self) -> f64;

    /// The point at a parameter (µm).
    fn at(&self, t: f64) -> Point;

    /// The direction at a parameter (radians); monotone.
    fn heading(&self, t: f64) -> f64;
}

/// A chord that misses the tolerance by less than this part of it is long enough.
const SLACK: f64 = 1e-3;

/// The most steps in search of one chord.
const MOST_STEPS: usize = 60;

/// How often the range of tolerances is halved to even the chords out: the last one then differs by a few percent, the others by less.
const HALVINGS: usize = 10;

/// The most chords on one piece: a file holds fewer points in a thousand polygons.
pub(crate) const MOST_CHORDS: usize = 1 << 20;

/// The fewest points strictly between the ends of a curve that keep every chord within `tolerance` (µm, positive);
/// nothing if that takes more than [`MOST_CHORDS`].
pub(crate) fn between_ends(curve: &impl Turning, tolerance: f64) -> Option<Vec<Point>> {
    let knots = evened(curve, tolerance, longest(curve, tolerance)?);
    Some(knots.into_iter().map(|t| curve.at(t)).collect())
}

/// The inner vertices (parameters) of chords as long as the tolerance lets them be, one after the other;
/// nothing if there are more than [`MOST_CHORDS`].
fn longest(curve: &impl Turning, tolerance: f64) -> Option<Vec<f64>> {
    let span = curve.span();
    let mut knots = Vec::new();
    let (mut from, mut guess, mut before) = (0.0, span / 16.0, span / 16.0);
    while knots.len() < MOST_CHORDS {
        let step = longest_step(curve, from, guess, tolerance);
        if from + step >= span {
            return Some(knots);
        }
        // The next chord will have grown or shrunk about as much as this one.
        guess = step * (step / before).clamp(0.5, 2.0);
        (from, before) = (from + step, step);
        knots.push(from);
    }
    None
}

/// The same number of chords, made with the smallest tolerance for which it is enough.
fn evened(curve: &impl Turning, tolerance: f64, longest_ones: Vec<f64>) -> Vec<f64> {
    let number = longest_ones.len();
    // The error of a chord goes with the second to third power of its length: at this tolerance the chords are too many.
    let (mut few, mut many) = (tolerance, tolerance * (number as f64 / (number + 1) as f64).powi(3));
    let mut best = longest_ones;
    for _ in 0..HALVINGS {
        let middle = (few + many) / 2.0;
        match longest(curve, middle) {
            Some(knots) if knots.len() == number => (few, best) = (middle, knots),
            _ => many = middle,
        }
    }
    best
}

/// The length of the longest chord from a parameter on that keeps the tolerance, at most to the end.
fn longest_step(curve: &impl Turning, from: f64, guess: f64, tolerance: f64) -> f64 {
    let rest = curve.span() - from;
    let (mut good, mut bad) = (0.0, f64::INFINITY);
    let mut step = guess.min(rest);
    for _ in 0..MOST_STEPS {
        let load = load(curve, from, from + step, tolerance);
        if load > 1.0 {
            bad = step;
        } else if step >= rest {
            return rest;
        } else {
            good = step;
        }
        if (1.0 - SLACK..=1.0).contains(&load) {
            break;
        }
        // Errors go with the second power of the length, and with the third where the curvature begins at zero.
        let aimed = step * ((1.0 - SLACK / 2.0) / load).powf(0.47).min(4.0);
        let next = if aimed > good && aimed < bad { aimed } else { (good + bad) / 2.0 };
        step = next.min(rest);
    }
    // A curve that no step of any length follows (there is none of that kind) is cut no finer than this.
    good.max(curve.span() * 1e-9)
}

/// How much of what is allowed a chord uses up: of the tolerance or of the widest turn, whatever is more. Above 1 it is
/// too long.
fn load(curve: &impl Turning, from: f64, to: f64, tolerance: f64) -> f64 {
    let turned = (curve.heading(to) - curve.heading(from)).abs().to_degrees() / WIDEST_CHORD;
    // With more than half a turn the farthest point is not the only one that runs along the chord.
    let error = if turned <= 1.0 { deviation(curve, from, to) / tolerance } else { 0.0 };
    error.max(turned * turned)
}

/// The largest distance between a stretch of a curve and its chord (µm).
fn deviation(curve: &impl Turning, from: f64, to: f64) -> f64 {
    let (start, end) = (curve.at(from), curve.at(to));
    let chord = end - start;
    let length = chord.norm();
    if length == 0.0 {
        return 0.0;
    }
    // The curve is farthest from its chord where it runs along it.
    let side = |t: f64| {
        let (sin, cos) = curve.heading(t).sin_cos();
        chord.cross(Point::new(cos, sin))
    };
    chord.cross(curve.at(root(side, from, to)) - start).abs() / length
}

/// Where a function that changes its sign between two parameters is about zero: false position in the Illinois form
/// (M. Dowell and P. Jarratt, "A modified regula falsi method", BIT 11, 168–174, 1971).
fn root(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    /// Enough for three digits; the distance that is read off there has twice as many.
    const STEPS: usize = 5;
    let (mut a, mut b) = (from, to);
    let (mut fa, mut fb) = (f(a), f(b));
    let mut t = (a + b) / 2.0;
    for _ in 0..STEPS {
        if fa == fb {
            break;
        }
        t = b - fb * (b - a) / (fb - fa);
        let ft = f(t);
        if ft * fb < 0.0 {
            (a, fa) = (b, fb);
        } else {
            fa /= 2.0;
        }
        (b, fb) = (t, ft);
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Arm, Euler};
    use crate::{Path, Spiral};

    /// The farthest that any of many points of the curve is from its chord.
    fn worst(curve: &impl Turning, knots: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        for knots in knots.windows(2) {
            let (start, end) = (curve.at(knots[0]), curve.at(knots[1]));
            let chord = (end - start) / start.distance(end);
            for i in 0..=100 {
                let t = knots[0] + (knots[1] - knots[0]) * f64::from(i) / 100.0;
                worst = worst.max(chord.cross(curve.at(t) - start).abs());
            }
        }
        worst
    }

    /// The fewest chords by brute force: every chord reaches as far along a dense row of points as it may.
    fn fewest(curve: &impl Turning, tolerance: f64) -> usize {
        let rows = 8_000;
        let at = |i: usize| curve.span() * i as f64 / rows as f64;
        let (mut chords, mut from) = (0, 0);
        while from < rows {
            let (mut good, mut bad) = (from + 1, rows + 1);
            while good + 1 < bad {
                let middle = (good + bad) / 2;
                let turned = (curve.heading(at(middle)) - curve.heading(at(from))).abs().to_degrees();
                let fine = turned <= WIDEST_CHORD && worst(curve, &[at(from), at(middle)]) <= tolerance;
                if fine { good = middle } else { bad = middle }
            }
            (chords, from) = (chords + 1, good);
        }
        chords
    }

    fn check(curve: &impl Turning, tolerance: f64) {
        let long = longest(curve, tolerance).unwrap();
        let even = evened(curve, tolerance, long.clone());
        let best = fewest(curve, tolerance);
        for knots in [long, even] {
            let all = [&[0.0], &knots[..], &[curve.span()]].concat();
            let error = worst(curve, &all);
            assert!(error <= tolerance, "{error} µm with {} points for {tolerance} µm", knots.len());
            let ours = knots.len() + 1;
            assert!(ours as f64 <= 1.1 * best as f64, "{ours} chords where {best} do");
        }
    }

    #[test]
    fn euler_bends_keep_the_tolerance_with_hardly_more_chords_than_needed() {
        for (degrees, p) in [(90.0, 1.0), (-45.0, 0.5), (180.0, 0.2), (300.0, 1.0), (2.0, 0.7)] {
            let bend = Euler::new(10.0, degrees, p, false).unwrap();
            for tolerance in [1.0, 0.03, 1e-3, 1e-4] {
                check(&bend, tolerance);
            }
        }
    }

    #[test]
    fn arms_of_spirals_keep_the_tolerance_with_hardly_more_chords_than_needed() {
        let path = Spiral { num_turns: 4.0, gap: 3.0, inner_gap: 8.0, num_pts: 2000.0 }.path().unwrap();
        let arms: Vec<&Arm> = path.parts().iter().filter_map(|part| part.curve.arm()).collect();
        assert_eq!(arms.len(), 2);
        for tolerance in [0.3, 0.01, 5e-4] {
            arms.iter().for_each(|arm| check(*arm, tolerance));
        }
    }

    #[test]
    fn a_symmetric_bend_gets_symmetric_points() {
        let bend = Path::euler(10, 90).unwrap().with_tolerance(0.01).unwrap();
        // The mirror line is the perpendicular bisector of the chord from the origin to (e, e).
        let end = bend.end();
        let images = bend.points().iter().rev().map(|p| Point::new(end.x - p.y, end.y - p.x));
        for (p, image) in bend.points().iter().zip(images) {
            assert!(p.distance(image) < 0.01, "{p} {image}");
        }
    }
}
