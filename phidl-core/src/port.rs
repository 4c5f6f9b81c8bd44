//! [`Port`]: an opening at which two cells are joined.

use std::collections::BTreeMap;

use smol_str::SmolStr;

use crate::error::{Error, Result};
use crate::geom::{Point, Rect, Transform};
use crate::num::angle;
use crate::param::Value;
use crate::place::{Bounded, DeferredError, Transformable};

/// A named opening: midpoint, width, and the direction that looks out of the geometry it belongs to.
///
/// ```
/// # use phidl_core::prelude::*;
/// let port = Port::new((3, 4), 2, 0);
/// assert_eq!(port.endpoints(), (Point::new(3.0, 5.0), Point::new(3.0, 3.0)));
/// ```
///
/// Given as a value, `((x, y), width, orientation)` is a port too. The name comes with
/// [`add_port`](crate::scene::DeviceBuilder::add_port).
#[derive(Debug, Clone, PartialEq)]
pub struct Port {
    name: SmolStr,
    midpoint: Point,
    width: f64,
    orientation: f64,
    info: BTreeMap<String, Value>,
    deferred: Option<Box<DeferredError>>,
}

impl Port {
    /// A port without a name; width in µm, orientation in degrees (kept in `[0, 360)`).
    ///
    /// A negative width, or a number that is not finite, is refused when the port is added to a cell.
    pub fn new(midpoint: impl Into<Point>, width: impl Into<f64>, orientation: impl Into<f64>) -> Self {
        Self {
            name: SmolStr::default(),
            midpoint: midpoint.into(),
            width: width.into(),
            orientation: angle::normalized(orientation.into()),
            info: BTreeMap::new(),
            deferred: None,
        }
    }

    /// The port between two points, `left` and `right` as seen when looking out.
    pub fn between(left: impl Into<Point>, right: impl Into<Point>) -> Self {
        let (left, right) = (left.into(), right.into());
        let across = right - left;
        Self::new((left + right) / 2.0, across.norm(), angle::direction(-across.y, across.x))
    }

    /// The same port under another name.
    #[must_use]
    pub fn named(mut self, name: impl AsRef<str>) -> Self {
        self.name = SmolStr::new(name);
        self
    }

    /// The same port with another width (µm).
    #[must_use]
    pub fn with_width(self, width: impl Into<f64>) -> Self {
        Self { width: width.into(), ..self }
    }

    /// The same port at another midpoint.
    #[must_use]
    pub fn with_midpoint(self, midpoint: impl Into<Point>) -> Self {
        Self { midpoint: midpoint.into(), ..self }
    }

    /// The same port with another orientation (degrees).
    #[must_use]
    pub fn with_orientation(self, orientation: impl Into<f64>) -> Self {
        Self { orientation: angle::normalized(orientation.into()), ..self }
    }

    /// The same port with one more value in its info.
    #[must_use]
    pub fn with_info(mut self, key: impl Into<String>, value: impl Into<Value>) -> Self {
        self.info.insert(key.into(), value.into());
        self
    }

    /// The name; empty until the port belongs to a cell.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The name in the form in which it is kept.
    pub(crate) fn short_name(&self) -> &SmolStr {
        &self.name
    }

    /// The center of the opening.
    #[must_use]
    pub fn midpoint(&self) -> Point {
        self.midpoint
    }

    /// The width of the opening (µm).
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The direction that looks out of the geometry (degrees, in `[0, 360)`).
    #[must_use]
    pub fn orientation(&self) -> f64 {
        self.orientation
    }

    /// Values of any kind.
    #[must_use]
    pub fn info(&self) -> &BTreeMap<String, Value> {
        &self.info
    }

    /// The vector of length 1 that looks out.
    #[must_use]
    pub fn normal(&self) -> Point {
        Point::polar(1.0, self.orientation)
    }

    /// The two ends of the opening: left and right as seen when looking out.
    #[must_use]
    pub fn endpoints(&self) -> (Point, Point) {
        let half = Point::polar(self.width / 2.0, self.orientation - 90.0);
        (self.midpoint - half, self.midpoint + half)
    }

    /// The port that faces this one at the same midpoint.
    #[must_use]
    pub fn flipped(&self) -> Self {
        let mut flipped = self.clone();
        flipped.orientation = angle::normalized(self.orientation + 180.0);
        flipped
    }

