//! Bridges: what opens the counters of an outline font, so that it can be etched through.
//!
//! A bridge is a slab of constant width from a counter straight to the nearest area without ink: one above and one below
//! the counter, or, if neither fits, one on either side. Cutting it out changes contours only where its walls cross them:
//! two chains of corners between the walls go, and the walls join what is left. So the rest of the glyph keeps its
//! points, and nothing is rounded. A boolean engine would do the same on a grid; it is only asked to unite contours that
//! cross or cover each other, as variable fonts have them, since there the boundary of the ink is not drawn yet.

use phidl_boolean::grid::{self, GridPoint, Region};
use phidl_boolean::{BooleanError, RunOptions};
use phidl_core::geom::{Point, Rect, signed_area};

use super::opened;
use super::polygon::{contains, edges, segments_cross};

/// What is said of a glyph whose counters leave no room.
const NO_ROOM: &str = "a counter leaves no room for bridges as wide as stencil asks for";
/// Grid on which contours that cross are united, in font units: far finer than the grid that they are drawn on.
const UNITING: f64 = 1.0 / 1024.0;

/// The contours of a glyph with every counter opened by bridges of a width, in font units; or why that cannot be.
pub(super) fn bridged(contours: Vec<Vec<Point>>, width: f64) -> Result<Vec<Vec<Point>>, String> {
    let mut ink = Ink::new(contours)?;
    let counters: Vec<Vec<Point>> = ink.contours.iter().filter(|c| signed_area(c) < 0.0).cloned().collect();
    for counter in counters {
        let plan = [0, 1, 2, 3].map(|turns| Slab::above(&turned(&counter, turns), width));
        let opened = ink.cut(0, plan[0]) | ink.cut(2, plan[2]);
        if !opened {
            let _ = ink.cut(1, plan[1]) | ink.cut(3, plan[3]);
        }
    }
    let closed = ink.contours.iter().any(|contour| signed_area(contour) < 0.0);
    if closed { Err(NO_ROOM.to_owned()) } else { Ok(ink.contours) }
}

/// A contour turned clockwise by quarter turns, exactly.
fn turned(contour: &[Point], turns: usize) -> Vec<Point> {
    let turn = |p: &Point| match turns % 4 {
        0 => *p,
        1 => Point::new(p.y, -p.x),
        2 => -*p,
        _ => Point::new(-p.y, p.x),
    };
    contour.iter().map(turn).collect()
}

/// Where a bridge begins: its two walls and the height of the top of the counter at each.
#[derive(Debug, Clone, Copy)]
struct Slab {
    left: Point,
    right: Point,
}

impl Slab {
    /// Over the middle of a counter; none if the counter is narrower than the bridge.
    fn above(counter: &[Point], width: f64) -> Option<Self> {
        let middle = Rect::around(counter.iter().copied())?.center().x;
        let top = |x: f64| edges(counter).filter_map(|edge| meet(edge, x)).max_by(|a, b| a.y.total_cmp(&b.y));
        Some(Self { left: top(middle - width / 2.0)?, right: top(middle + width / 2.0)? })
    }

    fn holds(&self, chain: &[Point]) -> bool {
        chain.iter().all(|p| (self.left.x..=self.right.x).contains(&p.x))
    }
}

/// Where an edge meets an upright line. Of its ends, the right one counts.
fn meet((a, b): (Point, Point), x: f64) -> Option<Point> {
    ((a.x < x) != (b.x < x)).then(|| Point::new(x, a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))))
}

/// Where a wall meets a contour.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    contour: usize,
    /// The corner before it.
    edge: usize,
    at: Point,
}

/// The boundary of the ink: outer contours counter-clockwise, counters clockwise, so that the ink is on the left.
struct Ink {
    contours: Vec<Vec<Point>>,
}

impl Ink {
    fn new(mut contours: Vec<Vec<Point>>) -> Result<Self, String> {
        let largest = contours.iter().map(|c| signed_area(c)).max_by(|a, b| a.abs().total_cmp(&b.abs()));
        if largest.is_some_and(|area| area < 0.0) {
            contours.iter_mut().for_each(|contour| contour.reverse());
        }
        if any_crossing(&contours) || !contours.iter().all(|contour| is_boundary(contour, &contours)) {
            contours = united(contours).map_err(|error| error.to_string())?;
        }
        Ok(Self { contours })
    }

