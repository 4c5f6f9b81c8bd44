//! Points that are one: clusters by gaps, with no borders of buckets for a pair to fall between.

use phidl_core::geom::Point;

/// The clusters of some points, as indices in ascending order: sorted by x and cut where neighbors differ by more than
/// `reach`, each run sorted by y and cut, and once more by x.
pub(super) fn clusters(points: impl Iterator<Item = Point>, reach: f64) -> Vec<Vec<usize>> {
    let points: Vec<Point> = points.collect();
    let mut order: Vec<usize> = (0..points.len()).collect();
    let mut runs = Vec::new();
    for run in cut(&mut order, |i| points[i].x, reach) {
        for run in cut(run, |i| points[i].y, reach) {
            runs.extend(cut(run, |i| points[i].x, reach).into_iter().map(|run| run.to_vec()));
        }
    }
    for run in &mut runs {
        run.sort_unstable();
    }
    runs
}

/// The runs of some indices, sorted by a coordinate, between gaps of more than `reach`.
fn cut(indices: &mut [usize], coordinate: impl Fn(usize) -> f64, reach: f64) -> Vec<&mut [usize]> {
    indices.sort_by(|a, b| coordinate(*a).total_cmp(&coordinate(*b)));
    indices.chunk_by_mut(|a, b| coordinate(*b) - coordinate(*a) <= reach).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_within_reach_are_one_cluster_and_others_are_not() {
        let at = |x: f64, y: f64| Point::new(x, y);
        let points = [at(0.0, 0.0), at(5.0, 0.0), at(1e-7, -1e-7), at(5.0, 1.0), at(5.0 + 2e-7, 1.0), at(0.0, 3e-6)];
        let mut found = clusters(points.into_iter(), 1e-6);
        found.sort();
        assert_eq!(found, [vec![0, 2], vec![1], vec![3, 4], vec![5]]);
    }

    #[test]
    fn a_column_of_many_points_is_cut_by_y() {
        let column = (0..10_000).map(|i| Point::new(7.0, f64::from(i)));
        assert_eq!(clusters(column, 1e-6).len(), 10_000);
    }
}
