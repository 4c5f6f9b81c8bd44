//! The fewest chords of an Euler bend, without a search.
//!
//! On a chord of the length h over which the curvature goes from k to k', a gently curved line deviates from its chord by the
//! maximum over u of ½ (h²/4 − u²) (k̄ + (k' − k) u / 3h), where k̄ is the mean of both and u is measured from the middle.
//! Chords of maximum length for a tolerance τ then end at the lengths τ^⅓ σ₁, τ^⅓ σ₂, …, with the same σ for every clothoid;
//! on an arc all chords are equal. So the number of chords is known at once, and so is the tolerance for which that number
//! is whole: all chords then have the same error, and both halves are symmetric.
//!
//! The neglected terms (the turn along a chord, the corner of the curvature between clothoid and arc, and in the middle) go
//! with the square of a chord's share of the bend. Every chord is measured in the end, and bends with few chords are left to
//! the [search](crate::sampling), which needs fewer there.
//!
//! It stays because of a figure: 1,000 extruded Euler bends within 1 nm take 2.7 ms, against 3.7 ms for gdstk's FlexPath
//! arcs; with the search alone they would be slower than those.

use phidl_core::geom::Point;
use phidl_core::num::count;

use super::euler::Euler;
use crate::sampling::{MOST_CHORDS, ParamCurve as _};

/// Bends with fewer chords than this are left to the search.
const FEW: usize = 24;

/// Number of further chords that are tried when a chord misses the tolerance.
const TRIES: usize = 2;

/// Fraction of the tolerance reserved for the neglected terms.
const SLACK: f64 = 2e-3;

/// σ of k chords is ((k − LEAD + BEND / k) / RATE)^⅔, to four digits from the first chord on. RATE is that of chords on an
/// arc of the curvature σ. The other two constants are the limit and the next term of a chord-by-chord computation, which a
/// test repeats.
const RATE: f64 = std::f64::consts::SQRT_2 / 6.0;
const LEAD: f64 = 0.075_73;
const BEND: f64 = 0.006_3;

/// The points between the ends of a bend that keep every chord within a tolerance (µm); `None` if the search is better.
pub(super) fn inner_points(bend: &Euler, tolerance: f64) -> Option<Vec<Point>> {
    let own = in_own_unit(bend, tolerance / bend.scale())?;
    Some(own.into_iter().map(|p| bend.in_micrometers(p)).collect())
}

/// The same in the unit of the bend, turning left.
fn in_own_unit(bend: &Euler, tolerance: f64) -> Option<Vec<Point>> {
    let aimed = tolerance * (1.0 - SLACK);
    let least = Chords::amount(bend, aimed);
    if !(FEW as f64..MOST_CHORDS as f64).contains(&least) {
        return None;
    }
    let fewest = count::up(least);
    (fewest..=fewest + TRIES).find_map(|number| Chords::of(bend, number).points(bend, tolerance))
}

/// The ends of a number of chords.
struct Chords {
    number: usize,
    /// Lengths from the start, up to the middle.
    ends: Vec<f64>,
}

impl Chords {
    /// The fractional number of chords for a tolerance.
    fn amount(bend: &Euler, tolerance: f64) -> f64 {
        Self::work(bend) / tolerance.sqrt() + 2.0 * lead(Self::on_clothoid(bend) / tolerance.sqrt())
    }

    /// The number of chords times the root of the tolerance, without the lead.
    fn work(bend: &Euler) -> f64 {
        2.0 * (Self::on_clothoid(bend) + bend.arc_length() / 2.0 * (bend.clothoid_length() / 8.0).sqrt())
    }

    fn on_clothoid(bend: &Euler) -> f64 {
        RATE * bend.clothoid_length().powf(1.5)
    }

