//! Hashes of paths, measured on PHIDL.

use std::f64::consts::PI;

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Path, Section, Spiral, TransitionShape, transition};

use crate::golden::defined_hash;

fn arc(radius: f64, angle: f64) -> Path {
    Path::arc(radius, angle).unwrap()
}

fn euler(radius: f64, angle: f64) -> Path {
    Path::euler(radius, angle).unwrap()
}

fn straight(length: f64) -> Path {
    Path::straight(length).unwrap()
}

fn hash(path: &Path) -> String {
    path.hash_geometry(1e-4).unwrap()
}

fn drawn(device: &Device) -> String {
    device.hash_geometry(1e-4).unwrap()
}

fn check(cases: &[(&str, Path, &str)]) {
    let wrong: Vec<&str> =
        cases.iter().filter(|(_, path, expected)| hash(path) != *expected).map(|(name, ..)| *name).collect();
    assert!(wrong.is_empty(), "other hashes: {wrong:?}");
}

#[test]
fn pieces_have_the_hashes_of_the_reference() {
    let bend = EulerBend::new();
    check(&[
        ("straight", straight(15.0), "3672036ccf29992546436e1cc5e62e667cde4af0"),
        ("euler1", euler(3.0, 90.0), "d6134ba90167caf551de6d2f8c7230f7f072c562"),
        ("euler2", bend.p(0.5).path(3, 90).unwrap(), "78b325576400e3f4f9a04c27243432102e84cfe7"),
        ("euler3", bend.p(0.5).use_eff().path(3, 90).unwrap(), "0c5fc2a47b910522b4bd37176dbb096f99ea1083"),
        ("arc", arc(10.0, 90.0), "53eaa037b8872155a1d1cb81e2daa02a0da2eb91"),
        (
            "arc(5,-45,100)",
            ArcBend::new().num_pts(100).path(5, -45).unwrap(),
            "f69a770adf9f6c7e7edf369674d6f1fbfe826e6a",
        ),
        ("arc(10,180)", arc(10.0, 180.0), "57d3f56ba06f01b634e550d6123080afe9faba02"),
        ("euler(-90)", euler(3.0, -90.0), "2830f1f62f903b5a0b6078e2b7b6c23a3d6a21e8"),
        (
            "euler(10,45,.25,eff)",
            bend.p(0.25).use_eff().path(10, 45).unwrap(),
            "9f179ad4d77fd255c5a4339807480ba4dda8aa63",
        ),
        ("euler(180)", euler(3.0, 180.0), "84c2a16a2d53479f8df4d3765264289e37207f1b"),
        ("euler(p=0)", bend.p(0).path(3, 90).unwrap(), "d75d384acc877a6bddf969e91d3f586b67cab2e8"),
        ("euler(5,30,.5)", bend.p(0.5).num_pts(100).path(5, 30).unwrap(), "275f6d803bb120d2655c0be2a83f4171e63866a7"),
        ("euler(25,45,.5)", bend.p(0.5).path(25, 45).unwrap(), "27049e64e5fd36eaed7161158fcf910014799db8"),
    ]);
}

