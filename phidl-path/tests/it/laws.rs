//! Laws that hold for every path.

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Overlaps, Path, Section, TransitionShape, transition};
use proptest::prelude::*;
use testkit::laws::placement_laws;
use testkit::strategies::{angle, point, transform};

/// A piece of any kind and reasonable size.
fn piece() -> impl Strategy<Value = Path> {
    let angle = prop_oneof![-170.0..-2.0, 2.0..170.0f64];
    prop_oneof![
        (1.0..50.0f64).prop_map(|length| Path::straight(length).unwrap()),
        (2.0..30.0f64, angle.clone()).prop_map(|(radius, angle)| Path::arc(radius, angle).unwrap()),
        (2.0..30.0f64, angle, 0.1..1.0f64)
            .prop_map(|(radius, angle, p)| EulerBend::new().p(p).path(radius, angle).unwrap()),
    ]
}

fn path() -> impl Strategy<Value = Path> {
    prop::collection::vec(piece(), 1..5).prop_map(Path::of)
}

/// Waypoints that turn by at most 90° at a time, with legs long enough for bends of radius 3.
fn waypoints() -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec((8.0..60.0f64, -90.0..90.0f64), 2..7).prop_map(|legs| {
        let mut points = vec![Point::ORIGIN];
        let mut heading = 0.0;
        for (length, turn) in legs {
            heading += turn;
            points.push(points[points.len() - 1] + Point::polar(length, heading));
        }
        points
    })
}

/// The smaller turn between two directions.
fn apart(a: f64, b: f64) -> f64 {
    phidl_core::num::angle::between(a, b)
}