    fn of(bend: &Euler, number: usize) -> Self {
        // The root of the tolerance for this number. It depends on the number of chords on the clothoid, which depends on
        // the root; two iterations suffice.
        let mut root = Self::work(bend) / (number as f64 - 2.0 * LEAD);
        for _ in 0..2 {
            root = Self::work(bend) / (number as f64 - 2.0 * lead(Self::on_clothoid(bend) / root));
        }
        let on_clothoid = Self::on_clothoid(bend) / root;
        let on_clothoid = on_clothoid + lead(on_clothoid);
        let (unit, arc) = (root.powi(2).cbrt(), root * (8.0 / bend.clothoid_length()).sqrt());
        let end = |i: usize| match i as f64 {
            0.0 => 0.0,
            k if k <= on_clothoid => unit * ((k - lead(k)) / RATE).powi(2).cbrt(),
            k => bend.clothoid_length() + (k - on_clothoid) * arc,
        };
        let middle = bend.span() / 2.0;
        let mut ends: Vec<f64> = (0..number.div_ceil(2)).map(|i| end(i).min(middle)).collect();
        if number.is_multiple_of(2) {
            ends.push(middle);
        }
        Self { number, ends }
    }

    /// The points at the ends of the chords, except those of the bend; `None` if a chord misses the tolerance.
    fn points(&self, bend: &Euler, tolerance: f64) -> Option<Vec<Point>> {
        let first = bend.first_half_at(&self.ends);
        // An end in the middle is its own image.
        let with_image = if self.number.is_multiple_of(2) { &first[1..first.len() - 1] } else { &first[1..] };
        let second = with_image.iter().rev().map(|p| bend.mirrored(*p));
        let points: Vec<Point> = first[1..].iter().copied().chain(second).collect();
        self.keep(bend, &first, &points, tolerance).then_some(points)
    }

    /// Whether the chords up to the middle and the one across it keep the tolerance.
    fn keep(&self, bend: &Euler, first: &[Point], points: &[Point], tolerance: f64) -> bool {
        let farthest: Vec<f64> = self.ends.windows(2).map(|ends| farthest_between(bend, ends[0], ends[1])).collect();
        let between = bend.first_half_at(&farthest);
        let chords = first.windows(2).zip(between).map(|(ends, p)| (ends[0], ends[1], p));
        let before_middle = first.len() - 2;
        let across = (points[before_middle], points[before_middle + 1], bend.middle());
        let is_across = !self.number.is_multiple_of(2);
        let deviation = |(from, to, p): (Point, Point, Point)| (to - from).cross(p - from).abs() / from.distance(to);
        chords.chain(is_across.then_some(across)).all(|chord| deviation(chord) <= tolerance)
    }
}

/// The lead of a clothoid over the rate of arcs, in chords, after a number of them.
fn lead(chords: f64) -> f64 {
    LEAD - BEND / chords
}

/// The length at which the bend is farthest from a chord between two lengths in its first half.
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
    fn chords_keep_the_tolerance_with_at_most_a_tenth_more_than_needed() {
        for (degrees, p) in [(90.0, 1.0), (-45.0, 0.5), (180.0, 0.2), (300.0, 1.0), (90.0, 0.03), (1440.0, 0.9)] {
            let bend = Euler::new(10.0, degrees, p, false).unwrap();
            for tolerance in [4e-3, 7e-4, 1e-4] {
                let Some(points) = in_own_unit(&bend, tolerance / bend.scale()) else { continue };
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
    fn a_fine_bend_needs_no_search() {
        for (degrees, p) in [(90.0, 1.0), (-45.0, 0.5), (180.0, 0.2), (90.0, 0.03)] {
            for radius in [3.0, 5.0, 12.9, 100.0, 1e4] {
                let bend = Euler::new(radius, degrees, p, false).unwrap();
                assert!(in_own_unit(&bend, 2e-4 / bend.scale()).is_some(), "{radius} {degrees} {p}");
            }
        }
    }

    /// The deviation of a clothoid from a chord that begins at a length, in the approximation of the module.
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
            assert!((RATE * sigma.powf(1.5) + lead(k) - k).abs() < 1e-4, "{k}");
        }
        assert!((sigma - 90.0).abs() < 1.0, "{sigma}");
    }
}
