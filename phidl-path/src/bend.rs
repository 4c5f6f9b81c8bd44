//! [`Bend`]: the shape of a corner; [`ArcBend`] and [`EulerBend`] implement it.
//!
//! A bend is a shape without a size: the corner gives the angle, the caller the radius. A function from radius and angle to
//! a path is a bend too. (PHIDL passes such a function and its options separately, and an unknown option is noticed only in
//! the call.)

use phidl_core::{Error, Result};

use crate::Path;
use crate::curve::{Arc, Euler};

/// Default number of points per full turn.
const NUM_PTS: f64 = 720.0;

/// The shape of a corner.
pub trait Bend {
    /// The path of a radius (µm) that turns by an angle (degrees, positive to the left), from the origin heading right.
    ///
    /// It must depend on nothing else: [`Path::smooth`] calls it once for all corners that turn by the same angle.
    ///
    /// # Errors
    /// If the bend cannot be drawn with this radius or angle.
    fn bend(&self, radius: f64, angle: f64) -> Result<Path>;
}

impl<F: Fn(f64, f64) -> Result<Path>> Bend for F {
    fn bend(&self, radius: f64, angle: f64) -> Result<Path> {
        self(radius, angle)
    }
}

/// Circular arcs: the shortest bends.
///
/// ```
/// # use phidl_path::{ArcBend, Path};
/// let path = Path::smooth([(0, 0), (50, 0), (50, 50)], 5, ArcBend::new().num_pts(16))?;
/// assert_eq!(path.points().len(), 6);
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcBend {
    num_pts: f64,
}

impl ArcBend {
    /// Arcs with 720 points per full turn.
    #[must_use]
    pub fn new() -> Self {
        Self { num_pts: NUM_PTS }
    }

    /// The same with another number of points per full turn.
    #[must_use]
    pub fn num_pts(self, num_pts: impl Into<f64>) -> Self {
        Self { num_pts: num_pts.into() }
    }

    /// The arc of a radius (µm) and an angle (degrees, positive to the left), from the origin heading right.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the radius is greater than 0, the angle not 0, and the number
    /// of points greater than 0.
    pub fn path(self, radius: impl Into<f64>, angle: impl Into<f64>) -> Result<Path> {
        Arc::new(radius.into(), angle.into())?.path(self.num_pts)
    }
}

impl Default for ArcBend {
    fn default() -> Self {
        Self::new()
    }
}

impl Bend for ArcBend {
    fn bend(&self, radius: f64, angle: f64) -> Result<Path> {
        self.path(radius, angle)
    }
}

/// Euler bends: the curvature rises and falls linearly, which keeps the optical loss low.
///
/// ```
/// # use phidl_path::EulerBend;
/// let bend = EulerBend::new().p(0.25).use_eff().path(10, 45)?;
/// assert_eq!(bend.info()["Reff"].as_f64(), Some(10.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerBend {
    p: f64,
    use_eff: bool,
    num_pts: f64,
}

impl EulerBend {
    /// Bends of clothoids alone with 720 points per full turn. The radius is the smallest radius of curvature.
    #[must_use]
    pub fn new() -> Self {
        Self { p: 1.0, use_eff: false, num_pts: NUM_PTS }
    }

    /// The same with another fraction (0 to 1) of the turn in the clothoids and the rest in an arc between them. With 0 it
    /// is an arc.
    #[must_use]
    pub fn p(self, p: impl Into<f64>) -> Self {
        Self { p: p.into(), ..self }
    }

    /// The same, where the radius is that of the arc with the same ends; for angles up to 190°.
    #[must_use]
    pub fn use_eff(self) -> Self {
        Self { use_eff: true, ..self }
    }

    /// The same with another number of points per full turn.
    #[must_use]
    pub fn num_pts(self, num_pts: impl Into<f64>) -> Self {
        Self { num_pts: num_pts.into(), ..self }
    }

    /// The bend of a radius (µm) and an angle (degrees, positive to the left), from the origin heading right.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the radius is greater than 0; the angle not 0 and within
    /// ±1440°, with an effective radius within ±190°; `p` from 0 to 1; the number of points greater than 0.
    pub fn path(self, radius: impl Into<f64>, angle: impl Into<f64>) -> Result<Path> {
        let (radius, angle) = (radius.into(), angle.into());
        if self.p != 0.0 {
            return Euler::new(radius, angle, self.p, self.use_eff)?.path(self.num_pts);
        }
        // Without clothoids both radii are that of the arc.
        let mut path = Arc::new(radius, angle)?.path(self.num_pts)?;
        path.set_info("Reff", radius).set_info("Rmin", radius);
        Ok(path)
    }
}

impl Default for EulerBend {
    fn default() -> Self {
        Self::new()
    }
}

impl Bend for EulerBend {
    fn bend(&self, radius: f64, angle: f64) -> Result<Path> {
        self.path(radius, angle)
    }
}

/// The bend for a corner. It must start at the origin and end on its mirror image at the bisector, or it would not meet
/// the leg after the corner.
pub(crate) fn checked(bend: &impl Bend, radius: f64, angle: f64) -> Result<Path> {
    /// Distance by which a bend may miss its end (µm): ports that meet within this form a joint.
    const JOINT: f64 = 1e-6;
    let path = bend.bend(radius, angle)?;
    path.check()?;
    let end = path.end();
    let due = phidl_core::geom::Point::polar(end.norm(), angle / 2.0);
    let met = end.distance(due).min(end.distance(-due)) <= JOINT;
    match path.start().norm() <= JOINT && met {
        true => Ok(path),
        false => Err(Error::custom(
            "smooth",
            format!(
                "the bend for a corner of {angle}° leads from {} to {end}, but it must start at (0, 0) and end as far behind \
                 the corner as it starts before it",
                path.start()
            ),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_euler_bend_without_clothoids_is_an_arc() {
        let bend = EulerBend::new().p(0).path(10, -90).unwrap();
        assert_eq!(bend.points(), Path::arc(10, -90).unwrap().points());
        assert_eq!(bend.info()["Rmin"].as_f64(), Some(10.0));
    }

    #[test]
    fn a_bend_that_misses_the_next_leg_is_refused() {
        let crooked = |radius: f64, _: f64| Path::arc(radius, 45);
        assert!(checked(&crooked, 5.0, 45.0).is_ok());
        assert!(checked(&crooked, 5.0, 90.0).is_err());
    }
}
