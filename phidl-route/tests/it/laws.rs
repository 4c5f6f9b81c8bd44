//! Laws of all routes, for random positions of the ports.

use phidl_core::num::angle;
use phidl_core::param::Param as _;
use phidl_core::prelude::*;
use phidl_path::Path;
use phidl_route::{
    PathType, RouteBend, RouteManhattanParams, RouteSerpentineParams, RouteSharpParams, RouteSmoothParams,
    SmoothOptions, manhattan_centerline, path_manhattan, serpentine_centerline,
};
use proptest::prelude::*;
use testkit::golden::merged_area;

/// Rounding of a few operations within a millimeter (µm).
const NOISE: f64 = 1e-6;

/// Two ports turned by a multiple of 90° against each other, near or far, on a grid or off it, both at a common angle.
fn ports() -> impl Strategy<Value = [Port; 2]> {
    let near = (-40..=40_i32, -40..=40_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
    let place = prop_oneof![
        near,
        (-60.0..60.0, -60.0..60.0).prop_map(Point::from),
        (-900.0..900.0, -900.0..900.0).prop_map(Point::from)
    ];
    let common = prop_oneof![Just(0.0), (0..4).prop_map(|i| f64::from(i) * 90.0), 0.0..360.0];
    (place, 0..4_i32, common, 0.1..4.0, 0.1..4.0, testkit::strategies::point()).prop_map(
        |(place, quarters, common, width1, width2, corner)| {
            let turn = Transform { origin: corner, ..Transform::rotation(common) };
            let port1 = Port::new(corner, width1, common);
            [port1, Port::new(turn.apply(place), width2, common + 90.0 * f64::from(quarters))]
        },
    )
}

fn bend() -> impl Strategy<Value = RouteBend> {
    prop_oneof![Just(RouteBend::Circular), Just(RouteBend::Euler), Just(RouteBend::Gradual)]
}

/// The smallest radius of the circles through three neighboring points of a path (µm).
fn tightest(path: &Path) -> f64 {
    let radius = |p: &[Point]| {
        let (a, b, c) = (p[1] - p[0], p[2] - p[1], p[2] - p[0]);
        a.norm() * b.norm() * c.norm() / (2.0 * a.cross(b).abs())
    };
    let points: Vec<Point> = path.points().iter().copied().fold(Vec::new(), |mut points: Vec<Point>, p| {
        if points.last().is_none_or(|last| last.distance(p) > NOISE) {
            points.push(p);
        }
        points
    });
    points.windows(3).map(radius).fold(f64::INFINITY, f64::min)
}

/// A Manhattan route with everything allowed.
fn manhattan(ports: &[Port; 2], bend: RouteBend, radius: f64) -> RouteManhattanParams {
    let route = RouteManhattanParams::new(&ports[0], &ports[1]).bend(bend).radius(radius);
    route.allow_detour(true).allow_crossings(true)
}

/// The ends of a route lie on its ports: its own ports face them, and its outline has their corners.
fn meets(route: &Device, ports: &[Port; 2], widths: [f64; 2]) -> Result<(), TestCaseError> {
    for ((name, port), width) in ["1", "2"].into_iter().zip(ports).zip(widths) {
        let own = route.port(name).unwrap();
        prop_assert!(own.midpoint().distance(port.midpoint()) < NOISE);
        prop_assert!(angle::between(own.orientation(), port.orientation() + 180.0) < NOISE);
        prop_assert!((own.width() - width).abs() < NOISE);
        let (left, right) = port.clone().with_width(width).endpoints();
        for corner in [left, right] {
            let nearest = route.polygons().flat_map(|polygon| polygon.points.iter()).map(|p| p.distance(corner));
            prop_assert!(nearest.fold(f64::INFINITY, f64::min) < NOISE, "no corner at {corner}");
        }
    }
    Ok(())
}

/// How often a route says that it runs over itself, and over the ports.
fn overlaps(route: &Device) -> [u32; 2] {
    ["crossings", "over_ports"].map(|key| u32::from_value(&route.info()[key]).unwrap())
}

/// By another engine: a strip with mitered corners covers its length times its width, unless it covers something twice.
fn runs_over_itself_as_it_says(route: &Device, width: f64) -> Result<(), TestCaseError> {
    let outlines: Vec<Vec<Point>> = route.polygons().map(|polygon| polygon.points.to_vec()).collect();
    let (covered, strip) = (merged_area(&outlines), route.info()["length"].as_f64().unwrap() * width);
    let twice = strip - covered;
    prop_assert!(twice.abs() < 1e-5 * strip || overlaps(route)[0] > 0, "{twice} of {strip} µm² are covered twice");
    // A touch is seen a little too early, where bends are far out.
    prop_assert!(twice > -1e-5 * strip, "{covered} µm² are more than {strip}");
    Ok(())
}

/// A line leaves the first port forwards and enters the second from the front.
fn faces(path: &Path, ports: &[Port; 2]) -> Result<(), TestCaseError> {
    prop_assert!(path.start().distance(ports[0].midpoint()) < NOISE);
    prop_assert!(path.end().distance(ports[1].midpoint()) < NOISE);
    prop_assert!(angle::between(path.start_angle(), ports[0].orientation()) < NOISE);
    prop_assert!(angle::between(path.end_angle(), ports[1].orientation() + 180.0) < NOISE);
    Ok(())
}

proptest! {
    #[test]
    fn manhattan_routes_meet_and_face_their_ports_and_are_never_tighter_than_their_radius(
        ports in ports(), bend in bend(), radius in 2.0..30.0,
    ) {
        let route = manhattan(&ports, bend, radius).width(ports[0].width());
        let path = route.centerline().unwrap();
        faces(&path, &ports)?;
        prop_assert!(tightest(&path) >= radius * (1.0 - 1e-4), "{} < {radius}", tightest(&path));
        let Ok(route) = route.build() else {
            // Only a wire too wide for its bends is refused.
            prop_assert!(ports[0].width() > 2.0 * radius);
            return Ok(());
        };
        meets(&route, &ports, [ports[0].width(); 2])?;
        prop_assert!((route.info()["length"].as_f64().unwrap() - path.length()).abs() < NOISE);
        let smallest = route.info()["smallest_radius"].as_f64();
        prop_assert_eq!(smallest, (path.points().len() > 2).then_some(radius));
    }

    #[test]
    fn manhattan_routes_run_over_themselves_only_if_their_info_says_so(
        ports in ports(), bend in bend(), radius in 2.0..30.0, slim in 0.01..0.99,
    ) {
        let ports = ports.map(|port| port.with_width(2.0 * radius * slim));
        let route = manhattan(&ports, bend, radius).build().unwrap();
        runs_over_itself_as_it_says(&route, ports[0].width())?;
        let size = manhattan_centerline(((0, 0), 1, 0), ((9e3, 9e3), 1, 270), bend, radius).unwrap().pieces()[0].length();
        let bend_size = 9e3 - size;
        if ports[0].midpoint().distance(ports[1].midpoint()) > 5.0 * bend_size {
            prop_assert_eq!(overlaps(&route), [0, 0], "there is room for a route");
        }
        // Without permission, a route is direct and clear, or an error.
        if let Ok(direct) = RouteManhattanParams::new(&ports[0], &ports[1]).bend(bend).radius(radius).build() {
            prop_assert!(overlaps(&direct) == [0, 0] && !direct.info().contains_key("detour"));
        }
    }

    #[test]
    fn waypoints_turn_at_right_angles_and_have_room_for_their_bends(ports in ports(), radius in 2.0..30.0) {
        let waypoints = path_manhattan(&ports[0], &ports[1], radius).unwrap();
        let legs: Vec<Point> = waypoints.points().windows(2).map(|leg| leg[1] - leg[0]).collect();
        for pair in legs.windows(2) {
            prop_assert!(pair[0].dot(pair[1]).abs() < NOISE * pair[0].norm() * pair[1].norm());
        }
        for (i, leg) in legs.iter().enumerate() {
            let corners = usize::from(i > 0) + usize::from(i + 1 < legs.len());
            prop_assert!(leg.norm() >= radius * corners as f64, "leg {i} of {:?}", waypoints.points());
        }
    }

    #[test]
    fn smooth_and_sharp_routes_meet_their_ports_at_any_position(ports in ports(), radius in 5.0..30.0) {
        let widths = [ports[0].width(), ports[1].width()];
        for options in [SmoothOptions::euler(), SmoothOptions::arc()] {
            let route = RouteSmoothParams::new(&ports[0], &ports[1]).radius(radius).smooth_options(options).allow_crossings(true);
            meets(&route.build().unwrap(), &ports, widths)?;
        }
        let narrower = [widths[0] / 2.0, widths[1]];
        let sharp = RouteSharpParams::new(&ports[0], &ports[1]).width((narrower[0], narrower[1])).allow_crossings(true);
        meets(&sharp.build().unwrap(), &ports, narrower)?;
    }

    #[test]
    fn a_route_of_any_path_type_faces_its_ports_or_is_an_error(
        ports in [(testkit::strategies::point(), testkit::strategies::angle()), (testkit::strategies::point(), testkit::strategies::angle())],
        length in prop_oneof![Just(None), (-50.0..300.0).prop_map(Some)],
    ) {
        let ports = ports.map(|(at, orientation)| Port::new(at, 2, orientation));
        for path_type in [PathType::L, PathType::U, PathType::V, PathType::Z] {
            let params = RouteSharpParams::new(&ports[0], &ports[1]).path_type(path_type);
            let takes_length = matches!(path_type, PathType::U | PathType::Z);
            let params = if takes_length { params.length1(length) } else { params };
            match params.build() {
                Ok(route) => meets(&route, &ports, [2.0, 2.0])?,
                Err(error) => {
                    let text = error.report();
                    prop_assert!(text.contains("port1 at") && text.contains("port2 at"), "{text}");
                }
            }
        }
    }

    #[test]
    fn serpentines_have_the_given_length(
        ports in ports(), bend in bend(), radius in 2.0..20.0, more in 0.0..3000.0_f64,
    ) {
        let ports = ports.map(|port| port.with_width(1));
        let length = manhattan(&ports, bend, radius).centerline().unwrap().length() + more;
        let route = RouteSerpentineParams::new(&ports[0], &ports[1], length).bend(bend).radius(radius);
        let route = route.allow_detour(true).allow_crossings(true);
        let path = match route.centerline() {
            Ok(path) => path,
            Err(error) => {
                let text = error.to_string();
                let explained = text.contains("are missing") || text.contains("would run over the route on both sides");
                prop_assert!(explained && text.contains("port1 at") && text.contains("port2 at"), "{text}");
                return Ok(());
            }
        };
        faces(&path, &ports)?;
        prop_assert!((path.length() - length).abs() <= 1e-4, "{} instead of {length}", path.length());
        prop_assert!(tightest(&path) >= radius * (1.0 - 1e-4));
        if let Ok(route) = route.build() {
            meets(&route, &ports, [ports[0].width(); 2])?;
            runs_over_itself_as_it_says(&route, ports[0].width())?;
        }
    }
}

#[test]
fn a_straight_span_with_room_takes_every_length() {
    let ports = [Port::new((0, 0), 1, 0), Port::new((200, 0), 1, 180)];
    for bend in [RouteBend::Circular, RouteBend::Euler] {
        for i in 0..400 {
            let length = 200.0 + f64::from(i * i) * 0.013;
            let path = serpentine_centerline(&ports[0], &ports[1], length, bend, 8).unwrap();
            assert!((path.length() - length).abs() <= 1e-4, "{bend:?} {length}: {}", path.length());
        }
    }
}

#[test]
fn routes_do_not_depend_on_the_position_and_direction_of_their_pair() {
    // Turned by a common angle, the waypoints must be the same.
    for quarters in 0..4 {
        for (x, y) in [(30, 20), (-7, 12), (9, 4), (3, -30), (-50, 0)] {
            let upright = path_manhattan(((0, 0), 1, 0), ((x, y), 1, 90 * quarters), 5).unwrap();
            for common in [37.0, 90.0, 271.3] {
                let turn = Transform { origin: Point::new(11.0, -7.0), ..Transform::rotation(common) };
                let to = Port::new(turn.apply((x, y).into()), 1, common + 90.0 * f64::from(quarters));
                let turned = path_manhattan(Port::new(turn.origin, 1, common), to, 5).unwrap();
                assert_eq!(turned.points().len(), upright.points().len());
                for (p, q) in turned.points().iter().zip(upright.points()) {
                    assert!(p.distance(turn.apply(*q)) < NOISE, "{p} {q}");
                }
            }
        }
    }
}
