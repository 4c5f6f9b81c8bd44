//! Growing and shrinking obey their definition.

use phidl_boolean::{
    Join, OffsetOptions, Region, RunOptions, StripCount,
    grid::{Contours, GridPoint, offset},
};
use proptest::prelude::*;

use crate::{
    check::assert_clean,
    shapes::{polygons, rectangles},
    support::confetti,
};

/// Steps by which rounding of edges and corners may move an outline.
const ROUNDING: f64 = 2.0;

fn any_join() -> impl Strategy<Value = Join> {
    prop_oneof![
        (1.0..6.0).prop_map(|limit| Join::Miter { limit }),
        (0.0..3.0).prop_map(|extension| Join::Extended { extension }),
        Just(Join::Bevel),
        (3.0..90.0).prop_map(|points_per_turn| Join::Round { points_per_turn }),
    ]
}

fn shapes() -> impl Strategy<Value = Contours> {
    prop_oneof![polygons(6, 300), rectangles(8, 200)]
}

fn moved(shapes: &Contours, distance: f64, join: Join) -> Region {
    offset(shapes, distance, &OffsetOptions { join, merge_first: true }, &RunOptions::default()).unwrap()
}

/// Distance from a point to the nearest edge of a region.
fn distance_to_edges(region: &Region, p: GridPoint) -> f64 {
    let to_edge = |(a, b): (&GridPoint, &GridPoint)| {
        let (dx, dy) = ((b.x - a.x) as f64, (b.y - a.y) as f64);
        let (px, py) = ((p.x - a.x) as f64, (p.y - a.y) as f64);
        let t = ((px * dx + py * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        (px - t * dx).hypot(py - t * dy)
    };
    let contours = region.contours().iter();
    contours.flat_map(|c| c.iter().zip(c.iter().cycle().skip(1))).map(to_edge).fold(f64::INFINITY, f64::min)
}

fn probes() -> impl Iterator<Item = GridPoint> {
    (-100..400).step_by(17).flat_map(|x| (-100..400).step_by(19).map(move |y| GridPoint::new(x, y)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn round_joins_give_the_places_within_the_distance(a in shapes(), distance in -60.0..60.0f64) {
        prop_assume!(distance.abs() > 3.0);
        let merged = moved(&a, 0.0, Join::default());
        let points_per_turn = 1000.0;
        let result = moved(&a, distance, Join::Round { points_per_turn });
        for p in probes() {
            let inside = merged.contains(p);
            let depth = distance_to_edges(&merged, p) * if inside { 1.0 } else { -1.0 };
            if (depth + distance).abs() > ROUNDING + 1.0 {
                prop_assert_eq!(result.contains(p), depth + distance > 0.0, "{:?} at depth {}", p, depth);
            }
        }
    }

    #[test]
    fn every_join_lies_between_the_chamfer_and_its_longest_tip(a in shapes(), distance in 3.0..60.0f64, join in any_join()) {
        let merged = moved(&a, 0.0, Join::default());
        let grown = moved(&a, distance, join);
        assert_clean(&grown);
        let reach = match join {
            Join::Miter { limit } => limit.max(2f64.sqrt()),
            Join::Extended { extension } => extension.hypot(1.0),
            Join::Bevel => 2f64.sqrt(),
            Join::Round { .. } => 1.0,
        };
        for p in probes().filter(|&p| !merged.contains(p)) {
            if grown.contains(p) {
                let away = distance_to_edges(&merged, p);
                prop_assert!(away <= distance * reach + ROUNDING, "{:?} is {} away", p, away);
            }
        }
        for p in probes().filter(|&p| merged.contains(p)) {
            prop_assert!(grown.contains(p) || distance_to_edges(&merged, p) < ROUNDING);
        }
    }

    /// Miter tips hold every disc around a corner, and arcs take away no more than a disc: closing loses nothing.
    #[test]
    fn growing_and_shrinking_again_keeps_the_shape_inside(a in shapes(), distance in 3.0..40.0f64) {
        let merged = moved(&a, 0.0, Join::default());
        let (tips, arcs) = (Join::Miter { limit: 2.0 }, Join::Round { points_per_turn: 64.0 });
        let run = RunOptions::default();
        let closed = merged.offset(distance, tips, &run).unwrap().offset(-distance, arcs, &run).unwrap();
        let deep = probes().filter(|&p| merged.contains(p) && distance_to_edges(&merged, p) > ROUNDING + 1.0);
        for p in deep {
            prop_assert!(closed.contains(p), "{:?} was lost", p);
        }
    }

    #[test]
    fn upright_shapes_grow_and_shrink_exactly(a in rectangles(10, 60), distance in 1..9i32) {
        let run = RunOptions::default();
        let distance = f64::from(distance);
        let merged = moved(&a, 0.0, Join::default());
        let closed = merged.offset(distance, Join::default(), &run).unwrap().offset(-distance, Join::default(), &run).unwrap();
        prop_assert!((&merged - &closed).is_empty());
        let opened = merged.offset(-distance, Join::default(), &run).unwrap().offset(distance, Join::default(), &run).unwrap();
        prop_assert!((&opened - &merged).is_empty());
    }

    #[test]
    fn offsets_do_not_depend_on_strips_threads_or_the_order_of_merging(
        a in shapes(), distance in -30.0..30.0f64, join in any_join(), strip_vertices in 1usize..50,
    ) {
        let options = OffsetOptions { join, merge_first: true };
        let whole = offset(&a, distance, &options, &RunOptions { strips: StripCount::VerticesPerStrip(usize::MAX), ..RunOptions::default() });
        let divided = offset(&a, distance, &options, &RunOptions { strips: StripCount::VerticesPerStrip(strip_vertices), threads: Some(2), ..RunOptions::default() });
        prop_assert_eq!(whole, divided);
    }
}

#[test]
fn a_crowded_scene_grows_into_less_holes_and_shrinks_into_more_pieces() {
    let scene = confetti(40, 3);
    let count = |region: &Region| (region.polygons().len(), region.contours().len());
    let merged = moved(&scene, 0.0, Join::default());
    let grown = moved(&scene, 5000.0, Join::default());
    let shrunk = moved(&scene, -3000.0, Join::default());
    [&grown, &shrunk].into_iter().for_each(assert_clean);
    assert!(count(&grown).0 < count(&merged).0);
    assert!((&merged - &grown).is_empty() && (&shrunk - &merged).is_empty());
}
