//! Growing and shrinking.
//!
//! The outlines of the merged shapes are moved sideways in real numbers, corner by corner, as the definition has it:
//! growing adds a strip along each edge and a wedge at each convex corner, shrinking takes a strip away along each
//! edge and a wedge at each reflex corner. The moved outline is one closed, possibly self-crossing contour whose
//! winding number at a place is *covered before* plus strips and wedges there (minus, when shrinking). So the places
//! of positive winding are the result, and the engine finds them in one operation. Only the new corners are rounded.
//!
//! Rejected: uniting the strips as separate polygons (about five times the edges), and an engine's own outline
//! function (`i_overlay` limits and bevels corners by other rules, and takes no clockwise outlines).

use std::ops::Range;

use phidl_core::geom::Point;
use phidl_core::num;
use rayon::prelude::*;

use crate::{
    contours::Contours,
    engine::{Operand, Rule, resolve},
    error::BooleanError,
    jobs::per_job,
    op::{Fill, Operation},
    options::RunOptions,
    point::{GridPoint, MAX_COORDINATE},
    region::Region,
};

/// Sideways shift in grid steps below which two edges count as one straight line.
const STRAIGHT_STEPS: f64 = 1.0;

/// Steps by which a region must be narrower than it shrinks before nobody looks at it.
const SPARE_STEPS: f64 = 8.0;

/// Fewest points of a full circle: chords no farther from the arc than a quarter of the radius.
const FEWEST_POINTS: f64 = 4.347;

/// Corners that are moved by one parallel job.
const STRETCH: usize = 2048;

/// What is put at the corners where moved edges gape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Join {
    /// The edges are extended until they meet. Where the tip would be farther from the corner than `limit` distances,
    /// the corner is cut like [`Join::Bevel`]. At least 1; with 2, corners from 60° on keep their tip.
    Miter {
        /// Largest distance of the tip from the corner, in offset distances.
        limit: f64,
    },
    /// The edges are extended by `extension` distances or until they meet. 0 cuts corners straight from edge end to
    /// edge end, √2 − 1 keeps corners of 135°, 1 keeps right angles.
    Capped {
        /// Largest extension, in offset distances; zero or more.
        extension: f64,
    },
    /// The corner is cut square, at the offset distance from it.
    Bevel,
    /// An arc around the corner.
    Round {
        /// Points of a full circle; 3 or more. Never more than one for every two grid steps of the arc.
        points_per_turn: f64,
    },
}

impl Default for Join {
    /// Miter joins with limit 2.
    fn default() -> Self {
        Self::Miter { limit: 2.0 }
    }
}

/// How to grow or shrink.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// What is put at corners.
    pub join: Join,
    /// Merge overlapping and touching shapes first. Otherwise each shape is grown or shrunk on its own, and the results
    /// are united.
    pub merge_first: bool,
}

impl Default for Growth {
    fn default() -> Self {
        Self { join: Join::default(), merge_first: true }
    }
}

/// Grows (`distance` > 0) or shrinks (`distance` < 0) shapes; `distance` is in grid steps and need not be whole.
///
/// What vanishes leaves an empty region; distance 0 merges.
///
/// # Errors
/// [`BooleanError::Option`] for a distance or join out of its range, otherwise as [`boolean`](crate::grid::boolean). Growing beyond
/// ±[`MAX_COORDINATE`] is [`BooleanError::OutOfRange`].
///
/// # Examples
/// ```
/// use phidl_boolean::{Growth, RunOptions};
/// use phidl_boolean::grid::{Contours, GridPoint, offset};
/// let square: Contours = [[(0, 0), (10, 0), (10, 10), (0, 10)].map(GridPoint::from)].into_iter().collect();
/// let run = RunOptions::default();
/// assert_eq!(offset(&square, 1.0, &Growth::default(), &run)?.area(), 144.0);
/// assert!(offset(&square, -5.0, &Growth::default(), &run)?.is_empty());
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
pub fn offset(shapes: &Contours, distance: f64, options: &Growth, run: &RunOptions) -> Result<Region, BooleanError> {
    check(distance, options.join)?;
    run.check()?;
    shapes.check_range()?;
    // All steps run on the same threads, which are started once.
    let inner = RunOptions { threads: None, ..*run };
    if options.merge_first {
        return run.on_threads(|| Region::merged(shapes, &inner)?.offset(distance, options.join, &inner));
    }
    let alone = |shape: &[GridPoint]| -> Result<Region, BooleanError> {
        let one: Contours = [shape.to_vec()].into_iter().collect();
        Region::merged(&one, &inner)?.offset(distance, options.join, &inner)
    };
    run.on_threads(|| {
        let shapes: Vec<&[GridPoint]> = shapes.iter().collect();
        let moved: Vec<_> = shapes.into_par_iter().map(alone).collect();
        let mut all = Contours::new();
        for region in moved {
            all.append(region?.contours());
        }
        resolve([Operand::Wound(&all), Operand::Wound(&Contours::new())], POSITIVE, &inner)
    })
}

