//! The clothoid whose curvature is the length from its start: the Fresnel integrals, several at once.
//!
//! Their power series are summed as polynomials with as many terms as the longest clothoid needs, in blocks of points, which
//! the compiler vectorizes. PHIDL stops after eight terms and so misses the end of a full turn by 3e-7 of the radius. A
//! rational approximation would be faster, but has only nine correct digits.

use std::f64::consts::SQRT_2;

use phidl_core::geom::Point;

/// How many points are computed side by side.
const BLOCK: usize = 8;

/// The clothoid up to some length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Clothoid {
    /// How many terms of the series are no less than rounding.
    terms: usize,
}

impl Clothoid {
    /// The clothoid up to a length at which it has turned by 720° at most: beyond, the series loses more than four of its
    /// sixteen digits to cancellation.
    pub(super) fn up_to(length: f64) -> Self {
        /// A term of this part of the first one is below the last bit of the sum.
        const NOTHING: f64 = 1e-18;
        let fourth = (length / SQRT_2).powi(4);
        let mut power = 1.0;
        let counts = |[of_x, of_y]: &&[f64; 2]| {
            let counts = (power * of_x.abs()).max(power * of_y.abs()) > NOTHING;
            power *= fourth;
            counts
        };
        Self { terms: FACTORS.iter().take_while(counts).count() }
    }

    /// The point at a length from the start: the integrals of cos(s²/2) and sin(s²/2).
    pub(super) fn at(self, length: f64) -> Point {
        let [point] = self.block([length]);
        point
    }

    /// The points at some lengths from the start.
    pub(super) fn at_each(self, lengths: &[f64]) -> Vec<Point> {
        let (blocks, rest) = lengths.as_chunks::<BLOCK>();
        let mut points = Vec::with_capacity(lengths.len());
        blocks.iter().for_each(|block| points.extend(self.block(*block)));
        points.extend(rest.iter().map(|length| self.at(*length)));
        points
    }

    /// The power series in t = s/√2, from the last term to the first.
    fn block<const N: usize>(self, lengths: [f64; N]) -> [Point; N] {
        let t = lengths.map(|length| length / SQRT_2);
        let square = t.map(|t| t * t);
        let fourth = square.map(|square| square * square);
        let (mut x, mut y) = ([0.0; N], [0.0; N]);
        for [of_x, of_y] in FACTORS[..self.terms].iter().rev() {
            for i in 0..N {
                x[i] = x[i] * fourth[i] + of_x;
                y[i] = y[i] * fourth[i] + of_y;
            }
        }
        std::array::from_fn(|i| Point::new(x[i], y[i] * square[i]) * (t[i] * SQRT_2))
    }
}

/// Terms that are enough for a clothoid that turns by 720°: then t² is 4π, and the first term left out is below 1e-40.
const TERMS: usize = 64;

/// The factors of t^(4k+1) in x and of t^(4k+3) in y: alternately 1 / ((2m+1) m!) with both signs, for m = 2k, 2k+1.
static FACTORS: [[f64; 2]; TERMS] = {
    let mut factors = [[0.0; 2]; TERMS];
    let (mut k, mut m, mut factorial, mut sign) = (0, 0.0, 1.0, 1.0);
    while k < TERMS {
        let of_x = sign / ((2.0 * m + 1.0) * factorial);
        factorial *= m + 1.0;
        let of_y = sign / ((2.0 * m + 3.0) * factorial);
        factorial *= m + 2.0;
        factors[k] = [of_x, of_y];
        (k, m, sign) = (k + 1, m + 2.0, -sign);
    }
    factors
};

#[cfg(test)]
mod tests {
    use super::*;

    /// The same integrals by Simpson's rule.
    fn integrated(s: f64) -> Point {
        let n = 20_000;
        let h = s / f64::from(n);
        let weight = |i: i32| {
            if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        let sum = (0..=n).fold(Point::ORIGIN, |sum, i| {
            let phase = (h * f64::from(i)).powi(2) / 2.0;
            sum + Point::new(phase.cos(), phase.sin()) * weight(i)
        });
        sum * (h / 3.0)
    }

    #[test]
    fn the_series_gives_the_fresnel_integrals_at_all_lengths_that_are_allowed() {
        let longest = (2.0 * 720_f64.to_radians()).sqrt();
        let lengths = [0.0, 0.1, 1.0, 1.3, 1.7, 2.5, 3.5, 4.2, 4.9, longest];
        for (s, p) in lengths.iter().zip(Clothoid::up_to(longest).at_each(&lengths)) {
            assert!(p.distance(integrated(*s)) < 1e-10, "{s}");
        }
        for s in lengths {
            assert!(Clothoid::up_to(s).at(s).distance(integrated(s)) < 1e-10, "{s}");
        }
    }
}
