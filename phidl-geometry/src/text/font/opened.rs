//! Contours with holes, turned into outlines without: GDSII has no holes.
//!
//! Fonts fill by the winding number: a contour against the direction of the outer ones cuts a hole. A hole is opened by a
//! keyhole: the outline runs from one of its vertices to a vertex of the hole, around the hole, and back along the same
//! seam. No vertex is added, so the area is exact, and both sides of the seam coincide after any rounding. Rejected: a
//! seam to the nearest *edge*, whose new vertex rounds away from the edge; cutting the glyph into trapezoids, which gives
//! many polygons that touch.
//!
//! Contours of the same direction that overlap, as in many variable fonts, become polygons that overlap, which is the
//! same drawing: a layer is the union of its polygons.

use phidl_core::geom::{Point, signed_area};

use super::polygon::{contains, segments_cross};

/// The outlines of a glyph, holes opened.
pub(super) fn outlines(contours: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    shapes(contours).into_iter().map(Shape::opened).collect()
}

/// A contour with the holes in it.
struct Shape {
    outer: Vec<Point>,
    holes: Vec<Vec<Point>>,
}

/// Assigns every hole to the smallest contour around it. The largest contour defines the filling direction, since TrueType
/// and PostScript disagree about it.
fn shapes(contours: Vec<Vec<Point>>) -> Vec<Shape> {
    let largest = contours.iter().map(|c| signed_area(c)).max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(1.0);
    let (filled, cut): (Vec<_>, Vec<_>) = contours.into_iter().partition(|c| signed_area(c) * largest > 0.0);
    let mut shapes: Vec<Shape> = filled.into_iter().map(|outer| Shape { outer, holes: Vec::new() }).collect();
    for hole in cut {
        let around = shapes.iter_mut().filter(|shape| shape.holes_could_have(&hole));
        match around.min_by(|a, b| signed_area(&a.outer).abs().total_cmp(&signed_area(&b.outer).abs())) {
            Some(shape) => shape.holes.push(hole),
            // Outside of everything the winding number is not zero either: it is filled.
            None => shapes.push(Shape { outer: hole, holes: Vec::new() }),
        }
    }
    shapes
}

impl Shape {
    fn holes_could_have(&self, hole: &[Point]) -> bool {
        hole.iter().all(|p| contains(&self.outer, *p))
    }

    /// One outline: holes are joined from right to left, each to the nearest vertex on its right that it sees.
    fn opened(mut self) -> Vec<Point> {
        let rightmost = |hole: &Vec<Point>| hole.iter().map(|p| p.x).fold(f64::NEG_INFINITY, f64::max);
        self.holes.sort_by(|a, b| rightmost(b).total_cmp(&rightmost(a)));
        self.holes.into_iter().fold(self.outer, |outline, hole| joined(outline, &hole))
    }
}

/// The outline with a hole joined to it by a seam.
fn joined(mut outline: Vec<Point>, hole: &[Point]) -> Vec<Point> {
    let start = (0..hole.len()).max_by(|a, b| hole[*a].x.total_cmp(&hole[*b].x)).unwrap_or(0);
    let from = hole[start];
    let mut vertices: Vec<usize> = (0..outline.len()).filter(|i| outline[*i].x >= from.x).collect();
    vertices.sort_by(|a, b| outline[*a].distance(from).total_cmp(&outline[*b].distance(from)));
    // There is one: what is right of the rightmost point of the hole is not hidden by the hole, and the nearest vertex
    // in the triangle before the edge to its right is hidden by nothing else.
    let seen =
        vertices.into_iter().find(|i| !crosses(&outline, from, outline[*i]) && !crosses(hole, from, outline[*i]));
    // Contours that cross may hide all; a seam across them still covers the same, since its two sides cancel.
    let index = seen.unwrap_or(0);
    let seam = outline[index];
    let round = hole[start..].iter().chain(&hole[..=start]).copied();
    outline.splice(index..=index, [seam].into_iter().chain(round).chain([seam]));
    outline
}

/// Whether the segment between two points crosses an edge of a contour.
fn crosses(contour: &[Point], from: Point, to: Point) -> bool {
    (0..contour.len()).any(|i| segments_cross(from, to, contour[i], contour[(i + 1) % contour.len()]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, size: f64, clockwise: bool) -> Vec<Point> {
        let mut corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)].map(Point::from).to_vec();
        if clockwise {
            corners.reverse();
        }
        corners
    }

    #[test]
    fn holes_are_cut_whatever_the_direction_of_the_font() {
        for truetype in [false, true] {
            let holes = [square(2.0, 2.0, 2.0, !truetype), square(6.0, 3.0, 1.0, !truetype)];
            let contours = [vec![square(0.0, 0.0, 10.0, truetype)], holes.to_vec()].concat();
            let opened = outlines(contours);
            assert_eq!(opened.len(), 1);
            assert_eq!(signed_area(&opened[0]).abs(), 100.0 - 4.0 - 1.0);
            assert_eq!(opened[0].len(), 3 * 4 + 2 * 2, "each seam repeats two vertices and makes none");
        }
    }

    #[test]
    fn an_island_in_a_hole_is_a_polygon_of_its_own() {
        let contours = vec![square(0.0, 0.0, 9.0, false), square(1.0, 1.0, 7.0, true), square(3.0, 3.0, 2.0, false)];
        let areas: Vec<f64> = outlines(contours).iter().map(|outline| signed_area(outline)).collect();
        assert_eq!(areas, [81.0 - 49.0, 4.0]);
    }

    #[test]
    fn a_hole_goes_to_the_smallest_contour_around_it() {
        let contours = vec![square(0.0, 0.0, 2.0, false), square(10.0, 0.0, 5.0, false), square(11.0, 1.0, 1.0, true)];
        let areas: Vec<f64> = outlines(contours).iter().map(|outline| signed_area(outline)).collect();
        assert_eq!(areas, [4.0, 24.0]);
    }
}
