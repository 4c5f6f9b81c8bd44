//! Facts that the test suite of PHIDL 1.7.2 and runs of it state: hashes, positions, boxes.

use phidl_core::prelude::*;

/// The polygon of PHIDL's first test, as two coordinate lists.
fn q() -> Polygon {
    Polygon::new(([8, 6, 7, 9], [6, 8, 9, 5]), 0)
}

fn cell_of(polygons: impl IntoIterator<Item = Polygon>) -> Device {
    let mut d = Device::builder("cell");
    for polygon in polygons {
        d.add(polygon);
    }
    d.build().unwrap()
}

#[track_caller]
fn assert_hash(device: &Device, expected: &str) {
    assert_eq!(device.hash_geometry(1e-4).unwrap(), expected);
}

#[track_caller]
fn assert_near(a: Point, b: (f64, f64)) {
    assert!(a.distance(b.into()) < 2e-6, "{a} is not near {b:?}");
}

fn rectangle(width: f64, height: f64, layer: u16) -> Device {
    let mut d = Device::builder("rectangle");
    d.add_polygon([(width, height), (width, 0.0), (0.0, 0.0), (0.0, height)], layer).unwrap();
    d.build().unwrap()
}

/// A 4 × 2 rectangle with ports `w` and `e`.
fn wire() -> Device {
    let mut d = rectangle(4.0, 2.0, 0).edit();
    d.add_port("w", ((0, 1), 2, 180)).unwrap();
    d.add_port("e", ((4, 1), 2, 0)).unwrap();
    d.build().unwrap()
}

#[test]
fn polygons_from_rows_and_from_points_are_the_same() {
    let expected = "c0629d2a7c557f72fad131ae8260df22c1df2d56";
    assert_hash(&cell_of([q()]), expected);
    assert_hash(&cell_of([Polygon::new([(8, 6), (6, 8), (7, 9), (9, 5)], 0)]), expected);
    let several = [
        Polygon::new([(8, 6), (6, 8), (7, 9), (9, 5)], 7),
        Polygon::new([(8, 0), (6, 8), (7, 9), (9, 5)], (8, 0)),
        Polygon::new([(8, 1), (6, 8), (7, 9), (9, 5)], (9, 1)),
    ];
    assert_hash(&cell_of(several), "96abc3c9e30f3bbb32c5a39aeea2ba0fa3b13ebe");
}

#[test]
fn moves_give_the_hashes_of_the_reference() {
    let mut polygon = q();
    polygon.move_by((1.7, 0.8));
    assert_hash(&cell_of([polygon.clone()]), "57a86bce5f60f7bc78c7c30473a544b736d2afb3");
    polygon.movex(13.9);
    assert_hash(&cell_of([polygon.clone()]), "8fe6706e05ebe1512ee2efe2582546b949fbc48f");
    polygon.movey(19.2);
    assert_hash(&cell_of([polygon]), "7df43241eca2dd11f267c25876e650eadaca7d9f");

    let mut d = Device::builder("cell");
    d.add(q());
    d.add_polygon(([8, 6, 7, 9, 7, 0], [6, 8, 9, 5, 7, 0]), 0).unwrap();
    d.move_by(.., (1.7, 0.8));
    assert_hash(&d.build().unwrap(), "c863156dd00a590dc02823e1791554d4142b1ea9");
}

#[test]
fn rotations_and_reflections_give_the_hashes_of_the_reference() {
    let turned = "2e4815072eabe053c3029d9e29a5b3ed59fe9bb7";
    assert_hash(&cell_of([q().rotated(37.5)]), turned);
    let mut d = cell_of([q()]).edit();
    d.rotate(.., 37.5);
    assert_hash(&d.build().unwrap(), turned);

    let mirrored = "bc6ae5308c2240e425cd503e0cdda30007bbfc4d";
    assert_hash(&cell_of([q().mirrored((1.7, 2.5), (4.5, 9.1))]), mirrored);
    let mut d = cell_of([q()]).edit();
    d.mirror(.., (1.7, 2.5), (4.5, 9.1));
    assert_hash(&d.build().unwrap(), mirrored);

    assert_hash(&cell_of([q().rotated_about(45, (1, 2))]), "d661c74feb5821ab687b559602aecc5dc9034ec7");
}

