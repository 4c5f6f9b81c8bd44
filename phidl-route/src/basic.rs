//! [`route_basic`].

use std::f64::consts::PI;

use phidl_core::num::{angle, count};
use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

use crate::port_pair::{PortPair, left_of, opposite};

/// The law of a change between the ends of a [`route_basic`](fn@route_basic).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum RouteProfile {
    /// As a raised cosine: without a kink at either end.
    #[default]
    Sine,
    /// In proportion.
    Straight,
}

impl RouteProfile {
    /// The fraction of the change at a fraction `t` of the forward distance.
    fn fraction(self, t: f64) -> f64 {
        match self {
            Self::Straight => t,
            Self::Sine => (1.0 - (PI * t).cos()) / 2.0,
        }
    }
}

/// Largest distance of a chord from the line (µm), measured in the middle of its `t`; PHIDL's number.
const CHORD: f64 = 0.01;
/// Maximum number of times a chord is halved: it bounds the memory for lines that go sideways by meters.
const HALVINGS: u32 = 12;

/// Draws one smooth piece between two ports that face each other; they need not lie on one axis.
///
/// ```text
///              ╭────┤ port2
///            ╱
///   port1 ├─╯
/// ```
///
/// # Ports
/// `1` on `port1`, as wide as the piece starts, and `2` on `port2`, as wide as it ends, facing them.
///
/// # Info
/// `length` of the centerline through its points (µm); `bends`: 2, or 0 if it is straight; `smallest_radius` of the
/// curve: 2F²/(π²|L|) at both ends, for a piece that goes F forwards and L to the side (µm; null if it is straight).
///
/// # Errors
/// The ports must be turned by 180° against each other (to 0.0005°), `port2` in front of `port1`.
///
/// # Numerics
/// In the frame of `port1`, with t from 0 to 1, a sine is (F t, L (1 − cos πt)/2), and its width is measured square to
/// it. A straight piece is (F t, L t), but its width is measured square to the ports, which makes its ends meet them.
/// There are `num_path_pts` values of t, evenly spaced. Where the line is more than 10 nm from the middle of a chord, the
/// chord is halved, as often as needed. The outline runs forwards on the left and back on the right.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteProfile, route_basic};
/// let s_bend = route_basic(((0, 0), 1, 0), ((40, 10), 2, 180), RouteProfile::Sine, RouteProfile::Straight, None, None, 99)?;
/// assert_eq!(s_bend.port("2")?.width(), 2.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL 1.5's `route_basic`.
#[device(picture = "docs/route_basic.svg", example = RouteBasicParams::new(((0, 0), 1, 0), ((40, 10), 2, 180)))]
pub fn route_basic(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// The law of the centerline to the side.
    #[default(RouteProfile::Sine)]
    path_type: RouteProfile,
    /// The law of the width.
    #[default(RouteProfile::Straight)]
    width_type: RouteProfile,
    /// Width at the start, that of `port1` if not given.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width1: Option<f64>,
    /// Width at the end, that of `port2` if not given.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width2: Option<f64>,
    /// Number of points of the centerline, at least 2; more are added where chords deviate by more than 10 nm.
    #[default(99)]
    num_path_pts: usize,
    /// Where it is drawn.
    #[default(0)]
    #[param(named)]
    layer: Layers,
) -> Result<Device> {
    check.at_least("num_path_pts", num_path_pts, 2)?;
    check.at_most("num_path_pts", num_path_pts, count::MOST)?;
    let pair = PortPair::new("route_basic", &port1, &port2)?;
    let line = Centerline::between(&pair, path_type)?;
    let widths = [width1.unwrap_or(port1.width()), width2.unwrap_or(port2.width())];
    let samples = line.samples(num_path_pts);

    let mut d = Device::builder("route_basic");
    d.add_polygon(
        line.outline(&pair, &samples, |t| widths[0] + (widths[1] - widths[0]) * width_type.fraction(t)),
        layer,
    )?;
    d.add_port("1", port1.flipped().with_width(widths[0]))?;
    d.add_port("2", (port2.midpoint(), widths[1], port1.orientation()))?;
    let points: Vec<Point> = samples.iter().map(|t| line.at(*t)).collect();
    let length: f64 = points.windows(2).map(|chord| chord[0].distance(chord[1])).sum();
    let radius = line.smallest_radius();
    d.info("length", length).info("bends", if radius.is_some() { 2 } else { 0 }).info("smallest_radius", radius);
    d.build()
}

/// A centerline in the frame of the first port.
struct Centerline {
    forwards: f64,
    lateral: f64,
    profile: RouteProfile,
}

impl Centerline {
    fn between(pair: &PortPair<'_>, profile: RouteProfile) -> Result<Self> {
        if !opposite(pair.port1, pair.port2) {
            let turn = angle::between(pair.port1.orientation(), pair.port2.orientation());
            return Err(
                pair.error(format_args!("the ports must face each other, but are turned by {turn}° instead of 180°"))
            );
        }
        let forwards = pair.forward_distance();
        match forwards > 0.0 {
            true => Ok(Self { forwards, lateral: pair.lateral_distance(), profile }),
            false => Err(pair.missing("the distance of port2 ahead of port1", forwards, f64::MIN_POSITIVE)),
        }
    }

