//! Copying and selecting, against facts measured on PHIDL.

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::scene::Anchor;
use phidl_geometry as pg;
use proptest::prelude::*;
use testkit::strategies::hierarchy;

/// A cell with everything that a copy of the reference loses.
fn rich() -> Device {
    let pad = pg::compass((4, 2), 1).unwrap();
    let mut d = Device::builder("rich");
    d.add_as("row", pad.array(3, 2, (10, 7)).with_property(3, "x").rotated(30));
    let key = d.add_polygon([(0, 0), (1, 0), (0, 1)], (3, 5)).unwrap();
    d.set_properties(key, Properties::from([(1, "p".to_owned())])).unwrap();
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 2).unwrap();
    d.add(Label::new("nw", (1, 2), (4, 1)).anchored(Anchor::NorthWest).rotated(45).scaled(2));
    d.add_port("in", ((0, 0), 1, 180)).unwrap();
    d.info("kind", "rich");
    d.build().unwrap()
}

fn hash(device: &Device) -> String {
    device.hash_geometry(1e-4).unwrap()
}

#[test]
fn copies_have_all_that_the_original_has_and_are_cells_of_their_own() {
    let original = rich();
    for copy in [pg::copy(&original).unwrap(), pg::deepcopy(&original).unwrap()] {
        assert_eq!(copy.drawing_hash(), original.drawing_hash());
        assert_eq!((copy.name(), copy.info()), (original.name(), original.info()));
        assert!(copy.ports().eq(original.ports()));
        assert!(!copy.same_cell(&original) && !pg::copy(&original).unwrap().same_cell(&copy));
        assert_eq!(copy.get("row").unwrap().array(), original.get("row").unwrap().array());
        assert_eq!(copy.labels(), original.labels());
    }
    let child = |device: &Device| device.references()[0].device().clone();
    assert!(child(&pg::copy(&original).unwrap()).same_cell(&child(&original)));
    assert!(!child(&pg::deepcopy(&original).unwrap()).same_cell(&child(&original)));
}

/// The copy test of the reference. Cells cannot change here, so "edit A below D" makes a new D.
#[test]
fn editing_an_original_changes_no_copy() {
    let ellipse = |radii: (f64, f64), layer: u16| pg::ellipse(radii, 2.5, layer).unwrap();
    let mut d = Device::builder("d");
    let (a, b) = (ellipse((10.0, 5.0), 1), pg::copy(ellipse((10.0, 5.0), 1)).unwrap());
    for cell in [&a, &b, &b] {
        d.add(cell);
    }
    let d = d.build().unwrap();
    let (shallow, deep) = (pg::copy(&d).unwrap(), pg::deepcopy(&d).unwrap());
    let mut more = d.edit();
    more.add(ellipse((12.0, 5.0), 2));
    assert_eq!(hash(&more.build().unwrap()), "856cedcbbb53312ff839b9fe016996357e658d33");
    for copy in [d, shallow, deep] {
        assert_eq!(hash(&copy), "0313cd7e58aa265b44dd1ea10265d1088a2f1c6d");
    }
}

