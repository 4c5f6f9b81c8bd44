//! The fewest chords of an Euler bend, without a search.
//!
//! On a chord of the length h over which the curvature goes from k to k', a gently bent curve leaves its chord by the
//! maximum over u of ½ (h²/4 − u²) (k̄ + (k' − k) u / 3h), with k̄ the mean of both and u measured from the middle. Made as
//! long as a tolerance τ lets them be, the chords of a clothoid then end at lengths τ^⅓ σ₁, τ^⅓ σ₂, …, the same numbers for
//! every clothoid; on an arc they are all alike. So the number of chords is known at once, and so is the tolerance with
//! which that number comes out whole: all chords are then equally good, and both halves are alike.
//!
//! What is neglected (how much a chord turns; the corner of the curvature between clothoid and arc, and in the middle)
//! goes with the square of a chord's share in the bend. Every chord is measured in the end, and bends of few chords are
//! left to the [search](crate::sampling), which also finds fewer there.

use phidl_core::geom::Point;
use phidl_core::num::count;

use super::euler::Euler;
use crate::sampling::{MOST_CHORDS, Turning as _};

/// With fewer chords than this they are searched for.
const FEW: usize = 24;

/// How often a chord more is tried when one of them misses the tolerance.
const TRIES: usize = 2;

/// Part of the tolerance that is kept back for what is neglected.
const SLACK: f64 = 2e-3;

/// σ of a number of chords is ((k − AHEAD + BEND / k) / PACE)^⅔, to four digits from the first chord on. The pace is that
/// of chords on an arc of the curvature σ; the other two are the limit and the next term of what is found chord by chord
/// (a test does).
const PACE: f64 = std::f64::consts::SQRT_2 / 6.0;
const AHEAD: f64 = 0.075_73;
const BEND: f64 = 0.006_3;

/// The points between the ends of a bend, in its own unit and turning left, that keep every chord within a tolerance;
/// nothing if they are better searched for.
pub(super) fn between_ends(bend: &Euler, tolerance: f64) -> Option<Vec<Point>> {
    let aimed = tolerance * (1.0 - SLACK);
    let least = Chords::amount(bend, aimed);
    if !(FEW as f64..MOST_CHORDS as f64).contains(&least) {
        return None;
    }
    let fewest = count::up(least);
    (fewest..=fewest + TRIES).find_map(|number| Chords::of(bend, number).points(bend, tolerance))
}

/// Where a number of chords end.
struct Chords {
    number: usize,
    /// Lengths from the start, up to the middle.
    ends: Vec<f64>,
}

impl Chords {
    /// How many chords a tolerance calls for; a whole number only by accident.
    fn amount(bend: &Euler, tolerance: f64) -> f64 {
        Self::work(bend) / tolerance.sqrt() + 2.0 * ahead(Self::on_clothoid(bend) / tolerance.sqrt())
    }

    /// What is to be divided by the root of the tolerance.
    fn work(bend: &Euler) -> f64 {
        2.0 * (Self::on_clothoid(bend) + bend.arc_length() / 2.0 * (bend.clothoid_length() / 8.0).sqrt())
    }

    fn on_clothoid(bend: &Euler) -> f64 {
        PACE * bend.clothoid_length().powf(1.5)
    }

    fn of(bend: &Euler, number: usize) -> Self {
        // The root of the tolerance with which this number comes out. It takes the number of chords on the clothoid, which
        // takes the root: a second round makes no difference any more.
        let mut root = Self::work(bend) / (number as f64 - 2.0 * AHEAD);
        for _ in 0..2 {
            root = Self::work(bend) / (number as f64 - 2.0 * ahead(Self::on_clothoid(bend) / root));
        }
        let on_clothoid = Self::on_clothoid(bend) / root;
        let on_clothoid = on_clothoid + ahead(on_clothoid);
        let (unit, arc) = (root.powi(2).cbrt(), root * (8.0 / bend.clothoid_length()).sqrt());
        let end = |i: usize| match i as f64 {
            0.0 => 0.0,
            k if k <= on_clothoid => unit * ((k - ahead(k)) / PACE).powi(2).cbrt(),
            k => bend.clothoid_length() + (k - on_clothoid) * arc,
        };
        let middle = bend.span() / 2.0;
        let mut ends: Vec<f64> = (0..number.div_ceil(2)).map(|i| end(i).min(middle)).collect();
        if number.is_multiple_of(2) {
            ends.push(middle);
        }
        Self { number, ends }
    }

