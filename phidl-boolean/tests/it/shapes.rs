//! Shapes for property tests, from tame to nasty.

use phidl_boolean::{
    Operation,
    grid::{Contours, GridPoint},
};
use proptest::prelude::*;

/// Up to `count` polygons with corners anywhere in a square: most cross themselves and repeat points.
pub(crate) fn polygons(count: usize, side: i64) -> impl Strategy<Value = Contours> {
    let point = (0..=side, 0..=side).prop_map(GridPoint::from);
    let polygon = prop::collection::vec(point, 0..8);
    prop::collection::vec(polygon, 0..=count).prop_map(Contours::from_iter)
}

/// Up to `count` rectangles, which share edges and corners often.
pub(crate) fn rectangles(count: usize, side: i64) -> impl Strategy<Value = Contours> {
    let rectangle = (0..side, 0..side, 1..=side / 2 + 1, 1..=side / 2 + 1).prop_map(|(x, y, w, h)| {
        vec![(x, y), (x + w, y), (x + w, y + h), (x, y + h)].into_iter().map(GridPoint::from).collect::<Vec<_>>()
    });
    prop::collection::vec(rectangle, 0..=count).prop_map(Contours::from_iter)
}

/// Crowds in which almost every edge bends, larger scenes, and edges that coincide.
pub(crate) fn any_shapes() -> impl Strategy<Value = Contours> {
    prop_oneof![polygons(8, 12), polygons(8, 60), polygons(6, 2000), rectangles(10, 12), long_slivers(12)]
}

/// Nearly parallel lines over a long distance: the hardest case for rounding.
fn long_slivers(count: usize) -> impl Strategy<Value = Contours> {
    let sliver = (0..40i64, 0..40i64, 960..1000i64, 0..40i64, 1..3i64).prop_map(|(x, y, w, z, h)| {
        vec![(x, y), (w, z), (w, z + h), (x, y + h)].into_iter().map(GridPoint::from).collect::<Vec<_>>()
    });
    prop::collection::vec(sliver, 0..=count).prop_map(Contours::from_iter)
}

pub(crate) fn any_operation() -> impl Strategy<Value = Operation> {
    prop::sample::select(vec![Operation::Or, Operation::And, Operation::Not, Operation::BMinusA, Operation::Xor])
}
