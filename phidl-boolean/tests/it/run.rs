//! Progress, stopping and refusals; nasty but small inputs.

use std::sync::{
    Arc,
    atomic::{AtomicUsize, Ordering},
};

use phidl_boolean::{
    BooleanError, Operation, Options, ProgressMonitor, Region, RunOptions, StripCount,
    grid::{Contours, GridPoint, MAX_COORDINATE, boolean},
    union,
};
use phidl_core::scene::Device;

use crate::support::{confetti, dots, snapped};

fn shape(points: &[(i64, i64)]) -> Contours {
    [points.iter().copied().map(GridPoint::from).collect::<Vec<_>>()].into_iter().collect()
}

fn merged(shapes: &Contours) -> Region {
    Region::merged(shapes, &RunOptions::default()).unwrap()
}

#[test]
fn progress_counts_up_to_its_total() {
    let last = Arc::new(AtomicUsize::new(0));
    let seen = last.clone();
    let monitor = ProgressMonitor::with_report(move |progress| {
        assert!(progress.done <= progress.total);
        if progress.done == progress.total {
            seen.fetch_add(1, Ordering::Relaxed);
        }
    });
    let options =
        RunOptions { monitor: Some(&monitor), strips: StripCount::VerticesPerStrip(100), ..RunOptions::default() };
    boolean(&confetti(20, 1), &confetti(20, 2), Operation::Xor, &options).unwrap();
    assert_eq!(last.load(Ordering::Relaxed), 1);
}

#[test]
fn an_operation_can_be_cancelled_from_its_own_report() {
    let monitor = Arc::new(std::sync::OnceLock::<ProgressMonitor>::new());
    let inner = monitor.clone();
    let monitor = monitor.get_or_init(move || {
        ProgressMonitor::with_report(move |progress| {
            if progress.done > 2
                && let Some(monitor) = inner.get()
            {
                monitor.cancel();
            }
        })
    });
    let options =
        RunOptions { monitor: Some(monitor), strips: StripCount::VerticesPerStrip(20), ..RunOptions::default() };
    let result = boolean(&confetti(20, 1), &confetti(20, 2), Operation::Or, &options);
    assert_eq!(result, Err(BooleanError::Cancelled));
}

#[test]
fn copies_of_a_shape_are_the_shape() {
    let one = confetti(5, 1);
    let mut copies = Contours::new();
    (0..300).for_each(|_| copies.append(&one));
    let others = confetti(5, 2);
    for operation in [Operation::Or, Operation::And, Operation::Not, Operation::Xor] {
        let run = RunOptions::default();
        let expected = boolean(&one, &others, operation, &run).unwrap();
        assert_eq!(boolean(&copies, &others, operation, &run).unwrap(), expected, "{operation:?}");
    }
}

#[test]
fn an_operation_beyond_its_memory_is_refused_before_and_while_it_runs() {
    let run = |memory_limit| RunOptions { memory_limit, ..RunOptions::default() };
    let refused = |shapes: &Contours, limit| Region::merged(shapes, &run(limit)).unwrap_err();
    let scene = confetti(100, 1);
    assert!(matches!(refused(&scene, 1000), BooleanError::Memory { crossings: 0, .. }));
    // 2 × 250 bars have 250,000 crossings and few edges.
    let mut bars = Contours::new();
    testkit::scenes::crossbar(250, 7.3).iter().for_each(|layer| bars.append(&snapped(layer)));
    let error = refused(&bars, 5_000_000);
    assert!(matches!(error, BooleanError::Memory { crossings: 40_000.., .. }), "{error}");
    assert!(Region::merged(&bars, &run(500_000_000)).is_ok());
}

#[test]
fn a_huge_array_is_refused_with_its_cell_before_it_is_flattened() {
    let mut d = Device::builder("via");
    d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], 1).unwrap();
    let vias = d.build().unwrap().array(60_000, 60_000, (5, 5));
    let error = union(&vias, 1, &Options::default()).unwrap_err().to_string();
    assert!(error.starts_with("union: in cell via: 14400000000 edges"), "{error}");
}

#[test]
fn coordinates_at_the_end_of_the_range_work_and_beyond_it_name_the_shape() {
    let m = MAX_COORDINATE;
    let diamond = shape(&[(m, 0), (0, m), (-m, 0), (0, -m)]);
    let cross = shape(&[(-m, -m), (m, m - 8), (m, m), (-m, 8 - m)]);
    let both = boolean(&diamond, &cross, Operation::And, &RunOptions::default()).unwrap();
    let corner = both.bbox().unwrap().1;
    assert!((corner.x - m / 2).abs() <= 4 && (corner.y - m / 2).abs() <= 4, "{corner:?}");
    let beyond = boolean(&diamond, &shape(&[(0, 0), (m + 1, 0), (0, 1)]), Operation::Or, &RunOptions::default());
    assert_eq!(beyond, Err(BooleanError::OutOfRange { shape: 0, x: m + 1, y: 0 }));
}

