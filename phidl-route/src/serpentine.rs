//! Routes of a given length: [`route_serpentine`] and [`delay_line`].
//!
//! What a route lacks in length is made up on its longest straight piece, in bumps to one side: four corners each, as
//! many bumps as there is room for, and as high as the length asks for. Where the whole of it is less than what bends of
//! 90° add, there is one bump of flatter bends. So every length from the shortest on can be had (with gradual bends,
//! those between are missing). The alternative, changing the radius, would change what the bends do to the light.
//!
//! The length is that of the line that is drawn, the sum over its chords, and it is met to far less than a step of the
//! grid: the height is corrected once more by what the finished line lacks.

use phidl_core::error::ParamError;
use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::{Bend as _, Path};

use crate::RouteBend;
use crate::manhattan::{bent, crossing, way_points};
use crate::request::{Request, check_positive, left_of};

/// To how much a length is met (µm): a tenth of a step of the usual database grid.
const EXACT: f64 = 1e-4;
/// The flattest bends (degrees).
const FLATTEST: f64 = 0.1;
/// The flattest gradual bends (degrees): their slopes turn by 30°.
const FLATTEST_GRADUAL: f64 = 30.5;
/// How much of what a flat bump adds is left to its bends; the rest is added by its legs. It keeps legs long enough for
/// their bends when the line is corrected: a bend of three points instead of two is a fifth longer in what it adds.
const BY_BENDS: f64 = 0.75;
/// The same for bends of 90°, which have so many points that one more or less hardly counts.
const BY_SQUARE_BENDS: f64 = 0.999;
/// How often the angle of flat bends is bisected: to the last bit.
const BISECTIONS: usize = 60;

/// Draws a wire of a given length between two ports at right angles, in bumps on its longest straight piece.
///
/// ```text
///             ╭─╮ ╭─╮ ╭─╮
///   port1 ├───╯ ╰─╯ ╰─╯ ╰───┤ port2
/// ```
///
/// Otherwise it is [`route_manhattan`](fn@crate::route_manhattan). The bumps are on the left of the way, or on its right
/// where they would cross it on the left.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as `port1`.
///
/// # Info
/// `length`: that of the drawn centerline, within 0.1 nm of what was asked for; `bends`, and `smallest_radius` (µm).
///
/// # Errors
/// As for [`route_manhattan`](fn@crate::route_manhattan); and if the length is less than that of the plain route, if no
/// straight piece has room for a bump, if the bumps would be higher than `max_height` or cross the route on both sides:
/// each with what is missing.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, route_serpentine};
/// let wire = route_serpentine(((0, 0), 1, 0), ((300, 80), 1, 180), 1000, RouteBend::Euler, 10, 1)?;
/// assert!((wire.info()["length"].as_f64().unwrap() - 1000.0).abs() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design.
#[device(picture = "docs/route_serpentine.svg", example = RouteSerpentineParams::new(((0, 0), 2, 0), ((300, 80), 2, 180), 1000))]
pub fn route_serpentine(
    /// Where it starts; its width is that of the route.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Length of the centerline from port to port.
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Radius of the bends: of the centerline; effective for Euler bends, smallest for gradual ones.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// How far the bumps may reach to the side.
    #[default(None)]
    #[param(unit = "um", named, above = 0.0)]
    max_height: Option<f64>,
) -> Result<Device> {
    let request = Request::new("route_serpentine", &port1, &port2)?;
    Serpentine { request: &request, length, bend, radius, max_height }.drawn(&layer)?.build()
}

