//! Crossings of lines without width. They decide between PHIDL's waypoints and others.

use phidl_core::geom::Point;

/// Lengths below this (µm) are rounding; lines that share less do not cross.
const NOISE: f64 = 1e-6;

/// The number of times a line crosses or covers itself. An end that touches the line does not count.
pub(crate) fn crossings(points: &[Point]) -> usize {
    let legs: Vec<[Point; 2]> = points.windows(2).map(|leg| [leg[0], leg[1]]).collect();
    let later = |i: usize| legs.get(i + 2..).unwrap_or(&[]);
    legs.iter().enumerate().map(|(i, leg)| later(i).iter().filter(|other| cross(*leg, **other)).count()).sum()
}

/// Whether two legs cross at inner points of both, or overlap.
fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let (along_a, along_b) = (a[1] - a[0], b[1] - b[0]);
    let (length_a, length_b) = (along_a.norm(), along_b.norm());
    if length_a <= NOISE || length_b <= NOISE {
        return false;
    }
    let (along_a, along_b, between) = (along_a / length_a, along_b / length_b, b[0] - a[0]);
    let sine = along_a.cross(along_b);
    if sine.abs() * length_a.max(length_b) > NOISE {
        let within = |at: f64, length: f64| at > NOISE && at < length - NOISE;
        return within(between.cross(along_b) / sine, length_a) && within(between.cross(along_a) / sine, length_b);
    }
    let (from, to) = (between.dot(along_a), (b[1] - a[0]).dot(along_a));
    let shared = from.max(to).min(length_a) - from.min(to).max(0.0);
    between.cross(along_a).abs() <= NOISE && shared > NOISE
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    #[test]
    fn crossings_are_counted_and_touches_are_not() {
        let crossed = line(&[(0., 0.), (15., 0.), (15., -10.), (5., -10.), (5., 4.)]);
        let touching = line(&[(0., 0.), (15., 0.), (15., -10.), (5., -10.), (5., 0.)]);
        let covering = line(&[(0., 0.), (15., 0.), (15., 5.), (25., 5.), (25., 0.), (3., 0.)]);
        assert_eq!([crossings(&crossed), crossings(&touching), crossings(&covering)], [1, 0, 1]);
    }

    #[test]
    fn a_turned_line_crosses_itself_as_often() {
        let crossed = line(&[(0., 0.), (15., 0.), (15., -10.), (5., -10.), (5., 4.)]);
        for degrees in [0.3, 45.0, 77.7, 181.0] {
            let turn = phidl_core::geom::Transform::rotation(degrees);
            let turned: Vec<Point> = crossed.iter().map(|p| turn.apply(*p + Point::new(1e4, 3e3))).collect();
            assert_eq!(crossings(&turned), 1);
        }
    }
}