#[test]
fn a_list_of_numbers_is_a_list_of_layers_and_their_first_occurrence_orders_them() {
    let mut d = Device::builder("d");
    for layer in [(3, 0), (0, 0), (3, 5), (3, 0)] {
        d.add_polygon([(0, 0), (i32::from(layer.0) + 1, 0), (0, 1)], layer).unwrap();
    }
    let d = d.build().unwrap();
    let layers = |list: &str| {
        let params =
            [("D".to_owned(), Value::from(d.clone())), ("layers".to_owned(), serde_json::from_str(list).unwrap())];
        let extracted = registry::find("extract").unwrap().build(&params.into()).unwrap();
        extracted.polygons().map(|p| p.layer.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(layers("[0, 3]"), ["3/0", "3/0", "0/0"]);
    assert_eq!(layers("[[3, 5]]"), ["3/5"]);
    assert!(layers("[]").is_empty() && layers("[77]").is_empty());
    assert!(pg::extract(rich(), (3, 5)).unwrap().polygons().next().unwrap().properties().next().is_none());
}

#[test]
fn a_copied_layer_stands_alone_and_flat() {
    let copy = pg::copy_layer(rich(), 1, (9, 9)).unwrap();
    assert_eq!((copy.polygons().len(), copy.references().len(), copy.name()), (6, 0, "extract"));
    assert_eq!(copy.layers(), [Layer::new(9, 9)]);
    assert!(pg::copy_layer(rich(), 77, 78).unwrap().is_empty());
}

#[test]
fn flattening_keeps_arrays_ports_and_info_and_looks_at_the_layer() {
    let flat = pg::flatten(rich(), None).unwrap();
    assert_eq!((flat.polygons().len(), flat.references().len(), flat.name()), (8, 0, "rich"));
    assert_eq!(hash(&flat), hash(&rich()));
    assert_eq!((flat.port("in").unwrap(), flat.info()), (rich().port("in").unwrap(), rich().info()));
    let single = pg::flatten(rich(), (9, 8)).unwrap();
    assert_eq!((single.layers(), single.labels()[0].layer), (vec![Layer::new(9, 8)], Layer::new(9, 8)));
}

#[test]
fn drawn_ports_are_those_of_the_reference() {
    let pad = pg::compass((4, 2), 1).unwrap();
    let drawn = pg::ports_to_geometry(&pad, 2).unwrap();
    assert_eq!(hash(&drawn), "b3117d45024ce0cd51c13f6de01e9d8e4855c9a9");
    let north = drawn.polygons().next().unwrap().points.to_vec();
    let expected = [(-2.0, 1.0), (2.0, 1.0), (0.0, 1.4)].map(Point::from);
    assert!(north.iter().zip(expected).all(|(a, b)| a.distance(b) < 1e-12), "{north:?}");
    let label = &drawn.labels()[0];
    assert_eq!((label.rotation(), label.transform().magnification), (180.0, 0.16));
    assert!(label.position().distance(Point::new(0.0, 0.8)) < 1e-12);
    let again = pg::geometry_to_ports(&drawn, 2).unwrap();
    assert_eq!(hash(&again), "98fd9b96c746c5f52b9d29c462bcc6f828f4ea48");
    assert!(again.labels().is_empty());
}

#[test]
fn a_layer_with_a_datatype_loses_no_port_and_other_labels_stay() {
    let mut d = Device::builder("d");
    d.add_label("not a port", (0, 0), (2, 5)).unwrap();
    d.add_label("[\"x\", 1.0, 0.0]", (0, 0), 2).unwrap();
    d.add_port("a \"b\"\n", ((1, 2), 1.234_567_89, 33)).unwrap();
    let drawn = pg::ports_to_geometry(d.build().unwrap(), (2, 5)).unwrap();
    let again = pg::geometry_to_ports(&drawn, (2, 5)).unwrap();
    let port = again.port("a \"b\"\n").unwrap();
    assert_eq!((port.width(), port.orientation()), (1.234_567_89, 33.0));
    assert_eq!(again.labels().len(), 2);
    let mut twice = Device::builder("twice");
    twice.add_label("[\"a\", 1.0, 0.0]", (0, 0), 0).unwrap();
    twice.add_label("[\"a\", 2.0, 0.0]", (5, 0), 0).unwrap();
    let error = pg::geometry_to_ports(twice.build().unwrap(), 0).unwrap_err();
    assert!(matches!(error.root(), Error::Duplicate { .. }), "{error}");
}

#[test]
fn the_samples_of_a_layer_set_stand_where_the_reference_has_them() {
    let mut set = LayerSet::new();
    for (name, layer) in [("zz", (5, 1)), ("aa", (2, 0)), ("bb", (2, 3)), ("cc", (10, 0))] {
        set.add(NamedLayer::new(name, layer)).unwrap();
    }
    for (size, spacing, pitch) in [(100.0, 100.0, 200.0), (50.0, 20.0, 60.0)] {
        let samples = pg::preview_layerset(&set, size, spacing).unwrap();
        let squares: Vec<(Rect, Layer)> =
            samples.flat_polygons().filter(|p| p.len() == 4).map(|p| (p.bbox().unwrap(), p.layer.unwrap())).collect();
        let corners = [(0.0, 0.0), (pitch, 0.0), (0.0, -pitch), (pitch, -pitch)];
        let layers = [(2, 0), (2, 3), (5, 1), (10, 0)].map(Layer::from);
        for ((x, y), layer) in corners.into_iter().zip(layers) {
            assert!(squares.contains(&(Rect::new((x, y), (x + size, y + size)), layer)), "{layer}");
        }
    }
    assert!(pg::preview_layerset(LayerSet::new(), 100, 100).unwrap().references().is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn ports_survive_being_drawn(original in hierarchy()) {
        let drawn = pg::ports_to_geometry(&original, (77, 7)).unwrap();
        prop_assert!(drawn.ports_recursive(None).unwrap().is_empty());
        let again = pg::geometry_to_ports(&drawn, (77, 7)).unwrap();
        prop_assert_eq!(again.flat_counts(), original.flat_counts());
        for (a, b) in again.ports_recursive(None).unwrap().iter().zip(original.ports_recursive(None).unwrap()) {
            prop_assert!(a.midpoint().distance(b.midpoint()) < 1e-9);
            prop_assert_eq!((a.name(), a.width(), a.orientation()), (b.name(), b.width(), b.orientation()));
        }
    }

    #[test]
    fn a_deep_copy_and_a_flat_one_draw_the_same(original in hierarchy()) {
        let of = |d: &Device| d.hash_geometry(1e-4).unwrap();
        prop_assert_eq!(of(&pg::deepcopy(&original).unwrap()), of(&original));
        prop_assert_eq!(pg::deepcopy(&original).unwrap().cells().len(), original.cells().len());
        prop_assert_eq!(of(&pg::flatten(&original, None).unwrap()), of(&original));
        let all: Vec<Layer> = original.layers();
        prop_assert_eq!(of(&pg::extract(&original, all).unwrap()), of(&original));
    }
}
