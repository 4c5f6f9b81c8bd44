//! [`PortPair`]: two ports to be joined, and the rules between them.
//!
//! Every rule is checked here or with the lengths measured here. So a route that cannot be made has the same sentence in
//! every family: both ports, the measured length, and how much is missing. An error for each family was rejected: it would
//! name internal lengths that the user never gave.

use phidl_core::error::ParamError;
use phidl_core::geom::Point;
use phidl_core::num::angle;
use phidl_core::port::Port;
use phidl_core::{Error, Result};

/// Tolerance of right angles between ports (degrees): half a step of the three decimals to which PHIDL compares.
pub(crate) const SKEW: f64 = 1e-3;
/// Distance beside a port's axis at which a route may leave or arrive (µm): a step of the usual database grid.
const BESIDE: f64 = 1e-3;
/// Distance from a port at which a route may start or end (µm): ports that meet within this form a joint.
const JOINT: f64 = 1e-6;

/// Two ports to be joined, and the position of the second one relative to the first.
#[derive(Debug, Clone)]
pub(crate) struct PortPair<'a> {
    what: &'a str,
    pub(crate) port1: &'a Port,
    pub(crate) port2: &'a Port,
    /// Unit vectors in the directions of the ports.
    pub(crate) forward1: Point,
    pub(crate) forward2: Point,
    /// Unit vector to the left of the first port.
    pub(crate) left1: Point,
}

impl<'a> PortPair<'a> {
    /// The pair of a route; refused if a number of a port is not finite.
    pub(crate) fn new(what: &'a str, port1: &'a Port, port2: &'a Port) -> Result<Self> {
        for (name, port) in [("port1", port1), ("port2", port2)] {
            let finite = port.midpoint().is_finite() && port.orientation().is_finite() && port.width().is_finite();
            if !finite || port.width() < 0.0 {
                return Err(refused(
                    what,
                    name,
                    port,
                    "have a finite midpoint and orientation, and a width of at least 0 µm",
                ));
            }
        }
        Ok(Self {
            what,
            port1,
            port2,
            forward1: forward(port1),
            forward2: forward(port2),
            left1: left_of(forward(port1)),
        })
    }

    /// The name of the route.
    pub(crate) fn what(&self) -> &'a str {
        self.what
    }

    /// From the first port to the second.
    pub(crate) fn span(&self) -> Point {
        self.port2.midpoint() - self.port1.midpoint()
    }

    /// A point in the frame of the first port: forwards and to the left (µm).
    pub(crate) fn to_local(&self, point: Point) -> Point {
        let from = point - self.port1.midpoint();
        Point::new(from.dot(self.forward1), from.dot(self.left1))
    }

    /// Distance of the second port in front of the first (µm).
    pub(crate) fn forward_distance(&self) -> f64 {
        self.span().dot(self.forward1)
    }

    /// Distance of the second port to the left of the first (µm).
    pub(crate) fn lateral_distance(&self) -> f64 {
        self.span().dot(self.left1)
    }

    /// Rotation of the second port against the first (degrees, three decimals, in `[0, 360)`).
    ///
    /// PHIDL tells 360 from 0, and then enters the second port from behind.
    pub(crate) fn turn(&self) -> f64 {
        let turn = round3((self.port2.orientation() - self.port1.orientation()).rem_euclid(360.0));
        if turn >= 360.0 { 0.0 } else { turn }
    }

    /// Refuses ports that are not turned by one of some angles against each other.
    pub(crate) fn check_turn(&self, allowed: &[f64], rule: &str) -> Result<()> {
        let turn = self.turn();
        match allowed.contains(&turn) {
            true => Ok(()),
            false => {
                Err(self.error(format_args!("the ports are turned by {turn}° against each other, but must be {rule}")))
            }
        }
    }

    /// Refuses a length that is less than it must be, with the difference. `what` is a noun with its article.
    pub(crate) fn check_room(&self, what: &str, length: f64, least: f64) -> Result<()> {
        match length >= least {
            true => Ok(()),
            false => Err(self.missing(what, length, least)),
        }
    }

    /// The error for a length that is less than it must be, with the difference.
    pub(crate) fn missing(&self, what: &str, length: f64, least: f64) -> Error {
        let (short, least, length) = (micrometers(least - length), micrometers(least), micrometers(length));
        self.error(format_args!("{what} is {length}, but must be at least {least}: {short} are missing"))
    }

    /// Refuses waypoints that do not start and end at the ports, leave the first one forwards and enter the second one
    /// from the front.
    pub(crate) fn check_waypoints(&self, points: &[Point]) -> Result<()> {
        let (first, last) = (points[0], points[points.len() - 1]);
        let off = first.distance(self.port1.midpoint()).max(last.distance(self.port2.midpoint()));
        if off.is_nan() || off > JOINT {
            let message =
                format_args!("the waypoints must start and end at the ports, but miss one by {}", micrometers(off));
            return Err(self.error(message));
        }
        let different = |from: Point| move |p: &&Point| p.distance(from) > JOINT;
        let second = points.iter().find(different(first));
        let before_last = points.iter().rev().find(different(last));
        let (Some(second), Some(before_last)) = (second, before_last) else {
            return Err(self.error("the ports are at one position, so there is nothing to draw"));
        };
        self.check_leg("the first leg must leave port1 along its orientation", *second - first, self.forward1)?;
        self.check_leg("the last leg must enter port2 against its orientation", last - *before_last, -self.forward2)
    }

    /// Refuses a first or last leg that is not on the axis of its port.
    fn check_leg(&self, rule: &str, leg: Point, along: Point) -> Result<()> {
        let ahead = leg.dot(along);
        if ahead.abs() <= JOINT {
            return Err(self.error(format_args!("{rule}, but leads sideways")));
        }
        if ahead <= 0.0 {
            return Err(self.error(format_args!("{rule}, but leads {} backwards", micrometers(-ahead))));
        }
        let beside = leg.cross(along).abs();
        if beside > BESIDE && beside > ahead * SKEW.to_radians() {
            return Err(self.error(format_args!("{rule}, but deviates by {} from the axis", micrometers(beside))));
        }
        Ok(())
    }

    /// The error for a rule between the ports: a sentence, with both ports before it.
    pub(crate) fn error(&self, message: impl std::fmt::Display) -> Error {
        Error::custom(self.what, format_args!("no route {}: {message}", self.between()))
    }

    /// Both ports, in a message.
    pub(crate) fn between(&self) -> String {
        format!("from {} to {}", title("port1", self.port1), title("port2", self.port2))
    }
}

