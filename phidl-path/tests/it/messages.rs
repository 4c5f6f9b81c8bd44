//! Every error sentence of the crate, read by eye.

use std::fmt::Write as _;

use expect_test::expect;
use phidl_core::Error;
use phidl_path::{
    ArcBend, CrossSection, EulerBend, Extrusion, Overlaps, Path, Section, Spiral, TransitionShape, transition,
};

fn line(points: &[(f64, f64)]) -> Path {
    Path::from_points(points.to_vec()).unwrap()
}

fn corner() -> Path {
    line(&[(0., 0.), (10., 0.), (10., 10.)])
}

fn extruded(section: Section) -> Error {
    corner().extrude(&section.into()).unwrap_err()
}

fn listed(errors: impl IntoIterator<Item = Error>) -> String {
    errors.into_iter().fold(String::new(), |mut text, error| {
        writeln!(text, "{}", error.report()).unwrap();
        text
    })
}

#[test]
fn messages_of_paths() {
    let mut blank = Path::new();
    blank.set_end_angle(f64::NAN);
    let mut short = Path::new();
    short.append([(0, 0)]);
    let errors = [
        Path::from_points([(0, 0)]).unwrap_err(),
        Path::from_points(Vec::<(f64, f64)>::new()).unwrap_err(),
        Path::from_points([(0.0, 0.0), (f64::NAN, 1.0)]).unwrap_err(),
        blank.hash_geometry(1e-4).unwrap_err(),
        short.offset(1).unwrap_err(),
        Path::new().offset(1).unwrap_err(),
        Path::straight(-1).unwrap_err(),
        Path::straight_of(1, 1).unwrap_err(),
        Path::arc(-2, 90).unwrap_err(),
        Path::arc(2, 0).unwrap_err(),
        ArcBend::new().num_pts(0).path(2, 90).unwrap_err(),
        ArcBend::new().num_pts(1e12).path(2, 90).unwrap_err(),
        Path::euler(3, 2000).unwrap_err(),
        EulerBend::new().use_eff().path(3, 270).unwrap_err(),
        EulerBend::new().p(1.5).path(3, 90).unwrap_err(),
        Spiral { num_turns: 1.0, ..Spiral::default() }.path().unwrap_err(),
        Spiral { num_pts: 20.0, ..Spiral::default() }.path().unwrap_err(),
        corner().with_tolerance(0).unwrap_err(),
        Path::arc(1e12, 300).unwrap().with_tolerance(1e-6).unwrap_err(),
        corner().hash_geometry(0.0).unwrap_err(),
        corner().interpolate([21], 0).unwrap_err(),
        corner().beside([1], vec![0.0]).unwrap_err(),
        corner().offset(f64::NAN).unwrap_err(),
        corner().offset(vec![1.0]).unwrap_err(),
        corner().offset(|t: f64| if t == 0.0 { 1e305 } else { -1e305 }).unwrap_err(),
        corner().curvature().unwrap_err(),
    ];
    expect![[r#"
        path: a path needs at least 2 points, but 1 point is given
        path: a path needs at least 2 points, but no points are given
        path: points[1] is (NaN, 1), but it must be finite
        path: end_angle is NaN°, but it must be finite
        path: a path needs at least 2 points, but 1 point is given
        offset: the path has 1 point, but needs at least 2
        straight: length is -1 µm, but it must be at least 0 µm and finite
        straight: num_pts is 1, but it must be from 2 to 16777216
        arc: radius is -2 µm, but it must be greater than 0 µm and finite
        arc: angle is 0°, but it must be finite and not 0°
        arc: num_pts is 0, but it must be greater than 0 and finite
        arc: num_pts is 1000000000000, but it must be small enough for at most 16777216 points
        euler: angle is 2000°, but it must be from -1440° to 1440°
        euler: angle is 270°, but it must be from -190° to 190° for use_eff
        euler: p is 1.5, but it must be from 0 to 1
        spiral: num_turns is 1, but it must be greater than 1 and less than 1e6
        spiral: num_pts is 20, but it must be enough for two points on each curve
        with_tolerance: tolerance is 0 µm, but it must be at least 0.000001 µm and finite
        with_tolerance: tolerance is 0.000001 µm, but it must be large enough for at most 1048576 chords on each piece
        hash_geometry: precision is 0 µm, but it must be greater than 0 µm and finite
        interpolate: distance is 21 µm, but it must be from 0 µm to 20 µm, the length of the path
        beside: offset is [0.0], but it must be a number or a function, and finite at t = 0.05
        path: offset is NaN µm, but it must be finite
        path: offset is a list of 1 values, but it must have one for each of the 3 points of the path
        path: the offset has no finite slope at an end of the path
        curvature: the path needs at least 4 distinct points, but has 3
    "#]]
    .assert_eq(&listed(errors));
}

#[test]
fn messages_of_smoothed_paths() {
    let crooked = |radius: f64, _: f64| Path::arc(radius, 45);
    let errors = [
        Path::smooth([(1, 1), (1, 1)], 1, ArcBend::new()).unwrap_err(),
        Path::smooth([(0, 0), (9, 0), (1, 0)], 1, ArcBend::new()).unwrap_err(),
        Path::smooth([(0, 0), (3, 0), (3, 9)], 5, ArcBend::new()).unwrap_err(),
        Path::smooth([(0, 0), (30, 0), (30, 90)], 5, crooked).unwrap_err(),
        Path::smooth([(0, 0), (30, 0), (30, 90)], -5, ArcBend::new()).unwrap_err(),
    ];
    expect![[r#"
        smooth: all waypoints are one point, but at least two different ones are needed
        smooth: the line doubles back at (9, 0), where no bend fits
        smooth: the leg from (0, 0) to (3, 0) is 3 µm long, but its bends need 5 µm
        smooth: the bend for a corner of 90° leads from (0, 0) to (3.5355339059327373, 1.4644660940672627), but it must start at (0, 0) and end as far behind the corner as it starts before it
        arc: radius is -5 µm, but it must be greater than 0 µm and finite
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_cross_sections() {
    let (wg, etch) = (|| Section::new(1).named("wg"), || Section::new(2).named("etch"));
    let x = CrossSection::new().add(wg()).add(etch());
    let of = |section: Section| CrossSection::new().add(section);
    let errors = [
        x.get("gw").unwrap_err(),
        CrossSection::of_width(1, 0).get("wg").unwrap_err(),
        corner().extrude(&CrossSection::new().add(wg()).add(wg())).unwrap_err(),
        extruded(Section::new(1).ports("p", "p")),
        extruded(Section::new(-1).named("wg")),
        extruded(Section::new(1).offset(f64::INFINITY)),
        extruded(Section::new((1, -1))),
        extruded(Section::new(|t: f64| 1.0 / (t - t))),
        extruded(Section::new(vec![1.0, 2.0])),
        extruded(wg().right_of("strip")),
        corner().extrude(&x.clone().add(Section::new(1).right_of("wg").offset(2))).unwrap_err(),
        transition(&x, &of(Section::new(1).named("rib")), TransitionShape::Sine).unwrap_err(),
        transition(&x, &of(Section::new(1)), TransitionShape::Sine).unwrap_err(),
        transition(&of(Section::new(vec![1.0, 2.0]).named("wg")), &x, TransitionShape::Sine).unwrap_err(),
    ];
    expect![[r#"
        cross-section: there is no section "gw"; known are wg, etch
        cross-section: there is no section "wg"; no section has a name
        cross-section: the name "wg" is used twice
        cross-section: the port name "p" is used twice
        section "wg": width is -1 µm, but it must be greater than 0 µm and finite
        section 0: offset is inf µm, but it must be finite
        section 0: width is -1 µm at t = 1, but it must be at least 0 µm everywhere
        section 0: width is inf µm at t = 0, but it must be finite
        section 0: width is a list of 2 values, but it must have one for each of the 3 points of the path
        section "wg": it begins at an edge of "strip", so a section "strip" must be added before it
        section 2: offset is 2.0 µm, but it must be left out, since the section begins at an edge of "wg"
        transition: the cross-sections need a section name in common, but the first has wg, etch and the second has rib
        transition: the cross-sections need a section name in common, but the first has wg, etch and the second has no named section
        section "wg": width is [1.0, 2.0], but it must be a number or a function, and finite at t = 1
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_extrusions() {
    let x = CrossSection::new().add(Section::new(1)).add(Section::new(0.5).offset(1.5).named("heater"));
    let turn =
        |radius: f64| Path::of([Path::line(10).unwrap(), Path::arc(radius, -180).unwrap(), Path::line(10).unwrap()]);
    let spiral = Spiral { num_turns: 3.0, gap: 3.0, inner_gap: 9.0, num_pts: 4000.0 }.path().unwrap();
    let knot = line(&[(0., 0.), (50., 0.), (50., 30.), (20., 30.), (20., -30.)]);
    let all = |path: &Path, width: f64| {
        Extrusion::new(path, &CrossSection::of_width(width, 0)).overlaps(Overlaps::RefuseAll).build().unwrap_err()
    };
    let errors = [
        Path::new().extrude(&x).unwrap_err(),
        Path::straight(0).unwrap().extrude(&x).unwrap_err(),
        Extrusion::new(&corner(), &x).simplify(-1).build().unwrap_err(),
        turn(1.6).extrude(&x).unwrap_err(),
        turn(1.0).extrude(&x).unwrap_err(),
        line(&[(0., 0.), (1., 0.), (1., 1.)]).extrude_width(4, 0).unwrap_err(),
        line(&[(0., 0.), (9., 0.), (0., 0.)]).extrude_width(1, 0).unwrap_err(),
        all(&spiral, 3.2),
        all(&knot, 2.0),
    ];
    expect![[r#"
        extrude: the path has 1 point, but needs at least 2
        extrude: the length of the path is 0 µm, but it must be greater than 0 µm and finite
        extrude: simplify is -1 µm, but it must be at least 0 µm and finite
        extrude: section "heater" overlaps itself on the right from 10.014001 µm to 15.012531 µm along the path: its edge lies 1.75 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 1.75 µm, or a width of at most 0.1999 µm would do
        extrude: section "heater" overlaps itself on the right from 10 µm to 13.141583 µm along the path: its edge lies 1.75 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 1.75 µm, or the section may lie closer to the path
        extrude: section 0 overlaps itself on the left from 0 µm to 2 µm along the path: its edge lies 2 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 2 µm, or a width of at most 2 µm would do
        extrude: section 0 overlaps itself on the right from 9 µm to 9 µm along the path: its edge lies 0.5 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 0.5 µm, or the section may lie closer to the path
        extrude: section 0 overlaps itself: the positions at 65.9883 µm and at 145.385693 µm along the path are 2.982832 µm apart; a width of at most 2.982 µm would do
        extrude: section 0 crosses itself: the path passes twice through one position, at 20 µm and at 140 µm along it
    "#]].assert_eq(&listed(errors));
}
