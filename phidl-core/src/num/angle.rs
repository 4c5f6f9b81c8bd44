//! Angles in degrees, exact where a mask needs them to be.
//!
//! Angles stay in degrees everywhere and are turned into a sine and a cosine only here, so that a
//! multiple of 90° never leaves a remainder like `6e-17` on an axis. No tolerance is applied:
//! 89.999° is not a quarter turn.
//!
//! Angles that are binary fractions of a degree (30, 22.5, 0.125) add up exactly, so four quarter turns of anything at
//! such an angle are the identity to the last bit; other angles keep all but their last bit.

use crate::geom::Point;

/// Brings an angle into `[0, 360)`; a NaN or an infinity becomes NaN.
///
/// ```
/// # use phidl_core::num::angle::normalized;
/// assert_eq!(normalized(-90.0), 270.0);
/// assert_eq!(normalized(725.5), 5.5);
/// ```
#[must_use]
pub fn normalized(degrees: f64) -> f64 {
    let turned = match degrees {
        0.0..360.0 => degrees,
        360.0..720.0 => degrees - 360.0, // exact
        _ => degrees.rem_euclid(360.0),
    };
    // A tiny negative angle rounds up to a full turn.
    if turned >= 360.0 { 0.0 } else { turned }
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90°.
///
/// ```
/// # use phidl_core::num::angle::sin_cos;
/// assert_eq!(sin_cos(-270.0), (1.0, 0.0));
/// ```
#[must_use]
#[inline]
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    sin_cos_in_reach(if in_reach(degrees) { degrees } else { normalized(degrees) })
}

/// The vectors of length 1 in some directions (degrees), as [`sin_cos`] gives them. Several at a time: a curve costs half
/// of what it costs point by point.
///
/// ```
/// # use phidl_core::num::angle::directions;
/// # use phidl_core::geom::Point;
/// assert_eq!(directions([0.0, 90.0]), [Point::new(1.0, 0.0), Point::new(0.0, 1.0)]);
/// ```
#[must_use]
pub fn directions(degrees: impl IntoIterator<Item = f64>) -> Vec<Point> {
    // Loops of their own, without a branch in them, so that the compiler can put neighbors into one register.
    let mut directions: Vec<Point> = degrees.into_iter().map(|angle| Point::new(angle, 0.0)).collect();
    if !directions.iter().fold(true, |all, direction| all & in_reach(direction.x)) {
        let far = directions.iter_mut().filter(|direction| !in_reach(direction.x));
        far.for_each(|direction| direction.x = normalized(direction.x));
    }
    for direction in &mut directions {
        let (sin, cos) = sin_cos_in_reach(direction.x);
        *direction = Point::new(cos, sin);
    }
    directions
}

/// Whether the number of quarter turns is exact. No mask turns more often.
#[inline]
fn in_reach(degrees: f64) -> bool {
    degrees.abs() <= 1e12
}

/// Sine and cosine of an angle [in reach](in_reach).
#[inline]
fn sin_cos_in_reach(degrees: f64) -> (f64, f64) {
    /// Adding it leaves no room for a fraction, so it rounds; the quarter turn is in the last two bits.
    const ROUND: f64 = 1.5 * (1_u64 << 52) as f64;
    let rounded = degrees * (1.0 / 90.0) + ROUND;
    // Exact: both are multiples of the last bit of the angle, and the difference is no larger than the angle.
    let rest = degrees - 90.0 * (rounded - ROUND);
    let (sin, cos) = sin_cos_of_an_eighth(rest.to_radians());
    // (sin, cos), (cos, -sin), (-sin, -cos), (-cos, sin): by bits, since branches would depend on the data.
    let quarter = rounded.to_bits();
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    let exchanged = (sin ^ cos) & (quarter & 1).wrapping_neg();
    let sin = sin ^ exchanged ^ ((quarter & 2) << 62);
    let cos = cos ^ exchanged ^ ((quarter.wrapping_add(1) & 2) << 62);
    // Adding gives a zero that is positive.
    (f64::from_bits(sin) + 0.0, f64::from_bits(cos) + 0.0)
}