/// Draws a wire of a given length on a given span: a delay line.
///
/// ```text
///        ╭─╮ ╭─╮ ╭─╮
///   1 ├──╯ ╰─╯ ╰─╯ ╰──┤ 2      from (0, 0) to (span, 0)
/// ```
///
/// # Ports
/// `1` at the origin, facing 180°, and `2` at the end of the span, facing 0°.
///
/// # Info
/// As for [`route_serpentine`](fn@route_serpentine).
///
/// # Errors
/// As for [`route_serpentine`](fn@route_serpentine): the length must be at least the span, and the span have room.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, delay_line};
/// let line = delay_line(2000, 200, 0.5, RouteBend::Circular, 5, 1)?;
/// assert!((line.info()["length"].as_f64().unwrap() - 2000.0).abs() < 1e-4);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design.
#[device(picture = "docs/delay_line.svg")]
pub fn delay_line(
    /// Length of the centerline.
    #[default(1000.0)]
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// Distance of its ends.
    #[default(200.0)]
    #[param(unit = "um", above = 0.0)]
    span: f64,
    /// Width of the wire.
    #[default(1.0)]
    #[param(unit = "um", above = 0.0)]
    width: f64,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Radius of the bends: of the centerline; effective for Euler bends, smallest for gradual ones.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (port1, port2) = (Port::new((0, 0), width, 0), Port::new((span, 0), width, 180));
    let request = Request::new("delay_line", &port1, &port2)?;
    Serpentine { request: &request, length, bend, radius, max_height: None }.drawn(&layer)?.build()
}

/// The way points of [`route_serpentine`](fn@route_serpentine) with bends at their corners, for an extrusion by hand.
///
/// # Errors
/// As for [`route_serpentine`](fn@route_serpentine), but that nothing is said of a width.
pub fn serpentine_centerline(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    length: impl Into<f64>,
    bend: RouteBend,
    radius: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2, length, radius) = (port1.into(), port2.into(), length.into(), radius.into());
    check_positive("serpentine_centerline", "length", length)?;
    let request = Request::new("serpentine_centerline", &port1, &port2)?;
    let points = Serpentine { request: &request, length, bend, radius, max_height: None }.points()?;
    Path::smooth(points, radius, bend)
}

/// A route on its way to its length.
struct Serpentine<'a> {
    request: &'a Request<'a>,
    length: f64,
    bend: RouteBend,
    radius: f64,
    max_height: Option<f64>,
}

/// The bumps on a straight piece.
#[derive(Debug, Clone, Copy)]
struct Bumps {
    count: usize,
    /// How far the bends turn.
    angle: f64,
    /// How far before its corner a bend starts (µm).
    reach: f64,
    /// How far the bends at the corners of the route itself reach (µm).
    corner: f64,
    /// Length of a rising or falling leg, from corner to corner (µm).
    rise: f64,
}