#[test]
fn placed_and_appended_paths_have_the_hashes_of_the_reference() {
    let (p1, p2, right) = (arc(12.0, 47.0), arc(12.0, 63.0), arc(12.0, -63.0));
    let (s, l, r) = (straight(10.0), euler(4.0, 90.0), euler(4.0, -90.0));
    check(&[
        ("rotate1", Path::new().rotated(47), "f30d4e52e113a2954e7facee8144ac8bf4ea66c9"),
        ("rotate2", arc(10.0, 90.0).rotated(47), "d3bc47a30787fb6d9514fdd91f45d619c9afff02"),
        ("move1", Path::new().moved_by((16, 17.7)), "6be1a6e602c7ce3d5560176aa7c9ebbf1b6788d5"),
        ("move2", arc(10.0, 90.0).moved_by((16, 17.7)), "200e897720aa4d4a7f54afeaa2ca1faaa0e6b3de"),
        ("append1", p1.clone() + &p2, "57a2cec018e695db668437a9b3dcdd8c595e300f"),
        ("append2", Path::of([&p1, &p2]), "57a2cec018e695db668437a9b3dcdd8c595e300f"),
        (
            "append3",
            Path::of([vec![&p1, &right], vec![&right, &p1, &right]]),
            "85646fba990cd2e72334df5d1e31678f090f6ce2",
        ),
        ("S L S R S", Path::of([&s, &l, &s, &r, &s]), "f9a9cd5988e4f4b847530a365055d86bf7e61225"),
        ("L R nested", Path::of([[&l, &r], [&l, &r], [&l, &r]]), "6952df8d0b48069f28fdef280d565342236032cb"),
    ]);
}

#[test]
fn smoothed_paths_have_the_hashes_of_the_reference() {
    let points = [(20, 0), (40, 0), (80, 40), (80, 10), (100, 10)];
    check(&[
        (
            "smooth1",
            Path::smooth(points, 2, EulerBend::new().use_eff()).unwrap(),
            "3a2526edee6cf4577cf7fb700ee18a28048e4967",
        ),
        ("smooth2", Path::smooth(points, 4, ArcBend::new()).unwrap(), "f075520ab38933b35f3c8af110627de29e34b695"),
        ("default", Path::smooth(points, 4, EulerBend::new()).unwrap(), "f39b59d22e2801ad0241b5de41571aa46ab848f1"),
    ]);
    // Noise makes the reference end in a direction a hair below 0°, which it takes for 360°, a defect of PHIDL.
    let tutorial = [(20, 10), (40, 10), (20, 40), (50, 40), (50, 20), (70, 20)];
    let path = Path::smooth(tutorial, 2, EulerBend::new()).unwrap();
    assert_eq!((path.points().len(), path.end_angle()), (1706, 0.0));
    assert_eq!(defined_hash(path.points(), 0.0, 360.0), "2f11c28d512c54cd1ee1fb833fd848dc93e8ab87");
}

#[test]
fn spirals_have_the_hashes_of_the_reference_with_its_angles() {
    // The hash takes the last bit of an arctangent, which is not the same on all machines.
    let spiral = |num_turns: f64, gap: f64, inner_gap: f64, num_pts: f64| {
        Spiral { num_turns, gap, inner_gap, num_pts }.path().unwrap()
    };
    let cases = [
        (
            Spiral::default().path().unwrap(),
            (-3.089_199_313_396_054_2, 176.265_593_491_862_52),
            "1d46b2f8ab45f35ce781083755df41609d2ee628",
        ),
        (
            spiral(1.5, 1., 2., 100.),
            (-11.530_605_825_716_826, -11.530_605_825_716_826),
            "3ed5fbda6566f2977fa8b624fcb864d3c411bb71",
        ),
        (
            spiral(2.2, 1., 2., 200.),
            (172.428_021_774_562_15, 62.505_543_493_193_97),
            "9cbe8f46b08100ed7d584ada442cbf7634017d35",
        ),
        (
            spiral(2.7, 1., 2., 200.),
            (-115.076_103_718_897_44, 171.582_941_241_766_38),
            "a1b7dc6340d8f9ecff6397ddc79af8ba57a10d52",
        ),
        (
            spiral(3., 2., 5., 1000.),
            (-4.673_283_976_441_694, 173.857_394_643_184_62),
            "3b4bda6e873be2ed1aac8531ee729312bca0995e",
        ),
    ];
    for (path, (start, end), expected) in cases {
        let close = |ours: f64, theirs: f64| ((ours - theirs + 180.0).rem_euclid(360.0) - 180.0).abs() < 1e-9;
        assert!(close(path.start_angle(), start) && close(path.end_angle(), end));
        assert_eq!(defined_hash(path.points(), start, end), expected);
    }
}

