//! [`RouteBend`]: the bends of Manhattan routes.

use phidl_core::Result;
use phidl_macros::Choice;
use phidl_path::{ArcBend, Bend, EulerBend, Path};

use crate::port_pair::{check_positive, refused};

/// The bends of a Manhattan route. None is tighter anywhere than the given radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum RouteBend {
    /// An arc.
    #[default]
    Circular,
    /// An Euler bend: the curvature rises to 1/radius and falls. Nearly twice as large as the arc of the radius.
    ///
    /// (PHIDL's bends are as large as the arc, and nearly twice as tight as their radius;
    /// [`route_smooth`](fn@crate::route_smooth) draws those.)
    Euler,
    /// An arc whose curvature rises and falls in ten steps; about half as large again as the arc of the radius.
    Gradual,
}

/// Number of arcs of a gradual bend before its radius.
const STEPS: u32 = 10;
/// Turn of these arcs together (degrees).
const RISE: f64 = 15.0;

impl RouteBend {
    /// Distance before its corner at which a bend of an angle (degrees) starts (µm).
    pub(crate) fn extent(self, radius: f64, angle: f64) -> Result<f64> {
        check_positive("bend", "radius", radius)?;
        let (sin, cos) = phidl_core::num::angle::sin_cos(angle);
        let tangent_of_half = sin / (1.0 + cos);
        match self {
            Self::Circular => Ok(radius * tangent_of_half),
            // The info belongs to the curve, so the fewest points suffice.
            Self::Euler => Ok(recorded(&EulerBend::new().num_pts(1).path(radius, angle)?, "Reff") * tangent_of_half),
            Self::Gradual => Ok(self.bend(radius, angle)?.end().norm() / 2.0 / (angle / 2.0).to_radians().cos()),
        }
    }
}

/// A length in the info of an Euler bend (µm).
pub(crate) fn recorded(bend: &Path, key: &str) -> f64 {
    let um = bend.info().get(key).and_then(phidl_core::param::Value::as_f64);
    um.expect("invariant: an Euler bend records its radii")
}

impl Bend for RouteBend {
    fn bend(&self, radius: f64, angle: f64) -> Result<Path> {
        match self {
            Self::Circular => ArcBend::new().path(radius, angle),
            Self::Euler => EulerBend::new().path(radius, angle),
            Self::Gradual => gradual(radius, angle),
        }
    }
}

/// Ten arcs of equal angle with curvatures of 1/10, 2/10, … 10/10 of the sharpest, an arc of the radius up to the
/// middle, and the mirror image of both.
fn gradual(radius: f64, angle: f64) -> Result<Path> {
    let middle = angle.abs() - 2.0 * RISE;
    if middle <= 0.0 {
        let rule = format!("be more than {}°, the turn of its two ends", 2.0 * RISE);
        return Err(refused("gradual bend", "angle", format_args!("{angle}°"), rule));
    }
    let step = (RISE / f64::from(STEPS)).copysign(angle);
    let rise = |n: u32| arc(radius * f64::from(STEPS) / f64::from(n), step);
    let mut path = Path::new();
    for n in 1..=STEPS {
        path.append(rise(n)?);
    }
    path.append(arc(radius, middle.copysign(angle))?);
    for n in (1..=STEPS).rev() {
        path.append(rise(n)?);
    }
    Ok(path)
}

/// An arc whose chords turn by half a degree or slightly less. All chords of one bend must turn equally: on the inner edge of
/// a wide wire, a short chord between long ones would run backwards.
fn arc(radius: f64, angle: f64) -> Result<Path> {
    const CHORD: f64 = 0.5;
    let points = (angle.abs() / CHORD).ceil() + 1.0;
    // Half a point more than needed, so that truncation is safe.
    ArcBend::new().num_pts((points + 0.5) * 360.0 / angle.abs()).path(radius, angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gradual_bend_is_symmetric_and_half_as_large_again() {
        for angle in [90.0, -90.0] {
            let bend = RouteBend::Gradual.bend(10.0, angle).unwrap();
            let end = bend.end();
            assert!((end.x - end.y.abs()).abs() < 1e-9, "{end}");
            assert!((1.45..1.6).contains(&(end.x / 10.0)), "{end}");
            assert_eq!(phidl_core::num::angle::normalized(angle), bend.end_angle());
        }
    }

    #[test]
    fn the_curvature_of_a_gradual_bend_rises_in_ten_steps() {
        // By definition: the length of ten arcs of 1.5° of radius 10 R / n, twice, and of 60° of radius R.
        let harmonic: f64 = (1..=10).map(|n| 1.0 / f64::from(n)).sum();
        let expected = 2.0 * 10.0 * 1.5_f64.to_radians() * harmonic + 60_f64.to_radians();
        let length = RouteBend::Gradual.bend(1.0, 90.0).unwrap().length();
        assert!((length - expected).abs() < 1e-4, "{length} {expected}");
    }

    #[test]
    fn extents_are_those_of_the_bends() {
        for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
            let path = bend.bend(7.0, 90.0).unwrap();
            assert!((bend.extent(7.0, 90.0).unwrap() - path.end().x).abs() < 1e-9);
        }
        assert!(RouteBend::Gradual.bend(7.0, 20.0).is_err() && RouteBend::Gradual.extent(-1.0, 90.0).is_err());
    }

    #[test]
    fn an_euler_bend_has_the_extent_of_the_reference() {
        // A bend of smallest radius 3 that turns by 90° ends at (5.61, 5.61).
        assert!((RouteBend::Euler.extent(3.0, 90.0).unwrap() - 5.610_287_54).abs() < 1e-8);
    }
}
