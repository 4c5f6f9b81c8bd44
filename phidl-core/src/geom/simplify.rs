//! Fewer points within a tolerance: Ramer–Douglas–Peucker.
//!
//! U. Ramer, "An iterative procedure for the polygonal approximation of plane curves", Comput. Graph. Image Process. 1,
//! 244–256 (1972); D. Douglas and T. Peucker, Cartographica 10, 112–122 (1973).

use super::Point;

/// The points of an open line that are needed to stay within `tolerance` (µm) of it; the ends always are.
///
/// Distances are taken to the infinite line through the ends of a stretch, and a point goes only if its distance is at
/// most the tolerance. With tolerance 0, exactly collinear points go. An outline is simplified as the line from its
/// first to its last point, so these two stay.
///
/// ```
/// # use phidl_core::geom::{Point, simplified};
/// let line = [(0, 0), (1, 0), (2, 0), (2, 2)].map(Point::from);
/// assert_eq!(simplified(&line, 0.01).len(), 3);
/// ```
#[must_use]
pub fn simplified(line: &[Point], tolerance: f64) -> Vec<Point> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut keep = vec![false; line.len()];
    keep[0] = true;
    keep[line.len() - 1] = true;
    // An explicit stack: a recursion as deep as the line is long would end the program on a spiral of a million points.
    let mut stretches = vec![(0, line.len() - 1)];
    while let Some((first, last)) = stretches.pop() {
        if let Some((middle, distance)) = farthest(line, first, last)
            && distance > tolerance
        {
            keep[middle] = true;
            stretches.push((first, middle));
            stretches.push((middle, last));
        }
    }
    line.iter().zip(keep).filter_map(|(p, kept)| kept.then_some(*p)).collect()
}

/// The first of the points between two others that is farthest from the line through them.
fn farthest(line: &[Point], first: usize, last: usize) -> Option<(usize, f64)> {
    let (a, b) = (line[first], line[last]);
    let along = b - a;
    let length = along.norm();
    let distance = |p: Point| if length == 0.0 { p.distance(a) } else { along.cross(a - p).abs() / length };
    let mut best = None;
    for (i, p) in line.iter().enumerate().take(last).skip(first + 1) {
        let d = distance(*p);
        if best.is_none_or(|(_, most)| d > most) {
            best = Some((i, d));
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(pairs: &[(f64, f64)]) -> Vec<Point> {
        pairs.iter().map(|p| Point::from(*p)).collect()
    }

    #[test]
    fn collinear_points_go_but_the_first_and_the_last_stay() {
        let outline = points(&[(0., 0.), (1., 0.), (2., 0.), (2., 2.), (0., 2.), (0., 1.)]);
        assert_eq!(simplified(&outline, 1e-3), points(&[(0., 0.), (2., 0.), (2., 2.), (0., 2.), (0., 1.)]));
    }

    #[test]
    fn a_point_at_the_tolerance_goes_and_one_beyond_it_stays() {
        let tent = points(&[(0., 0.), (1., 0.5), (2., 0.)]);
        assert_eq!(simplified(&tent, 0.5).len(), 2);
        assert_eq!(simplified(&tent, 0.4999).len(), 3);
    }

    #[test]
    fn a_half_circle_keeps_the_five_points_that_the_specification_names() {
        let circle: Vec<Point> = (0..1000)
            .map(|i| std::f64::consts::PI * f64::from(i) / 999.0)
            .map(|t| Point::new(t.cos(), t.sin()))
            .collect();
        let kept = simplified(&circle, 0.1);
        let expected =
            points(&[(1., 0.), (0.708773, 0.705437), (0.001572, 0.999999), (-0.706551, 0.707662), (-1., 0.)]);
        assert_eq!(kept.len(), 5);
        assert!(kept.iter().zip(&expected).all(|(a, b)| a.distance(*b) < 1e-6), "{kept:?}");
    }

    #[test]
    fn a_closed_line_is_split_at_its_farthest_point() {
        let ring = points(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.), (0., 0.)]);
        assert_eq!(simplified(&ring, 0.1), ring);
    }
}