#[test]
fn extruded_arcs_have_the_hashes_of_the_reference() {
    let path = arc(10.0, 90.0);
    assert_eq!(drawn(&path.extrude_width(1, 0).unwrap()), "048ae3e85ff393362d2283c0046db1f0a53b5fe7");
    assert_eq!(drawn(&path.extrude_width(1, 3).unwrap()), "3ec778d98ce1760c4ba067bd1bdc0baf80dcbaf7");
    assert_eq!(drawn(&path.extrude_width((2.5, 3), 0).unwrap()), "2768e7f7ce7503a512089ddb80cd52ed0b43fd8d");
    let (fine, x) = (ArcBend::new().num_pts(900).path(10, 90).unwrap(), CrossSection::of_width(1, 3));
    let simple = Extrusion::new(&fine, &x).simplify(1e-2).build().unwrap();
    assert_eq!(drawn(&simple), "ad53c18e34eb12e552d147a175a67e5fcc372ebe");

    let x = CrossSection::new()
        .add(Section::new(1).ports("in", "out"))
        .add(Section::new(3).offset(2).layer(2))
        .add(Section::new(3).offset(-2).layer(2));
    let three = x.extrude(&path).unwrap();
    assert_eq!(drawn(&three), "e17c4ed7a7467412728dc893610006fa2d9982b0");
    assert_eq!((three.port("in").unwrap().midpoint(), three.port("in").unwrap().orientation()), (Point::ORIGIN, 180.0));
    let out = three.port("out").unwrap();
    assert!(out.midpoint().distance((10, 10).into()) < 1e-12 && out.orientation() == 90.0);
}

#[test]
fn the_tutorial_path_has_the_hashes_of_the_reference() {
    let mut path = arc(10.0, 90.0);
    path.append([straight(10.0), euler(3.0, -90.0), straight(40.0), arc(8.0, -45.0), straight(10.0), arc(8.0, 45.0)]);
    path.append(straight(10.0));
    assert_eq!(path.points().len(), 1112);
    assert!((path.length() - 107.699_010_586).abs() < 1e-8);
    assert_eq!(hash(&path), "bbcf3e80161fe17748f5ab13b1bbdf14f3d6db09");
    path.movey(10).set_xmin(20);
    assert_eq!(hash(&path), "146415d058fa5ae8fc178476ed2cf20aac00c699");
    assert_eq!(drawn(&path.extrude_width(1.5, 3).unwrap()), "739163b7a3f7b79540d4245de8826817f1259c1a");
    assert_eq!(drawn(&path.extrude_width((0.7, 3.7), 4).unwrap()), "cc81c1e81e127529bf3d4c7c9bc83e1f9385f9a6");
}

#[test]
fn the_looping_path_has_the_hashes_and_counts_of_the_reference() {
    let limacon: Vec<Point> = phidl_core::num::count::linspace(-PI, 0.0, 1000)
        .map(|t| Point::new(t.cos(), t.sin()) * (20.0 + 25.0 * t.sin()))
        .collect();
    let mut path = arc(10.0, 90.0);
    path.append(straight(5.0)).append(arc(5.0, -90.0)).append(limacon).rotate(-45);
    assert_eq!(path.points().len(), 1457);
    assert!((path.length() - 84.528_318_223).abs() < 1e-8);
    assert_eq!(path.start_angle(), 315.0);
    assert!((path.end_angle() - 32.029_624_386_712_584).abs() < 1e-12);
    let x = CrossSection::new()
        .add(Section::new(0.5).offset(2).layer(0))
        .add(Section::new(0.5).offset(4).layer(1).end_port("out2"))
        .add(Section::new(1.5).layer(2).ports("in", "out"))
        .add(Section::new(1).layer(3));
    assert_eq!(drawn(&path.extrude(&x).unwrap()), "5d330be3c9af72b92c1369b51b03963337fd4907");
    for (tolerance, counts) in [(1e-3, [958, 1073, 841, 860]), (0.1, [99, 104, 86, 88]), (0.3, [59, 64, 52, 55])] {
        let simple = Extrusion::new(&path, &x).simplify(tolerance).build().unwrap();
        let ours: Vec<usize> = simple.polygons().map(|p| p.points.len()).collect();
        assert_eq!(ours, counts, "{tolerance}");
    }
}

