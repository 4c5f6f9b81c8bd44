//! The only rounding rule: from micrometers to whole steps of a grid.
//!
//! It is used on entry into the boolean engine and when a file is written. A generator never rounds. Halves round away
//! from zero, so that a mirrored layout rounds to the mirror image. (`floor(x + 0.5)` would keep shifts exact instead, but
//! a mask is more than shifts.) Floating-point noise below 2⁻²⁰ of a step is removed before, so that two computations of
//! one half step round alike.

use crate::geom::Point;

/// Noise below this part of a step is removed before rounding: 2²⁰ parts.
const NOISE_PARTS: f64 = 1_048_576.0;

/// Parts below this number (2⁵¹) are rounded without a library call.
const QUICKLY: f64 = 2_251_799_813_685_248.0;

/// Adding and subtracting it rounds to a whole number (1.5 · 2⁵², where neighboring doubles differ by one).
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;

/// A square grid of `step` micrometers, with the largest number of steps that fits its integers.
///
/// ```
/// # use phidl_core::num::grid::Grid;
/// let nanometer = Grid::new(1e-3)?;
/// assert_eq!(nanometer.steps(0.0015)?, 2);
/// assert_eq!(nanometer.steps(-0.0015)?, -2);
/// # Ok::<(), phidl_core::num::grid::GridError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    step: f64,
    per_um: f64,
    most: i64,
}

/// Why a coordinate or a grid was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GridError {
    /// The coordinate is not a number, infinite, or further out than the grid's integers reach.
    #[error("coordinate {um} µm is outside the grid, which reaches ±{limit_um} µm in steps of {step} µm")]
    OutOfRange {
        /// The coordinate (µm).
        um: f64,
        /// The grid's reach (µm).
        limit_um: f64,
        /// The grid step (µm).
        step: f64,
    },
    /// A grid step must be a positive, finite length.
    #[error("grid step is {step} µm, but it must be greater than 0 µm and finite")]
    BadStep {
        /// The step that was asked for (µm).
        step: f64,
    },
}

impl Grid {
    /// A grid of `step` micrometers whose steps fit into 32 bits, as GDSII stores them.
    ///
    /// # Errors
    /// [`GridError::BadStep`] unless the step is positive and finite.
    pub fn new(step: f64) -> Result<Self, GridError> {
        // A step like 1e-3 is not a binary fraction, but its inverse mostly is a whole number: multiply by that.
        let inverse = (1.0 / step).round();
        let per_um = if inverse > 0.0 && ((inverse * step) - 1.0).abs() < 1e-12 { inverse } else { 1.0 / step };
        if step > 0.0 && step.is_finite() && per_um.is_finite() {
            Ok(Self { step, per_um, most: i64::from(i32::MAX) })
        } else {
            Err(GridError::BadStep { step })
        }
    }

    /// The same grid with another reach: `±most` steps.
    #[must_use]
    pub fn reaching(self, most: i64) -> Self {
        Self { most, ..self }
    }

    /// The grid step (µm).
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The coordinate as a number of steps: noise removed, then halves away from zero.
    ///
    /// # Errors
    /// [`GridError::OutOfRange`] if the coordinate is not finite or further out than the grid reaches.
    #[inline]
    pub fn steps(&self, um: f64) -> Result<i64, GridError> {
        let steps = self.rounded(um);
        if steps.abs() <= self.most as f64 {
            #[expect(clippy::cast_possible_truncation, reason = "the range was checked above")]
            let steps = steps as i64;
            Ok(steps)
        } else {
            Err(GridError::OutOfRange { um, limit_um: self.um(self.most), step: self.step })
        }
    }

    /// Both coordinates of a point as steps.
    ///
    /// # Errors
    /// [`GridError::OutOfRange`] as for [`Grid::steps`].
    pub fn point_steps(&self, point: Point) -> Result<(i64, i64), GridError> {
        Ok((self.steps(point.x)?, self.steps(point.y)?))
    }

    /// The length of a number of steps (µm).
    #[must_use]
    #[inline]
    pub fn um(&self, steps: i64) -> f64 {
        steps as f64 / self.per_um
    }

    /// A length (µm) as a real number of steps, without the noise of floating point.
    #[must_use]
    pub fn scaled(&self, um: f64) -> f64 {
        quiet(um * self.per_um)
    }