impl Region {
    /// Grows (`distance` > 0) or shrinks (`distance` < 0) the region; `distance` is in grid steps.
    ///
    /// # Errors
    /// See [`offset`].
    pub fn offset(&self, distance: f64, join: Join, run: &RunOptions) -> Result<Self, BooleanError> {
        check(distance, join)?;
        run.check()?;
        if distance == 0.0 {
            return Ok(self.clone());
        }
        if self.vanishes(distance) {
            return Ok(Self::new());
        }
        let inner = RunOptions { threads: None, ..*run };
        run.on_threads(|| {
            let moved = moved_outlines(self.contours(), distance, join);
            resolve([Operand::Wound(&moved), Operand::Wound(&Contours::new())], POSITIVE, &inner)
        })
    }

    /// True if shrinking eats the whole box of the region, with steps to spare: at the very distance, what rounding
    /// leaves must not depend on what else is in the region.
    #[expect(clippy::cast_precision_loss, reason = "coordinates are far below 2^53")]
    fn vanishes(&self, distance: f64) -> bool {
        self.bbox().is_none_or(|(low, high)| {
            let narrow = (high.x - low.x).min(high.y - low.y) as f64;
            distance < 0.0 && narrow + SPARE_STEPS <= -2.0 * distance
        })
    }
}

const POSITIVE: Rule = Rule { operation: Operation::Or, fill: Fill::Positive };

fn check(distance: f64, join: Join) -> Result<(), BooleanError> {
    let bound = |option, value: f64, holds: bool, rule| {
        if value.is_finite() && holds { Ok(()) } else { Err(BooleanError::Option { option, value, rule }) }
    };
    #[expect(clippy::cast_precision_loss, reason = "2^40 is exact in an f64")]
    let limit = MAX_COORDINATE as f64;
    bound("distance", distance, distance.abs() <= limit, "within ±2^40 grid steps")?;
    match join {
        Join::Miter { limit } => bound("miter limit", limit, limit >= 1.0, "finite and at least 1"),
        Join::Capped { extension } => bound("extension", extension, extension >= 0.0, "finite and at least 0"),
        Join::Bevel => Ok(()),
        Join::Round { points_per_turn: n } => bound("points_per_turn", n, n >= 3.0, "finite and at least 3"),
    }
}

/// A vector in grid steps.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Vector {
    x: f64,
    y: f64,
}

impl Vector {
    /// `self · a + other · b`
    fn mix(self, a: f64, other: Self, b: f64) -> Self {
        Self { x: self.x * a + other.x * b, y: self.y * a + other.y * b }
    }

    /// To the right of this direction, which is outward along an outline.
    fn outward(self) -> Self {
        Self { x: self.y, y: -self.x }
    }

    fn rotated(self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { x: self.x * cos - self.y * sin, y: self.x * sin + self.y * cos }
    }
}

/// An edge of an outline as moving it needs it.
#[derive(Debug, Clone, Copy)]
struct Run {
    direction: Vector,
    length: f64,
}

