//! Laws that hold for all inputs.

use phidl_boolean::{
    Operation, Region, RunOptions, StripCount,
    grid::{Contours, GridPoint, boolean},
};
use proptest::prelude::*;

use crate::{
    check::{assert_clean, assert_covers, assert_same_cover},
    shapes::{any_operation, any_shapes, rectangles},
};

fn strips(strip_vertices: usize) -> RunOptions<'static> {
    RunOptions { strips: StripCount::VerticesPerStrip(strip_vertices), ..RunOptions::default() }
}

fn undivided(a: &Contours, b: &Contours, operation: Operation) -> Region {
    boolean(a, b, operation, &strips(usize::MAX)).unwrap()
}

fn probes() -> Vec<GridPoint> {
    let step = |range: std::ops::Range<i64>, by| range.step_by(by);
    let fine = (0..=14).flat_map(|x| (0..=14).map(move |y| GridPoint::new(x, y)));
    let coarse = step(-3..2003, 97).flat_map(|x| step(-2..2003, 89).map(move |y| GridPoint::new(x, y)));
    fine.chain(coarse).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn results_do_not_depend_on_the_strips_or_the_threads(
        a in any_shapes(), b in any_shapes(), operation in any_operation(), strip_vertices in 1usize..40,
    ) {
        let whole = undivided(&a, &b, operation);
        prop_assert_eq!(&whole, &boolean(&a, &b, operation, &strips(strip_vertices)).unwrap());
        prop_assert_eq!(&whole, &boolean(&a, &b, operation, &strips(1)).unwrap());
        let options = RunOptions { threads: Some(3), ..strips(strip_vertices) };
        prop_assert_eq!(&whole, &boolean(&a, &b, operation, &options).unwrap());
    }

    #[test]
    fn results_are_clean_and_cover_what_set_theory_says(
        a in any_shapes(), b in any_shapes(), operation in any_operation(),
    ) {
        let result = undivided(&a, &b, operation);
        assert_clean(&result);
        assert_covers(&result, &a, &b, operation, &probes());
    }

    #[test]
    fn operations_on_clean_regions_are_exact_where_nothing_is_snapped(a in rectangles(12, 20), b in rectangles(12, 20)) {
        let run = RunOptions::default();
        let (a, b) = (Region::merged(&a, &run).unwrap(), Region::merged(&b, &run).unwrap());
        prop_assert_eq!((&a | &b).area2() + (&a & &b).area2(), a.area2() + b.area2());
        prop_assert_eq!((&a ^ &b).area2(), (&a - &b).area2() + (&b - &a).area2());
        prop_assert_eq!(&a - &b, &a - &(&a & &b));
        prop_assert_eq!((&a | &b) - b.clone(), &a - &b);
    }

    #[test]
    fn operands_may_be_exchanged(a in any_shapes(), b in any_shapes()) {
        for operation in [Operation::Or, Operation::And, Operation::Xor] {
            prop_assert_eq!(undivided(&a, &b, operation), undivided(&b, &a, operation));
        }
        prop_assert_eq!(undivided(&a, &b, Operation::Not), undivided(&b, &a, Operation::BMinusA));
    }

    #[test]
    fn shapes_united_one_after_the_other_or_all_at_once_are_the_same(a in rectangles(12, 20)) {
        let run = RunOptions::default();
        let one_by_one = a.iter().map(|shape| Region::merged(&[shape.to_vec()].into_iter().collect(), &run).unwrap());
        prop_assert_eq!(one_by_one.fold(Region::new(), |all, one| all | one), Region::merged(&a, &run).unwrap());
    }

    #[test]
    fn a_clean_region_without_slanted_edges_is_left_as_it_is(a in rectangles(12, 20)) {
        let merged = Region::merged(&a, &RunOptions::default()).unwrap();
        prop_assert_eq!(&(&merged | &merged), &merged);
        prop_assert_eq!(&(&merged & &merged), &merged);
        prop_assert_eq!(&(&merged - &Region::new()), &merged);
    }

    /// A snapped edge may come within half a step of a vertex; only then it is snapped once more.
    #[test]
    fn a_clean_region_keeps_its_place_to_half_a_step(a in any_shapes()) {
        let merged = Region::merged(&a, &RunOptions::default()).unwrap();
        let again = &merged | &merged;
        prop_assert_eq!(&(&merged & &merged), &again);
        prop_assert!((&merged - &merged).is_empty());
        prop_assert!((&merged ^ &Region::new()) == again);
        assert_same_cover(&again, &merged, &probes());
    }

    #[test]
    fn areas_of_snapped_edges_differ_by_less_than_half_a_step_along_them(a in any_shapes(), b in any_shapes()) {
        let perimeter: f64 = a.iter().chain(b.iter()).map(|c| {
            c.iter().zip(c.iter().cycle().skip(1)).map(|(p, q)| ((p.x - q.x) as f64).hypot((p.y - q.y) as f64)).sum::<f64>()
        }).sum();
        let area = |operation| undivided(&a, &b, operation).area();
        let alone = |shapes: &Contours| undivided(shapes, &Contours::new(), Operation::Or).area();
        let difference = area(Operation::Or) + area(Operation::And) - alone(&a) - alone(&b);
        prop_assert!(difference.abs() <= 2.0 * perimeter, "{difference} at a perimeter of {perimeter}");
    }
}