/// Sine and cosine of an angle within ±π/4 to the last bit or the one before: the Taylor series, broken off where the next term
/// is below a hundredth of the last bit. Curves are made of calls of this function; the ones of the system, which have
/// to reduce any angle in radians, take five times as long.
#[inline]
fn sin_cos_of_an_eighth(x: f64) -> (f64, f64) {
    const SIN: [f64; 8] = [
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5_040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
        -1.0 / 1_307_674_368_000.0,
        1.0 / 355_687_428_096_000.0,
    ];
    const COS: [f64; 8] = [
        1.0 / 24.0,
        -1.0 / 720.0,
        1.0 / 40_320.0,
        -1.0 / 3_628_800.0,
        1.0 / 479_001_600.0,
        -1.0 / 87_178_291_200.0,
        1.0 / 20_922_789_888_000.0,
        -1.0 / 6_402_373_705_728_000.0,
    ];
    let square = x * x;
    let (fourth, eighth) = (square * square, (square * square) * (square * square));
    // In pairs (G. Estrin's scheme), which do not wait for one another.
    let pair = |terms: &[f64; 8], i: usize| terms[i] + terms[i + 1] * square;
    let series = |t: &[f64; 8]| (pair(t, 0) + pair(t, 2) * fourth) + (pair(t, 4) + pair(t, 6) * fourth) * eighth;
    (x + x * (square * series(&SIN)), 1.0 - (0.5 * square - square * (square * series(&COS))))
}

/// How many quarter turns (0 to 3) an angle is, if it is a whole number of them.
#[must_use]
pub fn quarter_turns(degrees: f64) -> Option<u8> {
    match normalized(degrees) {
        0.0 => Some(0),
        90.0 => Some(1),
        180.0 => Some(2),
        270.0 => Some(3),
        _ => None,
    }
}

/// Direction of the vector (`x`, `y`) in degrees, in `[0, 360)`; exact along the axes and the diagonals.
#[must_use]
pub fn direction(x: f64, y: f64) -> f64 {
    normalized(y.atan2(x).to_degrees())
}

/// The smallest turn between two directions, in `[0, 180]`.
#[must_use]
pub fn between(a: f64, b: f64) -> f64 {
    let turn = normalized(a - b);
    turn.min(360.0 - turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact_and_their_neighbors_are_not_rounded() {
        assert_eq!(sin_cos(90.0), (1.0, 0.0));
        assert_eq!(sin_cos(-180.0), (0.0, -1.0));
        assert_eq!(sin_cos(3600.0 + 270.0), (-1.0, 0.0));
        assert_ne!(sin_cos(89.999_999).1, 0.0);
    }

    #[test]
    fn a_tiny_negative_angle_is_zero_and_not_a_full_turn() {
        assert_eq!(normalized(-1e-300), 0.0);
        assert!(normalized(-1e-12) < 360.0);
    }

    #[test]
    fn axes_and_diagonals_have_exact_directions() {
        assert_eq!(direction(0.0, -2.0), 270.0);
        assert_eq!(direction(3.0, 3.0), 45.0);
        assert_eq!(direction(-1.0, 1.0), 135.0);
    }

    #[test]
    fn what_is_not_finite_stays_visible() {
        assert!(normalized(f64::INFINITY).is_nan());
        assert!(sin_cos(f64::NAN).0.is_nan());
    }

    #[test]
    fn sines_and_cosines_are_those_of_the_system_to_the_last_bits() {
        for i in -4_000..=4_000 {
            let degrees = f64::from(i) * 0.1237;
            let (sin, cos) = sin_cos(degrees);
            let (due_sin, due_cos) = degrees.to_radians().sin_cos();
            // Turning ten times around in radians costs the system's a bit more.
            assert!((sin - due_sin).abs() < 1e-15 && (cos - due_cos).abs() < 1e-15, "{degrees}");
            if degrees.abs() <= 45.0 {
                assert!((sin - due_sin).abs() <= 1.2e-16 && (cos - due_cos).abs() <= 2.3e-16, "{degrees}");
            }
        }
    }

    #[test]
    fn angles_a_quarter_turn_apart_have_the_same_digits() {
        for degrees in [0.125, 30.0, 44.5, 45.0] {
            let (sin, cos) = sin_cos(degrees);
            for turns in [-1e6, -1.0, 1.0, 2.0, 1e9] {
                assert_eq!(sin_cos(degrees + 360.0 * turns), (sin, cos), "{degrees} {turns}");
            }
            assert_eq!(sin_cos(degrees + 180.0), (-sin, -cos));
        }
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
        assert_eq!(sin_cos(360e14), (0.0, 1.0));
    }

    #[test]
    fn many_directions_have_the_bits_of_each_and_no_zero_is_negative() {
        let degrees = || (-2_000..=2_000).map(|i| f64::from(i) * 0.5).chain([1e13, 0.1, 1.0 / 3.0, f64::NAN, -0.0]);
        for (angle, direction) in degrees().zip(directions(degrees())) {
            let (sin, cos) = sin_cos(angle);
            assert_eq!((direction.x.to_bits(), direction.y.to_bits()), (cos.to_bits(), sin.to_bits()), "{angle}");
            assert!([sin, cos].iter().all(|v| *v != 0.0 || v.is_sign_positive()), "{angle}");
        }
    }
}
