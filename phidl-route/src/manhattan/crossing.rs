//! Where lines cross themselves or one another.

use phidl_core::geom::Point;

/// Lengths below this (µm) are rounding: lines that share less do not cross.
const NOISE: f64 = 1e-6;

/// How often a line crosses or covers itself. Touching with an end does not count: a line may end beside itself.
pub(crate) fn crossings(points: &[Point]) -> usize {
    let legs: Vec<[Point; 2]> = points.windows(2).map(|leg| [leg[0], leg[1]]).collect();
    let apart = |i: usize| legs.get(i + 2..).unwrap_or(&[]);
    legs.iter().enumerate().map(|(i, leg)| apart(i).iter().filter(|other| cross(*leg, **other)).count()).sum()
}

/// Whether a leg crosses or covers one of the legs of a line, the last one aside.
pub(crate) fn crosses_before(leg: [Point; 2], line: &[Point]) -> bool {
    let before = &line[..line.len() - 1];
    before.windows(2).any(|other| cross(leg, [other[0], other[1]]))
}

/// Whether two legs cross within both, or lie on each other.
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

/// The smallest distance between two lines (µm).
pub(crate) fn distance(a: &[Point], b: &[Point]) -> f64 {
    let legs = a.windows(2).flat_map(|leg| b.windows(2).map(move |other| ([leg[0], leg[1]], [other[0], other[1]])));
    legs.map(|(leg, other)| leg_distance(leg, other)).fold(f64::INFINITY, f64::min)
}

fn leg_distance(a: [Point; 2], b: [Point; 2]) -> f64 {
    if cross(a, b) {
        return 0.0;
    }
    let ends = [to_leg(a[0], b), to_leg(a[1], b), to_leg(b[0], a), to_leg(b[1], a)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

/// Distance of a point from a leg.
fn to_leg(point: Point, leg: [Point; 2]) -> f64 {
    let (along, out) = (leg[1] - leg[0], point - leg[0]);
    let square = along.dot(along);
    let t = if square > 0.0 { (out.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(leg[0] + along * t)
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

    #[test]
    fn distances_are_measured_between_the_nearest_points() {
        let a = line(&[(0., 0.), (10., 0.)]);
        assert_eq!(distance(&a, &line(&[(13., 4.), (20., 9.)])), 5.0);
        assert_eq!(distance(&a, &line(&[(5., 2.), (5., 9.)])), 2.0);
        assert_eq!(distance(&a, &line(&[(5., -2.), (5., 9.)])), 0.0);
    }
}
