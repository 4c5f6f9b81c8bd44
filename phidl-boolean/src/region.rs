//! [`Region`]: area on the grid, as polygons with holes.
//!
//! A region is always clean: rings do not cross, no point is covered twice, and every vertex is a real corner. Only the
//! engine makes regions, so every function can rely on that. Holes stay holes; outlines without holes, as files need them,
//! are made on request ([`Region::without_holes`]). The operations that make regions are in `region_ops`, above the
//! engine.

use crate::{
    contours::Contours,
    point::{GridPoint, cross, signed_area2},
};

/// Area on the grid: polygons with holes that do not overlap.
///
/// Outer rings run counter-clockwise and holes clockwise. Each begins at its leftmost (then lowest) point, and polygons
/// are in the order of those points. Areas that share an edge are one polygon; those that only touch in a point are two.
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
    /// Each outer ring is followed by its holes.
    contours: Contours,
    /// Index of the outer ring of each polygon.
    polygons: Vec<usize>,
}

impl Region {
    /// The empty region.
    pub fn new() -> Self {
        Self::default()
    }

    /// The polygons, from left to right.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = RegionPolygon<'_>> {
        (0..self.polygons.len()).map(|polygon| RegionPolygon {
            contours: &self.contours,
            outer: self.polygons[polygon],
            end: self.polygons.get(polygon + 1).copied().unwrap_or(self.contours.len()),
        })
    }

    /// All rings, outer ones counter-clockwise and holes clockwise.
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

    /// True if the point is covered or on the boundary.
    pub fn contains(&self, point: GridPoint) -> bool {
        let mut inside = false;
        for contour in self.contours.iter() {
            let Some(&last) = contour.last() else { continue };
            let mut a = last;
            for &b in contour {
                match intersection_with_ray(a, b, point) {
                    Intersection::OnEdge => return true,
                    Intersection::Crosses => inside = !inside,
                    Intersection::None => {}
                }
                a = b;
            }
        }
        inside
    }

    /// Rings must come from the engine: each outer one followed by its holes.
    pub(crate) fn from_parts(contours: Contours, polygons: Vec<usize>) -> Self {
        Self { contours, polygons }
    }
}

enum Intersection {
    OnEdge,
    Crosses,
    None,
}

/// How an edge intersects the ray from `p` to the left.
fn intersection_with_ray(a: GridPoint, b: GridPoint, p: GridPoint) -> Intersection {
    let d = cross(a, b, p);
    let in_box = p.x >= a.x.min(b.x) && p.x <= a.x.max(b.x) && p.y >= a.y.min(b.y) && p.y <= a.y.max(b.y);
    if d == 0 && in_box {
        Intersection::OnEdge
    } else if (a.y > p.y) != (b.y > p.y) && (d > 0) == (a.y > b.y) {
        Intersection::Crosses
    } else {
        Intersection::None
    }
}

/// One polygon of a [`Region`]: an outer ring and its holes.
#[derive(Debug, Clone, Copy)]
pub struct RegionPolygon<'a> {
    contours: &'a Contours,
    outer: usize,
    end: usize,
}

impl<'a> RegionPolygon<'a> {
    /// The outer ring, counter-clockwise.
    pub fn outer(&self) -> &'a [GridPoint] {
        self.contours.get(self.outer).unwrap_or_default()
    }

    /// The holes, clockwise.
    pub fn holes(&self) -> impl ExactSizeIterator<Item = &'a [GridPoint]> + use<'a> {
        let contours = self.contours;
        (self.outer + 1..self.end).map(move |hole| contours.get(hole).unwrap_or_default())
    }

    /// Number of points of all rings.
    pub fn point_count(&self) -> usize {
        self.outer().len() + self.holes().map(<[_]>::len).sum::<usize>()
    }
}