    /// Cuts the ink above a slab, after turning everything clockwise by quarter turns. Returns whether that was possible.
    fn cut(&mut self, turns: usize, slab: Option<Slab>) -> bool {
        let Some(slab) = slab else { return false };
        self.contours = self.contours.iter().map(|contour| turned(contour, turns)).collect();
        let cut = self.cut_above(&slab);
        self.contours = self.contours.iter().map(|contour| turned(contour, 4 - turns)).collect();
        cut.is_some()
    }

    fn cut_above(&mut self, slab: &Slab) -> Option<()> {
        let (low_left, high_left) = self.wall(slab.left)?;
        let (low_right, high_right) = self.wall(slab.right)?;
        // With the ink on its left, the counter runs to the right above itself, and what is above the ink to the left.
        let removed = [self.chain(low_left, low_right)?, self.chain(high_right, high_left)?];
        if !removed.iter().all(|chain| slab.holds(chain)) {
            return None;
        }
        // What is left begins where a chain ended, and goes on along a wall.
        let left = self.chain(high_left, if low_left.contour == high_left.contour { low_left } else { high_right });
        let right = self.chain(low_right, if low_left.contour == high_left.contour { high_right } else { low_left });
        let (left, right) = (left?, right?);
        let (low, high) = (low_left.contour, high_left.contour);
        if low == high {
            self.contours[low] = left;
            self.contours.push(right);
        } else {
            self.contours[low] = [left, right].concat();
            self.contours.remove(high);
        }
        self.contours.iter_mut().for_each(Vec::dedup);
        Some(())
    }

    /// The crossing of a wall at the top of the counter, and the next one above it.
    fn wall(&self, start: Point) -> Option<(Crossing, Crossing)> {
        /// Tolerance of a crossing recomputed after another bridge shortened the edge (font units).
        const SAME: f64 = 1e-6;
        let mut above: Vec<Crossing> =
            self.crossings(start.x).filter(|crossing| crossing.at.y > start.y - SAME).collect();
        above.sort_by(|a, b| a.at.y.total_cmp(&b.at.y));
        match above[..] {
            [low, high, ..] if low.at.y < start.y + SAME => Some((low, high)),
            _ => None,
        }
    }

    fn crossings(&self, x: f64) -> impl Iterator<Item = Crossing> + '_ {
        self.contours.iter().enumerate().flat_map(move |(contour, corners)| {
            let met = move |(edge, ends)| meet(ends, x).map(|at| Crossing { contour, edge, at });
            edges(corners).enumerate().filter_map(met)
        })
    }

    /// The chain along a contour from one crossing to another; none if they are on different contours.
    fn chain(&self, from: Crossing, to: Crossing) -> Option<Vec<Point>> {
        if from.contour != to.contour {
            return None;
        }
        let corners = &self.contours[from.contour];
        let start = corners[from.edge];
        let ahead = from.edge == to.edge && start.distance(to.at) >= start.distance(from.at);
        let count = match (to.edge + corners.len() - from.edge) % corners.len() {
            0 if !ahead => corners.len(),
            count => count,
        };
        let between = (1..=count).map(|step| corners[(from.edge + step) % corners.len()]);
        Some([from.at].into_iter().chain(between).chain([to.at]).collect())
    }
}

/// Whether a contour divides ink from no ink: outside of all others, or, as a counter, in just one.
fn is_boundary(contour: &[Point], all: &[Vec<Point>]) -> bool {
    let around = all.iter().filter(|other| other.as_slice() != contour && contains(other, contour[0]));
    let turns: f64 = around.map(|other| signed_area(other).signum()).sum();
    turns == if signed_area(contour) > 0.0 { 0.0 } else { 1.0 }
}

/// The boundary of what some contours cover by the winding number, on a grid.
fn united(contours: Vec<Vec<Point>>) -> Result<Vec<Vec<Point>>, BooleanError> {
    let grid = grid::with_step(UNITING)?;
    let outlines = opened::outlines(contours);
    let shapes = grid::snap(&grid, outlines.iter().map(|outline| outline.iter().map(|p| (p.x, p.y))))?;
    let ink = Region::merged(&shapes, &RunOptions::default())?;
    let corner = |p: &GridPoint| Point::new(grid.um(p.x), grid.um(p.y));
    Ok(ink.contours().iter().map(|contour| contour.iter().map(corner).collect()).collect())
}

