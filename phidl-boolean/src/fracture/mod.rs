//! Fracture: outlines without holes and with a limited number of points, as files need them.
//!
//! Both cut along *diagonals*, straight lines between two corners of the polygon. So no point is added, nothing is rounded,
//! and area and edges stay exact. Rejected: cuts along horizontal or vertical lines, as layout tools make them. They put
//! new points on slanted edges, off the grid.
//!
//! 1. [`corners`] numbers the corners from left to right; [`diagonals`] cuts a polygon with holes into monotone mountains, which have one long edge and a chain over it. One
//!    diagonal for each hole is its *bridge*. If a polygon is small enough, its outline along the bridges, with one keyhole
//!    for each hole, is the result ([`half_edges`]).
//! 2. Otherwise, [`triangulate`] cuts the monotone mountains into triangles.
//! 3. [`partition`] joins triangles over every diagonal that is no bridge, up to the limit. With a bridge for each hole the
//!    triangles form a tree, so the outline of a connected part is found by walking around it.

mod corners;
mod diagonals;
mod half_edges;
mod partition;
mod triangulate;

use rayon::prelude::*;

use corners::Corners;
use half_edges::HalfEdges;

use crate::{
    contours::Contours,
    error::BooleanError,
    jobs::per_job,
    point::GridPoint,
    region::{Region, RegionPolygon},
};

/// The smallest limit of points.
const FEWEST_POINTS: usize = 3;

impl Region {
    /// The region as outlines without holes: each hole is connected with the ring around it by a keyhole of width zero.
    ///
    /// Outlines run counter-clockwise. The points are those of the region; the ends of keyholes occur twice.
    ///
    /// # Examples
    /// ```
    /// use phidl_boolean::{Region, RunOptions, grid::{Contours, GridPoint, signed_area2}};
    /// let square = |low: i64, high: i64| -> Contours {
    ///     [[(low, low), (high, low), (high, high), (low, high)].map(GridPoint::from)].into_iter().collect()
    /// };
    /// let run = RunOptions::default();
    /// let frame = Region::merged(&square(0, 10), &run)? - Region::merged(&square(3, 7), &run)?;
    /// let outlines = frame.without_holes();
    /// assert_eq!(outlines.len(), 1);
    /// assert_eq!(outlines.iter().map(signed_area2).sum::<i128>(), 2 * 84);
    /// # Ok::<(), phidl_boolean::BooleanError>(())
    /// ```
    pub fn without_holes(&self) -> Contours {
        self.cut_to(usize::MAX)
    }

    /// The region as outlines without holes of at most `max_points` points each.
    ///
    /// # Errors
    /// [`BooleanError::Option`] if `max_points` is below 3.
    pub fn fractured(&self, max_points: usize) -> Result<Contours, BooleanError> {
        if max_points < FEWEST_POINTS {
            #[expect(clippy::cast_precision_loss, reason = "0, 1 or 2")]
            let value = max_points as f64;
            return Err(BooleanError::Option { option: "max_points", value, rule: "at least 3" });
        }
        Ok(self.cut_to(max_points))
    }

    fn cut_to(&self, max_points: usize) -> Contours {
        let polygons: Vec<RegionPolygon> = self.polygons().collect();
        let each = polygons.par_iter().with_min_len(per_job(polygons.len(), self.contours().point_count()));
        let cut: Vec<Contours> = each.map(|polygon| cut_polygon(*polygon, max_points)).collect();
        let mut all = Contours::with_capacity(cut.len(), self.contours().point_count());
        cut.iter().for_each(|contours| all.append(contours));
        all
    }
}

fn cut_polygon(polygon: RegionPolygon, max_points: usize) -> Contours {
    if polygon.holes().len() == 0 && polygon.outer().len() <= max_points {
        return [polygon.outer().to_vec()].into_iter().collect();
    }
    let rings: Vec<&[GridPoint]> = std::iter::once(polygon.outer()).chain(polygon.holes()).collect();
    let corners = Corners::new(&rings);
    let diagonals = diagonals::diagonals(&corners);
    let bridges = diagonals.iter().filter(|diagonal| diagonal.is_bridge);
    if polygon.point_count() + 2 * bridges.clone().count() <= max_points {
        let mut opened = Contours::with_capacity(1, polygon.point_count() + 2 * polygon.holes().len());
        let halves = HalfEdges::new(&corners, bridges);
        halves.for_each_face(|face, _| opened.push(face.iter().map(|&corner| corners.point(corner))));
        return opened;
    }
    partition::parts(&corners, &triangulate::triangles(&corners, &diagonals), max_points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{options::RunOptions, point::signed_area2};

    fn contour(points: &[(i64, i64)]) -> Contours {
        [points.iter().copied().map(GridPoint::from).collect::<Vec<_>>()].into_iter().collect()
    }

    fn square(x: i64, y: i64, side: i64) -> Contours {
        contour(&[(x, y), (x + side, y), (x + side, y + side), (x, y + side)])
    }

    fn merged(shapes: &Contours) -> Region {
        Region::merged(shapes, &RunOptions::default()).unwrap()
    }

    fn area2(contours: &Contours) -> i128 {
        contours.iter().map(signed_area2).sum()
    }

    #[test]
    fn a_grid_of_holes_becomes_one_outline_of_the_same_area() {
        let mut holes = Contours::new();
        for x in 0..7 {
            for y in 0..7 {
                holes.append(&contour(&[(10 * x + 3, 10 * y + 2), (10 * x + 8, 10 * y + 5), (10 * x + 4, 10 * y + 9)]));
            }
        }
        let sheet = &merged(&square(0, 0, 70)) - &merged(&holes);
        let outlines = sheet.without_holes();
        assert_eq!((outlines.len(), area2(&outlines)), (1, sheet.area2()));
        assert_eq!(outlines.point_count(), 4 + 49 * 3 + 2 * 49, "each bridge repeats its two ends");
        assert_eq!(merged(&outlines), sheet);
    }

    #[test]
    fn a_hole_that_touches_the_outline_in_a_point_needs_no_seam() {
        let tip = &merged(&square(0, 0, 10)) - &merged(&contour(&[(0, 5), (4, 3), (4, 7)]));
        let outlines = tip.without_holes();
        assert_eq!((outlines.len(), area2(&outlines)), (1, 200 - 16));
    }

    #[test]
    fn parts_obey_the_limit_and_keep_the_area() {
        let disc: Vec<(i64, i64)> = (0..1000)
            .map(|i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 1000.0).sin_cos();
                #[expect(clippy::cast_possible_truncation, reason = "at most 10^6")]
                let point = ((1e6 * cos).round() as i64, (1e6 * sin).round() as i64);
                point
            })
            .collect();
        let ring = &merged(&contour(&disc)) - &merged(&square(-1000, -2000, 5000));
        for limit in [3, 4, 5, 50, 199, 700] {
            let parts = ring.fractured(limit).unwrap();
            assert!(parts.iter().all(|part| part.len() <= limit && signed_area2(part) > 0), "{limit}");
            assert_eq!(area2(&parts), ring.area2(), "{limit}");
            assert_eq!(merged(&parts), ring, "{limit}");
            assert!(parts.len() <= 3 * 1008 / limit + 1, "{} parts of {limit} points", parts.len());
        }
    }

    #[test]
    fn small_outlines_stay_as_they_are_and_a_limit_below_three_is_refused() {
        let region = merged(&square(0, 0, 10));
        assert_eq!(&region.fractured(4).unwrap(), region.contours());
        assert!(region.fractured(2).is_err());
        assert!(Region::new().without_holes().is_empty());
    }
}
