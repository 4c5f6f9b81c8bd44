//! The one place where micrometers become grid steps.
//!
//! Float noise is removed first (to 2⁻²⁰ of a step), then halves round away from zero. Both steps matter: `0.00005`
//! and `0.15 / 3000` are the same place to a designer and must meet on the grid, and a mirrored layout must round to
//! the mirror image. Rounding by `floor(x + 0.5)` would keep shifts by whole steps exact instead, but breaks mirrors.

use crate::{
    contours::Contours,
    error::BooleanError,
    point::{GridPoint, MAX_COORDINATE},
};

/// Parts of a grid step below which a difference counts as float noise.
const NOISE_PER_STEP: f64 = (1u32 << 20) as f64;

/// A square grid through the origin.
///
/// # Examples
/// ```
/// use phidl_boolean::Grid;
/// let grid = Grid::default();
/// assert_eq!(grid.steps(0.3), Some(3000)); // 0.3 / 1e-4 is 2999.9999999999995 in floats
/// assert_eq!(grid.steps(-0.00005), Some(-1));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    precision: f64,
}

impl Default for Grid {
    /// The grid of the boolean functions: 10⁻⁴ µm.
    fn default() -> Self {
        Self { precision: 1e-4 }
    }
}

impl Grid {
    /// A grid with steps of `precision` µm.
    ///
    /// # Errors
    /// [`BooleanError::Precision`] if `precision` is not finite and greater than zero.
    pub fn new(precision: f64) -> Result<Self, BooleanError> {
        if precision.is_finite() && precision > 0.0 {
            Ok(Self { precision })
        } else {
            Err(BooleanError::Precision { precision })
        }
    }

    /// The grid step (µm).
    pub fn precision(&self) -> f64 {
        self.precision
    }

    /// Largest absolute coordinate that has a place on this grid (µm).
    #[expect(clippy::cast_precision_loss, reason = "2^40 is exact in an f64")]
    pub fn limit(&self) -> f64 {
        MAX_COORDINATE as f64 * self.precision
    }

    /// The nearest grid step to a coordinate in µm, halves away from zero; `None` if it is out of range or NaN.
    #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "the range is checked first")]
    pub fn steps(&self, coordinate: f64) -> Option<i64> {
        let steps = self.scaled(coordinate).round();
        (steps.abs() <= MAX_COORDINATE as f64).then_some(steps as i64)
    }

    /// A length in µm as a real number of grid steps, without float noise.
    pub fn scaled(&self, length: f64) -> f64 {
        (length / self.precision * NOISE_PER_STEP).round() / NOISE_PER_STEP
    }

    /// The coordinate in µm of a grid step.
    #[expect(clippy::cast_precision_loss, reason = "2^40 steps are exact in an f64")]
    pub fn coordinate(&self, steps: i64) -> f64 {
        // Dividing by the whole number of steps in a µm gives the float that a person would type.
        let per_um = (1.0 / self.precision).round();
        let is_decimal = ((1.0 / self.precision) - per_um).abs() <= per_um * f64::EPSILON;
        if is_decimal { steps as f64 / per_um } else { steps as f64 * self.precision }
    }

    /// Rounds closed shapes to the grid, in order.
    ///
    /// # Errors
    /// [`BooleanError::OffGrid`] names the first shape with a coordinate that is out of range, infinite or NaN.
    pub fn snap<S, P>(&self, shapes: S) -> Result<Contours, BooleanError>
    where
        S: IntoIterator<Item = P>,
        P: IntoIterator<Item = (f64, f64)>,
    {
        let mut contours = Contours::new();
        let mut points = Vec::new();
        for (shape, outline) in shapes.into_iter().enumerate() {
            points.clear();
            for (x, y) in outline {
                points.push(GridPoint::new(self.checked(shape, x)?, self.checked(shape, y)?));
            }
            contours.push(points.iter().copied());
        }
        Ok(contours)
    }

    fn checked(&self, shape: usize, value: f64) -> Result<i64, BooleanError> {
        self.steps(value).ok_or(BooleanError::OffGrid { shape, value, limit: self.limit() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_round_away_from_zero_on_both_sides() {
        let grid = Grid::default();
        assert_eq!(grid.steps(0.00005), Some(1));
        assert_eq!(grid.steps(-0.00005), Some(-1));
        assert_eq!(grid.steps(0.000_049), Some(0));
        assert_eq!(grid.steps(-0.56789), Some(-5679));
    }

    #[test]
    fn float_noise_below_a_millionth_step_does_not_decide_a_tie() {
        let grid = Grid::default();
        let tie = 0.00015; // 1.5 steps
        assert_eq!(grid.steps(tie * (1.0 - 1e-12)), grid.steps(tie));
        assert_eq!(grid.steps(tie * (1.0 + 1e-12)), grid.steps(tie));
    }

    #[test]
    fn coordinates_come_back_as_a_person_would_type_them() {
        let grid = Grid::default();
        assert_eq!(grid.coordinate(3000).to_bits(), 0.3_f64.to_bits());
        assert_eq!(Grid::new(0.25).map(|g| g.coordinate(-3)), Ok(-0.75));
    }

    #[test]
    fn what_has_no_place_on_the_grid_is_refused_with_the_shape_that_has_it() {
        let grid = Grid::default();
        for bad in [f64::NAN, f64::INFINITY, 1.2e8] {
            let shapes = [vec![(0.0, 0.0)], vec![(1.0, bad)]];
            let Err(BooleanError::OffGrid { shape, .. }) = grid.snap(shapes) else { panic!("{bad} was accepted") };
            assert_eq!(shape, 1);
        }
        assert_eq!(Grid::new(0.0), Err(BooleanError::Precision { precision: 0.0 }));
        assert!(Grid::new(f64::NAN).is_err());
    }
}