    /// The coordinate rounded to the grid, as a whole number of steps that may be out of range.
    #[inline]
    fn rounded(&self, um: f64) -> f64 {
        whole(um * self.per_um)
    }
}

/// The whole number nearest to a number of steps: noise removed, then halves away from zero. For computations in steps of
/// a grid and in real numbers.
#[must_use]
#[inline]
pub fn whole(steps: f64) -> f64 {
    let parts = steps * NOISE_PARTS;
    if parts.abs() < QUICKLY {
        // Both sums are exact but for the rounding that is wanted. `f64::round` is a call into the C library on
        // most machines, and a file of a million outlines asks for it sixteen million times.
        let quiet = (parts + TO_WHOLE - TO_WHOLE) / NOISE_PARTS;
        #[expect(clippy::cast_possible_truncation, reason = "`as` takes the whole part, of a number below 2³¹")]
        let steps = (quiet + 0.5_f64.copysign(quiet)) as i64;
        return steps as f64;
    }
    quiet(steps).round()
}

/// The number without the noise of floating point.
fn quiet(steps: f64) -> f64 {
    let parts = steps * NOISE_PARTS;
    // Beyond 2⁵² parts a double has no half steps, so there is no noise to remove.
    if parts.abs() < 4.5e15 { parts.round() / NOISE_PARTS } else { steps }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_go_away_from_zero_so_that_mirrored_layouts_mirror() {
        let grid = Grid::new(1e-3).unwrap();
        for um in [0.0005, 0.0015, 0.0025, 1.0005, 123.4565] {
            assert_eq!(grid.steps(um).unwrap(), -grid.steps(-um).unwrap());
        }
        assert_eq!(grid.steps(0.0025).unwrap(), 3);
        assert_eq!(grid.steps(1.0005).unwrap(), 1001);
    }

    #[test]
    fn two_computations_of_one_half_step_round_alike() {
        let grid = Grid::new(1e-3).unwrap();
        let direct = 0.0005;
        let roundabout = 1000.0005 - 1000.0; // 0.00049999998 in doubles
        assert_eq!(grid.steps(direct).unwrap(), grid.steps(roundabout).unwrap());
    }

    #[test]
    fn both_implementations_of_rounding_agree() {
        let grid = Grid::new(1.0).unwrap().reaching(1 << 40);
        for whole in [0.0, 1.0, 2.0, 1e6, 2_147_483_646.0] {
            for part in [0.0, 0.25, 0.499_999, 0.5, 0.500_001, 0.75] {
                let quick = grid.steps(whole + part).unwrap();
                assert_eq!(quick as f64, (whole + part).round(), "{whole} + {part}");
                assert_eq!(grid.steps(-whole - part).unwrap(), -quick);
            }
        }
        assert_eq!(grid.steps(2_147_483_648.5).unwrap(), 2_147_483_649);
    }

    #[test]
    fn lengths_keep_their_parts_of_a_step_and_lose_their_noise() {
        let grid = Grid::new(1e-4).unwrap();
        assert_eq!(grid.scaled(0.3), 3000.0); // 0.3 / 1e-4 is 2999.9999999999995 in doubles
        assert_eq!(grid.scaled(0.000_025), 0.25);
        assert_eq!(whole(-2.5), -3.0);
    }

    #[test]
    fn real_differences_are_not_noise() {
        let grid = Grid::new(1e-3).unwrap();
        assert_eq!(grid.steps(0.000_499_99).unwrap(), 0);
    }

    #[test]
    fn out_of_range_is_an_error() {
        let grid = Grid::new(1e-3).unwrap();
        assert_eq!(grid.steps(2_147_483.647).unwrap(), i64::from(i32::MAX));
        assert!(grid.steps(2_147_483.648).is_err());
        assert!(grid.steps(f64::NAN).is_err());
        assert!(grid.steps(f64::NEG_INFINITY).is_err());
        assert!(grid.reaching(1 << 40).steps(3_000_000.0).is_ok());
    }

    #[test]
    fn invalid_grid_steps_are_refused() {
        for step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
            assert!(Grid::new(step).is_err(), "{step}");
        }
    }
}
