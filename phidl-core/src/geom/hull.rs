//! Convex hulls: the few points that decide the bounding box of a turned cell.

use super::Point;

/// The corners of the smallest convex polygon around some points, counter-clockwise (A. M. Andrew, "Another efficient
/// algorithm for convex hulls in two dimensions", Inf. Process. Lett. 9, 216–219, 1979). Points inside an edge are left out.
pub(crate) fn convex_hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_unstable_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut hull = half_hull(points.iter().copied());
    hull.pop();
    hull.extend(half_hull(points.into_iter().rev()));
    hull.pop();
    hull
}

fn half_hull(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut hull: Vec<Point> = Vec::new();
    for p in points {
        while let [.., a, b] = hull[..]
            && (b - a).cross(p - b) <= 0.0
        {
            hull.pop();
        }
        hull.push(p);
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_and_repeated_points_are_left_out() {
        let square = [(0, 0), (4, 0), (4, 4), (0, 4)].map(Point::from);
        let mut points = square.to_vec();
        points.extend([(2, 2), (2, 0), (0, 0), (1, 3)].map(Point::from));
        assert_eq!(convex_hull(points), square);
    }

    #[test]
    fn few_points_are_their_own_hull() {
        assert_eq!(convex_hull(vec![]), vec![]);
        assert_eq!(convex_hull(vec![Point::ORIGIN; 3]), vec![Point::ORIGIN]);
        let line = [(0, 0), (1, 1), (2, 2)].map(Point::from).to_vec();
        assert_eq!(convex_hull(line.clone()), vec![line[0], line[2]]);
    }
}
