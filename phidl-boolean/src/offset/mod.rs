//! Offsets: growing and shrinking.
//!
//! The rings of the merged shapes are moved sideways in real numbers, corner by corner: growing adds a strip along each
//! edge and a wedge at each convex corner, shrinking removes a strip along each edge and a wedge at each reflex corner. A
//! moved ring is one closed, possibly self-crossing contour. Its winding number at a point is *covered before* plus the
//! strips and wedges there (minus, when shrinking). So the points of positive winding number are the result, and one
//! operation of the engine finds them. Only the new corners are rounded.
//!
//! Rejected: a union of the strips as separate polygons (about five times the edges); the outline function of another
//! engine (`i_overlay` limits and bevels corners by other rules, and takes no clockwise contours).

mod corner;
mod moves;

use rayon::prelude::*;

use crate::{
    contours::Contours,
    engine::{Operand, Rule, resolve},
    error::BooleanError,
    op::{Fill, Operation},
    options::RunOptions,
    point::{GridPoint, MAX_COORDINATE},
    region::Region,
};
use moves::moved_rings;

/// A region vanishes without a run of the engine only if it is this much (steps) narrower than twice the inset.
const SAFETY_STEPS: f64 = 8.0;

/// The shape of corners whose moved edges separate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Join {
    /// The edges are extended until they meet. Where the tip would be farther from the corner than `limit` distances,
    /// the corner is cut like [`Join::Bevel`]. At least 1; with 2, corners of 60° and more keep their tip.
    Miter {
        /// Largest distance of the tip from the corner, in offset distances.
        limit: f64,
    },
    /// The edges are extended by `extension` distances or until they meet. 0 cuts corners straight from edge end to
    /// edge end, √2 − 1 keeps corners of 135°, 1 keeps right angles.
    Extended {
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

/// How to grow or shrink shapes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OffsetOptions {
    /// The shape of corners.
    pub join: Join,
    /// Merge overlapping and touching shapes first. Otherwise each shape is grown or shrunk on its own, and the results
    /// are united.
    pub merge_first: bool,
}

impl Default for OffsetOptions {
    fn default() -> Self {
        Self { join: Join::default(), merge_first: true }
    }
}

/// Grows (`distance` > 0) or shrinks (`distance` < 0) shapes; `distance` is in grid steps and need not be whole.
///
/// The result is empty if all shapes vanish; distance 0 merges.
///
/// # Errors
/// [`BooleanError::Option`] for a distance or join out of its range, otherwise as [`boolean`](crate::grid::boolean). Growing beyond
/// ±[`MAX_COORDINATE`] is [`BooleanError::OutOfRange`].
///
/// # Examples
/// ```
/// use phidl_boolean::{OffsetOptions, RunOptions};
/// use phidl_boolean::grid::{Contours, GridPoint, offset};
/// let square: Contours = [[(0, 0), (10, 0), (10, 10), (0, 10)].map(GridPoint::from)].into_iter().collect();
/// let run = RunOptions::default();
/// assert_eq!(offset(&square, 1.0, &OffsetOptions::default(), &run)?.area(), 144.0);
/// assert!(offset(&square, -5.0, &OffsetOptions::default(), &run)?.is_empty());
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
pub fn offset(
    shapes: &Contours,
    distance: f64,
    options: &OffsetOptions,
    run: &RunOptions,
) -> Result<Region, BooleanError> {
    check(distance, options.join)?;
    run.check()?;
    shapes.check_range()?;
    // All stages run on the same threads, which are started once.
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
        resolve([Operand::Oriented(&all), Operand::Oriented(&Contours::new())], POSITIVE, &inner)
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
            let moved = moved_rings(self.contours(), distance, join);
            resolve([Operand::Oriented(&moved), Operand::Oriented(&Contours::new())], POSITIVE, &inner)
        })
    }

    /// True if twice the inset exceeds the bounding box by [`SAFETY_STEPS`]. At the exact distance, rounding may leave
    /// slivers, which must not depend on the rest of the region.
    #[expect(clippy::cast_precision_loss, reason = "coordinates are far below 2^53")]
    fn vanishes(&self, distance: f64) -> bool {
        self.bbox().is_none_or(|(low, high)| {
            let narrow = (high.x - low.x).min(high.y - low.y) as f64;
            distance < 0.0 && narrow + SAFETY_STEPS <= -2.0 * distance
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
        Join::Extended { extension } => bound("extension", extension, extension >= 0.0, "finite and at least 0"),
        Join::Bevel => Ok(()),
        Join::Round { points_per_turn: n } => bound("points_per_turn", n, n >= 3.0, "finite and at least 3"),
    }
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
        offset(shapes, distance, &OffsetOptions { join, merge_first: true }, &RunOptions::default()).unwrap()
    }

    fn area_um2(region: &Region) -> f64 {
        region.area() / (UM * UM)
    }

    #[test]
    fn a_square_grows_and_shrinks_as_measured() {
        for (join, area) in [
            (Join::default(), 144.0),
            (Join::Extended { extension: 0.0 }, 142.0),
            (Join::Extended { extension: 2f64.sqrt() - 1.0 }, 143.313_677),
            (Join::Extended { extension: 1.0 }, 144.0),
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
    fn arcs_have_the_documented_number_of_points() {
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
        let chamfer = corner(Join::Extended { extension: 0.0 });
        assert!(chamfer.contains(&GridPoint::new(40_000, 50_000)) && chamfer.contains(&GridPoint::new(50_000, 40_000)));
        let capped = corner(Join::Extended { extension: 2f64.sqrt() - 1.0 });
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
            let options = OffsetOptions { join: Join::default(), merge_first };
            area_um2(&offset(&two, -UM, &options, &RunOptions::default()).unwrap())
        };
        assert_eq!(shrunk(true), 175.0 - 56.0); // shrinking a merged outline of 60 µm with six convex, two reflex corners
        assert_eq!(shrunk(false), 64.0 + 64.0 - 9.0);
    }

    #[test]
    fn bad_distances_and_joins_are_refused() {
        let refused = |distance, join| {
            let options = OffsetOptions { join, ..OffsetOptions::default() };
            offset(&square(), distance, &options, &RunOptions::default()).is_err()
        };
        assert!(refused(f64::NAN, Join::default()));
        assert!(refused(1e13, Join::default()));
        assert!(refused(1.0, Join::Miter { limit: 0.5 }));
        assert!(refused(1.0, Join::Round { points_per_turn: f64::INFINITY }));
        assert!(refused(1.0, Join::Extended { extension: -1.0 }));
        assert!(refused(1_099_511_600_000.0, Join::default()), "the result reaches beyond the range");
    }

    #[test]
    fn distances_larger_than_the_shape_work() {
        assert!(grown(&l_shape(), -30_000.0, Join::default()).is_empty());
        assert!(grown(&square(), -1e9, Join::default()).is_empty());
        assert_eq!(grown(&square(), 1e9, Join::default()).bbox().unwrap().1.x, 1_000_100_000);
    }
}
