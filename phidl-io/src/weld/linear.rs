//! Linear parts of placements: an exact orientation and what remains.
//!
//! A linear part is split as `D ∘ μ·R(ρ)`: `D` is one of the eight orientations that map the grid onto itself, `ρ` lies in
//! `[0°, 90°)`. The angle is rounded to 2⁻⁴⁰ degrees before it is split; split first, a sum of angles that makes a quarter
//! turn up to the last bit would give a `ρ` just below 90°.

use phidl_core::geom::{Point, Transform};
use phidl_core::num::angle;

use super::corner::Corner;

/// One of the eight placements that map the grid onto itself: mirror at the x axis, then quarter turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Orientation {
    mirrored: bool,
    quarters: u8,
}

impl Orientation {
    /// The image of a grid point.
    pub(super) fn apply(self, [x, y]: Corner) -> Corner {
        let y = if self.mirrored { -y } else { y };
        match self.quarters {
            0 => [x, y],
            1 => [-y, x],
            2 => [-x, -y],
            _ => [y, -x],
        }
    }

    /// The image of a displacement.
    pub(super) fn apply_vector(self, v: Point) -> Point {
        self.transform().apply_vector(v)
    }

    pub(super) fn inverse(self) -> Self {
        let quarters = if self.mirrored { self.quarters } else { (4 - self.quarters) % 4 };
        Self { quarters, ..self }
    }

    /// This orientation, then another one.
    pub(super) fn then(self, next: Self) -> Self {
        let own = if next.mirrored { 4 - self.quarters } else { self.quarters };
        Self { mirrored: self.mirrored != next.mirrored, quarters: (own + next.quarters) % 4 }
    }

    pub(super) fn transform(self) -> Transform {
        let rotation = 90.0 * f64::from(self.quarters);
        Transform { x_reflection: self.mirrored, rotation, ..Transform::IDENTITY }
    }
}

/// A linear part, split.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Linear {
    pub(super) orientation: Orientation,
    /// What remains of the angle, in `[0, 90)` degrees.
    pub(super) residue: f64,
    pub(super) magnification: f64,
}

impl Linear {
    pub(super) fn of(transform: &Transform) -> Self {
        /// Parts of a degree that are told apart.
        const PARTS: f64 = (1_u64 << 40) as f64;
        let turn = if transform.x_reflection { -transform.rotation } else { transform.rotation };
        let turn = angle::normalized((angle::normalized(turn) * PARTS).round() / PARTS);
        let k = (turn / 90.0).floor();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "one of 0, 1, 2, 3")]
        let quarters = k as u8;
        let quarters = if transform.x_reflection { (4 - quarters) % 4 } else { quarters };
        Self {
            orientation: Orientation { mirrored: transform.x_reflection, quarters },
            residue: turn - 90.0 * k,
            magnification: transform.magnification,
        }
    }

    /// Whether whole numbers are mapped to whole numbers.
    pub(super) fn is_exact(&self) -> bool {
        self.residue == 0.0 && self.magnification.fract() == 0.0
    }

    /// Whether nothing remains but the orientation.
    pub(super) fn is_orientation(&self) -> bool {
        self.residue == 0.0 && self.magnification == 1.0
    }

    /// The image of a grid point, if it is one.
    pub(super) fn apply_exactly(&self, [x, y]: Corner) -> Option<Corner> {
        #[expect(clippy::cast_possible_truncation, reason = "a whole number; files refuse what is out of their range")]
        let factor = self.is_exact().then_some(self.magnification as i64)?;
        Some(self.orientation.apply([x.checked_mul(factor)?, y.checked_mul(factor)?]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(mirrored: bool, rotation: f64) -> Transform {
        Transform { x_reflection: mirrored, rotation, ..Transform::IDENTITY }
    }

    #[test]
    fn a_mirrored_turn_by_30_degrees_is_a_residue_of_60() {
        let linear = Linear::of(&turned(true, 30.0));
        assert_eq!(linear.residue, 60.0);
        assert_eq!(linear.orientation, Orientation { mirrored: true, quarters: 1 });
    }

    #[test]
    fn orientation_after_residue_is_the_linear_part() {
        let v = Point::new(3.0, 1.0);
        for mirrored in [false, true] {
            for step in 0..48 {
                let t = turned(mirrored, 7.5 * f64::from(step));
                let linear = Linear::of(&t);
                let image = linear.orientation.apply_vector(Transform::rotation(linear.residue).apply(v));
                assert!(image.distance(t.apply(v)) < 1e-12, "{t:?}");
                assert!((0.0..90.0).contains(&linear.residue));
            }
        }
    }

    #[test]
    fn noise_below_a_quarter_turn_is_no_residue() {
        let sum = [29.9, 0.1, 17.3, 12.7, 20.2, 9.8].iter().fold(0.0, |sum, angle| sum + angle);
        assert_eq!(Linear::of(&turned(false, sum)).residue, 0.0);
        assert_eq!(Linear::of(&turned(false, 90.0 - 1e-14)).orientation.quarters, 1);
    }

    #[test]
    fn orientations_form_a_group() {
        let all = (0..8).map(|i| Orientation { mirrored: i >= 4, quarters: i % 4 });
        for a in all.clone() {
            assert_eq!(a.then(a.inverse()), Orientation { mirrored: false, quarters: 0 });
            for b in all.clone() {
                assert_eq!(a.then(b).apply([5, 2]), b.apply(a.apply([5, 2])));
            }
        }
    }
}
