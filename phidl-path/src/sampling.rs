//! Sampling by tolerance: the fewest points that keep every chord close to its curve.
//!
//! Greedy from the start, every chord is made as long as the tolerance allows; no other choice of points on the curve needs
//! fewer chords. Then the tolerance is lowered until the last chord is nearly as good as the others, and its remaining
//! slack is distributed over all chords: the number of chords is the same, their errors are even, and a symmetric bend
//! gets symmetric points. Spacing points by the root of the curvature, the common method, is wrong where the curvature goes
//! to zero, as at the start of every Euler bend.
//!
//! The length of a chord is estimated from the headings of the curve, which are cheap: an arc of the length L that turns
//! by a deviates from its chord by L a / 8. The curve differs from that by a few percent, and by nearly the same factor from
//! one chord to the next. So a chord is found in one or two trials, each of which is measured.

use std::f64::consts::TAU;

use phidl_core::geom::Point;

/// Largest turn along one chord (degrees), however large the tolerance is: a bend stays a bend.
pub(crate) const WIDEST_CHORD: f64 = 120.0;

/// A parametrized curve whose heading is monotone.
pub(crate) trait ParamCurve {
    /// The parameter of its end; it starts at 0.
    fn span(&self) -> f64;

    /// The point at a parameter (µm).
    fn at(&self, t: f64) -> Point;

    /// The direction at a parameter (radians); monotone.
    fn heading(&self, t: f64) -> f64;

    /// The speed: displacement per parameter (µm).
    fn speed(&self, t: f64) -> f64;

    /// The parameter between two others at which the direction is `heading` (radians).
    fn parameter_of(&self, heading: f64, from: f64, to: f64) -> f64 {
        root(|t| self.heading(t) - heading, from, to)
    }
}

/// A chord whose error is within this fraction of the tolerance is long enough.
const SLACK: f64 = 1e-3;

/// Maximum number of steps in the search for one chord.
const MOST_STEPS: usize = 60;

/// Error ratio of the last chord, compared with the others, at which it is about as long as they are.
const EVEN: f64 = 0.9;

/// Maximum number of tolerances tried to lengthen the last chord. One is nearly always enough.
const ROUNDS: usize = 6;

/// Maximum number of chords on one piece: a thousand polygons in a file have fewer points.
pub(crate) const MOST_CHORDS: usize = 1 << 20;

/// Chords of maximum length for some tolerance, one after the other.
struct Chords {
    /// The inner vertices (parameters).
    knots: Vec<f64>,
    /// The error ratio of the last chord.
    last: f64,
}

impl Chords {
    /// The fractional number of chords, if the last one counts in proportion to its length; approximate.
    fn amount(&self) -> f64 {
        self.knots.len() as f64 + self.last.sqrt()
    }
}

/// The fewest points strictly between the ends of a curve that keep every chord within `tolerance` (µm, positive);
/// `None` if that takes more than [`MOST_CHORDS`].
pub(crate) fn inner_points(curve: &impl ParamCurve, tolerance: f64) -> Option<Vec<Point>> {
    let knots = redistributed(curve, tolerance, equalized(curve, tolerance, longest(curve, tolerance)?));
    Some(knots.into_iter().map(|t| curve.at(t)).collect())
}

/// The longest chords that keep a tolerance; `None` if there are more than [`MOST_CHORDS`].
fn longest(curve: &impl ParamCurve, tolerance: f64) -> Option<Chords> {
    let span = curve.span();
    let mut knots = Vec::new();
    let mut search = ChordSearch { curve, tolerance, factor: 1.0, step: span / 16.0 };
    let mut from = 0.0;
    while knots.len() < MOST_CHORDS {
        let (step, error_ratio) = search.longest_step(from);
        if from + step >= span {
            return Some(Chords { knots, last: error_ratio });
        }
        from += step;
        knots.push(from);
    }
    None
}

/// The same number of chords for about the smallest tolerance that this number can keep.
fn equalized(curve: &impl ParamCurve, tolerance: f64, longest_ones: Chords) -> Chords {
    let number = longest_ones.knots.len();
    let wanted = (number + 1) as f64;
    // The error of a chord goes with the second to third power of its length: at this tolerance the chords are too many.
    let (mut few, mut many) = (tolerance, tolerance * (number as f64 / wanted).powi(3));
    let (mut at, mut amount) = (tolerance, longest_ones.amount());
    let mut best = longest_ones;
    for _ in 0..ROUNDS {
        if best.last >= EVEN {
            break;
        }
        // Slightly below the target: one chord more would be useless.
        let aimed = at * (amount / (wanted - 0.03)).powi(2);
        at = if aimed > many && aimed < few { aimed } else { (few + many) / 2.0 };
        let Some(chords) = longest(curve, at) else { break };
        amount = chords.amount();
        if chords.knots.len() == number {
            (few, best) = (at, chords);
        } else {
            many = at;
        }
    }
    best
}

/// The same chords with the slack of the last one distributed over all: each vertex moves back by its share of the
/// preceding chord. Unchanged if a chord would then miss the tolerance.
fn redistributed(curve: &impl ParamCurve, tolerance: f64, chords: Chords) -> Vec<f64> {
    let Chords { knots, last } = chords;
    let share = (1.0 - last.sqrt()) / (knots.len() + 1) as f64;
    let before = std::iter::once(&0.0).chain(&knots);
    let back = |(i, (t, before)): (usize, (&f64, &f64))| t - share * (i + 1) as f64 * (t - before);
    let moved: Vec<f64> = knots.iter().zip(before).enumerate().map(back).collect();
    let ends = || std::iter::once(0.0).chain(moved.iter().copied()).chain([curve.span()]);
    let mut search = ChordSearch { curve, tolerance, factor: 1.0, step: 0.0 };
    let sound = ends().zip(ends().skip(1)).all(|(from, to)| search.error_ratio(from, curve.at(from), to) <= 1.0);
    if sound { moved } else { knots }
}