fn close(a: &Path, b: &Path) -> bool {
    a.points().len() == b.points().len()
        && a.points().iter().zip(b.points()).all(|(p, q)| p.distance(*q) < 1e-9)
        && apart(a.start_angle(), b.start_angle()) < 1e-9
        && apart(a.end_angle(), b.end_angle()) < 1e-9
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(64) })]

    #[test]
    fn paths_keep_the_placement_laws(radius in 1.0..50.0f64, turns in prop::collection::vec(angle(), 1..4), t in transform()) {
        let arcs = turns.iter().map(|turn| Path::arc(radius, turn - 180.5).unwrap()).collect::<Vec<_>>();
        placement_laws(&Path::of(arcs), &t)?;
    }

    #[test]
    fn placement_methods_are_inverted_by_their_opposites(path in path(), by in point(), degrees in angle()) {
        let there = path.clone().rotated_about(degrees, by).moved_by(by);
        prop_assert!(close(&there.moved_by(-by).rotated_about(-degrees, by), &path));
        let line = (by, by + Point::new(1.0, degrees));
        prop_assert!(close(&path.clone().mirrored(line.0, line.1).mirrored(line.0, line.1), &path));
    }

    #[test]
    fn a_turn_in_place_is_the_transform_of_it(path in path(), degrees in -400.0..400.0f64) {
        let mut transformed = path.clone();
        transformed.transform_mut(&Transform::rotation(degrees));
        prop_assert!(close(&path.clone().rotated(degrees), &transformed));
        let mut transformed = path.clone();
        transformed.transform_mut(&Transform::reflection((0, 0), (1.0, degrees)));
        prop_assert!(close(&path.mirrored((0, 0), (1.0, degrees)), &transformed));
    }

    #[test]
    fn appended_pieces_go_on_where_the_path_ends_and_as_it_ends(first in path(), second in path()) {
        let joined = first.clone() + &second;
        let n = first.points().len();
        prop_assert_eq!(joined.points().len(), n + second.points().len() - 1);
        prop_assert_eq!(joined.points()[n - 1], first.end());
        prop_assert!((joined.length() - first.length() - second.length()).abs() < 1e-9 * joined.length());
        let turned = first.end_angle() - first.start_angle() + second.end_angle() - second.start_angle();
        prop_assert!(apart(joined.end_angle() - joined.start_angle(), turned) < 1e-9);
        // Curves that meet without a kink: the turn at the joint is that of half a step on either side.
        let (before, joint, after) = (joined.points()[n - 2], joined.points()[n - 1], joined.points()[n]);
        prop_assert!(apart((joint - before).direction(), (after - joint).direction()) < 1.0);
    }

    #[test]
    fn appending_is_associative(a in path(), b in path(), c in path()) {
        let left = (a.clone() + &b) + &c;
        let right = a + (b + &c);
        prop_assert!(close(&left, &right));
    }

    #[test]
    fn a_smooth_parallel_curve_is_longer_by_its_distance_times_the_turn(
        radius in 5.0..50.0f64,
        degrees in 5.0..350.0f64,
        distance in -4.0..4.0f64,
    ) {
        let bend = EulerBend::new().p(0.5).path(radius, degrees).unwrap();
        let expected = bend.length() + distance * degrees.to_radians();
        let offset = bend.offset(distance).unwrap();
        prop_assert!((offset.length() / expected - 1.0).abs() < 1e-4, "{} {expected}", offset.length());
        // And back again, but for the ends, whose faces follow the tangents and not the chords.
        let back = offset.offset(-distance).unwrap();
        let inner = 2..bend.points().len() - 2;
        prop_assert!(inner.into_iter().all(|i| back.points()[i].distance(bend.points()[i]) < 1e-9));
    }

    #[test]
    fn mirroring_the_path_mirrors_the_drawing(path in path(), width in 0.1..1.0f64, offset in -1.0..1.0f64) {
        let section = || Section::new(width).layer(1).ports("in", "out");
        let x = CrossSection::new().add(section().offset(offset));
        let drawn = path.extrude(&x).unwrap();
        let mirrored = path.mirrored((0, 0), (1, 0)).extrude(&x.mirrored()).unwrap();
        for name in ["in", "out"] {
            let (p, q) = (drawn.port(name).unwrap(), mirrored.port(name).unwrap());
            prop_assert!(p.midpoint().distance(Point::new(q.midpoint().x, -q.midpoint().y)) < 1e-9);
            prop_assert!(apart(p.orientation(), -q.orientation()) < 1e-9 && p.width() == q.width());
        }
        let area = |d: &Device| d.polygons().next().unwrap().area();
        prop_assert!((area(&drawn) - area(&mirrored)).abs() < 1e-9 * (1.0 + area(&drawn)));
    }

    #[test]
    fn a_strip_has_the_area_of_its_width_times_its_length_along_its_middle(radius in 3.0..40.0f64, degrees in 5.0..350.0f64) {
        // Pappus: the middle of the strip is the path.
        let path = Path::arc(radius, degrees).unwrap();
        let strip = path.extrude(&CrossSection::of_width(2, 1)).unwrap();
        let area = strip.polygons().next().unwrap().area();
        prop_assert!((area / (2.0 * radius * degrees.to_radians()) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn no_section_of_a_coplanar_transition_overlaps_or_leaves_another(
        path in path(),
        ends in [(0.2..4.0f64, 0.1..3.0f64), (0.2..4.0f64, 0.1..3.0f64)],
        shape in prop_oneof![Just(TransitionShape::Sine), Just(TransitionShape::Linear)],
        by_offset in any::<bool>(),
    ) {
        // Strip, gaps and grounds by the edges of others, or by numbers that meet at both ends.
        let [from, to] = ends.map(|(strip, gap)| if by_offset { cpw_by_offsets(strip, gap) } else { cpw(strip, gap) });
        // From left to right: ground, gap, strip, gap, ground; the second one is mirrored.
        let there = (transition(&from, &to, shape).unwrap(), [3, 1, 0, 2, 4]);
        let back = (transition(&to, &from, shape).unwrap().mirrored(), [4, 2, 0, 1, 3]);
        for (taper, order) in [there, back] {
            let drawn = Extrusion::new(&path, &taper).overlaps(Overlaps::Keep).build().unwrap();
            let edges: Vec<[Vec<Point>; 2]> = drawn.polygons().map(|polygon| edges(polygon.points)).collect();
            for pair in order.windows(2) {
                let ([_, right], [left, _]) = (&edges[pair[0]], &edges[pair[1]]);
                let apart = right.iter().zip(left).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                prop_assert!(apart < 1e-9, "{apart} µm between sections {pair:?}");
            }
            let last = path.points().len() - 1;
            for (section, [left, right]) in edges.iter().enumerate() {
                for (end, heading) in [(0, path.start_angle()), (last, path.end_angle())] {
                    let along = Point::polar(1.0, heading);
                    prop_assert!((right[end] - left[end]).dot(along).abs() < 1e-9, "the face of {section} is not square");
                }
            }
        }
    }

    #[test]
    fn smoothed_paths_start_and_end_on_their_waypoints_and_keep_the_radius(points in waypoints(), euler in any::<bool>()) {
        let smoothed = match euler {
            true => Path::smooth(points.clone(), 3, EulerBend::new().use_eff().p(0.2)),
            false => Path::smooth(points.clone(), 3, ArcBend::new()),
        };
        // A leg between two right angles needs 6 µm; all have at least 8.
        let path = smoothed.unwrap();
        prop_assert!(path.start().distance(points[0]) < 1e-9);
        prop_assert!(path.end().distance(points[points.len() - 1]) < 1e-9);
        prop_assert!(path.length() <= Path::from_points(points).unwrap().length() + 1e-9);
    }

    #[test]
    fn resampled_paths_stay_within_the_tolerance_of_their_curves(path in path(), tolerance in 1e-4..0.1f64) {
        let dense = path.with_tolerance(1e-6).unwrap();
        let coarse = path.with_tolerance(tolerance).unwrap();
        let far = dense.points().iter().step_by(7).map(|p| distance_to(*p, coarse.points())).fold(0.0, f64::max);
        prop_assert!(far <= tolerance + 1e-6, "{far} µm where {tolerance} µm are allowed");
    }
}

/// A coplanar line of a strip, two gaps and two grounds, each beside the one before.
fn cpw(strip: f64, gap: f64) -> CrossSection {
    CrossSection::new()
        .add(Section::new(strip).layer(1).named("strip"))
        .add(Section::new(gap).left_of("strip").layer(2).named("left gap"))
        .add(Section::new(gap).right_of("strip").layer(2).named("right gap"))
        .add(Section::new(5).left_of("left gap").layer(3).named("left ground"))
        .add(Section::new(5).right_of("right gap").layer(3).named("right ground"))
}

/// The same by offsets.
fn cpw_by_offsets(strip: f64, gap: f64) -> CrossSection {
    let (gap_at, ground_at) = ((strip + gap) / 2.0, strip / 2.0 + gap + 2.5);
    CrossSection::new()
        .add(Section::new(strip).layer(1).named("strip"))
        .add(Section::new(gap).offset(-gap_at).layer(2).named("left gap"))
        .add(Section::new(gap).offset(gap_at).layer(2).named("right gap"))
        .add(Section::new(5).offset(-ground_at).layer(3).named("left ground"))
        .add(Section::new(5).offset(ground_at).layer(3).named("right ground"))
}

/// The left and the right edge of an outline, both from the start on.
fn edges(outline: &[Point]) -> [Vec<Point>; 2] {
    let (right, left) = outline.split_at(outline.len() / 2);
    [left.iter().rev().copied().collect(), right.to_vec()]
}

/// Distance of a point to a line of chords.
fn distance_to(p: Point, chain: &[Point]) -> f64 {
    let to_chord = |chord: &[Point]| {
        let along = chord[1] - chord[0];
        let part = ((p - chord[0]).dot(along) / along.dot(along)).clamp(0.0, 1.0);
        p.distance(chord[0] + along * part)
    };
    chain.windows(2).map(to_chord).fold(f64::INFINITY, f64::min)
}
