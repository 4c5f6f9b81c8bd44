//! Numbers of points on curves, with PHIDL's rounding rules.
//!
//! Every count is limited to [`MOST`], so that a tiny angle or tolerance leads to an error instead of exhausting memory.

/// The largest count that these functions return.
pub const MOST: usize = 1 << 24;

/// Number of chords of a full turn when neighboring points are at most `resolution` degrees apart: rounded up.
#[must_use]
pub fn per_turn(resolution: f64) -> usize {
    up(360.0 / resolution)
}

/// Number of chords of a full turn, rounded to the nearest whole number (halves to even), as rings count them.
#[must_use]
pub fn per_turn_nearest(resolution: f64) -> usize {
    whole((360.0 / resolution).round_ties_even())
}

/// The smallest whole number that is not less than `amount`; negative amounts and NaN give zero.
#[must_use]
pub fn up(amount: f64) -> usize {
    whole(amount.ceil())
}

/// The nearest whole number, halves to even; negative amounts and NaN give zero.
#[must_use]
pub fn nearest(amount: f64) -> usize {
    whole(amount.round_ties_even())
}

/// Number of chords that keep every chord of an arc within `tolerance` of it, both lengths in µm and positive.
///
/// A chord over the angle `a` leaves a circle of radius `r` by `2 r sin²(a/4)`, so `a = 4 asin √(tolerance / 2r)`.
/// This form keeps its digits for tiny ratios, where `2 acos(1 - tolerance / r)` loses them. Closed outlines ask for at least three.
#[must_use]
pub fn for_tolerance(radius: f64, sweep_deg: f64, tolerance: f64) -> usize {
    let widest = 4.0 * (tolerance / (2.0 * radius)).min(1.0).sqrt().asin();
    up(sweep_deg.abs() / widest.to_degrees()).max(1)
}

/// `count` evenly spaced values from `from` to `to`, both included; one value is `from`.
pub fn linspace(from: f64, to: f64, count: usize) -> impl DoubleEndedIterator<Item = f64> + ExactSizeIterator + Clone {
    let last = count.saturating_sub(1).max(1);
    (0..count).map(move |i| if i > 0 && i == last { to } else { from + (to - from) * (i as f64 / last as f64) })
}

fn whole(amount: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "`as` saturates, and the value is limited on both sides"
    )]
    let count = amount.clamp(0.0, MOST as f64) as usize;
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_round_up_and_rings_round_to_nearest() {
        assert_eq!((per_turn(7.0), per_turn_nearest(7.0)), (52, 51));
        assert_eq!((per_turn(2.5), per_turn_nearest(2.5)), (144, 144));
    }

    #[test]
    fn halves_go_to_even() {
        assert_eq!((nearest(2.5), nearest(3.5)), (2, 4));
    }

    #[test]
    fn invalid_amounts_are_limited() {
        assert_eq!(up(f64::INFINITY), MOST);
        assert_eq!(up(f64::NAN), 0);
        assert_eq!(up(-3.0), 0);
    }

    #[test]
    fn chords_of_a_tolerance_keep_it_and_one_fewer_does_not() {
        let sagitta = |chords: usize| 10.0 * (1.0 - (std::f64::consts::PI / chords as f64).cos());
        let chords = for_tolerance(10.0, 360.0, 0.001);
        assert!(sagitta(chords) <= 0.001 && sagitta(chords - 1) > 0.001);
    }

    #[test]
    fn linspace_hits_both_ends() {
        let values: Vec<f64> = linspace(0.1, 0.7, 4).collect();
        assert_eq!((values[0], values[3], values.len()), (0.1, 0.7, 4));
        assert_eq!(linspace(3.0, 9.0, 1).collect::<Vec<_>>(), [3.0]);
        assert_eq!(linspace(3.0, 9.0, 0).count(), 0);
    }
}