#[test]
fn an_array_is_rotated_and_mirrored_as_a_whole() {
    let child = {
        let mut d = Device::builder("child");
        d.add_polygon([(30, 20), (30, 0), (0, 0), (0, 20)], 7).unwrap();
        d.build().unwrap()
    };
    let mut d = Device::builder("arrayed");
    let array = d.add(child.array(7, 5, (31, 21)));
    assert_eq!(d.bbox(), Some(Rect::new((0, 0), (216, 104))));
    d[array].rotate(10).move_by((15, 1.5)).mirror((0, 1), (0, 0));
    assert_near(d[array].transform().origin, (-15.0, 1.5));
    let d = d.build().unwrap();
    assert_hash(&d, "418b7503baff80fbe93031d45d87557c277f07b4");
    let first: Vec<Point> = d.flat_polygons().next().unwrap().points().collect();
    assert_near(first[0], (-41.071269, 26.4056));
    assert_near(first[3], (-11.527036, 21.196155));

    let mut two = Device::builder("two");
    two.add(d.place().moved_by((300, 0)));
    two.add(d.place().rotated(45));
    assert_hash(&two.build().unwrap(), "fd7c2b4adb811342b836d9fca13992eff951630d");
}

#[test]
fn a_magnified_array_keeps_its_spacing() {
    let triangle = cell_of([Polygon::new([(0, 0), (4, 0), (4, 2)], 1)]);
    let transform = Transform { x_reflection: true, magnification: 2.0, rotation: 90.0, origin: Point::new(1.0, 1.0) };
    let mut d = Device::builder("array");
    d.add(triangle.array(2, 2, (10, 5)).with_transform(transform));
    let d = d.build().unwrap();
    assert_hash(&d, "6014a5333c262d71790b12fca6d2958b103b3c05");
    let second: Vec<Point> = d.flat_polygons().nth(1).unwrap().points().collect();
    assert_eq!(second, [(6, 1), (6, 9), (10, 9)].map(Point::from));
    assert_eq!(rectangle(4.0, 2.0, 0).array(3, 2, (10, 5)).bbox(), Some(Rect::new((0, 0), (24, 7))));
}

#[test]
fn nested_references_have_the_coordinates_of_the_reference() {
    let r = {
        let mut d = cell_of([Polygon::new([(0, 0), (4, 0), (4, 2)], 1)]).edit();
        d.add_port("e", ((4, 1), 1, 0)).unwrap();
        d.build().unwrap()
    };
    let inner = r.place().rotated_about(30, (1, 1)).mirrored((0, 0), (2, 1));
    assert_near(inner.transform().origin, (0.087564, 0.726795));
    assert!((inner.transform().rotation - 23.130102).abs() < 1e-6 && inner.transform().x_reflection);
    let m = {
        let mut d = Device::builder("m");
        d.add(inner);
        d.build().unwrap()
    };
    let outer = m.place().moved_by((3, 4)).rotated(-20).mirrored((0, 1), (0, 0));
    assert_near(outer.transform().origin, (-4.187158, 2.73271));
    assert!((outer.transform().rotation - 200.0).abs() < 1e-9 && outer.transform().x_reflection);
    let top = |outer: Reference| {
        let mut d = Device::builder("t");
        d.add(outer);
        d.build().unwrap()
    };
    let t = top(outer.clone());
    assert_hash(&t, "95354cc20a73c8e3f4d976b71125402fdd27a42e");
    let port = &t.ports_recursive(None).unwrap()[0];
    assert_near(port.midpoint(), (-8.566656, 2.605631));
    assert!((port.orientation() - 176.869898).abs() < 1e-6);
    let doubled = Transform { magnification: 2.0, ..*outer.transform() };
    assert_hash(&top(outer.with_transform(doubled)), "ab7c4d886b9a2f96f01bbb92489b093883aa1f88");
}

#[test]
fn ports_of_references_are_transformed() {
    let mut d = Device::builder("cell");
    d.add_port("a", ((5.7, 9.2), 1, 37)).unwrap();
    let port = d.build().unwrap().place().moved_by((1, 1)).rotated(45).port("a").unwrap();
    assert_near(port.midpoint(), (-2.474_873_734_152_916, 11.950_104_602_052_654));
    assert!((port.orientation() - 82.0).abs() < 1e-9);
}

#[test]
fn ports_of_arrays_come_row_by_row() {
    let mut top = Device::builder("top");
    top.add(wire().array(3, 2, (10, 5)).rotated(90));
    let ports = top.build().unwrap().ports_recursive(None).unwrap();
    let east: Vec<&Port> = ports.iter().filter(|p| p.name() == "e").collect();
    let midpoints: Vec<Point> = east.iter().map(|p| p.midpoint()).collect();
    assert_eq!(midpoints, [(-1, 4), (-1, 14), (-1, 24), (-6, 4), (-6, 14), (-6, 24)].map(Point::from));
    assert!(east.iter().all(|p| p.orientation() == 90.0));
    assert_eq!(east[5].info()["array_idx"], Value::from([1, 2]));
}