/// The search for one chord after another.
struct ChordSearch<'a, C> {
    curve: &'a C,
    tolerance: f64,
    /// The deviation of the last chord divided by that of an arc of the same length and turn: nearly the same from chord to
    /// chord, so that the next one is found at the first trial.
    factor: f64,
    /// The length of the last chord (in the parameter).
    step: f64,
}

impl<C: ParamCurve> ChordSearch<'_, C> {
    /// The length of the longest chord from a parameter on that keeps the tolerance, at most to the end, and its error
    /// ratio.
    fn longest_step(&mut self, from: f64) -> (f64, f64) {
        let (rest, start) = (self.curve.span() - from, self.curve.at(from));
        let (mut good, mut bad) = ((0.0, 0.0), f64::INFINITY);
        let mut step = self.guess(from).min(rest);
        for _ in 0..MOST_STEPS {
            let error_ratio = self.error_ratio(from, start, from + step);
            if error_ratio > 1.0 {
                bad = step;
            } else if step >= rest {
                return (rest, error_ratio);
            } else {
                good = (step, error_ratio);
            }
            if (1.0 - SLACK..=1.0).contains(&error_ratio) {
                break;
            }
            // Errors go with the second power of the length, and with the third where the curvature begins at zero.
            let aimed = step * ((1.0 - SLACK / 2.0) / error_ratio).powf(0.47).min(4.0);
            let next = if aimed > good.0 && aimed < bad { aimed } else { (good.0 + bad.min(rest)) / 2.0 };
            step = next.min(rest);
        }
        // Minimum step, so that the loop terminates on degenerate input.
        self.step = good.0.max(self.curve.span() * 1e-9);
        (self.step, good.1)
    }

    /// An estimate of the longest chord, from the headings of the curve alone.
    fn guess(&self, from: f64) -> f64 {
        /// Enough for four digits, more than the factor has.
        const STEPS: usize = 8;
        const CLOSE: f64 = 1e-4;
        let allowed = (1.0 - SLACK / 2.0) * self.tolerance / self.factor;
        let mut step = self.step;
        for _ in 0..STEPS {
            let ratio = allowed / self.sagitta(from, from + step);
            // As a power between the square root, for arcs, and the cubic root, for the start of a clothoid: both
            // converge.
            step *= (0.58 + 0.42 * ratio).min(4.0);
            if (ratio - 1.0).abs() <= CLOSE {
                break;
            }
        }
        step
    }

    /// The sagitta of an arc with the length and the turn of a stretch of the curve (µm).
    fn sagitta(&self, from: f64, to: f64) -> f64 {
        let turned = (self.curve.heading(to.min(self.curve.span())) - self.curve.heading(from)).abs();
        self.curve.speed(from) * (to - from) * turned / 8.0
    }

    /// The error ratio of a chord: its share of the tolerance, or of the widest turn, whichever is larger. Above 1 the
    /// chord is too long.
    fn error_ratio(&mut self, from: f64, start: Point, to: f64) -> f64 {
        let turned = (self.curve.heading(to) - self.curve.heading(from)).abs().to_degrees() / WIDEST_CHORD;
        // With more than half a turn the farthest point is not the only one that runs along the chord.
        if turned > 1.0 {
            return turned * turned;
        }
        let deviation = deviation(self.curve, (from, start), to);
        let sagitta = self.sagitta(from, to);
        if sagitta > 0.0 && deviation > 0.0 {
            self.factor = deviation / sagitta;
        }
        (deviation / self.tolerance).max(turned * turned)
    }
}

/// The largest distance between a stretch of a curve and its chord (µm).
fn deviation(curve: &impl ParamCurve, (from, start): (f64, Point), to: f64) -> f64 {
    let chord = curve.at(to) - start;
    let length = chord.norm();
    if length == 0.0 {
        return 0.0;
    }
    // The curve is farthest from its chord where it runs along it. The chord turns less than half a turn.
    let direction = chord.y.atan2(chord.x);
    let heading = direction + TAU * ((curve.heading(from) - direction) / TAU).round();
    chord.cross(curve.at(curve.parameter_of(heading, from, to)) - start).abs() / length
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
pub(crate) mod tests {
    use super::*;
    use crate::curve::{Arm, Euler};
    use crate::{Path, Spiral};

    /// The farthest that any of many points of the curve is from its chord.
    pub(crate) fn worst(curve: &impl ParamCurve, knots: &[f64]) -> f64 {
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
    pub(crate) fn fewest(curve: &impl ParamCurve, tolerance: f64) -> usize {
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

    fn check(curve: &impl ParamCurve, tolerance: f64) {
        let long = longest(curve, tolerance).unwrap();
        let even = redistributed(curve, tolerance, equalized(curve, tolerance, longest(curve, tolerance).unwrap()));
        let best = fewest(curve, tolerance);
        for knots in [long.knots, even] {
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
        let arms: Vec<&Arm> = path.segments().iter().filter_map(|segment| segment.curve.arm()).collect();
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
