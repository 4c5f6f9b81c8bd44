//! The shortest clear line where the ordinary waypoints run over themselves.
//!
//! All lines of up to six corners are tried whose legs lie on a small set of coordinates: those of the two ports and up to
//! four bend extents beside them. A maze router on a finer grid was rejected: it would sometimes find shorter lines, but its
//! lines would jump from one position of the ports to the next, and it would succeed for no more positions (a test tries two
//! more corners, and half the step). Where there is no line, there is no room between the two ports.

use phidl_core::Result;
use phidl_core::geom::Point;

use super::footprint::{Footprint, Wire};
use crate::port_pair::{PortPair, left_of};

/// Shortfall of a leg that is accepted as rounding (µm).
const ROOM: f64 = 1e-9;

/// The lines that are tried.
struct SearchGrid {
    /// Maximum number of corners.
    corners: usize,
    /// Where their legs may lie, in reaches beside a port; of lines that are equally long the first is taken.
    beside: &'static [f64],
}

const DEFAULT: SearchGrid = SearchGrid { corners: 6, beside: &[1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0, 0.0] };

/// The shortest line with the fewest corners on which a wire does not run over itself or over an obstacle. Legs have room
/// for bends of this extent (µm). Obstacles are in the frame of the first port.
pub(crate) fn shortest(
    pair: &PortPair<'_>,
    extent: f64,
    wire: &mut Wire,
    obstacles: &[Footprint],
) -> Result<Option<Vec<Point>>> {
    shortest_of(&DEFAULT, pair, extent, wire, obstacles)
}

fn shortest_of(
    tried: &SearchGrid,
    pair: &PortPair<'_>,
    extent: f64,
    wire: &mut Wire,
    obstacles: &[Footprint],
) -> Result<Option<Vec<Point>>> {
    let goal = pair.to_local(pair.port2.midpoint());
    // Exact, since the ports are turned by a multiple of 90° but for noise.
    let enter = -Point::polar(1.0, pair.turn());
    let lines = [goal.x, goal.y].map(|coordinate| beside(tried, coordinate, extent));
    let (line, footprints, last) = (Vec::new(), Vec::new(), [goal, enter]);
    let mut search =
        DetourSearch { goal, enter, extent, lines, corners: 0, wire, obstacles, last, line, footprints, best: None };
    let fewest = if enter.x == 0.0 { 1 } else { 2 };
    for corners in (fewest..=tried.corners).step_by(2) {
        search.corners = corners;
        if let Some(line) = search.run()? {
            let start = pair.port1.midpoint();
            let place = |p: &Point| start + pair.forward1 * p.x + pair.left1 * p.y;
            let corners = line[..line.len() - 1].iter().map(place);
            return Ok(Some(corners.chain([pair.port2.midpoint()]).collect()));
        }
    }
    Ok(None)
}

/// Coordinates on which legs may lie: beside the first port, at 0, and beside the second.
fn beside(tried: &SearchGrid, coordinate: f64, extent: f64) -> Vec<f64> {
    let mut lines: Vec<f64> = Vec::with_capacity(2 * tried.beside.len());
    for line in tried.beside.iter().flat_map(|step| [step * extent, coordinate + step * extent]) {
        if lines.iter().all(|known| (known - line).abs() > ROOM) {
            lines.push(line);
        }
    }
    lines
}

/// A search in the frame of the first port, depth first; what is already longer than the best is cut off. The last corner
/// is chosen first, for it is between the two ends that there is no room.
struct DetourSearch<'a> {
    goal: Point,
    /// Direction in which the goal is entered.
    enter: Point,
    extent: f64,
    /// Coordinates on which legs may lie: of x, and of y.
    lines: [Vec<f64>; 2],
    corners: usize,
    wire: &'a mut Wire,
    obstacles: &'a [Footprint],
    /// The last corner, and the direction in which it is reached.
    last: [Point; 2],
    /// The corners so far, from the start on.
    line: Vec<Point>,
    /// What the wire covers so far, at its end and from its start on.
    footprints: Vec<Footprint>,
    best: Option<(f64, Vec<Point>)>,
}

