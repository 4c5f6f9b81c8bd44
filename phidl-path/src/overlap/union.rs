//! A band as polygons that do not cross themselves and together cover what the band sweeps.
//!
//! Each step of the path is a quadrilateral with square ends, and each corner a wedge on its outer side with the miter of
//! the outline. Neighbors share their corner points, so rounding to a grid opens no gap between them.

use phidl_core::geom::{Point, signed_area};

use crate::Side;
use crate::band::Band;

/// Areas below this (µm²) are left out.
const NOTHING: f64 = 1e-12;

/// The polygons of a band.
pub(crate) fn polygons(band: &Band<'_>) -> Vec<Vec<Point>> {
    let last = band.normals.len() - 1;
    let normals: Vec<Point> = (0..last).map(|i| step_normal(band, i)).collect();
    let steps = (0..last).map(|i| step(band, i, normals[i]));
    let corners = (1..last).map(|i| corner(band, i, normals[i - 1], normals[i]));
    steps.chain(corners).filter(|outline| signed_area(outline).abs() > NOTHING).collect()
}

/// The unit vector to the right of a step; at a bevel, which has no length, that of its second sample.
fn step_normal(band: &Band<'_>, i: usize) -> Point {
    let along = band.normals.points[i + 1] - band.normals.points[i];
    let length = along.norm();
    if length > 0.0 { Point::new(along.y, -along.x) / length } else { band.normals.vectors[i + 1] }
}

/// The quadrilateral of a step, with a vertex on the path where the path is inside the band.
fn step(band: &Band<'_>, i: usize, normal: Point) -> Vec<Point> {
    let last = band.normals.len() - 1;
    let face = |sample: usize| {
        let p = band.normals.points[sample];
        let across = if sample == 0 || sample == last { band.normals.vectors[sample] } else { normal };
        let (left, right) = (band.distance(Side::Left, sample), band.distance(Side::Right, sample));
        let inside = (left < 0.0 && right > 0.0).then_some(p);
        [Some(p + across * left), inside, Some(p + across * right)]
    };
    let (start, end) = (face(i), face(i + 1));
    start.into_iter().chain(end.into_iter().rev()).flatten().collect()
}

/// The wedge at a corner between two steps, on the outer side of the turn.
fn corner(band: &Band<'_>, sample: usize, before: Point, after: Point) -> Vec<Point> {
    let outer_side = if before.cross(after) > 0.0 { Side::Right } else { Side::Left };
    let sign = outer_side.sign();
    let (outer, inner) =
        (band.distance(outer_side, sample) * sign, band.distance(outer_side.opposite(), sample) * sign);
    if outer <= 0.0 {
        return Vec::new();
    }
    let inner = inner.max(0.0);
    let (p, miter) = (band.normals.points[sample], band.normals.vectors[sample]);
    let at = |along: Point, distance: f64| p + along * (sign * distance);
    let mut wedge = vec![at(before, inner), at(before, outer), at(miter, outer), at(after, outer), at(after, inner)];
    if inner > 0.0 {
        wedge.push(at(miter, inner));
    }
    wedge
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::band::Baseline;
    use crate::{CrossSection, Path};

    #[test]
    fn a_corner_is_two_legs_and_a_wedge() {
        let path = Path::from_points([(0, 0), (10, 0), (10, 10)]).unwrap();
        let x = CrossSection::of_width(2, 0);
        let baseline = Baseline::new(&path, &x).unwrap();
        let polygons = polygons(&baseline.bands(&x).unwrap()[0]);
        let areas: Vec<f64> = polygons.iter().map(|outline| signed_area(outline).abs()).collect();
        assert_eq!(areas, [20.0, 20.0, 1.0]);
    }
}