#[expect(clippy::cast_precision_loss, reason = "differences of coordinates are far below 2^53")]
fn run_between(a: GridPoint, b: GridPoint) -> Run {
    let (x, y) = ((b.x - a.x) as f64, (b.y - a.y) as f64);
    let length = Point::new(x, y).norm();
    Run { direction: Vector { x: x / length, y: y / length }, length }
}

/// The outlines with each edge moved by `distance` to its outside, and joined at the corners.
fn moved_outlines(outlines: &Contours, distance: f64, join: Join) -> Contours {
    // A merged layer may be one outline of a million corners, so stretches are moved in parallel, not outlines.
    let stretches: Vec<Stretch> = outlines.iter().flat_map(stretches).collect();
    let parts: Vec<(Vec<GridPoint>, Vec<usize>)> = stretches
        .par_chunks(per_job(stretches.len(), outlines.point_count()))
        .map(|stretches| moved_part(stretches, distance, join))
        .collect();
    let mut all = Contours::with_capacity(outlines.len(), parts.iter().map(|(points, _)| points.len()).sum());
    parts.iter().for_each(|(points, ends)| all.push_part(points, ends));
    all
}

/// Some corners of an outline, one after the other.
type Stretch<'a> = (&'a [GridPoint], Range<usize>);

fn stretches(outline: &[GridPoint]) -> impl Iterator<Item = Stretch<'_>> {
    let corners = |first: usize| first..(first + STRETCH).min(outline.len());
    (0..outline.len()).step_by(STRETCH).map(move |first| (outline, corners(first)))
}

/// What moving makes of some stretches, and where outlines end in it.
fn moved_part(stretches: &[Stretch], distance: f64, join: Join) -> (Vec<GridPoint>, Vec<usize>) {
    let corners: usize = stretches.iter().map(|(_, corners)| corners.len()).sum();
    let (mut points, mut ends) = (Vec::with_capacity(corners + corners / 4), Vec::with_capacity(stretches.len()));
    for (outline, corners) in stretches {
        move_stretch(outline, corners.clone(), distance, join, &mut points);
        if corners.end == outline.len() {
            ends.push(points.len());
        }
    }
    (points, ends)
}

/// Draws what moving an outline makes of some of its corners.
fn move_stretch(outline: &[GridPoint], corners: Range<usize>, distance: f64, join: Join, moved: &mut Vec<GridPoint>) {
    let n = outline.len();
    let at = |i: usize| outline[i % n];
    let first = corners.start + n;
    let run = |i: usize| run_between(at(i), at(i + 1));
    let mut previous = Corner::new(at(first - 1), run(first - 2), run(first - 1), distance);
    let mut corner = Corner::new(at(first), previous.after, run(first), distance);
    for i in corners {
        let next = Corner::new(at(i + 1), corner.after, run(i + 1), distance);
        let keep_their_edges = previous.leaves_some_of(&corner) && corner.leaves_some_of(&next);
        corner.draw(keep_their_edges, join, moved);
        (previous, corner) = (corner, next);
    }
}

/// A corner of an outline between two edges.
struct Corner {
    at: GridPoint,
    before: Run,
    after: Run,
    distance: f64,
    /// Sine and cosine of the turn, counter-clockwise positive.
    sin: f64,
    cos: f64,
}

impl Corner {
    fn new(at: GridPoint, before: Run, after: Run, distance: f64) -> Self {
        let (u, v) = (before.direction, after.direction);
        Self { at, before, after, distance, sin: u.x * v.y - u.y * v.x, cos: u.x * v.x + u.y * v.y }
    }

    /// How much moving takes away from either edge at this corner.
    fn cut(&self) -> f64 {
        if self.gapes() { 0.0 } else { (self.distance * self.sin).abs() / (1.0 + self.cos) }
    }

    /// Whether something is left of the edge to the next corner if the moved edges are cut where they meet, at both.
    fn leaves_some_of(&self, next: &Self) -> bool {
        self.cut() + next.cut() <= self.after.length
    }

    fn gapes(&self) -> bool {
        self.sin * self.distance > 0.0
    }