#[test]
fn connections_have_the_coordinates_of_the_reference() {
    let east = wire().port("e").unwrap().clone();
    let mut r = wire().place();
    r.connect("w", &east).unwrap();
    assert_eq!((r.transform().origin, r.transform().rotation), (Point::new(4.0, 0.0), 0.0));
    for (overlap, x) in [(0.5, 3.5), (-0.5, 4.5)] {
        let mut r = wire().place();
        r.connect_overlapping("w", &east, overlap).unwrap();
        assert_eq!(r.transform().origin, Point::new(x, 0.0));
    }
    let mut r = wire().place();
    r.connect("e", &east).unwrap();
    assert_eq!((r.transform().origin, r.transform().rotation), (Point::new(8.0, 2.0), 180.0));
    let moved = wire().place().moved_by((10, 20)).rotated(30);
    let mut r = wire().place();
    r.connect("w", &moved.port("e").unwrap()).unwrap();
    assert_near(r.transform().origin, (2.124356, 24.320508));
    let mut r = wire().place().mirrored((0, 1), (0, 0));
    r.connect("w", &east).unwrap();
    assert!(r.transform().origin.distance(Point::new(4.0, 2.0)) < 1e-12 && r.transform().x_reflection);
}

#[test]
fn a_chain_of_overlapping_connections_has_the_hash_of_the_reference() {
    let mut d = Device::builder("block");
    d.add_polygon([(0, 0), (10, 0), (10, 1), (0, 1)], 0).unwrap();
    d.add_port("1", ((0.0, 0.5), 1, 180)).unwrap();
    d.add_port("2", ((10.0, 0.5), 1, 30)).unwrap();
    let block = d.build().unwrap();
    let mut chain = Device::builder("chain");
    let mut last = chain.add(&block);
    for _ in 0..4 {
        let end = chain[last].port("2").unwrap();
        last = chain.add(&block);
        chain[last].connect_overlapping("1", &end, 0.25).unwrap();
    }
    assert_near(chain[last].transform().origin, (23.87676, 23.602241));
    assert!((chain[last].transform().rotation - 120.0).abs() < 1e-9);
    assert_hash(&chain.build().unwrap(), "20676521643560c65f671a97e194299fb97ba267");
}

#[test]
fn flattening_keeps_the_geometry() {
    let one = cell_of([Polygon::new(([8, 6, 7, 9, 7, 0], [6, 8, 9, 5, 7, 0]), 8)]);
    let two = cell_of([Polygon::new(([18, 16, 17, 19, 17, 10], [16, 18, 19, 15, 17, 10]), 9)]);
    let mut d = Device::builder("top");
    d.add(one);
    d.add(two);
    let top = d.clone().build().unwrap();
    let hash = "8a057feca51d8097f2a915eda558fe2a9b88fb13";
    assert_hash(&top, hash);
    assert_hash(&top.flattened().unwrap(), hash);
    assert!(top.flattened().unwrap().references().is_empty());
    d.flatten_onto((5, 5)).unwrap();
    assert_hash(&d.build().unwrap(), "cfc1ba30384f5f1f7d888f47f16d1f310f95b464");
}

/// The 90 polygons of PHIDL's layer test, on its layers.
fn zigzag_polygons() -> impl Iterator<Item = Polygon> {
    include_str!("zigzag.txt").lines().map(|line| {
        let (index, corners) = line.split_once(": ").unwrap();
        let corner = |text: &str| {
            let (x, y) = text.split_once(',').unwrap();
            (x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap())
        };
        let layer = match index.parse::<u32>().unwrap() {
            13..=16 => (14, 0),
            23..=26 => (14, 1),
            _ => (15, 0),
        };
        Polygon::new(corners.split(' ').map(corner).collect::<Vec<_>>(), layer)
    })
}

#[test]
fn removing_layers_takes_the_polygons_of_exactly_these_layers() {
    let mut d = Device::builder("layers");
    d.add_polygon(([8, 6, 7, 9, 7], [6, 8, 9, 5, 7]), 13).unwrap();
    d.add_polygon(([18, 16, 17, 19, 17], [16, 18, 19, 15, 17]), 14).unwrap();
    for polygon in zigzag_polygons() {
        d.add(polygon);
    }
    assert_hash(&d.clone().build().unwrap(), "7a7aa6a22b3d0b852a0e465398018dd19a1be305");
    d.remove_layers([(13, 0), (14, 0)], LayerTarget::All);
    assert_hash(&d.build().unwrap(), "bb81ec3b3a6be2372a7ffc32f57121a9f1a97b34");
}