    /// The points at the ends, those of the whole bend excepted, unless a chord misses the tolerance.
    fn points(&self, bend: &Euler, tolerance: f64) -> Option<Vec<Point>> {
        let first = bend.first_half_at(&self.ends);
        // Where there is an end in the middle, it is its own image.
        let with_image = if self.number.is_multiple_of(2) { &first[1..first.len() - 1] } else { &first[1..] };
        let second = with_image.iter().rev().map(|p| bend.mirrored(*p));
        let points: Vec<Point> = first[1..].iter().copied().chain(second).collect();
        self.keep(bend, &first, &points, tolerance).then_some(points)
    }

    /// Whether the chords up to the middle and the one across it keep the tolerance.
    fn keep(&self, bend: &Euler, first: &[Point], points: &[Point], tolerance: f64) -> bool {
        let apart: Vec<f64> = self.ends.windows(2).map(|ends| farthest_between(bend, ends[0], ends[1])).collect();
        let between = bend.first_half_at(&apart);
        let chords = first.windows(2).zip(between).map(|(ends, p)| (ends[0], ends[1], p));
        let before_middle = first.len() - 2;
        let across = (points[before_middle], points[before_middle + 1], bend.middle());
        let is_across = !self.number.is_multiple_of(2);
        let deviation = |(from, to, p): (Point, Point, Point)| (to - from).cross(p - from).abs() / from.distance(to);
        chords.chain(is_across.then_some(across)).all(|chord| deviation(chord) <= tolerance)
    }
}

/// By how much a clothoid is ahead of the pace of arcs, in chords, after a number of them.
fn ahead(chords: f64) -> f64 {
    AHEAD - BEND / chords
}

/// Where the bend is farthest from a chord between two lengths from its start, both in its first half.
fn farthest_between(bend: &Euler, from: f64, to: f64) -> f64 {
    let [k, next] = [from, to].map(|s| s.min(bend.clothoid_length()));
    let (mean, rise, h) = ((k + next) / 2.0, next - k, to - from);
    (from + to) / 2.0 + h * rise / 12.0 / (mean + (mean * mean + rise * rise / 12.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::tests::{fewest, worst};

    #[test]
    fn chords_that_were_not_searched_for_keep_the_tolerance_and_are_hardly_more_than_needed() {
        for (degrees, p) in [(90.0, 1.0), (-45.0, 0.5), (180.0, 0.2), (300.0, 1.0), (90.0, 0.03), (1440.0, 0.9)] {
            let bend = Euler::new(10.0, degrees, p, false).unwrap();
            for tolerance in [4e-3, 7e-4, 1e-4] {
                let Some(points) = between_ends(&bend, tolerance / bend.scale()) else { continue };
                let ours = points.len() + 1;
                let best = fewest(&bend, tolerance);
                assert!(ours as f64 <= 1.1 * best as f64, "{ours} chords where {best} do");
                let first = Chords::of(&bend, ours).ends;
                let second = first.iter().rev().map(|s| bend.span() - s).skip(usize::from(ours.is_multiple_of(2)));
                let knots: Vec<f64> = first.iter().copied().chain(second).collect();
                assert_eq!(knots.len(), ours + 1);
                let error = worst(&bend, &knots);
                assert!(error <= tolerance, "{error} µm with {ours} chords for {tolerance} µm");
            }
        }
    }

    #[test]
    fn a_fine_bend_is_not_searched_for() {
        for (degrees, p) in [(90.0, 1.0), (-45.0, 0.5), (180.0, 0.2), (90.0, 0.03)] {
            for radius in [3.0, 5.0, 12.9, 100.0, 1e4] {
                let bend = Euler::new(radius, degrees, p, false).unwrap();
                assert!(between_ends(&bend, 2e-4 / bend.scale()).is_some(), "{radius} {degrees} {p}");
            }
        }
    }

    /// How far a clothoid leaves its chord from a length on, in the approximation of the module.
    fn sagitta(from: f64, h: f64) -> f64 {
        let mean = from + h / 2.0;
        let u = h * h / 12.0 / (mean + (mean * mean + h * h / 12.0).sqrt());
        0.5 * (h * h / 4.0 - u * u) * (mean + u / 3.0)
    }

    #[test]
    fn the_ends_of_the_longest_chords_of_a_clothoid_are_known() {
        let mut sigma = 0.0;
        for k in 1..=200 {
            let (mut short, mut long) = (0.0, 10.0);
            for _ in 0..60 {
                let h = (short + long) / 2.0;
                if sagitta(sigma, h) > 1.0 { long = h } else { short = h }
            }
            sigma += short;
            let k = f64::from(k);
            assert!((PACE * sigma.powf(1.5) + ahead(k) - k).abs() < 1e-4, "{k}");
        }
        assert!((sigma - 90.0).abs() < 1.0, "{sigma}");
    }
}