    /// Draws what becomes of the corner; its moved edges may be cut where they meet if that leaves some of both.
    fn draw(&self, leaves_edges: bool, join: Join, out: &mut Vec<GridPoint>) {
        let (n1, n2) = (self.before.direction.outward(), self.after.direction.outward());
        let gapes = self.gapes();
        let is_straight = self.cos > 0.0 && (self.sin * self.distance).abs() < STRAIGHT_STEPS;
        if is_straight || (!gapes && (leaves_edges || self.edges_meet())) {
            out.push(self.tip());
        } else if gapes {
            self.join(join, n1, n2, out);
        } else {
            // The way over the corner itself keeps the winding right where the moved edges are too short to meet.
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
            Join::Capped { extension } if (self.turn().abs() / 2.0).tan() <= extension => out.push(self.tip()),
            Join::Capped { extension } => self.bevel(extension, n1, n2, out),
            Join::Round { points_per_turn } => self.arc(points_per_turn, n1, n2, out),
        }
    }

    /// Where the moved edges meet, on the bisector.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 × 10 µm at 10⁻⁴ µm.
    const SIDE: i64 = 100_000;
    const UM: f64 = 1e4;

    fn contours(points: &[(i64, i64)]) -> Contours {
        [points.iter().copied().map(GridPoint::from).collect::<Vec<_>>()].into_iter().collect()
    }

    fn square() -> Contours {
        contours(&[(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)])
    }

    fn l_shape() -> Contours {
        let h = SIDE / 2;
        contours(&[(0, 0), (SIDE, 0), (SIDE, h), (h, h), (h, SIDE), (0, SIDE)])
    }

    fn grown(shapes: &Contours, distance: f64, join: Join) -> Region {
        offset(shapes, distance, &Growth { join, merge_first: true }, &RunOptions::default()).unwrap()
    }

    fn area_um2(region: &Region) -> f64 {
        region.area() / (UM * UM)
    }

    #[test]
    fn a_square_grows_and_shrinks_as_the_specification_measured() {
        for (join, area) in [
            (Join::default(), 144.0),
            (Join::Capped { extension: 0.0 }, 142.0),
            (Join::Capped { extension: 2f64.sqrt() - 1.0 }, 143.313_677),
            (Join::Capped { extension: 1.0 }, 144.0),
            (Join::Round { points_per_turn: 3.0 }, 142.0),
            (Join::Round { points_per_turn: 8.0 }, 142.8284),
            (Join::Round { points_per_turn: 64.0 }, 143.136_577),
            (Join::Round { points_per_turn: 200.0 }, 143.141_072),
        ] {
            assert!((area_um2(&grown(&square(), UM, join)) - area).abs() < 1e-3, "{join:?}");
        }
        assert_eq!(area_um2(&grown(&square(), -UM, Join::default())), 64.0);
    }

    #[test]
    fn arcs_have_the_points_that_the_specification_counts() {
        for (points_per_turn, points) in [(5.0, 8), (8.0, 12), (12.0, 16), (64.0, 68), (200.0, 204)] {
            let region = grown(&square(), UM, Join::Round { points_per_turn });
            assert_eq!(region.contours().point_count(), points, "{points_per_turn} points per turn");
        }
    }

    #[test]
    fn a_bevel_is_cut_square_at_the_distance() {
        let region = grown(&square(), UM, Join::Bevel);
        assert!(region.contours().points().contains(&GridPoint::new(110_000, -4142)));
        assert_eq!(region.contours().point_count(), 8);
    }

    #[test]
    fn shrinking_treats_reflex_corners_as_growing_treats_convex_ones() {
        let corner = |join| grown(&l_shape(), -UM, join).contours().points().to_vec();
        assert!(corner(Join::default()).contains(&GridPoint::new(40_000, 40_000)));
        let chamfer = corner(Join::Capped { extension: 0.0 });
        assert!(chamfer.contains(&GridPoint::new(40_000, 50_000)) && chamfer.contains(&GridPoint::new(50_000, 40_000)));
        let capped = corner(Join::Capped { extension: 2f64.sqrt() - 1.0 });
        assert!(capped.contains(&GridPoint::new(40_000, 45_858)) && capped.contains(&GridPoint::new(45_858, 40_000)));
    }