/// The error for a parameter of a route.
pub(crate) fn refused(what: &str, param: &str, value: impl std::fmt::Display, rule: impl Into<String>) -> Error {
    ParamError { device: what.to_owned(), param: param.to_owned(), value: value.to_string(), rule: rule.into() }.into()
}

/// Refuses a length that is not finite and greater than zero.
pub(crate) fn check_positive(what: &str, param: &str, um: f64) -> Result<()> {
    match um > 0.0 && um.is_finite() {
        true => Ok(()),
        false => Err(refused(what, param, format_args!("{um} µm"), "be greater than 0 µm and finite")),
    }
}

/// Refuses a length that is not finite.
pub(crate) fn check_finite(what: &str, param: &str, um: f64) -> Result<()> {
    match um.is_finite() {
        true => Ok(()),
        false => Err(refused(what, param, format_args!("{um} µm"), "be finite")),
    }
}

/// A port in a message.
pub(crate) fn title(role: &str, port: &Port) -> String {
    let name = if port.name().is_empty() { role.to_owned() } else { format!("{role} \"{}\"", port.name()) };
    format!("{name} at {} facing {}°", port.midpoint(), port.orientation())
}

/// A length in a message, rounded to a picometer.
pub(crate) fn micrometers(um: f64) -> String {
    const PICOMETERS: f64 = 1e6;
    format!("{} µm", (um * PICOMETERS).round() / PICOMETERS)
}

/// The unit vector in the direction of a port, from the system's sine and cosine, also at multiples of 90°, as in PHIDL.
/// (Exact ones would move waypoints by 1e-14 µm only, but that decides whether a bend has 179 or 180 points.)
fn forward(port: &Port) -> Point {
    let (sin, cos) = port.orientation().to_radians().sin_cos();
    Point::new(cos, sin)
}

pub(crate) fn left_of(forward: Point) -> Point {
    Point::new(-forward.y, forward.x)
}

/// Three decimals, halves to even: the precision to which PHIDL compares lengths and angles.
pub(crate) fn round3(v: f64) -> f64 {
    (v * 1000.0).round_ties_even() / 1000.0
}

/// Whether two ports have opposite orientations.
pub(crate) fn opposite(port1: &Port, port2: &Port) -> bool {
    round3(angle::between(port1.orientation(), port2.orientation())) == 180.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn port(x: f64, y: f64, orientation: f64) -> Port {
        Port::new((x, y), 1, orientation)
    }

    #[test]
    fn the_second_port_is_measured_from_the_first() {
        let (a, b) = (port(1.0, 2.0, 90.0), port(-3.0, 12.0, 0.0));
        let pair = PortPair::new("test", &a, &b).unwrap();
        assert!((pair.forward_distance() - 10.0).abs() < 1e-12 && (pair.lateral_distance() - 4.0).abs() < 1e-12);
        assert_eq!(pair.turn(), 270.0);
    }

    #[test]
    fn a_full_turn_up_to_rounding_is_none() {
        let (a, b) = (port(0.0, 0.0, 0.0), port(9.0, 9.0, 359.999_999_99));
        assert_eq!(PortPair::new("test", &a, &b).unwrap().turn(), 0.0);
    }

    #[test]
    fn waypoints_that_miss_a_port_or_its_direction_are_refused() {
        let (a, b) = (port(0.0, 0.0, 0.0), port(10.0, 5.0, 270.0));
        let pair = PortPair::new("route", &a, &b).unwrap();
        let check =
            |points: &[(f64, f64)]| pair.check_waypoints(&points.iter().copied().map(Point::from).collect::<Vec<_>>());
        assert!(check(&[(0., 0.), (10., 0.), (10., 5.)]).is_ok());
        assert!(check(&[(0., 0.), (0., 0.), (10., 0.), (10., 5.)]).is_ok(), "a repeated point has no direction");
        assert!(check(&[(0., 0.), (10., 0.), (10., 4.)]).unwrap_err().to_string().contains("miss one by 1 µm"));
        assert!(check(&[(0., 0.), (-3., 0.), (-3., -2.), (10., -2.), (10., 5.)]).is_err(), "leaves backwards");
        assert!(check(&[(0., 0.), (12., 0.), (12., 9.), (10., 9.), (10., 5.)]).is_err(), "arrives from behind");
        assert!(check(&[(0., 0.), (10., 5.)]).is_err(), "leaves sideways");
    }

    #[test]
    fn ports_with_invalid_numbers_are_refused() {
        let valid = port(0.0, 0.0, 0.0);
        assert!(PortPair::new("route", &valid, &port(f64::NAN, 0.0, 0.0)).is_err());
        assert!(PortPair::new("route", &Port::new((0, 0), -1, 0), &valid).is_err());
    }
}