    /// The placement method of the deferred error, if there is one.
    pub(crate) fn invalid_method(&self) -> Option<&'static str> {
        self.deferred.as_ref().map(|error| error.method)
    }

    /// Refuses an invalid port in the name of a cell.
    pub(crate) fn check(&self, device: &str) -> Result<()> {
        let what = |what: &str| format!("the {what} of the port \"{}\"", self.name).into();
        if let Some(error) = &self.deferred {
            return Err(error.into_error(device, &format!("the port \"{}\"", self.name)));
        }
        let not_finite = |name: &str, value: String| {
            Err(Error::NotFinite { device: device.into(), what: what(name), value: value.into() })
        };
        if !self.midpoint.is_finite() {
            return not_finite("midpoint", self.midpoint.to_string());
        }
        if !self.orientation.is_finite() {
            return not_finite("orientation", self.orientation.to_string());
        }
        if !self.width.is_finite() {
            return not_finite("width", self.width.to_string());
        }
        if let Some((key, value)) = self.info.iter().find(|(_, value)| !value.is_finite()) {
            return not_finite(&format!("info \"{key}\""), value.to_string());
        }
        if self.width < 0.0 {
            let problem =
                format!("the width of the port \"{}\" is {} µm, but it must be at least 0 µm", self.name, self.width);
            return Err(Error::invalid(device, problem));
        }
        Ok(())
    }
}

impl std::fmt::Display for Port {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, midpoint, width, orientation, .. } = self;
        write!(f, "port \"{name}\" at {midpoint}, {width} µm wide, facing {orientation}°")
    }
}

impl Bounded for Port {
    /// The midpoint.
    fn bbox(&self) -> Option<Rect> {
        Some(Rect { min: self.midpoint, max: self.midpoint })
    }
}

/// A port by value or by reference, for whatever connects to one.
impl AsRef<Self> for Port {
    fn as_ref(&self) -> &Self {
        self
    }
}

impl Transformable for Port {
    fn transform_mut(&mut self, by: &Transform) {
        self.midpoint = by.apply(self.midpoint);
        self.orientation = by.apply_direction(self.orientation);
        self.width *= by.magnification;
    }

    /// A rotation about the midpoint leaves it exactly where it is.
    fn rotate_mut(&mut self, degrees: f64, center: Point) {
        let midpoint = if center == self.midpoint { Some(center) } else { None };
        self.transform_mut(&Transform::rotation_about(degrees, center));
        self.midpoint = midpoint.unwrap_or(self.midpoint);
    }

    /// The midpoint, as in PHIDL.
    fn pivot(&self) -> Point {
        self.midpoint
    }

    fn defer(&mut self, error: DeferredError) {
        self.deferred.get_or_insert(Box::new(error));
    }
}

impl From<&Port> for Port {
    fn from(port: &Port) -> Self {
        port.clone()
    }
}

impl<P: Into<Point>, W: Into<f64>, O: Into<f64>> From<(P, W, O)> for Port {
    fn from((midpoint, width, orientation): (P, W, O)) -> Self {
        Self::new(midpoint, width, orientation)
    }
}

impl From<&Port> for Point {
    fn from(port: &Port) -> Self {
        port.midpoint
    }
}

impl From<Port> for Point {
    fn from(port: Port) -> Self {
        port.midpoint
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endpoints_are_left_and_right_when_looking_out() {
        assert_eq!(Port::new((3, 4), 2, 90).endpoints(), (Point::new(2.0, 4.0), Point::new(4.0, 4.0)));
    }

    #[test]
    fn a_port_between_two_points_looks_away_from_the_material() {
        for (a, b, orientation) in
            [((3, 5), (3, 3), 0.0), ((3, 3), (3, 5), 180.0), ((0, 0), (1, 0), 90.0), ((1, 0), (0, 0), 270.0)]
        {
            assert_eq!(Port::between(a, b).orientation(), orientation);
        }
        let port = Port::new((1, 2), 3, 30);
        let (left, right) = port.endpoints();
        assert!((Port::between(left, right).orientation() - 30.0).abs() < 1e-12);
    }

    #[test]
    fn orientations_are_kept_within_a_turn() {
        assert_eq!(Port::new((0, 0), 1, -90).orientation(), 270.0);
        assert_eq!(Port::new((0, 0), 1, 725.5).orientation(), 5.5);
    }

    #[test]
    fn magnification_scales_the_width() {
        let mut port = Port::new((4, 1), 2, 0);
        port.transform_mut(&Transform { magnification: 2.0, x_reflection: true, ..Transform::IDENTITY });
        assert_eq!((port.midpoint(), port.width(), port.orientation()), (Point::new(8.0, -2.0), 4.0, 0.0));
    }

    #[test]
    fn invalid_ports_are_refused_by_name() {
        let error = Port::new((0, 0), -1, 0).named("e").check("ring").unwrap_err();
        assert_eq!(error.to_string(), "ring: the width of the port \"e\" is -1 µm, but it must be at least 0 µm");
        assert!(Port::new((0.0, f64::NAN), 1, 0).check("ring").is_err());
        assert!(Port::new((0, 0), 1, f64::INFINITY).check("ring").is_err());
        let noted = Port::new((0, 0), 1, 0).named("e").with_info("loss", f64::NAN).check("ring").unwrap_err();
        assert_eq!(noted.to_string(), "ring: the info \"loss\" of the port \"e\" is NaN, but it must be finite");
    }
}