#[test]
fn sections_that_change_have_the_hashes_of_the_reference() {
    let mut path = Path::new();
    path.append(Path::line(10).unwrap()).set_end_angle(90).append(Path::line(10).unwrap()).set_end_angle(-45);
    path.append(Path::line(15).unwrap()).set_end_angle(0).append(Path::line(10).unwrap());
    let x = CrossSection::new()
        .add(Section::new(1).layer(3))
        .add(Section::new(1.5).offset(2.5).layer(4))
        .add(Section::new(1.5).offset(-2.5).layer(7));
    assert_eq!(drawn(&path.extrude(&x).unwrap()), "3146b52822d650b38bdc6a0c0511102cc2433005");

    let wavy =
        CrossSection::new().add(Section::new(3).offset(-6)).add(Section::new(|t: f64| 3.0 + (10.0 * PI * t).cos()));
    assert_eq!(drawn(&straight(40.0).extrude(&wavy).unwrap()), "c1b1c19ec55a8aa4efb197306e493f23e0639086");
    let winding = CrossSection::new().add(Section::new(1).offset(|t: f64| 3.0 + (6.0 * PI * t).cos()));
    assert_eq!(drawn(&straight(40.0).extrude(&winding).unwrap()), "e3354931e40d12b3750ddc9d43195b471041e4b9");
    let offset = straight(40.0).offset(|t: f64| 2.0 + (4.0 * PI * t).cos()).unwrap();
    assert_eq!(hash(&offset), "eaeff6f6613d91db8be8d9e5851e14b7c8516dce");
}

/// The reference's transition: offsets change as a raised cosine whatever the widths do, and move the middle line.
fn moved_middles(mut taper: CrossSection) -> CrossSection {
    let middle = taper.get_mut("wg2").unwrap();
    let (from, to) = (middle.offset.at(0.0).unwrap(), middle.offset.at(1.0).unwrap());
    middle.offset = (move |t: f64| from + (1.0 - (PI * t).cos()) / 2.0 * (to - from)).into();
    taper
}

#[test]
fn transitions_with_moved_middles_have_the_hashes_of_the_reference() {
    let first = CrossSection::new()
        .add(Section::new(1.2).layer(2).named("wg").ports("in1", "out1"))
        .add(Section::new(2.2).layer(3).named("etch"))
        .add(Section::new(1.1).offset(3).layer(1).named("wg2"));
    let second = CrossSection::new()
        .add(Section::new(1).layer(2).named("wg").ports("in2", "out2"))
        .add(Section::new(3.5).layer(3).named("etch"))
        .add(Section::new(3).offset(5).layer(1).named("wg2"));
    let sine = moved_middles(transition(&first, &second, TransitionShape::Sine).unwrap());
    let linear = moved_middles(transition(&first, &second, TransitionShape::Linear).unwrap());
    assert_eq!(drawn(&straight(15.0).extrude(&sine).unwrap()), "507e8c69d8fbc11ccfa2a337e817f6de847bd689");
    assert_eq!(drawn(&straight(15.0).extrude(&linear).unwrap()), "e9af8ad05a8e1637451e9704d7cf28c7cf7ab539");
    let bend = EulerBend::new().p(0.5).path(25, 45).unwrap();
    assert_eq!(drawn(&bend.extrude(&sine).unwrap()), "7f53a62c20b39cb292478f9bc4d282f01963a85f");
}