    fn at(&self, t: f64) -> Point {
        Point::new(self.forwards * t, self.lateral * self.profile.fraction(t))
    }

    /// The unit vector to the left, across which the width is measured.
    fn left_at(&self, t: f64) -> Point {
        let along = match self.profile {
            RouteProfile::Straight => Point::new(self.forwards, 0.0),
            RouteProfile::Sine => Point::new(self.forwards, self.lateral * PI * (PI * t).sin() / 2.0),
        };
        left_of(along / along.norm())
    }

    /// The values of t at its points.
    fn samples(&self, num_path_pts: usize) -> Vec<f64> {
        let mut samples: Vec<f64> = Vec::with_capacity(num_path_pts);
        for t in count::linspace(0.0, 1.0, num_path_pts) {
            if let Some(before) = samples.last().copied() {
                self.halve(before, t, HALVINGS, &mut samples);
            }
            samples.push(t);
        }
        samples
    }

    /// Adds points between two, as many as keep the chords close to the line.
    fn halve(&self, from: f64, to: f64, most: u32, samples: &mut Vec<f64>) {
        let middle = (from + to) / 2.0;
        let chord = (self.at(from) + self.at(to)) / 2.0;
        if most > 0 && chord.distance(self.at(middle)) > CHORD {
            self.halve(from, middle, most - 1, samples);
            samples.push(middle);
            self.halve(middle, to, most - 1, samples);
        }
    }

    /// Forwards on the left, back on the right.
    fn outline(&self, pair: &PortPair<'_>, samples: &[f64], width: impl Fn(f64) -> f64) -> Vec<Point> {
        let place = |p: Point| pair.port1.midpoint() + pair.forward1 * p.x + pair.left1 * p.y;
        let edge = |side: f64| {
            let at = |t: &f64| place(self.at(*t) + self.left_at(*t) * (side * width(*t) / 2.0));
            samples.iter().map(at).collect::<Vec<Point>>()
        };
        let (mut outline, right) = (edge(1.0), edge(-1.0));
        outline.extend(right.into_iter().rev());
        outline
    }

    /// The curvature L π² cos(πt) / 2F² over the third power of the slope's length is largest at the ends, where the
    /// slope is along the axis.
    fn smallest_radius(&self) -> Option<f64> {
        let curved = self.profile == RouteProfile::Sine && self.lateral != 0.0;
        curved.then(|| 2.0 * self.forwards.powi(2) / (PI.powi(2) * self.lateral.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn to(x: f64, y: f64, orientation: f64) -> Result<Device> {
        RouteBasicParams::new(((0, 0), 1, 0), ((x, y), 2, orientation)).build()
    }

    #[test]
    fn a_straight_piece_has_the_area_of_a_trapezoid_and_ends_square_to_its_ports() {
        let params = RouteBasicParams::new(((0, 0), 1, 0), ((10, 4), 3, 180)).path_type(RouteProfile::Straight);
        let d = params.num_path_pts(2).build().unwrap();
        let outline = d.polygons().next().unwrap();
        let expected = [(0.0, 0.5), (10.0, 5.5), (10.0, 2.5), (0.0, -0.5)].map(Point::from);
        assert!(outline.points.iter().zip(expected).all(|(p, q)| p.distance(q) < 1e-12));
        assert!((outline.area() - 20.0).abs() < 1e-12);
        assert_eq!(d.info()["bends"].as_f64(), Some(0.0));
    }

    #[test]
    fn the_smallest_radius_is_that_of_the_circle_through_the_first_points() {
        let d = to(40.0, 10.0, 180.0).unwrap();
        let line = Centerline { forwards: 40.0, lateral: 10.0, profile: RouteProfile::Sine };
        let p = line.at(1e-3);
        // A circle that leaves the origin along x goes through (x, y) if its radius is (x² + y²) / 2y.
        let radius = (p.x * p.x + p.y * p.y) / (2.0 * p.y);
        assert!((d.info()["smallest_radius"].as_f64().unwrap() - radius).abs() < 1e-3 * radius);
    }

    #[test]
    fn chords_stay_close_to_the_line_for_any_number_of_points() {
        let line = Centerline { forwards: 30.0, lateral: 40.0, profile: RouteProfile::Sine };
        let samples = line.samples(5);
        for pair in samples.windows(2) {
            let chord = (line.at(pair[0]) + line.at(pair[1])) / 2.0;
            assert!(chord.distance(line.at((pair[0] + pair[1]) / 2.0)) <= 0.01);
        }
        assert!(samples.is_sorted() && samples.len() > 5);
    }

    #[test]
    fn ports_that_do_not_face_each_other_are_refused() {
        assert!(to(40.0, 10.0, 170.0).is_err() && to(40.0, 10.0, 0.0).is_err());
        assert!(to(40.0, 10.0, 180.0004).is_ok());
        let error = to(-3.0, 1.0, 180.0).unwrap_err().to_string();
        assert!(
            error.contains("the distance of port2 ahead of port1 is -3 µm") && error.contains("3 µm are missing"),
            "{error}"
        );
        assert!(RouteBasicParams::new(((0, 0), 1, 0), ((9, 0), 1, 180)).num_path_pts(1).build().is_err());
    }
}