/// Squares of side 15n + 20 at (n, 4n), n = 0, 2, 3, 1, 2.
fn squares() -> (DeviceBuilder, Vec<ReferenceKey>) {
    let mut d = Device::builder("squares");
    let add = |n: i32| d.add(rectangle(f64::from(15 * n + 20), f64::from(15 * n + 20), 0).place().moved_by((n, 4 * n)));
    let keys = [0, 2, 3, 1, 2].map(add).to_vec();
    (d, keys)
}

#[test]
fn distributing_spaces_boxes_or_edges() {
    type Arrangement = fn(&mut Selection<'_>);
    let hashes: [(Arrangement, &str); 4] = [
        (|m| _ = m.distribute(Direction::X, 5), "1aa688d7dfb59e94d28dd0d9b8f324ff30281d70"),
        (|m| _ = m.distribute_by(Edge::XMin, 100), "18be0ef1db78095233d2f3ae5f065d9f453a6c07"),
        (|m| _ = m.distribute_by(Edge::XMax, 100), "9bae704112575e2b901ee929a7bc307758febb14"),
        (|m| _ = m.distribute_by(Edge::X, 100), "5fdff4034fced7ebde34ccece708f344d69b2de5"),
    ];
    for (arrange, hash) in hashes {
        let (mut d, _) = squares();
        arrange(&mut d.select_all());
        assert_hash(&d.build().unwrap(), hash);
    }
    let (mut d, keys) = squares();
    d.select_all().distribute(Direction::X, -5);
    let left: Vec<f64> = keys.iter().map(|key| d[*key].xmin()).collect();
    assert_eq!(left, [0.0, 15.0, 60.0, 120.0, 150.0]);
    // 690 µm between the outer edges, 280 µm of them filled: four gaps of 102.5 µm.
    let (mut d, keys) = squares();
    d[keys[4]].set_xmax(690);
    d.select_all().distribute_evenly(Direction::X);
    let left: Vec<f64> = keys.iter().map(|key| d[*key].xmin()).collect();
    let gap = (690.0 - (20.0 + 50.0 + 65.0 + 35.0 + 50.0)) / 4.0;
    assert_eq!(left, [0.0, 20.0 + gap, 70.0 + 2.0 * gap, 135.0 + 3.0 * gap, 640.0]);
}

#[test]
fn aligning_brings_edges_to_that_of_all_together() {
    for (edge, hash) in [
        (Edge::YMax, "38025959a80e46e47eabcf3f096c6273427dabc3"),
        (Edge::Y, "ed32ee1ce1f3da8f6216020877d6c1b64097c600"),
        (Edge::X, "7e6d78501c98b186c295ce87b43ea71e4a35e0a4"),
        (Edge::XMin, "f668ba99323a76cf4b03c61232786503932c7c0d"),
        (Edge::XMax, "732538fb8b5f2a9d508a7658e1414530944e65f6"),
        (Edge::YMin, "b786cc85b76bf644466924b268d42e21058f906e"),
    ] {
        let (mut d, _) = squares();
        d.select_all().distribute(Direction::X, 5).align(edge);
        assert_hash(&d.build().unwrap(), hash);
    }
}

#[test]
fn simplifying_a_half_circle_leaves_five_points() {
    let circle: Vec<Point> =
        (0..1000).map(|i| PI * f64::from(i) / 999.0).map(|t| Point::new(t.cos(), t.sin())).collect();
    let mut d = Device::builder("half circle");
    d.add_polygon(circle, 0).unwrap();
    assert_hash(&d.clone().build().unwrap(), "0c3b1465c8b6ffd911c41b02114b9a06f606ad91");
    d.simplify(0.1).unwrap();
    assert_hash(&d.build().unwrap(), "7d9ebcb231fb0107cbbf618353adeb583782ca11");
}

#[test]
fn the_box_of_a_hierarchy_is_that_of_its_elements() {
    let square = rectangle(10.0, 10.0, 0);
    let mut d = Device::builder("parent");
    d.add(&square);
    d.add(square.place().moved_by((30, 0)));
    assert_eq!(d.bbox(), Some(Rect::new((0, 0), (40, 10))));
}

#[test]
fn a_device_prints_what_it_holds() {
    expect_test::expect![[r#"Device (name "rectangle", ports ["w", "e"], aliases [], 1 polygons, 0 references)"#]]
        .assert_eq(&wire().to_string());
}
