//! Editing open cells: keys, aliases, layers, absorbing, and that finished cells never change.

use phidl_core::prelude::*;

fn dot(layer: u16) -> Device {
    let mut d = Device::builder(format!("dot{layer}"));
    d.add_polygon([(0, 0), (1, 0), (1, 1), (0, 1)], layer).unwrap();
    d.add(Label::new("dot", (1, 0), layer));
    d.build().unwrap()
}

#[test]
fn keys_and_aliases_stay_valid_when_other_elements_are_removed() {
    let mut d = Device::builder("cell");
    let a = d.add_as("a", dot(1));
    let b = d.add_as("b", dot(2));
    let c = d.add_as("c", dot(3));
    d.remove(b).unwrap();
    assert_eq!(d[c].device().name(), "dot3");
    assert_eq!(d["c"].device().name(), "dot3");
    assert!(d.get("b").is_err() && d.reference(b).is_err() && d.remove(b).is_err());
    let e = d.add(dot(4));
    assert_eq!((d[a].device().name(), d[e].device().name()), ("dot1", "dot4"));
}

#[test]
fn polygon_keys_cover_all_copies_and_survive_removals() {
    let mut d = Device::builder("cell");
    let first = d.add_polygon([(0, 0), (1, 0), (0, 1)], 9).unwrap();
    let pair = d.add_polygon([(0, 0), (2, 0), (0, 2)], [1, 2]).unwrap();
    let none = d.add_polygon([(0, 0), (2, 0), (0, 2)], Layers::NONE).unwrap();
    d.remove(first).unwrap();
    d.select(pair).move_by((10, 0));
    assert!(d.polygons().all(|p| p.points[0] == Point::new(10.0, 0.0)));
    assert!(d.polygon(none).is_err());
    d.remove_layers(1, LayerTarget::All);
    assert_eq!(d.polygon(pair).unwrap().layer, Layer::new(2, 0));
    d.remove(pair).unwrap();
    assert_eq!(d.polygons().len(), 0);
}

#[test]
fn an_edited_copy_does_not_change_the_original() {
    let original = dot(1);
    let mut parent = Device::builder("parent");
    parent.add(&original);
    let parent = parent.build().unwrap();
    let before = parent.content_hash();
    let mut copy = original.edit();
    copy.scale(.., 3);
    let copy = copy.build().unwrap();
    assert_eq!((original.xmax(), copy.xmax()), (1.0, 3.0));
    assert_eq!(parent.content_hash(), before);
    assert!(parent.references()[0].device().same_cell(&original));
}

#[test]
fn absorbing_takes_polygons_and_labels_of_references_and_arrays() {
    let mut middle = Device::builder("middle");
    middle.add(dot(1).place().moved_by((5, 0)));
    let middle = middle.build().unwrap();
    let mut d = Device::builder("cell");
    let array = d.add_as("row", middle.array(3, 1, (10, 0)).rotated(90));
    let before = d.clone().build().unwrap();
    d.absorb(array).unwrap();
    assert!(d.get("row").is_err());
    let positions: Vec<Point> = d.labels().map(Label::position).collect();
    assert_eq!(positions, [(0, 6), (0, 16), (0, 26)].map(Point::from));
    assert!(d.labels().all(|label| label.rotation() == 90.0));
    let after = d.build().unwrap();
    assert!(after.references().is_empty());
    assert_eq!(after.hash_geometry(1e-4), before.hash_geometry(1e-4));
}

#[test]
fn layers_are_exchanged_all_the_way_down_and_once() {
    let mut d = Device::builder("cell");
    d.add(dot(1));
    d.add(dot(2));
    d.add(dot(3));
    let untouched = d.references().nth(2).unwrap().device().clone();
    d.remap_layers([(1, 2), (2, 1)], LayerTarget::PolygonsOnly);
    let d = d.build().unwrap();
    let drawn: Vec<u16> = d.flat_polygons().map(|p| p.layer.unwrap().number).collect();
    assert_eq!(drawn, [2, 1, 3]);
    let labels: Vec<u16> = d.flattened().unwrap().labels().iter().map(|l| l.layer.number).collect();
    assert_eq!(labels, [1, 2, 3], "labels were not to be touched");
    assert!(d.references()[2].device().same_cell(&untouched), "a cell that does not change stays the same cell");
}

