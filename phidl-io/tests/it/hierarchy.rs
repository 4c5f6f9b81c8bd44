//! Random hierarchies on the grid, and what a drawing comes down to.

use phidl_core::prelude::*;
use proptest::prelude::{Just, Strategy, any, prop};
use proptest::prop_oneof;

/// So many nanometers, as the double that a file is read as.
fn um(nm: i32) -> f64 {
    f64::from(nm) / 1000.0
}

/// A coordinate on the grid of 1 nm, up to 50 µm out.
fn coordinate() -> impl Strategy<Value = f64> {
    (-50_000_i32..50_000).prop_map(um)
}

fn point() -> impl Strategy<Value = Point> {
    (coordinate(), coordinate()).prop_map(Point::from)
}

fn layer() -> impl Strategy<Value = Layer> {
    (prop_oneof![0_u16..4, Just(40_000)], prop_oneof![Just(0_u16), Just(65_535)]).prop_map(Layer::from)
}

fn properties() -> impl Strategy<Value = Properties> {
    let some = prop::collection::btree_map(any::<u16>(), "[ -~]{1,12}", 1..3);
    prop_oneof![3 => Just(Properties::new()), 1 => some]
}

/// Three corners that are apart, and more.
fn polygon() -> impl Strategy<Value = Polygon> {
    let at = (-50_000_i32..50_000, -50_000_i32..50_000);
    (at, prop::collection::vec(point(), 0..6), layer(), properties()).prop_map(|((x, y), more, layer, properties)| {
        let corners = [(x, y), (x + 1000, y), (x, y + 1000)].map(|(x, y)| Point::new(um(x), um(y)));
        let mut polygon = Polygon::new(corners.into_iter().chain(more).collect::<Vec<_>>(), layer);
        polygon.properties = properties;
        polygon
    })
}

fn transform() -> impl Strategy<Value = Transform> {
    let rotation = prop_oneof![Just(0.0), Just(90.0), Just(180.0), Just(270.0), 0.0..360.0_f64];
    let magnification = prop_oneof![3 => Just(1.0), 1 => 0.1..10.0_f64];
    (any::<bool>(), magnification, rotation, point()).prop_map(|(x_reflection, magnification, rotation, origin)| {
        Transform { x_reflection, magnification, rotation, origin }
    })
}

fn label() -> impl Strategy<Value = Label> {
    let anchors = [Anchor::NorthWest, Anchor::North, Anchor::East, Anchor::Center, Anchor::SouthEast, Anchor::West];
    let anchor = prop::sample::select(anchors.to_vec());
    ("[ -~]{0,20}", transform(), layer(), anchor, properties()).prop_map(
        |(text, transform, layer, anchor, properties)| {
            let mut label = Label::new(text, (0, 0), layer).anchored(anchor).with_transform(transform);
            label.properties = properties;
            label
        },
    )
}

/// A cell of its own, with something in it that no other cell has.
fn leaf(number: usize) -> impl Strategy<Value = Device> {
    let (polygons, labels) = (prop::collection::vec(polygon(), 0..5), prop::collection::vec(label(), 0..3));
    (polygons, labels).prop_map(move |(polygons, labels)| {
        let mut d = Device::builder(format!("leaf{number}"));
        d.add_label(format!("leaf {number}"), (0, 0), 1).unwrap();
        polygons.into_iter().for_each(|polygon| {
            d.add(polygon);
        });
        labels.into_iter().for_each(|label| {
            d.add(label);
        });
        d.build().unwrap()
    })
}

/// A placement of one of some cells; arrays on the grid stand at quarter turns and unmagnified.
fn placement(cells: Vec<Device>) -> impl Strategy<Value = Reference> {
    let array = prop::option::of((1_u32..5, 1_u32..5, coordinate(), coordinate()));
    (prop::sample::select(cells), transform(), array, properties()).prop_map(|(cell, transform, array, properties)| {
        let mut reference = match array {
            None => Reference::new(cell, transform),
            Some((columns, rows, dx, dy)) => {
                let rotation = (transform.rotation / 90.0).floor() * 90.0;
                let lattice = Array { columns, rows, column_step: Point::new(dx, 0.0), row_step: Point::new(0.0, dy) };
                Reference::new(cell, Transform { rotation, ..transform }).with_array(lattice)
            }
        };
        reference.properties = properties;
        reference
    })
}

fn holder(name: String, below: Vec<Device>) -> impl Strategy<Value = Device> {
    (prop::collection::vec(polygon(), 0..3), prop::collection::vec(placement(below), 1..5)).prop_map(
        move |(polygons, placements)| {
            let mut d = Device::builder(&name);
            d.add_label(name.clone(), (0, 0), 1).unwrap();
            for polygon in polygons {
                d.add(polygon);
            }
            for placement in placements {
                d.add(placement);
            }
            d.build().unwrap()
        },
    )
}

/// Three levels of cells on the grid, all different.
pub(crate) fn hierarchies() -> impl Strategy<Value = Device> {
    (leaf(0), leaf(1)).prop_flat_map(|(a, b)| {
        let below = vec![a, b];
        (Just(below.clone()), holder("middle".into(), below)).prop_flat_map(|(mut below, middle)| {
            below.push(middle);
            holder("top".into(), below)
        })
    })
}
