//! The laws of placement, for every type of element (testkit's law suite) and over random hierarchies.

use phidl_core::num::angle::between;
use phidl_core::prelude::*;
use proptest::prelude::*;
use testkit::laws::placement_laws;
use testkit::strategies::{angle, hierarchy, point, polygon, transform};

proptest! {
    #[test]
    fn polygons_keep_the_laws(p in polygon(), t in transform()) {
        placement_laws(&p, &t)?;
    }

    #[test]
    fn labels_keep_the_laws(at in point(), t in transform()) {
        placement_laws(&Label::new("x", at, 1).rotated(30), &t)?;
    }

    #[test]
    fn ports_keep_the_laws(at in point(), orientation in angle(), t in transform()) {
        placement_laws(&Port::new(at, 2.0, orientation), &t)?;
    }

    #[test]
    fn references_and_arrays_keep_the_laws(device in hierarchy(), at in transform(), t in transform()) {
        placement_laws(&device.place().with_transform(at), &t)?;
        placement_laws(&device.array(3, 2, (17.5, -4.25)).with_transform(at), &t)?;
    }

    #[test]
    fn groups_and_open_cells_keep_the_laws(p in polygon(), device in hierarchy(), t in transform()) {
        placement_laws(&(p + device.place() + Label::new("x", (1, 2), 3)), &t)?;
        placement_laws(&device.edit(), &t)?;
    }

    #[test]
    fn a_group_moves_as_its_members_do(p in polygon(), device in hierarchy(), t in transform()) {
        let mut group = p.clone() + device.place();
        group.transform_mut(&t);
        let (mut p, mut r) = (p, device.place());
        p.transform_mut(&t);
        r.transform_mut(&t);
        prop_assert_eq!(group, p + r);
    }

    #[test]
    fn the_box_is_that_of_the_flat_polygons(device in hierarchy(), t in transform()) {
        let placed = device.place().with_transform(t);
        let mut d = Device::builder("top");
        d.add(placed.clone());
        let flat = Rect::union_all(d.build().unwrap().flat_polygons().map(|p| p.bbox()));
        match (placed.bbox(), flat) {
            (Some(a), Some(b)) => {
                let size = 1.0 + a.max.norm().max(a.min.norm());
                prop_assert!(a.min.distance(b.min) < 1e-9 * size && a.max.distance(b.max) < 1e-9 * size, "{a} {b}");
            }
            (a, b) => prop_assert_eq!(a, b),
        }
    }

    #[test]
    fn flattening_changes_nothing_that_is_drawn(device in hierarchy()) {
        let flat = device.flattened().unwrap();
        prop_assert_eq!(flat.hash_geometry(1e-4), device.hash_geometry(1e-4));
        prop_assert_eq!(flat.polygons().len(), device.flat_counts().unwrap().0);
        let (a, b) = (flat.area(), device.area());
        prop_assert!((a - b).abs() <= 1e-9 * a.max(1.0), "{a} {b}");
    }

    #[test]
    fn connecting_makes_ports_coincide_and_face(
        at in transform(),
        own in (point(), 0.0..360.0),
        target in (point(), 0.0..360.0),
        overlap in -3.0..3.0,
    ) {
        let mut d = Device::builder("cell");
        d.add_port("p", (own.0, 1, own.1)).unwrap();
        let target = Port::new(target.0, 1, target.1);
        let mut r = d.build().unwrap().place().with_transform(at);
        r.connect_overlapping("p", &target, overlap).unwrap();
        let port = r.port("p").unwrap();
        let expected = target.midpoint() - target.normal() * overlap;
        prop_assert!(port.midpoint().distance(expected) < 1e-9, "{} {}", port.midpoint(), expected);
        let facing = between(port.orientation(), target.orientation() + 180.0);
        prop_assert!(facing < 1e-9, "{facing}");
    }

    #[test]
    fn a_rebuilt_copy_has_the_hashes_of_the_original(device in hierarchy()) {
        let copy = device.edit().build().unwrap();
        prop_assert!(!copy.same_cell(&device));
        prop_assert_eq!(copy.content_hash(), device.content_hash());
        prop_assert_eq!(copy.drawing_hash(), device.drawing_hash());
    }
}