impl Serpentine<'_> {
    fn drawn(&self, layer: &Layers) -> Result<DeviceBuilder> {
        bent(self.request, &self.points()?, self.bend, self.radius, layer)
    }

    /// The way points with bumps.
    fn points(&self) -> Result<Vec<Point>> {
        let plain = way_points(self.request, self.bend, self.radius)?;
        let missing = self.length - self.measured(&plain)?;
        if missing.abs() <= EXACT {
            return Ok(plain);
        }
        if missing < 0.0 {
            return Err(self.request.missing("a length", self.length, self.length - missing));
        }
        let (leg, room) = self.roomiest(&plain)?;
        let mut bumps = self.bumps(missing, room)?;
        let side = self.side(&plain, leg, &bumps)?;
        // What the corners of the finished line lack for rounding is added to the legs.
        let lacking = self.length - self.measured(&bumps.inserted(&plain, leg, side))?;
        bumps.rise += bumps.rise_for(lacking);
        let points = bumps.inserted(&plain, leg, side);
        let left = self.length - self.measured(&points)?;
        match left.abs() <= EXACT {
            true => Ok(points),
            false => Err(self.request.missing("a length", self.length - left, self.length)),
        }
    }

    fn measured(&self, points: &[Point]) -> Result<f64> {
        Ok(Path::smooth(points, self.radius, self.bend)?.length())
    }

    /// The leg with the longest straight piece, the first of several, and how long that is (µm).
    fn roomiest(&self, points: &[Point]) -> Result<(usize, f64)> {
        let reach = self.bend.reach(self.radius)?;
        let last = points.len() - 2;
        let room = |i: usize| {
            let corners = u8::from(i > 0) + u8::from(i < last);
            points[i].distance(points[i + 1]) - f64::from(corners) * reach
        };
        Ok((1..=last).fold((0, room(0)), |best, i| if room(i) > best.1 { (i, room(i)) } else { best }))
    }

    /// The bumps that add a length in a room.
    fn bumps(&self, added: f64, room: f64) -> Result<Bumps> {
        let square = self.lowest(90.0)?;
        let gain = square.gain(self.radius, self.bend)?;
        let least = gain / BY_SQUARE_BENDS;
        if added < least {
            return self.flat(added, room);
        }
        self.request.check_room("a straight piece", room, square.span())?;
        let most = (room / square.span() + EXACT).min(added / least).floor();
        let count = phidl_core::num::count::nearest(most).max(1);
        let mut bumps = Bumps { count, ..square };
        bumps.rise += bumps.rise_for(added - gain * count as f64);
        self.check_height(&bumps)?;
        Ok(bumps)
    }

    /// One bump of bends that turn by less than a right angle.
    fn flat(&self, added: f64, room: f64) -> Result<Bumps> {
        let gain = |angle: f64| self.lowest(angle)?.gain(self.radius, self.bend);
        let mut flatter = if self.bend == RouteBend::Gradual { FLATTEST_GRADUAL } else { FLATTEST };
        let least = gain(flatter)?;
        if BY_BENDS * added < least {
            let longer = self.length - added + least / BY_BENDS;
            return Err(self.request.missing(
                "a length between the plain route and its flattest bump",
                self.length,
                longer,
            ));
        }
        let mut steeper = 90.0;
        for _ in 0..BISECTIONS {
            let middle = (flatter + steeper) / 2.0;
            *(if gain(middle)? <= BY_BENDS * added { &mut flatter } else { &mut steeper }) = middle;
        }
        let mut bumps = self.lowest(flatter)?;
        bumps.rise += bumps.rise_for(added - gain(flatter)?);
        self.request.check_room("a straight piece", room, bumps.span())?;
        self.check_height(&bumps)?;
        Ok(bumps)
    }

    /// One bump whose legs have just enough room for bends of an angle.
    fn lowest(&self, angle: f64) -> Result<Bumps> {
        let chord = self.bend.bend(self.radius, angle)?.end().norm();
        let reach = chord / 2.0 / (angle / 2.0).to_radians().cos();
        Ok(Bumps { count: 1, angle, reach, corner: self.bend.reach(self.radius)?, rise: 2.0 * reach })
    }

    fn check_height(&self, bumps: &Bumps) -> Result<()> {
        let height = bumps.rise * bumps.angle.to_radians().sin();
        match self.max_height {
            Some(most) if height > most => Err(self.request.missing("a max_height", most, height)),
            _ => Ok(()),
        }
    }

    /// The side (1 left, −1 right) on which the bumps do not cross the rest of the route.
    fn side(&self, plain: &[Point], leg: usize, bumps: &Bumps) -> Result<f64> {
        let before = crossing::crossings(plain);
        let clear = |side: &f64| crossing::crossings(&bumps.inserted(plain, leg, *side)) <= before;
        [1.0, -1.0].into_iter().find(clear).ok_or_else(|| {
            let error = ParamError {
                device: self.request.what().to_owned(),
                param: "length".to_owned(),
                value: format!("{} µm, bumps that cross the route {}", self.length, self.request.between()),
                rule: "leave one side of its longest straight piece free".to_owned(),
            };
            error.into()
        })
    }
}

impl Bumps {
    /// Length that a bump adds with legs just long enough (µm): the bends, less what its corners would be straight on.
    fn gain(&self, radius: f64, bend: RouteBend) -> Result<f64> {
        let (_, cos) = phidl_core::num::angle::sin_cos(self.angle);
        Ok(4.0 * (bend.bend(radius, self.angle)?.length() - self.reach * (1.0 + cos)))
    }

    /// By how much the legs must be longer to add a length (µm).
    fn rise_for(&self, added: f64) -> f64 {
        let (_, cos) = phidl_core::num::angle::sin_cos(self.angle);
        added / (self.count as f64 * 2.0 * (1.0 - cos))
    }

    /// Length along the way from the first corner of a bump to its last (µm); its roof is as short as its bends allow.
    fn base(&self) -> f64 {
        let (_, cos) = phidl_core::num::angle::sin_cos(self.angle);
        2.0 * self.reach + 2.0 * self.rise * cos
    }

