//! [`Region`]: area on the grid, as outlines with their holes.
//!
//! A region is always clean: outlines do not cross, cover no place twice and have only real corners. It can only be
//! made by the engine, so every function can rely on that; and the operators cannot fail (the reason stands there). Holes stay holes; outlines without holes, as files want
//! them, are made on request ([`Region::without_holes`]).

use std::ops::{BitAnd, BitOr, BitXor, Sub};

use crate::{
    contours::Contours,
    engine::{Operand, Rule, resolve},
    error::BooleanError,
    op::{Fill, Operation},
    options::RunOptions,
    point::{GridPoint, cross, signed_area2},
};

/// Area on the grid: polygons with holes that do not overlap.
///
/// Outer outlines run counter-clockwise and holes clockwise; each begins at its leftmost (then lowest) point, and
/// polygons are in the order of those points. Polygons that share an edge are one; those that only touch in a point
/// are two.
///
/// # Examples
/// ```
/// use phidl_boolean::{Region, RunOptions, grid::{Contours, GridPoint}};
/// let square = |low: i64, high: i64| -> Contours {
///     [[(low, low), (high, low), (high, high), (low, high)].map(GridPoint::from)].into_iter().collect()
/// };
/// let run = RunOptions::default();
/// let frame = Region::merged(&square(0, 10), &run)? - Region::merged(&square(3, 7), &run)?;
/// assert_eq!(frame.area(), 84.0);
/// assert_eq!(frame.polygons().next().map(|polygon| polygon.holes().count()), Some(1));
/// assert!(!frame.contains(GridPoint::new(5, 5)));
/// # Ok::<(), phidl_boolean::BooleanError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Region {
    /// Each outer outline is followed by its holes.
    contours: Contours,
    /// Index of the outer outline of each polygon.
    polygons: Vec<usize>,
}

impl Region {
    /// The empty region.
    pub fn new() -> Self {
        Self::default()
    }

    /// The union of shapes as drawn: of any direction, overlapping, crossing themselves, with repeated points.
    ///
    /// # Errors
    /// See [`boolean`](crate::grid::boolean).
    pub fn merged(shapes: &Contours, options: &RunOptions) -> Result<Self, BooleanError> {
        crate::grid::boolean(shapes, &Contours::new(), Operation::Or, options)
    }

    /// A set operation between two regions.
    ///
    /// # Errors
    /// See [`boolean`](crate::grid::boolean).
    pub fn combine(&self, other: &Self, operation: Operation, options: &RunOptions) -> Result<Self, BooleanError> {
        let rule = Rule { operation, fill: Fill::NonZero };
        resolve([Operand::Wound(&self.contours), Operand::Wound(&other.contours)], rule, options)
    }

    /// The polygons, from left to right.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = Polygon<'_>> {
        (0..self.polygons.len()).map(|polygon| Polygon {
            contours: &self.contours,
            outer: self.polygons[polygon],
            end: self.polygons.get(polygon + 1).copied().unwrap_or(self.contours.len()),
        })
    }

    /// All outlines, outer ones counter-clockwise and holes clockwise.
    pub fn contours(&self) -> &Contours {
        &self.contours
    }

    /// True if nothing is covered.
    pub fn is_empty(&self) -> bool {
        self.contours.is_empty()
    }

    /// Twice the covered area in square grid steps, exactly.
    pub fn area2(&self) -> i128 {
        self.contours.iter().map(signed_area2).sum()
    }

    /// The covered area in square grid steps.
    #[expect(clippy::cast_precision_loss, reason = "`area2` is there for the exact value")]
    pub fn area(&self) -> f64 {
        self.area2() as f64 / 2.0
    }

    /// The lower left and the upper right corner of the smallest box around the region; `None` if it is empty.
    pub fn bbox(&self) -> Option<(GridPoint, GridPoint)> {
        let first = *self.contours.points().first()?;
        let grow = |(low, high): (GridPoint, GridPoint), p: &GridPoint| {
            (GridPoint::new(low.x.min(p.x), low.y.min(p.y)), GridPoint::new(high.x.max(p.x), high.y.max(p.y)))
        };
        Some(self.contours.points().iter().fold((first, first), grow))
    }

    /// True if the point is covered or on an outline.
    pub fn contains(&self, point: GridPoint) -> bool {
        let mut inside = false;
        for contour in self.contours.iter() {
            let Some(&last) = contour.last() else { continue };
            let mut a = last;
            for &b in contour {
                match meets_ray(a, b, point) {
                    Meeting::OnEdge => return true,
                    Meeting::Crosses => inside = !inside,
                    Meeting::Apart => {}
                }
                a = b;
            }
        }
        inside
    }

    /// Outlines must come from the engine: each outer one followed by its holes.
    pub(crate) fn from_parts(contours: Contours, polygons: Vec<usize>) -> Self {
        Self { contours, polygons }
    }
}

enum Meeting {
    OnEdge,
    Crosses,
    Apart,
}

/// How an edge meets the ray from `p` to the left.
fn meets_ray(a: GridPoint, b: GridPoint, p: GridPoint) -> Meeting {
    let d = cross(a, b, p);
    let in_box = p.x >= a.x.min(b.x) && p.x <= a.x.max(b.x) && p.y >= a.y.min(b.y) && p.y <= a.y.max(b.y);
    if d == 0 && in_box {
        Meeting::OnEdge
    } else if (a.y > p.y) != (b.y > p.y) && (d > 0) == (a.y > b.y) {
        Meeting::Crosses
    } else {
        Meeting::Apart
    }
}

/// One polygon of a [`Region`]: an outer outline and its holes.
#[derive(Debug, Clone, Copy)]
pub struct Polygon<'a> {
    contours: &'a Contours,
    outer: usize,
    end: usize,
}

impl<'a> Polygon<'a> {
    /// The outer outline, counter-clockwise.
    pub fn outer(&self) -> &'a [GridPoint] {
        self.contours.get(self.outer).unwrap_or_default()
    }

    /// The holes, clockwise.
    pub fn holes(&self) -> impl ExactSizeIterator<Item = &'a [GridPoint]> + use<'a> {
        let contours = self.contours;
        (self.outer + 1..self.end).map(move |hole| contours.get(hole).unwrap_or_default())
    }

    /// Number of points of all outlines.
    pub fn point_count(&self) -> usize {
        self.outer().len() + self.holes().map(<[_]>::len).sum::<usize>()
    }
}

/// Operators cannot fail, because whatever an operation refuses is refused before a region exists:
///
/// - coordinates: a region comes out of the engine, which takes points within the range only and puts new ones on grid
///   points between them (an offset that leaves the range is refused);
/// - size: results are limited to half of what one operation takes, so that any two regions fit together;
/// - options: the default ones are valid, start no threads and watch for nobody.
macro_rules! operator {
    ($trait:ident, $method:ident, $operation:expr, $doc:literal) => {
        impl $trait for &Region {
            type Output = Region;

            #[doc = $doc]
            fn $method(self, other: Self) -> Region {
                self.combine(other, $operation, &RunOptions::default())
                    .expect("invariant: regions are in range and small enough, and the default options are valid")
            }
        }

        impl $trait for Region {
            type Output = Region;

            #[doc = $doc]
            fn $method(self, other: Self) -> Region {
                $trait::$method(&self, &other)
            }
        }
    };
}

operator!(BitOr, bitor, Operation::Or, "The union.");
operator!(BitAnd, bitand, Operation::And, "The intersection.");
operator!(BitXor, bitxor, Operation::Xor, "What exactly one of the two covers.");
operator!(Sub, sub, Operation::Not, "What the first covers and the second does not.");