#[test]
fn a_cell_that_is_placed_twice_is_rewritten_once() {
    let mut d = Device::builder("cell");
    let shared = dot(1);
    d.add(&shared);
    d.add(&shared);
    d.keep_layers(7, LayerTarget::All);
    let d = d.build().unwrap();
    assert!(d.references()[0].device().same_cell(d.references()[1].device()));
    assert!(d.is_empty() && d.flattened().unwrap().labels().is_empty());
    assert_eq!(shared.polygons().len(), 1);
}

#[test]
fn iterators_stop_at_the_depth_and_filter_by_layer() {
    let mut middle = Device::builder("middle");
    middle.add(dot(1).array(2, 2, (4, 4)));
    middle.add_polygon([(0, 0), (9, 0), (0, 9)], 2).unwrap();
    let middle = middle.build().unwrap();
    let mut top = Device::builder("top");
    top.add(&middle);
    top.add(dot(2));
    let top = top.build().unwrap();
    assert_eq!(top.flat_polygons().count(), 6);
    assert_eq!(top.flat_polygons().on(1).count(), 4);
    let boxes: Vec<_> = top.flat_polygons().to_depth(0).map(|p| (p.device.name().to_owned(), p.bbox())).collect();
    assert_eq!(boxes, [("middle".into(), middle.bbox()), ("dot2".into(), dot(2).bbox())]);
    let one_down: Vec<_> = top.flat_polygons().to_depth(1).map(|p| p.layer).collect();
    assert_eq!(one_down, [Some(Layer::new(2, 0)), None, None, None, None, Some(Layer::new(2, 0))]);
    assert_eq!(top.instances().map(|i| i.depth).collect::<Vec<_>>(), [0, 1, 2, 2, 2, 2, 1]);
}

#[test]
fn areas_count_magnified_and_arrayed_copies() {
    let mut d = Device::builder("cell");
    d.add(dot(1).array(3, 2, (5, 5)).scaled(2));
    d.add(dot(2).place().rotated(30).mirrored((0, 0), (1, 3)));
    let d = d.build().unwrap();
    let areas = d.area_by_layer();
    assert_eq!(areas[&Layer::new(1, 0)], 24.0);
    assert!((areas[&Layer::new(2, 0)] - 1.0).abs() < 1e-12);
    assert_eq!(d.layers(), [Layer::new(1, 0), Layer::new(2, 0)]);
    assert_eq!(d.flat_counts().unwrap(), (7, 28));
}

#[test]
fn info_is_listed_once_for_every_cell_below() {
    let mut a = Device::builder("a");
    a.info("length", 3.5);
    let a = a.build().unwrap();
    let mut b = Device::builder("b");
    b.add(&a);
    b.add(&a);
    b.info("own", true);
    let b = b.build().unwrap();
    let below: Vec<_> = b.descendant_info().into_iter().map(|(cell, info)| (cell.name().to_owned(), info)).collect();
    assert_eq!(below.len(), 1);
    assert_eq!((below[0].0.as_str(), &below[0].1["length"]), ("a", &Value::from(3.5)));
    assert_eq!(b.info()["own"], Value::from(true));
}

#[test]
fn references_inside_a_placed_cell_are_found_by_alias() {
    let mut inner = Device::builder("inner");
    inner.add_as("dot", dot(1).place().moved_by((5, 0)));
    let placed = inner.build().unwrap().place().rotated(90).scaled(2);
    let dot = placed.get("dot").unwrap();
    assert_eq!((dot.transform().origin, dot.transform().magnification), (Point::new(0.0, 10.0), 2.0));
    assert!(placed.get("dash").is_err());
}

#[test]
fn groups_are_added_member_by_member() {
    let square = Polygon::new([(0, 0), (2, 0), (2, 2), (0, 2)], 1).with_property(1, "yolo");
    let mut group = square.clone() + dot(2) + Label::new("here", (1, 1), 3);
    group += square.moved_by((4, 0)) + dot(1).place();
    assert_eq!(group.len(), 4, "the added group is one member");
    let mut d = Device::builder("cell");
    assert_eq!(d.add(group.rotated(90)).len(), 5);
    let d = d.build().unwrap();
    assert_eq!((d.polygons().len(), d.references().len(), d.labels().len()), (2, 2, 1));
    assert_eq!(d.polygons().next().unwrap().properties().collect::<Vec<_>>(), [(1, "yolo")]);
}

