//! Cutting regions for files keeps area, edges and points.

use std::collections::BTreeSet;

use phidl_boolean::{
    Operation, RunOptions,
    grid::{Contours, GridPoint, boolean, signed_area2},
};
use proptest::prelude::*;

use crate::shapes::{any_operation, any_shapes, rectangles};

fn area2(contours: &Contours) -> i128 {
    contours.iter().map(signed_area2).sum()
}

fn points(contours: &Contours) -> BTreeSet<GridPoint> {
    contours.points().iter().copied().collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn outlines_without_holes_have_the_points_and_the_area_of_the_region(
        a in any_shapes(), b in any_shapes(), operation in any_operation(),
    ) {
        let region = boolean(&a, &b, operation, &RunOptions::default()).unwrap();
        let outlines = region.without_holes();
        prop_assert_eq!(outlines.len(), region.polygons().len());
        prop_assert_eq!(points(&outlines), points(region.contours()));
        let holes = region.contours().len() - region.polygons().len();
        prop_assert_eq!(outlines.point_count(), region.contours().point_count() + 2 * holes);
        for (outline, polygon) in outlines.iter().zip(region.polygons()) {
            let expected = signed_area2(polygon.outer()) + polygon.holes().map(signed_area2).sum::<i128>();
            prop_assert_eq!(signed_area2(outline), expected);
        }
    }

    #[test]
    fn parts_obey_the_limit_add_no_point_and_keep_the_area(a in any_shapes(), b in any_shapes(), limit in 3usize..20) {
        let region = boolean(&a, &b, Operation::Xor, &RunOptions::default()).unwrap();
        let parts = region.fractured(limit).unwrap();
        prop_assert!(parts.iter().all(|part| part.len() <= limit && signed_area2(part) > 0));
        prop_assert_eq!(points(&parts), points(region.contours()));
        prop_assert_eq!(area2(&parts), region.area2());
    }

    #[test]
    fn parts_of_axis_parallel_shapes_merge_to_the_region_again(a in rectangles(14, 20), limit in 3usize..12) {
        let run = RunOptions::default();
        let region = boolean(&a, &Contours::new(), Operation::Or, &run).unwrap();
        for parts in [region.without_holes(), region.fractured(limit).unwrap()] {
            prop_assert_eq!(&boolean(&parts, &Contours::new(), Operation::Or, &run).unwrap().area2(), &region.area2());
        }
    }
}