    #[test]
    fn tips_are_kept_up_to_the_miter_limit() {
        let corner = |half_angle: f64| {
            let (sin, cos) = half_angle.to_radians().sin_cos();
            let (x, y) = ((30.0 * UM * cos).round(), (30.0 * UM * sin).round());
            #[expect(clippy::cast_possible_truncation, reason = "a few million steps")]
            let triangle = contours(&[(0, 0), (x as i64, -y as i64), (x as i64, y as i64)]);
            grown(&triangle, UM, Join::default()).bbox().unwrap().0.x
        };
        assert!((corner(30.1) + 19_940).abs() < 20, "the tip of a 60.2° corner is 1/sin(30.1°) µm away");
        assert!(corner(29.5) >= -10_000, "a 59° corner is cut at 1 µm");
    }

    #[test]
    fn shapes_shrunk_one_by_one_fall_apart_where_they_only_overlap() {
        let mut two = square();
        two.append(&contours(&[(50_000, 50_000), (150_000, 50_000), (150_000, 150_000), (50_000, 150_000)]));
        let shrunk = |merge_first| {
            let options = Growth { join: Join::default(), merge_first };
            area_um2(&offset(&two, -UM, &options, &RunOptions::default()).unwrap())
        };
        assert_eq!(shrunk(true), 175.0 - 56.0); // shrinking a merged outline of 60 µm with six convex, two reflex corners
        assert_eq!(shrunk(false), 64.0 + 64.0 - 9.0);
    }

    #[test]
    fn long_outlines_are_moved_in_stretches_as_if_in_one() {
        let comb: Vec<GridPoint> =
            (0..3000i64).map(|i| GridPoint::new(10 * i, if i % 4 < 2 { 0 } else { 50 + i % 7 })).collect();
        for distance in [-4.0, 2.5, 40.0] {
            let mut whole = Vec::new();
            move_stretch(&comb, 0..comb.len(), distance, Join::default(), &mut whole);
            let outlines: Contours = [comb.clone()].into_iter().collect();
            let moved = moved_outlines(&outlines, distance, Join::default());
            assert_eq!(moved.iter().collect::<Vec<_>>(), [whole.as_slice()]);
        }
    }

    #[test]
    fn edges_that_keep_a_part_are_cut_where_they_meet() {
        // Each step takes more than half of the short edges, but never all of them.
        let stairs = contours(&[(0, 0), (100, 0), (100, 10), (60, 10), (60, 40), (0, 40)]);
        let moved = moved_outlines(&stairs, -4.0, Join::default());
        let cut = contours(&[(4, 4), (96, 4), (96, 6), (56, 6), (56, 36), (4, 36)]);
        assert_eq!(moved, cut);
    }

    #[test]
    fn bad_distances_and_joins_are_refused() {
        let refused = |distance, join| {
            let options = Growth { join, ..Growth::default() };
            offset(&square(), distance, &options, &RunOptions::default()).is_err()
        };
        assert!(refused(f64::NAN, Join::default()));
        assert!(refused(1e13, Join::default()));
        assert!(refused(1.0, Join::Miter { limit: 0.5 }));
        assert!(refused(1.0, Join::Round { points_per_turn: f64::INFINITY }));
        assert!(refused(1.0, Join::Capped { extension: -1.0 }));
        assert!(refused(1_099_511_600_000.0, Join::default()), "the result reaches beyond the range");
    }

    #[test]
    fn distances_beyond_the_shape_empty_it_or_grow_it() {
        assert!(grown(&l_shape(), -30_000.0, Join::default()).is_empty());
        assert!(grown(&square(), -1e9, Join::default()).is_empty());
        assert_eq!(grown(&square(), 1e9, Join::default()).bbox().unwrap().1.x, 1_000_100_000);
    }
}