#[test]
fn a_key_given_twice_moves_its_element_once() {
    let mut d = Device::builder("cell");
    let key = d.add(dot(1));
    d.group([key, key]).move_by((1, 0));
    assert_eq!(d[key].transform().origin, Point::new(1.0, 0.0));
}

#[test]
fn labels_are_removed_by_a_test_and_the_keys_of_the_others_stay() {
    let mut d = Device::builder("labelled");
    let add = |(text, x, layer): (&str, i32, u16)| d.add_label(text, (x, 0), layer).unwrap();
    let [a, b, c] = [("a", 0, 1), ("b", 1, 2), ("c", 2, 1)].map(add);
    d.remove_labels(|label| label.text == "a" || label.layer == Layer::new(2, 0));
    assert!(d.label(a).is_err() && d.label(b).is_err());
    assert_eq!(d.label(c).unwrap().text, "c");
    assert_eq!(d.build().unwrap().labels().len(), 1);
}

#[test]
fn a_mapped_hierarchy_shares_its_copies_and_keeps_the_originals() {
    let mut leaf = Device::builder("leaf");
    leaf.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    let leaf = leaf.build().unwrap();
    let mut middle = Device::builder("middle");
    middle.add(leaf.array(2, 3, (5, 5)));
    let middle = middle.build().unwrap();
    let mut top = Device::builder("top");
    top.add_as("first", &middle);
    top.add(leaf.place().rotated(30));
    let top = top.build().unwrap();

    let mut order = Vec::new();
    let copy = top.map_cells(|cell| {
        order.push(cell.name().to_owned());
        cell.add_polygon([(0, 0), (2, 0), (0, 2)], 2)?;
        Ok(())
    });
    let copy = copy.unwrap();
    assert_eq!(order, ["leaf", "middle", "top"]);
    assert_eq!((top.flat_counts().unwrap().0, copy.flat_counts().unwrap().0), (7, 2 * 7 + 2));
    let inner = copy.get("first").unwrap().device().references()[0].device();
    assert!(inner.same_cell(copy.references()[1].device()) && !inner.same_cell(&leaf));
    assert!(top.map_cells(|_| Err(Error::custom("leaf", "no"))).is_err());
}

#[test]
fn several_elements_are_added_and_removed_at_once() {
    let mut d = Device::builder("cell");
    let keys = d.add(vec![dot(1), dot(2), dot(3)]);
    let [a, b] = d.add([dot(4).place(), dot(5).array(2, 1, (5, 0))]);
    let polygon = d.add_polygon([(0, 0), (1, 0), (0, 1)], [1, 2]).unwrap();
    let label = d.add_label("x", (0, 0), 1).unwrap();
    d.remove([keys[0].into(), Key::from(polygon), a.into(), label.into()]).unwrap();
    assert_eq!((d.references().len(), d.polygons().len(), d.labels().len()), (3, 0, 0));
    assert_eq!(d[keys[1]].device().name(), "dot2");
    assert_eq!(d[b].device().name(), "dot5");
    assert!(d.remove([keys[1], keys[0]]).is_err());
    assert_eq!(d.references().len(), 3, "a refused list removes nothing");
    let all: Vec<ReferenceKey> = d.reference_keys().collect();
    d.remove(all).unwrap();
    assert!(d.build().unwrap().references().is_empty());
}

#[test]
fn a_clone_accepts_the_keys_of_its_original_and_new_keys_are_separate() {
    let mut original = Device::builder("original");
    let shared = original.add(dot(1));
    let none = original.add_polygon([(0, 0), (2, 0), (0, 2)], Layers::NONE).unwrap();
    let mut copy = original.clone();
    copy[shared].movex(5);
    assert_eq!((original.xmin(shared), copy.xmin(shared)), (0.0, 5.0));
    assert!(copy.remove(none).is_ok());
    let (late, other) = (original.add(dot(2)), copy.add(dot(3)));
    assert!(matches!(copy.reference(late), Err(Error::ForeignKey { .. })));
    assert!(matches!(original.reference(other), Err(Error::ForeignKey { .. })));
    let second = copy.clone();
    assert!(second.reference(shared).is_ok() && second.reference(other).is_ok());
    assert!(matches!(original.build().unwrap().edit().reference(shared), Err(Error::ForeignKey { .. })));
}
