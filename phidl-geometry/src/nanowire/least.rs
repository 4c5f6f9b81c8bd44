//! [`least`]: where a function of one variable is smallest.
//!
//! Golden sections with parabolic steps, after R. P. Brent, "Algorithms for minimization without derivatives" (1973). A
//! crate would find the same minimum by other steps; but the edge of [`optimal_step`](super::optimal_step) is defined by
//! where exactly this search stops, and masks drawn with PHIDL lie on it.

/// The smaller part of a golden section.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
/// Square root of the smallest relative difference that counts.
const SQRT_EPS: f64 = 1.483_239_697_419_132_6e-8;
/// Searches end here at the latest.
const MOST_EVALUATIONS: usize = 500;

/// A position and the value of the function there.
#[derive(Clone, Copy)]
struct Sample {
    at: f64,
    value: f64,
}

/// The minimum of `f` between `low` and `high`, to an absolute `tolerance`; of several, one of them.
pub(super) fn least(f: impl Fn(f64) -> f64, low: f64, high: f64, tolerance: f64) -> f64 {
    let sample = |at: f64| Sample { at, value: f(at) };
    let (mut low, mut high) = (low, high);
    let mut best = sample(low + GOLDEN * (high - low));
    let (mut second, mut third) = (best, best);
    let (mut step, mut step_before) = (0.0_f64, 0.0_f64);
    for _ in 1..MOST_EVALUATIONS {
        let middle = (low + high) / 2.0;
        let near = SQRT_EPS * best.at.abs() + tolerance / 3.0;
        if (best.at - middle).abs() <= 2.0 * near - (high - low) / 2.0 {
            break;
        }
        let parabola =
            (step_before.abs() > near).then(|| parabolic_step(best, second, third, step_before, (low, high))).flatten();
        if let Some(to_vertex) = parabola {
            step_before = step;
            let at = best.at + to_vertex;
            let at_the_edge = at - low < 2.0 * near || high - at < 2.0 * near;
            step = if at_the_edge { near.copysign(sign(middle - best.at)) } else { to_vertex };
        } else {
            step_before = if best.at >= middle { low - best.at } else { high - best.at };
            step = GOLDEN * step_before;
        }
        let new = sample(best.at + sign(step) * step.abs().max(near));
        if new.value <= best.value {
            if new.at >= best.at {
                low = best.at
            } else {
                high = best.at
            }
            (third, second, best) = (second, best, new);
        } else {
            if new.at < best.at {
                low = new.at
            } else {
                high = new.at
            }
            if new.value <= second.value || second.at == best.at {
                (third, second) = (second, new);
            } else if new.value <= third.value || third.at == best.at || third.at == second.at {
                third = new;
            }
        }
    }
    best.at
}

/// Step from the best sample to the vertex of the parabola through three, if it lies inside and converges fast enough.
fn parabolic_step(best: Sample, second: Sample, third: Sample, before: f64, (low, high): (f64, f64)) -> Option<f64> {
    let r = (best.at - second.at) * (best.value - third.value);
    let q = (best.at - third.at) * (best.value - second.value);
    let p = (best.at - third.at) * q - (best.at - second.at) * r;
    let q = 2.0 * (q - r);
    let p = if q > 0.0 { -p } else { p };
    let q = q.abs();
    let inside = p > q * (low - best.at) && p < q * (high - best.at);
    (p.abs() < (q * before / 2.0).abs() && inside).then(|| p / q)
}

/// The sign, where zero counts as positive.
fn sign(v: f64) -> f64 {
    if v < 0.0 { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_constants_are_those_of_their_formulas() {
        assert_eq!(GOLDEN, (3.0 - 5.0_f64.sqrt()) / 2.0);
        assert_eq!(SQRT_EPS, 2.2e-16_f64.sqrt());
    }

    #[test]
    fn smooth_minima_are_found_within_the_tolerance() {
        for minimum in [0.01, 0.5, 1.9, 3.1] {
            assert!((least(|v| (v - minimum).powi(2), 0.0, 3.2, 1e-5) - minimum).abs() < 1e-5, "{minimum}");
        }
        let cosine = least(f64::cos, 0.0, 6.0, 1e-5);
        assert!((cosine - std::f64::consts::PI).abs() < 1e-5);
    }

    #[test]
    fn a_kink_and_an_edge_are_found_too() {
        assert!((least(|v| (v - 0.3).abs(), 0.0, 1.0, 1e-5) - 0.3).abs() < 1e-5);
        assert!(least(|v| v, 0.0, 1.0, 1e-5) < 2e-5);
        assert!(least(|_| f64::NAN, 0.0, 1.0, 1e-5).is_finite());
    }
}
