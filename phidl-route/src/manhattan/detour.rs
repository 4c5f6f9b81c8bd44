//! The way round where the usual choice crosses itself.
//!
//! All lines of up to six corners are tried whose legs lie on a small set of coordinates: those of the two ports and up
//! to four reaches beside them. A maze router on a finer grid could find a way in more placements, but its lines would
//! jump from one placement to the next; and where the ports are so close that these do not do, the drawn wires would
//! touch whatever the line does.

use phidl_core::geom::Point;

use super::crossing;
use crate::request::Request;

/// Legs may be this much too short (µm): rounding.
const ROOM: f64 = 1e-9;

/// The shortest line with the fewest corners that does not cross itself, with room for bends that reach so far (µm).
pub(crate) fn shortest(request: &Request<'_>, reach: f64) -> Option<Vec<Point>> {
    let goal = Point::new(request.ahead(), request.aside());
    // Exact, since the ports are turned by a multiple of 90° but for noise.
    let enter = -Point::polar(1.0, request.turn());
    let fewest = if enter.x == 0.0 { 1 } else { 2 };
    let line = (fewest..=6).step_by(2).find_map(|corners| Search::new(goal, enter, reach, corners).run())?;
    let start = request.port1.midpoint();
    let place = |p: &Point| start + request.forward1 * p.x + request.left1 * p.y;
    let mut points: Vec<Point> = line.iter().map(place).collect();
    *points.last_mut()? = request.port2.midpoint();
    Some(points)
}

/// A search in the frame of the first port, depth first; what is already longer than the best is cut off.
struct Search {
    goal: Point,
    /// Direction in which the goal is entered.
    enter: Point,
    reach: f64,
    /// Coordinates on which legs may lie: of x, and of y.
    lines: [Vec<f64>; 2],
    corners: usize,
    best: Option<(f64, Vec<Point>)>,
}

impl Search {
    fn new(goal: Point, enter: Point, reach: f64, corners: usize) -> Self {
        let beside = |coordinate: f64| {
            let steps = [1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0, 0.0];
            steps.into_iter().flat_map(move |step| [step * reach, coordinate + step * reach]).collect()
        };
        Self { goal, enter, reach, lines: [beside(goal.x), beside(goal.y)], corners, best: None }
    }

    fn run(mut self) -> Option<Vec<Point>> {
        self.extend(&mut vec![Point::ORIGIN], 0.0);
        self.best.map(|(_, line)| line)
    }

    /// Adds every corner that may come next; the last one lies on the axis of the goal.
    fn extend(&mut self, line: &mut Vec<Point>, length: f64) {
        let leg = line.len() - 1;
        if leg == self.corners {
            return self.finish(line, length);
        }
        let along_x = leg.is_multiple_of(2);
        let goal = if along_x { self.goal.x } else { self.goal.y };
        let choices = if leg + 1 == self.corners { vec![goal] } else { self.lines[leg % 2].clone() };
        for to in choices {
            let from = line[leg];
            let next = if along_x { Point::new(to, from.y) } else { Point::new(from.x, to) };
            let long_enough =
                if leg == 0 { to >= self.reach - ROOM } else { from.distance(next) >= 2.0 * self.reach - ROOM };
            if long_enough {
                self.step(line, next, length);
            }
        }
    }

    fn step(&mut self, line: &mut Vec<Point>, next: Point, length: f64) {
        let from = line[line.len() - 1];
        let length = length + from.distance(next);
        let rest = self.goal - next;
        if self.improves(length + rest.x.abs() + rest.y.abs()) && !crossing::crosses_before([from, next], line) {
            line.push(next);
            self.extend(line, length);
            line.pop();
        }
    }

    fn finish(&mut self, line: &[Point], length: f64) {
        let from = line[line.len() - 1];
        let last = self.goal - from;
        let length = length + last.norm();
        let entered = last.dot(self.enter) >= self.reach - ROOM;
        if entered && self.improves(length) && !crossing::crosses_before([from, self.goal], line) {
            self.best = Some((length, [line, &[self.goal]].concat()));
        }
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
    use crate::manhattan::crossing::crossings;
    use phidl_core::port::Port;

    #[test]
    fn lines_have_room_for_their_bends_and_do_not_cross() {
        let a = Port::new((3, 1), 1, 90);
        let mut found = 0;
        for (x, y) in (-12..=12).flat_map(|x| (-12..=12).map(move |y| (f64::from(x), f64::from(y)))) {
            for orientation in [0, 90, 180, 270] {
                let b = Port::new((x, y), 1, orientation);
                let request = Request::new("test", &a, &b).unwrap();
                let Some(line) = shortest(&request, 3.0) else { continue };
                let lengths: Vec<f64> = line.windows(2).map(|leg| leg[0].distance(leg[1])).collect();
                assert!(lengths.iter().all(|length| *length >= 3.0 - 1e-9), "{line:?}");
                assert!(lengths[1..lengths.len() - 1].iter().all(|length| *length >= 6.0 - 1e-9), "{line:?}");
                assert_eq!(crossings(&line), 0);
                request.check_way(&line).unwrap();
                found += 1;
            }
        }
        assert!(found > 2000, "{found} of 2500 placements have a way round");
    }
}
