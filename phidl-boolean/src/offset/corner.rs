//! One corner of a moved ring: where its edges meet, or the join between them.

use phidl_core::geom::Point;
use phidl_core::num;

use super::Join;
use crate::point::GridPoint;

/// Sideways shift in grid steps below which two edges count as one straight line.
const STRAIGHT_STEPS: f64 = 1.0;

/// Fewest points of a full circle: chords no farther from the arc than a quarter of the radius.
const FEWEST_POINTS: f64 = 4.347;

/// A vector in grid steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vector {
    x: f64,
    y: f64,
}

impl Vector {
    /// `self · a + other · b`
    fn mix(self, a: f64, other: Self, b: f64) -> Self {
        Self { x: self.x * a + other.x * b, y: self.y * a + other.y * b }
    }

    /// To the right of this direction, which is outward along a ring.
    fn outward(self) -> Self {
        Self { x: self.y, y: -self.x }
    }

    fn rotated(self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { x: self.x * cos - self.y * sin, y: self.x * sin + self.y * cos }
    }
}

/// Direction and length of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeVector {
    direction: Vector,
    length: f64,
}

#[expect(clippy::cast_precision_loss, reason = "differences of coordinates are far below 2^53")]
pub(super) fn edge_between(a: GridPoint, b: GridPoint) -> EdgeVector {
    let (x, y) = ((b.x - a.x) as f64, (b.y - a.y) as f64);
    let length = Point::new(x, y).norm();
    EdgeVector { direction: Vector { x: x / length, y: y / length }, length }
}

/// A corner of a ring between two edges.
pub(super) struct Corner {
    at: GridPoint,
    before: EdgeVector,
    pub(super) after: EdgeVector,
    distance: f64,
    /// Sine and cosine of the turn, counter-clockwise positive.
    sin: f64,
    cos: f64,
}

impl Corner {
    pub(super) fn new(at: GridPoint, before: EdgeVector, after: EdgeVector, distance: f64) -> Self {
        let (u, v) = (before.direction, after.direction);
        Self { at, before, after, distance, sin: u.x * v.y - u.y * v.x, cos: u.x * v.x + u.y * v.y }
    }

    /// How much of either edge is cut off at this corner.
    fn cut(&self) -> f64 {
        if self.is_convex() { 0.0 } else { (self.distance * self.sin).abs() / (1.0 + self.cos) }
    }

    /// Whether a part of the edge to the next corner remains if the moved edges are cut where they meet, at both ends.
    pub(super) fn keeps_edge_to(&self, next: &Self) -> bool {
        self.cut() + next.cut() <= self.after.length
    }

    /// Whether the moved edges separate, as at convex corners that grow and reflex corners that shrink.
    fn is_convex(&self) -> bool {
        self.sin * self.distance > 0.0
    }

    /// Draws the moved corner. With `keeps_edges`, the moved edges may be cut where they meet, because a part of both
    /// remains.
    pub(super) fn draw(&self, keeps_edges: bool, join: Join, out: &mut Vec<GridPoint>) {
        let (n1, n2) = (self.before.direction.outward(), self.after.direction.outward());
        let is_convex = self.is_convex();
        let is_straight = self.cos > 0.0 && (self.sin * self.distance).abs() < STRAIGHT_STEPS;
        if is_straight || (!is_convex && (keeps_edges || self.edges_meet())) {
            out.push(self.tip());
        } else if is_convex {
            self.join(join, n1, n2, out);
        } else {
            // A detour over the corner itself keeps the winding right where the moved edges are too short to meet.
            out.extend([self.moved(n1, self.distance), self.at, self.moved(n2, self.distance)]);
        }
    }

    /// True if the moved edges cross, each in the half that is nearer to this corner.
    fn edges_meet(&self) -> bool {
        let cut = (self.distance * self.sin).abs();
        let half = self.before.length.min(self.after.length) / 2.0;
        cut <= half * (1.0 + self.cos)
    }

    fn join(&self, join: Join, n1: Vector, n2: Vector, out: &mut Vec<GridPoint>) {
        match join {
            Join::Miter { limit } if (1.0 + self.cos) * limit * limit >= 2.0 => out.push(self.tip()),
            Join::Miter { .. } | Join::Bevel => self.bevel((self.turn().abs() / 4.0).tan(), n1, n2, out),
            Join::Extended { extension } if (self.turn().abs() / 2.0).tan() <= extension => out.push(self.tip()),
            Join::Extended { extension } => self.bevel(extension, n1, n2, out),
            Join::Round { points_per_turn } => self.arc(points_per_turn, n1, n2, out),
        }
    }

    /// The miter tip: where the moved edges meet, on the bisector.
    fn tip(&self) -> GridPoint {
        let (n1, n2) = (self.before.direction.outward(), self.after.direction.outward());
        self.moved(n1.mix(1.0, n2, 1.0), self.distance / (1.0 + self.cos))
    }

    /// Both moved edges extended by `extension` distances and joined by a straight cut.
    fn bevel(&self, extension: f64, n1: Vector, n2: Vector, out: &mut Vec<GridPoint>) {
        let extension = extension * self.distance.abs();
        out.push(self.moved(n1.mix(self.distance, self.before.direction, extension), 1.0));
        out.push(self.moved(n2.mix(self.distance, self.after.direction, -extension), 1.0));
    }

    fn arc(&self, points_per_turn: f64, n1: Vector, n2: Vector, out: &mut Vec<GridPoint>) {
        let most = std::f64::consts::PI * self.distance.abs();
        let step = std::f64::consts::TAU / points_per_turn.max(FEWEST_POINTS).min(most.max(FEWEST_POINTS));
        let chords = (self.turn().abs() / step).round().max(1.0);
        let mut chord = 0.0;
        while chord < chords {
            out.push(self.moved(n1.rotated(step.copysign(self.turn()) * chord), self.distance));
            chord += 1.0;
        }
        out.push(self.moved(n2, self.distance));
    }

    fn turn(&self) -> f64 {
        self.sin.atan2(self.cos)
    }

    fn moved(&self, by: Vector, distance: f64) -> GridPoint {
        GridPoint::new(self.at.x + whole_steps(by.x * distance), self.at.y + whole_steps(by.y * distance))
    }
}

/// The nearest whole number of steps, by the rule of the grid.
#[expect(
    clippy::cast_possible_truncation,
    reason = "tips are at most a few distances away; the engine checks the range"
)]
fn whole_steps(length: f64) -> i64 {
    num::grid::whole(length) as i64
}