/// Whether any two edges cross, looked for from left to right.
fn any_crossing(contours: &[Vec<Point>]) -> bool {
    let left = |edge: &(Point, Point)| edge.0.x.min(edge.1.x);
    let mut all: Vec<(Point, Point)> = contours.iter().flat_map(|contour| edges(contour)).collect();
    all.sort_by(|a, b| left(a).total_cmp(&left(b)));
    all.iter().enumerate().any(|(i, (a, b))| {
        let near = all[i + 1..].iter().take_while(|other| left(other) <= a.x.max(b.x));
        near.into_iter().any(|(c, d)| segments_cross(*a, *b, *c, *d))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(x: f64, y: f64, width: f64, height: f64) -> Vec<Point> {
        Rect::new((x, y), (x + width, y + height)).corners().to_vec()
    }

    fn hole(x: f64, y: f64, width: f64, height: f64) -> Vec<Point> {
        rect(x, y, width, height).into_iter().rev().collect()
    }

    fn areas(contours: &[Vec<Point>]) -> Vec<f64> {
        contours.iter().map(|contour| signed_area(contour)).collect()
    }

    #[test]
    fn a_ring_falls_into_two_halves_of_the_exact_area() {
        let ring = vec![rect(0.0, 0.0, 10.0, 10.0), hole(3.0, 3.0, 4.0, 4.0)];
        let halves = bridged(ring, 2.0).unwrap();
        // 100 - 16 - 2 bridges of 2 × 3, in two equal parts.
        assert_eq!(areas(&halves), [36.0, 36.0]);
    }

    #[test]
    fn the_direction_of_the_font_does_not_matter() {
        let ring = vec![hole(0.0, 0.0, 10.0, 10.0), rect(3.0, 3.0, 4.0, 4.0)];
        assert_eq!(areas(&bridged(ring, 2.0).unwrap()), [36.0, 36.0]);
    }

    #[test]
    fn counters_on_top_of_each_other_share_the_bridge_between_them() {
        let eight = vec![rect(0.0, 0.0, 8.0, 14.0), hole(2.0, 2.0, 4.0, 4.0), hole(2.0, 8.0, 4.0, 4.0)];
        // Three bars of 2 are cut by bridges of 1.
        assert_eq!(areas(&bridged(eight, 1.0).unwrap()), [(112.0 - 32.0 - 6.0) / 2.0; 2]);
    }

    #[test]
    fn a_low_wide_counter_is_bridged_up_and_down_and_a_narrow_high_one_sideways() {
        let wide = vec![rect(0.0, 0.0, 10.0, 5.0), hole(2.0, 2.0, 6.0, 1.0)];
        assert_eq!(areas(&bridged(wide, 2.0).unwrap()).iter().sum::<f64>(), 50.0 - 6.0 - 8.0);
        let narrow = vec![rect(0.0, 0.0, 5.0, 10.0), hole(2.0, 2.0, 1.0, 6.0)];
        assert_eq!(areas(&bridged(narrow, 2.0).unwrap()).iter().sum::<f64>(), 50.0 - 6.0 - 8.0);
    }

    #[test]
    fn an_island_in_a_counter_is_left_whole() {
        let target = vec![rect(0.0, 0.0, 18.0, 18.0), hole(2.0, 2.0, 14.0, 14.0), rect(7.0, 7.0, 4.0, 4.0)];
        let mut parts = areas(&bridged(target, 1.0).unwrap());
        parts.sort_by(f64::total_cmp);
        assert_eq!(parts, [16.0, 62.0, 62.0]);
    }

    #[test]
    fn what_cannot_be_bridged_is_refused() {
        let tight = vec![rect(0.0, 0.0, 10.0, 10.0), hole(4.0, 4.0, 2.0, 2.0)];
        assert_eq!(bridged(tight, 3.0), Err(NO_ROOM.to_owned()));
    }

    #[test]
    fn a_counter_between_contours_that_overlap_is_opened_too() {
        let bars = [rect(0.0, 0.0, 10.0, 3.0), rect(0.0, 7.0, 10.0, 3.0)];
        let posts = [rect(0.0, 0.0, 3.0, 10.0), rect(7.0, 0.0, 3.0, 10.0)];
        assert_eq!(areas(&bridged([bars, posts].concat(), 2.0).unwrap()), [36.0, 36.0]);
        // A contour inside another of the same direction changes nothing.
        let doubled = vec![rect(0.0, 0.0, 10.0, 10.0), hole(3.0, 3.0, 4.0, 4.0), rect(1.0, 4.0, 1.0, 1.0)];
        assert_eq!(areas(&bridged(doubled, 2.0).unwrap()), [36.0, 36.0]);
    }
}
