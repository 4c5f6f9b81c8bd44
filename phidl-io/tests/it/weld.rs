//! Welding: the worked examples, with values that were computed by hand and by an independent prototype.

use phidl_core::num::grid::Grid;
use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use phidl_io::weld::{self, Beneath, Listing, WeldOptions, WeldReport};

fn strip(length: f64, width: f64) -> Device {
    let (half, mut d) = (width / 2.0, Device::builder("strip"));
    d.add_polygon([(0.0, -half), (length, -half), (length, half), (0.0, half)], 1).unwrap();
    d.add_port("1", ((0, 0), width, 180)).unwrap();
    d.add_port("2", ((length, 0.0), width, 0)).unwrap();
    d.build().unwrap()
}

fn report(device: &Device, options: &WeldOptions) -> WeldReport {
    weld::inspect(device, &Grid::new(1e-3).unwrap(), options).unwrap()
}

/// The polygons of the written file, where a reader finds them, in steps.
fn written(device: &Device, options: WeldOptions) -> Vec<Vec<(i64, i64)>> {
    let options = GdsOptions { weld: options, ..GdsOptions::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("welded.gds");
    gds::write(device, &path, &options).unwrap();
    let read = gds::read(&path, &ReadOptions::default()).unwrap().device;
    let grid = Grid::new(1e-3).unwrap();
    let steps = |p: Point| grid.point_steps(p).unwrap();
    read.flat_polygons().map(|polygon| polygon.points().map(steps).collect()).collect()
}

fn chain(parts: Vec<Reference>) -> Device {
    let mut d = Device::builder("top");
    for part in parts {
        d.add(part);
    }
    d.build().unwrap()
}

/// The second strip joined to the first.
fn joined(first: &Reference, second: &Device) -> Reference {
    let mut placed = second.place();
    placed.connect("1", &first.port("2").unwrap()).unwrap();
    placed
}

#[test]
fn level_joints_are_closed_and_change_no_byte() {
    let s = strip(1.0, 0.5);
    let a = s.place();
    let top = chain(vec![a.clone(), joined(&a, &s)]);
    let report = report(&top, &WeldOptions::default());
    assert_eq!((report.joints, report.closed, report.welded, report.forms.len()), (1, 1, 0, 0));
    let plain = gds::to_bytes(&top, &GdsOptions { weld: false.into(), ..GdsOptions::default() }).unwrap();
    assert_eq!(gds::to_bytes(&top, &GdsOptions::default()).unwrap(), plain);
}

#[test]
fn a_joint_at_10_degrees_is_two_forms() {
    let s = strip(1.0, 0.5);
    let a = s.place().rotated(10);
    let top = chain(vec![a.clone(), joined(&a, &s)]);
    assert_eq!(
        written(&top, WeldOptions::default()),
        [
            vec![(43, -246), (1028, -73), (941, 420), (-43, 246)],
            vec![(1028, -73), (2013, 101), (1926, 593), (941, 420)],
        ]
    );
    let report = report(&top, &WeldOptions::default());
    assert_eq!((report.welded, report.forms.len(), report.forms[0].rotation), (1, 2, 10.0));
    assert_eq!(report.largest_gap_steps, 1.0);
}

#[test]
fn a_mirrored_strip_at_30_degrees_has_the_form_of_60() {
    let s = strip(1.0, 0.5);
    let a = s.place().mirrored((0, 0), (1, 0)).rotated(30);
    let top = chain(vec![a.clone(), joined(&a, &s)]);
    assert_eq!(written(&top, WeldOptions::default())[0], [(-125, 217), (741, 717), (991, 283), (125, -217)]);
}

#[test]
fn an_odd_width_patches_the_minority() {
    // A strip that ends at (10, 10), and another that begins there, both 0.415 wide, one from the other side.
    let ends_at = |at: (f64, f64)| {
        let mut d = Device::builder("end");
        let (x, y) = at;
        d.add_polygon([(x - 0.2075, y - 3.0), (x + 0.2075, y - 3.0), (x + 0.2075, y), (x - 0.2075, y)], 1).unwrap();
        d.add_port("2", ((x, y), 0.415, 90)).unwrap();
        d.build().unwrap()
    };
    let arc = ends_at((10.0, 10.0)).place();
    let s = strip(5.0, 0.415);
    let top = chain(vec![arc.clone(), joined(&arc, &s)]);
    let polygons = written(&top, WeldOptions::default());
    // Away from zero: 9793 on the left; the straight's own rounding gave 9792.
    assert!(polygons[0].contains(&(9793, 10_000)) && polygons[0].contains(&(10_208, 10_000)), "{polygons:?}");
    assert_eq!(polygons[1], [(10_208, 10_000), (10_208, 15_000), (9792, 15_000), (9793, 10_000)]);
    let mut heater = Device::builder("heater");
    heater.add_polygon([(0.0, -0.2075), (5.0, -0.2075), (5.0, 0.2075), (0.0, 0.2075)], 2).unwrap();
    heater.add_port("1", ((0, 0), 0.415, 180)).unwrap();
    let top = chain(vec![arc.clone(), joined(&arc, &s), joined(&arc, &heater.build().unwrap())]);
    let polygons = written(&top, WeldOptions::default());
    assert!(polygons[0].contains(&(9792, 10_000)), "two of three exact members agree on 9792: {polygons:?}");
}

#[test]
fn a_ring_of_four_arcs_is_one_turned_arc() {
    let quarter = {
        let mut d = Device::builder("arc");
        let at = |r: f64, degrees: f64| Point::polar(r, degrees);
        d.add_polygon([at(9.75, 0.0), at(10.25, 0.0), at(10.25, 90.0), at(9.75, 90.0)], 1).unwrap();
        d.add_port("1", ((10, 0), 0.5, 270)).unwrap();
        d.add_port("2", ((0, 10), 0.5, 180)).unwrap();
        d.build().unwrap()
    };
    let mut ring = Device::builder("ring");
    for quarter_turns in 0..4 {
        ring.add(quarter.place().rotated(90 * quarter_turns));
    }
    let top = chain(vec![ring.build().unwrap().place().rotated(30)]);
    let polygons = written(&top, WeldOptions::default());
    assert_eq!(polygons[0], [(8444, 4875), (8877, 5125), (-5125, 8877), (-4875, 8444)]);
    assert_eq!(report(&top, &WeldOptions::default()).forms.len(), 2);
}

#[test]
fn a_wide_edge_gets_the_corners_of_a_narrow_one() {
    let mut d = Device::builder("wide");
    d.add_polygon([(0, -5), (2, -5), (2, 5), (0, 5)], 1).unwrap();
    d.add_port("2", ((2, 0), 10, 0)).unwrap();
    let wide = d.build().unwrap().place().rotated(30);
    let top = chain(vec![wide.clone(), joined(&wide, &strip(1.0, 0.5))]);
    let polygons = written(&top, WeldOptions::default());
    assert_eq!(polygons[0].len(), 6);
    for corner in [(1607, 1217), (1857, 783)] {
        assert!(polygons[0].contains(&corner) && polygons[1].contains(&corner), "{polygons:?}");
    }
    assert_eq!(report(&top, &WeldOptions::default()).inserted_vertices, 2);
}

#[test]
fn every_layer_of_a_cross_section_is_welded() {
    let mut d = Device::builder("three");
    for (layer, half, offset) in [(1, 0.25, 0.0), (2, 1.5, 0.0), (3, 0.1, -2.0)] {
        let (low, high) = (offset - half, offset + half);
        d.add_polygon([(0.0, low), (2.0, low), (2.0, high), (0.0, high)], layer).unwrap();
    }
    d.add_port("1", ((0, 0), 0.5, 180)).unwrap();
    d.add_port("2", ((2, 0), 0.5, 0)).unwrap();
    let three = d.build().unwrap();
    let a = three.place().rotated(15);
    let top = chain(vec![a.clone(), joined(&a, &three)]);
    let polygons = written(&top, WeldOptions::default());
    let seams = [[(1867, 759), (1997, 276)], [(1544, 1967), (2320, -931)], [(2424, -1318), (2475, -1511)]];
    for (layer, seam) in seams.iter().enumerate() {
        for corner in seam {
            assert!(
                polygons[layer].contains(corner) && polygons[layer + 3].contains(corner),
                "{corner:?} {polygons:?}"
            );
        }
    }
}

#[test]
fn circuits_that_nothing_leads_out_of_are_rounded_once() {
    let s = strip(1.0, 0.5);
    let mut d = Device::builder("circuit");
    d.add(s.place());
    d.add(s.place().moved_by((1, 0)));
    let circuit = d.build().unwrap();
    let top = chain(vec![circuit.place().rotated(15), circuit.place().rotated(15).moved_by((5.0003, 2.0001))]);
    let polygons = written(&top, WeldOptions::default());
    for corner in [(901, 500), (1031, 17)] {
        assert!(polygons[0].contains(&corner) && polygons[1].contains(&corner), "{polygons:?}");
        let there = (corner.0 + 5000, corner.1 + 2000);
        assert!(polygons[2].contains(&there) && polygons[3].contains(&there), "{polygons:?}");
    }
    assert_eq!(report(&top, &WeldOptions::default()).forms.len(), 3);
    let trusting = WeldOptions { beneath: Beneath::Trust, ..WeldOptions::default() };
    assert_eq!(report(&top, &trusting).forms.len(), 0);
}

#[test]
fn corners_half_a_step_off_agree_as_they_are_written() {
    let mut d = Device::builder("square");
    d.add_polygon([(0.0, -0.5), (1.0, -0.5), (1.0, 0.5), (0.0, 0.5)], 1).unwrap();
    d.add_port("w", ((0, 0), 1, 180)).unwrap();
    d.add_port("e", ((1, 0), 1, 0)).unwrap();
    let square = d.build().unwrap();
    let a = square.place().moved_by((0.0, 0.0005));
    let mut b = square.place();
    b.connect("e", &a.port("w").unwrap()).unwrap();
    let report = report(&chain(vec![a, b]), &WeldOptions::default());
    assert_eq!((report.closed, report.forms.len()), (1, 0));
}

#[test]
fn a_magnified_side_takes_the_corners_of_an_exact_one() {
    let exact = strip(1.0, 0.4995).place();
    let odd = Reference::new(strip(1.0, 0.333), Transform::scaling(1.5));
    let mut b = odd.clone();
    b.connect("1", &exact.port("2").unwrap()).unwrap();
    let polygons = written(&chain(vec![exact, b]), WeldOptions::default());
    for corner in [(1000, 250), (1000, -250)] {
        assert!(polygons[0].contains(&corner) && polygons[1].contains(&corner), "{polygons:?}");
    }
}

#[test]
fn an_array_is_split_only_where_its_elements_meet_at_odd_angles() {
    let array = strip(1.0, 0.5).array(3, 1, (1, 0));
    let top = chain(vec![array.clone().rotated(10)]);
    let polygons = written(&top, WeldOptions::default());
    for (element, seam) in [(0, [(941, 420), (1028, -73)]), (1, [(1926, 593), (2013, 101)])] {
        for corner in seam {
            assert!(polygons[element].contains(&corner) && polygons[element + 1].contains(&corner), "{polygons:?}");
        }
    }
    let at_10 = report(&top, &WeldOptions::default());
    assert_eq!((at_10.forms.len(), at_10.arrays_split, at_10.joints), (3, 1, 2));
    let upright = report(&chain(vec![array.rotated(90)]), &WeldOptions::default());
    assert_eq!((upright.closed, upright.forms.len(), upright.arrays_split), (2, 0, 0));
}

#[test]
fn a_rigid_cell_stays_and_its_neighbor_gives_way() {
    let box_ = strip(3.0, 0.5);
    let mut black = box_.edit();
    black.rename("black_box");
    let black = black.build().unwrap().place().rotated(25).moved_by((0.0003, 0.0003));
    let top = chain(vec![black.clone(), joined(&black, &strip(1.0, 0.5))]);
    let rigid = WeldOptions { rigid: vec!["black*".into()], list: Listing::All, ..WeldOptions::default() };
    let polygons = written(&top, rigid.clone());
    for corner in [(2613, 1494), (2825, 1041)] {
        assert!(polygons[1].contains(&corner), "{polygons:?}");
    }
    assert!(report(&top, &rigid).forms.iter().all(|form| form.cell == "strip"));
}

#[test]
fn a_bare_polygon_is_a_side() {
    let s = strip(1.0, 0.5).place().rotated(10);
    let (low, high) = (Point::new(1.028_219_8, -0.072_553_8), Point::new(0.941_395_7, 0.419_850_1));
    let port = s.port("2").unwrap();
    let (left, right) = port.endpoints();
    assert!(left.distance(high) < 1e-6 && right.distance(low) < 1e-6);
    let out = port.normal() * 2.0;
    let mut d = Device::builder("top");
    d.add(s);
    d.add_polygon([right, right + out, left + out, left], 1).unwrap();
    let top = d.build().unwrap();
    let polygons = written(&top, WeldOptions::default());
    for corner in [(941, 420), (1028, -73)] {
        assert!(polygons.iter().all(|polygon| polygon.contains(&corner)), "{polygons:?}");
    }
    assert_eq!(report(&top, &WeldOptions::default()).welded, 1);
    let bare_off = WeldOptions { bare: false, ..WeldOptions::default() };
    assert_eq!(report(&top, &bare_off).joints, 0);
}

#[test]
fn three_cells_at_a_corner_share_one_point() {
    let mut d = Device::builder("square");
    d.add_polygon([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)], 1).unwrap();
    d.add_port("n", ((0.0, 0.5), 1, 90)).unwrap();
    d.add_port("e", ((0.5, 0.0), 1, 0)).unwrap();
    let square = d.build().unwrap().place().rotated(10);
    let s = strip(2.0, 1.0);
    let to = |port: &str| {
        let mut placed = s.place();
        placed.connect("1", &square.port(port).unwrap()).unwrap();
        placed
    };
    let top = chain(vec![square.clone(), to("n"), to("e")]);
    let polygons = written(&top, WeldOptions::default());
    let corner = Grid::new(1e-3).unwrap().point_steps(Transform::rotation(10.0).apply(Point::new(0.5, 0.5))).unwrap();
    assert!(polygons.iter().all(|polygon| polygon.contains(&corner)), "{corner:?} {polygons:?}");
}
