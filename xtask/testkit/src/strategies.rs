//! Random layouts for property tests.

use phidl_core::prelude::*;
use proptest::prelude::*;

/// A point within 1 mm of the origin.
pub fn point() -> impl Strategy<Value = Point> {
    (-1000.0..1000.0, -1000.0..1000.0).prop_map(Point::from)
}

/// An angle in degrees: any, or one that people draw; to a 1024th of a degree, so that angles add up without rounding
/// and laws about them hold exactly.
pub fn angle() -> impl Strategy<Value = f64> {
    let fine = (0..360 * 1024).prop_map(|i| f64::from(i) / 1024.0);
    prop_oneof![fine, (0..8).prop_map(|i| 45.0 * f64::from(i))]
}

/// Any placement; magnification from 0.5 to 2.
pub fn transform() -> impl Strategy<Value = Transform> {
    (any::<bool>(), prop_oneof![Just(1.0), 0.5..2.0], angle(), point()).prop_map(
        |(x_reflection, magnification, rotation, origin)| Transform { x_reflection, magnification, rotation, origin },
    )
}

/// A layer among a few, with and without a datatype.
pub fn layer() -> impl Strategy<Value = Layer> {
    (0u16..4, 0u16..2).prop_map(Layer::from)
}

/// An outline of 3 to 8 random points on one layer.
pub fn polygon() -> impl Strategy<Value = Polygon> {
    (prop::collection::vec(point(), 3..8), layer()).prop_map(|(points, layer)| Polygon::new(points, layer))
}

/// A cell with some polygons, labels and a port.
pub fn cell() -> impl Strategy<Value = Device> {
    (prop::collection::vec(polygon(), 0..3), point()).prop_map(|(polygons, at)| {
        let mut d = Device::builder("cell");
        for polygon in polygons {
            d.add(polygon);
        }
        d.add_label("label", at, 3).expect("a finite label");
        d.add_port("port", (at, 1, 30)).expect("a finite port");
        d.build().expect("a finite cell")
    })
}

/// A hierarchy of up to three levels with references and arrays at any placement.
pub fn hierarchy() -> impl Strategy<Value = Device> {
    cell().prop_recursive(2, 12, 3, |inner| {
        (cell(), prop::collection::vec((inner, transform(), 1u32..3, 1u32..3), 0..3)).prop_map(|(own, children)| {
            let mut d = own.edit();
            for (child, at, columns, rows) in children {
                d.add(child.array(columns, rows, (30.5, -12.25)).with_transform(at));
            }
            d.build().expect("finite placements")
        })
    })
}
