//! Angles in degrees, exact where a mask needs them to be.
//!
//! Angles stay in degrees everywhere and are turned into a sine and a cosine only here, so that a
//! multiple of 90° never leaves a remainder like `6e-17` on an axis. No tolerance is applied:
//! 89.999° is not a quarter turn.
//!
//! Angles that are binary fractions of a degree (30, 22.5, 0.125) add up exactly, so four quarter turns of anything at
//! such an angle are the identity to the last bit; other angles keep all but their last bit.

/// Brings an angle into `[0, 360)`; a NaN or an infinity becomes NaN.
///
/// ```
/// # use phidl_core::num::angle::normalized;
/// assert_eq!(normalized(-90.0), 270.0);
/// assert_eq!(normalized(725.5), 5.5);
/// ```
#[must_use]
pub fn normalized(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(360.0);
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
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    match quarter_turns(degrees) {
        Some(0) => (0.0, 1.0),
        Some(1) => (1.0, 0.0),
        Some(2) => (0.0, -1.0),
        Some(_) => (-1.0, 0.0),
        None => degrees.to_radians().sin_cos(),
    }
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
}