#[test]
fn operators_take_every_region_that_there_is() {
    let m = MAX_COORDINATE;
    let plane = merged(&shape(&[(-m, -m), (m, -m), (m, m), (-m, m)]));
    let needles = merged(&shape(&[(-m, -m), (m, m - 1), (m, m), (1 - m, m), (0, 1), (-m, 1 - m)]));
    for region in [&plane, &needles, &(&plane - &needles), &Region::new()] {
        for other in [&plane, &needles] {
            let [or, and, xor, not] = [region | other, region & other, region ^ other, region - other];
            assert!([&or, &and, &xor, &not].iter().all(|r| r.contours().check_range().is_ok()));
            assert!(or.area() + 4.0 * m as f64 >= region.area().max(other.area()));
        }
    }
    // What would lie beyond the range is refused before it is a region.
    let beyond = plane.offset(1.0, phidl_boolean::Join::default(), &RunOptions::default());
    assert!(matches!(beyond, Err(BooleanError::OutOfRange { .. })), "{beyond:?}");
}

#[test]
fn shapes_without_area_cover_nothing() {
    for points in [&[][..], &[(1, 1)], &[(1, 1), (5, 5)], &[(0, 0), (9, 9), (4, 4)], &[(2, 2), (2, 2), (2, 2), (2, 2)]]
    {
        assert!(merged(&shape(points)).is_empty(), "{points:?}");
    }
}

#[test]
fn spikes_and_repeated_points_disappear() {
    let square = merged(&shape(&[(0, 0), (10, 0), (10, 10), (0, 10)]));
    let spiky = shape(&[(0, 0), (0, 0), (5, 0), (15, 0), (10, 0), (10, 10), (10, 20), (10, 10), (0, 10), (0, 10)]);
    assert_eq!(merged(&spiky), square);
}

#[test]
fn both_lobes_of_a_figure_eight_count_even_on_top_of_another_shape() {
    let eight = [(0, 0), (100, 100), (100, 0), (0, 80)];
    let lobes = merged(&shape(&eight));
    assert_eq!(lobes.polygons().len(), 2);
    let mut covered = shape(&[(-10, -10), (110, -10), (110, 110), (-10, 110)]);
    covered.append(&shape(&eight));
    assert_eq!(merged(&covered).area(), 120.0 * 120.0);
}

#[test]
fn a_keyhole_is_a_hole() {
    let keyholed = shape(&[(10, 10), (0, 10), (0, 3), (3, 3), (3, 7), (7, 7), (7, 3), (3, 3), (0, 3), (0, 0), (10, 0)]);
    let region = merged(&keyholed);
    assert_eq!((region.area(), region.contours().len()), (84.0, 2));
    let turned: Contours = keyholed.iter().map(|c| c.iter().rev().copied().collect::<Vec<_>>()).collect();
    assert_eq!(merged(&turned), region);
}

#[test]
fn the_example_that_breaks_hole_linking_elsewhere_has_its_correct_areas() {
    let micrometers = |shapes: &[&[(i64, i64)]]| -> Contours {
        shapes
            .iter()
            .map(|s| s.iter().map(|&(x, y)| GridPoint::new(x * 10_000, y * 10_000)).collect::<Vec<_>>())
            .collect()
    };
    let first: [&[(i64, i64)]; 2] =
        [&[(12, 25), (28, 25), (21, 31), (5, 32)], &[(26, 3), (26, 21), (23, 26), (11, 20)]];
    let a = micrometers(&[first[0], first[1], &[(27, 1), (15, 37), (13, 34), (15, 25)]]);
    let b = micrometers(&[first[0], first[1], &[(26, 1), (15, 37), (14, 33), (14, 24)]]);
    for (operation, area) in [
        (Operation::Not, 5.108_101),
        (Operation::BMinusA, 5.375_419),
        (Operation::Xor, 10.483_520),
        (Operation::And, 287.741_180),
        (Operation::Or, 298.224_700),
    ] {
        let result = boolean(&a, &b, operation, &RunOptions::default()).unwrap();
        assert!((result.area() / 1e8 - area).abs() < 2e-3, "{operation:?}: {}", result.area() / 1e8);
    }
}

#[test]
fn shapes_that_touch_in_a_point_stay_two_and_those_that_share_an_edge_are_one() {
    let mut shapes = shape(&[(0, 0), (10, 0), (10, 10), (0, 10)]);
    shapes.append(&shape(&[(10, 10), (20, 10), (20, 20), (10, 20)]));
    assert_eq!(merged(&shapes).polygons().len(), 2);
    shapes.append(&shape(&[(10, 0), (20, 0), (20, 10), (10, 10)]));
    assert_eq!(merged(&shapes).polygons().len(), 1);
}

#[test]
fn the_operation_is_the_set_algebra_for_empty_operands() {
    let (some, none) = (shape(&[(0, 0), (4, 0), (0, 4)]), Contours::new());
    let run = |a: &Contours, b: &Contours, operation| boolean(a, b, operation, &RunOptions::default()).unwrap().area();
    for (operation, a_only, b_only) in [
        (Operation::Or, 8.0, 8.0),
        (Operation::And, 0.0, 0.0),
        (Operation::Not, 8.0, 0.0),
        (Operation::BMinusA, 0.0, 8.0),
        (Operation::Xor, 8.0, 8.0),
    ] {
        assert_eq!((run(&some, &none, operation), run(&none, &some, operation)), (a_only, b_only), "{operation:?}");
        assert_eq!(run(&none, &none, operation), 0.0);
    }
}

#[test]
fn shapes_that_touch_nothing_keep_their_points() {
    let scene = dots(200);
    let region = merged(&scene);
    assert_eq!(region.polygons().len(), scene.len());
    let sorted = |contours: &Contours| {
        let mut points = contours.points().to_vec();
        points.sort_unstable();
        points
    };
    assert_eq!(sorted(region.contours()), sorted(&scene));
}