    /// Straight length that all bumps need, with the bends at both ends (µm).
    fn span(&self) -> f64 {
        self.count as f64 * (self.base() + 2.0 * self.reach)
    }

    /// The way points with bumps in the middle of a leg.
    fn inserted(&self, points: &[Point], leg: usize, side: f64) -> Vec<Point> {
        let (from, to) = (points[leg], points[leg + 1]);
        let along = (to - from) / from.distance(to);
        let up = left_of(along) * side;
        let (sin, cos) = phidl_core::num::angle::sin_cos(self.angle);
        // Only inner ends of a leg have a bend; the middle of the straight piece is the middle of what these leave.
        let inner = |is_inner: bool| if is_inner { self.corner } else { 0.0 };
        let free = (inner(leg > 0), from.distance(to) - inner(leg + 2 < points.len()));
        let start = (free.0 + free.1 - self.span()) / 2.0 + self.reach;
        let bump = |i: usize| {
            let first = from + along * (start + i as f64 * (self.base() + 2.0 * self.reach));
            let (rise, roof) = (along * (self.rise * cos) + up * (self.rise * sin), along * (2.0 * self.reach));
            let fall = along * (self.rise * cos) - up * (self.rise * sin);
            [first, first + rise, first + rise + roof, first + rise + roof + fall]
        };
        let bumps = (0..self.count).flat_map(bump);
        points[..=leg].iter().copied().chain(bumps).chain(points[leg + 1..].iter().copied()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bump_of_arcs_adds_what_four_arcs_are_longer_than_their_chords() {
        let (a, b) = (Port::new((0, 0), 1, 0), Port::new((100, 0), 1, 180));
        let request = Request::new("test", &a, &b).unwrap();
        let s =
            Serpentine { request: &request, length: 0.0, bend: RouteBend::Circular, radius: 10.0, max_height: None };
        for angle in [20.0_f64, 45.0, 90.0] {
            let gain = s.lowest(angle).unwrap().gain(10.0, RouteBend::Circular).unwrap();
            let exact = 40.0 * (angle.to_radians() - angle.to_radians().sin());
            assert!((gain - exact).abs() < 1e-3, "{gain} {exact}");
        }
    }

    #[test]
    fn every_length_from_the_shortest_on_is_met() {
        for length in [100.0, 100.01, 101.0, 122.0, 123.0, 150.0, 400.0, 5000.0] {
            let path = serpentine_centerline(
                ((3, 4), 1, 30),
                (Point::new(3.0, 4.0) + Point::polar(100.0, 30.0), 1, 210),
                length,
                RouteBend::Circular,
                5,
            )
            .unwrap();
            assert!((path.length() - length).abs() <= 1e-4, "{length}: {}", path.length());
        }
    }

    #[test]
    fn what_cannot_be_is_refused_with_what_is_missing() {
        let error = delay_line(90, 100, 1, RouteBend::Circular, 5, 0).unwrap_err().to_string();
        assert!(error.contains("a length of 90 µm") && error.contains("10 µm are missing"), "{error}");
        let error = delay_line(200, 30, 1, RouteBend::Circular, 10, 0).unwrap_err().to_string();
        assert!(error.contains("a straight piece of 30 µm, but it must have at least 40 µm: 10 µm"), "{error}");
        let flat = RouteSerpentineParams::new(((0, 0), 1, 0), ((100, 0), 1, 180), 1000).max_height(50);
        assert!(flat.build().unwrap_err().to_string().contains("a max_height of 50 µm"));
    }

    #[test]
    fn bumps_turn_to_the_side_that_is_free() {
        // A C to the left: its long leg runs back above the ports, so that bumps on its left would cross the way.
        let (a, b) = (Port::new((0, 0), 1, 0), Port::new((-200, 5), 1, 180));
        let device = RouteSerpentineParams::new(&a, &b, 900).radius(5).build().unwrap();
        assert!((device.info()["length"].as_f64().unwrap() - 900.0).abs() < 1e-4);
    }
}