impl DetourSearch<'_> {
    /// The best line with this number of corners.
    fn run(&mut self) -> Result<Option<Vec<Point>>> {
        let (enter, across) = (self.enter, left_of(self.enter));
        let bend = self.wire.extent(across, enter)?;
        for corner in self.last_corners() {
            for arrive in [across, -across] {
                self.last = [corner, arrive];
                self.line = vec![Point::ORIGIN];
                let end = [
                    self.wire.leg(self.corners, corner + enter * bend, self.goal),
                    self.wire.corner(self.corners, corner, arrive, enter)?,
                ];
                if end.iter().all(|footprint| self.is_clear(footprint)) {
                    self.footprints.extend(end);
                    self.extend(0.0)?;
                }
                self.footprints.clear();
            }
        }
        Ok(self.best.take().map(|(_, line)| line))
    }

    /// The corners from which the goal may be entered.
    fn last_corners(&self) -> Vec<Point> {
        let (goal, enter) = (self.goal, self.enter);
        let lines = if enter.x == 0.0 { &self.lines[1] } else { &self.lines[0] };
        let corner = |line: &f64| if enter.x == 0.0 { Point::new(goal.x, *line) } else { Point::new(*line, goal.y) };
        let far_enough = |corner: &Point| (goal - *corner).dot(enter) >= self.extent - ROOM;
        lines.iter().map(corner).filter(far_enough).collect()
    }

    /// Adds every corner that may come next; the one before the last lies on the leg that leads there.
    fn extend(&mut self, length: f64) -> Result<()> {
        let leg = self.line.len() - 1;
        let [last, arrive] = self.last;
        if leg + 1 == self.corners {
            let ahead = (last - self.line[leg]).dot(arrive);
            let straight = (last - self.line[leg]).cross(arrive).abs() <= ROOM;
            return if straight && ahead > 0.0 { self.step(last, length) } else { Ok(()) };
        }
        let from = self.line[leg];
        let along_x = leg.is_multiple_of(2);
        let choices = match leg + 2 == self.corners {
            true => vec![if along_x { last.x } else { last.y }],
            false => self.lines[leg % 2].clone(),
        };
        for to in choices {
            self.step(if along_x { Point::new(to, from.y) } else { Point::new(from.x, to) }, length)?;
        }
        Ok(())
    }

    /// Goes on from a corner if its leg is long enough and lies on nothing, and if the line can still be the shortest.
    fn step(&mut self, next: Point, length: f64) -> Result<()> {
        let leg = self.line.len() - 1;
        let from = self.line[leg];
        let own = from.distance(next);
        let long_enough = if leg == 0 { next.x >= self.extent - ROOM } else { own >= 2.0 * self.extent - ROOM };
        let rest = self.last[0] - next;
        let shortest = length + own + rest.x.abs() + rest.y.abs() + self.last[0].distance(self.goal);
        if !long_enough || !self.improves(shortest) {
            return Ok(());
        }
        let covered = self.footprints.len();
        self.line.push(next);
        if self.cover_last_leg()? {
            if leg + 1 == self.corners {
                self.best = Some((shortest, [&self.line[..], &[self.goal]].concat()));
            } else {
                self.extend(length + own)?;
            }
        }
        self.line.pop();
        self.footprints.truncate(covered);
        Ok(())
    }

    /// Adds the last leg so far, between two corners, and the bend before it, if they lie on nothing.
    fn cover_last_leg(&mut self) -> Result<bool> {
        let leg = self.line.len() - 2;
        let (from, to) = (self.line[leg], self.line[leg + 1]);
        let along = (to - from) / from.distance(to);
        let bend = self.wire.extent(along, left_of(along))?;
        let start = if leg == 0 { from } else { from + along * bend };
        let straight = self.wire.leg(leg, start, to - along * bend);
        if !self.is_clear(&straight) {
            return Ok(false);
        }
        self.footprints.push(straight);
        if leg == 0 {
            return Ok(true);
        }
        let before = (from - self.line[leg - 1]) / from.distance(self.line[leg - 1]);
        let corner = self.wire.corner(leg, from, before, along)?;
        let clear = self.is_clear(&corner);
        self.footprints.push(corner);
        Ok(clear)
    }

    fn is_clear(&self, footprint: &Footprint) -> bool {
        !self.obstacles.iter().any(|obstacle| obstacle.overlaps(footprint))
            && !self.footprints.iter().any(|other| footprint.lies_on(other))
    }

    /// Whether a length is less than that of the best line by more than rounding: of lines that are equally long, the
    /// first one is kept.
    fn improves(&self, length: f64) -> bool {
        self.best.as_ref().is_none_or(|(best, _)| length < best - ROOM)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manhattan::RouteBend;
    use crate::manhattan::crossing::crossings;
    use phidl_core::port::Port;

    /// Placements all around a port that looks up.
    fn placements(most: i32) -> impl Iterator<Item = [Port; 2]> {
        let places = (-most..=most).flat_map(move |x| (-most..=most).map(move |y| (x, y)));
        let ports = |(x, y)| (0..4).map(move |turn| [Port::new((3, 1), 2, 90), Port::new((x, y), 2, 90 * turn)]);
        places.flat_map(ports)
    }

    #[test]
    fn lines_have_room_for_their_bends_and_do_not_cross() {
        let mut found = 0;
        for [a, b] in placements(12) {
            let pair = PortPair::new("test", &a, &b).unwrap();
            let Some(line) = shortest(&pair, 3.0, &mut Wire::sharp(), &[]).unwrap() else { continue };
            let lengths: Vec<f64> = line.windows(2).map(|leg| leg[0].distance(leg[1])).collect();
            assert!(lengths.iter().all(|length| *length >= 3.0 - 1e-9), "{line:?}");
            assert!(lengths[1..lengths.len() - 1].iter().all(|length| *length >= 6.0 - 1e-9), "{line:?}");
            assert_eq!(crossings(&line), 0);
            pair.check_waypoints(&line).unwrap();
            found += 1;
        }
        assert!(found > 2000, "{found} of 2500 positions have a clear line");
    }

    #[test]
    fn more_corners_and_a_finer_grid_find_a_line_for_no_more_positions() {
        const FINE: [f64; 17] =
            [1.0, -1.0, 1.5, -1.5, 2.0, -2.0, 2.5, -2.5, 3.0, -3.0, 3.5, -3.5, 4.0, -4.0, 5.0, -5.0, 0.0];
        let (mut none, mut found) = (0, 0);
        for [a, b] in placements(4) {
            let pair = PortPair::new("test", &a, &b).unwrap();
            let mut wire = Wire::with_bends(2.0, RouteBend::Circular, 3.0);
            if shortest(&pair, 3.1, &mut wire, &[]).unwrap().is_some() {
                found += 1;
                continue;
            }
            for more in [SearchGrid { corners: 8, ..DEFAULT }, SearchGrid { corners: 6, beside: &FINE }] {
                let line = shortest_of(&more, &pair, 3.1, &mut wire, &[]).unwrap();
                assert_eq!(line, None, "from {a} to {b}");
            }
            none += 1;
        }
        assert!(none > 20 && found > 20, "{none} without a line, {found} with one");
    }
}
