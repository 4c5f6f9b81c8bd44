//! [`Bumps`]: the detours of a straight piece that add length.
//!
//! A bump has four corners: up, along, down, and on. As many as fit stand side by side, as high as the length requires.
//! Where the whole length is less than the gain of bends of 90°, there is one bump of flatter bends, so that every length
//! from the shortest on is possible (with gradual bends, a range above the shortest is not).
//!
//! The number of bumps is bounded by the points of their bends, before any is drawn.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::num::{angle, count};
use phidl_path::Bend as _;

use crate::RouteBend;
use crate::port_pair::left_of;

/// The flattest bends (degrees).
const FLATTEST: f64 = 0.1;
/// The flattest gradual bends (degrees): their slopes turn by 30°.
const FLATTEST_GRADUAL: f64 = 30.5;
/// Fraction of the gain of a flat bump that its bends add; its legs add the rest. It keeps legs long enough for their bends
/// when the line is corrected: a bend of three points instead of two adds a fifth more.
const BY_BENDS: f64 = 0.75;
/// The same for bends of 90°, whose many points make the correction small.
const BY_SQUARE_BENDS: f64 = 0.999;
/// Number of bisections of the angle of flat bends: to the last bit.
const BISECTIONS: usize = 60;
/// Maximum number of points in all bends.
const MOST_POINTS: f64 = (1 << 20) as f64;
/// Shortfall of a room that is accepted as rounding (in bumps).
const ROUNDING: f64 = 1e-9;

/// The bumps on a straight piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bumps {
    count: usize,
    /// Turn of the bends (degrees).
    angle: f64,
    /// Distance before its corner at which a bend starts (µm).
    extent: f64,
    /// Gain in length of four bends with the shortest legs (µm).
    gain: f64,
    /// Extent of the bends at the corners of the route itself (µm).
    corner: f64,
    /// Length of a rising or falling leg, from corner to corner (µm).
    rise: f64,
}

impl Bumps {
    /// The bumps that add a length in a room (µm), which may be too small for them; `None` if the flattest bump adds more.
    pub(super) fn adding(added: f64, room: f64, bend: RouteBend, radius: f64) -> Result<Option<Self>> {
        let square = Self::lowest(90.0, bend, radius)?;
        let least = square.gain / BY_SQUARE_BENDS;
        if added < least {
            return Self::flat(added, bend, radius);
        }
        let points = bend.bend(radius, 90.0)?.points().len();
        let affordable = MOST_POINTS / (4 * points) as f64;
        let most = (room / square.span() + ROUNDING).min(added / least).min(affordable).floor();
        let mut bumps = Self { count: count::nearest(most).max(1), ..square };
        bumps.lengthen(added - square.gain * bumps.count as f64);
        Ok(Some(bumps))
    }

    /// The smallest gain of a bump (µm).
    pub(super) fn least(bend: RouteBend, radius: f64) -> Result<f64> {
        Ok(Self::lowest(flattest(bend), bend, radius)?.gain / BY_BENDS)
    }

    /// One bump of bends that turn by less than a right angle.
    fn flat(added: f64, bend: RouteBend, radius: f64) -> Result<Option<Self>> {
        let lowest = |angle: f64| Self::lowest(angle, bend, radius);
        let (mut flatter, mut steeper) = (flattest(bend), 90.0);
        if BY_BENDS * added < lowest(flatter)?.gain {
            return Ok(None);
        }
        for _ in 0..BISECTIONS {
            let middle = (flatter + steeper) / 2.0;
            *(if lowest(middle)?.gain <= BY_BENDS * added { &mut flatter } else { &mut steeper }) = middle;
        }
        let mut bumps = lowest(flatter)?;
        bumps.lengthen(added - bumps.gain);
        Ok(Some(bumps))
    }

    /// One bump with the shortest legs for bends of an angle.
    fn lowest(angle: f64, bend: RouteBend, radius: f64) -> Result<Self> {
        let path = bend.bend(radius, angle)?;
        let extent = path.end().norm() / 2.0 / (angle / 2.0).to_radians().cos();
        let gain = 4.0 * (path.length() - extent * (1.0 + cos(angle)));
        Ok(Self { count: 1, angle, extent, gain, corner: bend.extent(radius, 90.0)?, rise: 2.0 * extent })
    }

    /// Lengthens the legs so that together they add a length (µm).
    pub(super) fn lengthen(&mut self, added: f64) {
        self.rise += added / (self.count as f64 * 2.0 * (1.0 - cos(self.angle)));
    }

    /// Height to the side (µm).
    pub(super) fn height(&self) -> f64 {
        self.rise * angle::sin_cos(self.angle).0
    }

    /// Distance from the first corner of a bump to its last (µm); its roof is as short as its bends allow.
    fn base(&self) -> f64 {
        2.0 * self.extent + 2.0 * self.rise * cos(self.angle)
    }

    /// Straight length of all bumps, with the bends at both ends (µm).
    pub(super) fn span(&self) -> f64 {
        self.count as f64 * (self.base() + 2.0 * self.extent)
    }

    /// The waypoints with bumps in the middle of a leg, on a side (1 left, −1 right).
    pub(super) fn inserted(&self, points: &[Point], leg: usize, side: f64) -> Vec<Point> {
        let (from, to) = (points[leg], points[leg + 1]);
        let along = (to - from) / from.distance(to);
        let up = left_of(along) * side;
        let (sin, cos) = angle::sin_cos(self.angle);
        // Only inner ends of a leg have a bend; the bumps are centered on the rest.
        let inner = |is_inner: bool| if is_inner { self.corner } else { 0.0 };
        let straight = (inner(leg > 0), from.distance(to) - inner(leg + 2 < points.len()));
        let start = (straight.0 + straight.1 - self.span()) / 2.0 + self.extent;
        let bump = |i: usize| {
            let first = from + along * (start + i as f64 * (self.base() + 2.0 * self.extent));
            let (rise, roof) = (along * (self.rise * cos) + up * (self.rise * sin), along * (2.0 * self.extent));
            let fall = along * (self.rise * cos) - up * (self.rise * sin);
            [first, first + rise, first + rise + roof, first + rise + roof + fall]
        };
        let bumps = (0..self.count).flat_map(bump);
        points[..=leg].iter().copied().chain(bumps).chain(points[leg + 1..].iter().copied()).collect()
    }
}

fn flattest(bend: RouteBend) -> f64 {
    if bend == RouteBend::Gradual { FLATTEST_GRADUAL } else { FLATTEST }
}

fn cos(degrees: f64) -> f64 {
    angle::sin_cos(degrees).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bump_of_arcs_adds_what_four_arcs_are_longer_than_their_chords() {
        for angle in [20.0_f64, 45.0, 90.0] {
            let gain = Bumps::lowest(angle, RouteBend::Circular, 10.0).unwrap().gain;
            let exact = 40.0 * (angle.to_radians() - angle.to_radians().sin());
            assert!((gain - exact).abs() < 1e-3, "{gain} {exact}");
        }
    }

    #[test]
    fn the_number_of_bumps_follows_from_room_and_length() {
        // A bump of arcs of 10 µm takes 40 µm and adds 40 (π/2 − 1) = 22.8 µm.
        let count = |added, room| Bumps::adding(added, room, RouteBend::Circular, 10.0).unwrap().unwrap().count;
        assert_eq!([count(1000.0, 100.0), count(1000.0, 120.0), count(50.0, 500.0), count(3.0, 500.0)], [2, 3, 2, 1]);
    }
}
