//! Every error sentence of the crate, read by eye.

use std::fmt::Write as _;

use expect_test::expect;
use phidl_core::Error;
use phidl_core::port::Port;
use phidl_core::runtime::registry;
use phidl_path::{ArcBend, Bend as _, CrossSection, Section};
use phidl_route::{
    PathType, RouteBasicParams, RouteBend, RouteManhattanAutoParams, RouteManhattanParams, RouteSerpentineParams,
    RouteSharpParams, RouteSmoothParams, RouteXyParams, SmoothOptions, delay_line, path_j, path_l, path_manhattan,
    path_straight, path_u, path_v, path_xy, path_z, route_custom,
};

fn port(x: f64, y: f64, width: f64, orientation: f64) -> Port {
    Port::new((x, y), width, orientation)
}

/// The origin, facing right.
fn origin() -> Port {
    port(0., 0., 1., 0.).named("in")
}

fn listed(errors: impl IntoIterator<Item = Error>) -> String {
    errors.into_iter().fold(String::new(), |mut text, error| {
        writeln!(text, "{}", error.report()).unwrap();
        text
    })
}

#[test]
fn messages_of_waypoints() {
    let errors = [
        path_straight(origin(), port(10., 5., 1., 180.)).unwrap_err(),
        path_straight(origin(), port(-10., 0., 1., 180.)).unwrap_err(),
        path_l(origin(), port(10., 5., 1., 180.)).unwrap_err(),
        path_u(origin(), port(10., 5., 1., 90.), 5).unwrap_err(),
        path_u(origin(), port(10., 5., 1., 0.), f64::INFINITY).unwrap_err(),
        path_j(origin(), port(10., 5., 1., 0.), 5, 5).unwrap_err(),
        path_v(origin(), port(10., 5., 1., 180.)).unwrap_err(),
        path_z(origin(), port(f64::NAN, 5., 1., 180.), 5, 5).unwrap_err(),
        path_manhattan(origin(), port(10., 5., 1., 45.), 5).unwrap_err(),
        path_manhattan(origin(), port(10., 5., 1., 90.), 0).unwrap_err(),
        path_xy((0, 0), (12, 8), "x").unwrap_err(),
        path_xy((0, 0), (12, 8), "xz").unwrap_err(),
        path_xy((1, 1), (1, 1), "xy").unwrap_err(),
    ];
    expect![[r#"
        path_straight: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 180°: port2 must lie straight ahead, but is 5 µm to the side
        path_straight: no route from port1 "in" at (0, 0) facing 0° to port2 at (-10, 0) facing 180°: the distance of port2 ahead of port1 is -10 µm, but must be at least 0.001 µm: 10.001 µm are missing
        path_L: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 180°: the ports are turned by 180° against each other, but must be turned by 90° or 270°
        path_U: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 90°: the ports are turned by 90° against each other, but must be turned by 0° or 180°
        path_U: length1 is inf µm, but it must be finite
        path_J: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 0°: the ports are turned by 0° against each other, but must be turned by 90° or 270°
        path_V: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 180°: the ports are parallel, so their axes do not meet
        path_Z: port2 is port "" at (NaN, 5), 1 µm wide, facing 180°, but it must have a finite midpoint and orientation, and a width of at least 0 µm
        path_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 5) facing 45°: the ports are turned by 45° against each other, but must be turned by a multiple of 90°
        path_manhattan: radius is 0 µm, but it must be greater than 0 µm and finite
        path_xy: directions is "x", but it must contain 'y', since the ports are 8 µm apart in y
        path_xy: directions is "xz", but it must have only x and y, not 'z'
        path_xy: both ports are at (1, 1), so there is nothing to draw
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_smooth_and_sharp_routes() {
    let smooth = |x: f64, y: f64, orientation: f64| RouteSmoothParams::new(origin(), port(x, y, 1., orientation));
    let sharp = |x: f64, y: f64, orientation: f64| RouteSharpParams::new(origin(), port(x, y, 1., orientation));
    let sections = CrossSection::of_width(1, 2);
    let wavy = CrossSection::from(Section::new(|t: f64| 1.0 + t));
    let points = |list: &[(f64, f64)]| list.iter().copied().map(Into::into).collect::<Vec<_>>();
    let manual = |list: &[(f64, f64)]| sharp(50., 50., 270.).path_type(PathType::Manual).manual_path(points(list));
    let arc = SmoothOptions::arc();
    let errors = [
        sharp(-10., -5., 270.).path_type(PathType::L).build().unwrap_err(),
        sharp(50., 5., 180.).path_type(PathType::U).length1(60).build().unwrap_err(),
        sharp(50., 50., 270.).length1(60).build().unwrap_err(),
        sharp(50., 50., 270.).path_type(PathType::Manual).build().unwrap_err(),
        manual(&[(0., 0.)]).build().unwrap_err(),
        manual(&[(0., 0.), (50., 1.), (50., 50.)]).build().unwrap_err(),
        manual(&[(0., 0.), (50., 0.), (50., 49.)]).build().unwrap_err(),
        sharp(0., 0., 180.).path_type(PathType::Manual).manual_path(points(&[(0., 0.), (0., 0.)])).build().unwrap_err(),
        RouteSharpParams::new(port(0., 0., 0., 0.), port(50., 50., 1., 270.)).build().unwrap_err(),
        sharp(50., 50., 270.).width(&sections).layer(3).build().unwrap_err(),
        sharp(50., 50., 270.).width(&wavy).build().unwrap_err(),
        sharp(5., 4., 270.).path_type(PathType::J).length1(15).length2(14).build().unwrap_err(),
        smooth(50., 50., 270.).path_type(PathType::U).build().unwrap_err(),
        smooth(50., 50., 180.).path_type(PathType::U).length1(3).build().unwrap_err(),
        smooth(50., 50., 270.).width(12).smooth_options(arc).build().unwrap_err(),
        smooth(50., 50., 270.)
            .smooth_options(SmoothOptions::Euler { p: 1.0, use_eff: false, num_pts: 720.0 })
            .build()
            .unwrap_err(),
        RouteXyParams::new(origin(), port(50., 50., 1., 270.)).directions("abc").build().unwrap_err(),
        RouteXyParams::new(origin(), port(5., 5., 1., 270.)).directions("xy").width(12).build().unwrap_err(),
        RouteBasicParams::new(origin(), port(50., 5., 1., 170.)).build().unwrap_err(),
        RouteBasicParams::new(origin(), port(-50., 5., 1., 180.)).build().unwrap_err(),
        RouteBasicParams::new(origin(), port(50., 5., 1., 180.)).num_path_pts(1).build().unwrap_err(),
        route_custom(origin(), port(50., 50., 1., 270.), [(0, 0)], 5, ArcBend::new(), &wavy).unwrap_err(),
        route_custom(origin(), port(50., 50., 1., 270.), [(0, 0), (0, 50), (50, 50)], 5, ArcBend::new(), &wavy)
            .unwrap_err(),
    ];
    expect![[r#"
        route_sharp: no route from port1 "in" at (0, 0) facing 0° to port2 at (-10, -5) facing 270°: the first leg must leave port1 along its orientation, but leads 10 µm backwards
        route_sharp: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 5) facing 180°: the last leg must enter port2 against its orientation, but leads 10 µm backwards
        route_sharp: length1 is given, but it must be left out, since path_type Manhattan does not use it
        route_sharp: manual_path is left out, but it must be given for path_type manual
        route_sharp: manual_path needs at least 2 points, but has 1
        route_sharp: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 270°: the first leg must leave port1 along its orientation, but deviates by 1 µm from the axis
        route_sharp: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 270°: the waypoints must start and end at the ports, but miss one by 1 µm
        route_sharp: no route from port1 "in" at (0, 0) facing 0° to port2 at (0, 0) facing 180°: the ports are at one position, so there is nothing to draw
        route_sharp: port1.width is 0 µm, but it must be greater than 0 µm, unless `width` is given
        route_sharp: layer is 3/0, but it must be left out with a cross-section, whose sections have layers of their own
        route_sharp: the cross-section has functions or lists, which cannot be compared as parameters; `route_custom` draws it
        in route_sharp: in the route from port1 "in" at (0, 0) facing 0° to port2 at (5, 4) facing 270°: extrude: section 0 crosses itself: the path passes twice through one position, at 5 µm and at 45 µm along it
        route_smooth: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 270°: the ports are turned by 270° against each other, but must be turned by 0° or 180°
        in route_smooth: in the route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 180°: smooth: the leg from (0, 0) to (3, 0) is 3 µm long, but its bends need 5 µm
        in route_smooth: in the route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 270°: extrude: section 0 overlaps itself on the left from 45.043877 µm to 52.81008 µm along the path: its edge lies 6 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 6 µm, or a width of at most 9.999 µm would do
        route_smooth: smooth_options is an Euler bend by its smallest radius, but it must have use_eff on a Manhattan route, whose legs have room for the effective radius only
        route_xy: directions is "abc", but it must have only x and y, not 'a'
        in route_xy: in the route from port1 "in" at (0, 0) facing 0° to port2 at (5, 5) facing 270°: extrude: section 0 overlaps itself on the left from 0 µm to 10 µm along the path: its edge lies 6 µm from the path, which bends too tightly there; a bend radius, or a leg between corners, of at least 6 µm, or a width of at most 10 µm would do
        route_basic: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 5) facing 170°: the ports must face each other, but are turned by 170° instead of 180°
        route_basic: no route from port1 "in" at (0, 0) facing 0° to port2 at (-50, 5) facing 180°: the distance of port2 ahead of port1 is -50 µm, but must be at least 0 µm: 50 µm are missing
        route_basic: num_path_pts is 1, but it must be at least 2
        route_custom: at least 2 waypoints are needed, not 1
        route_custom: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 270°: the first leg must leave port1 along its orientation, but leads sideways
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_manhattan_routes() {
    let to =
        |x: f64, y: f64, orientation: f64| RouteManhattanParams::new(origin(), port(x, y, 1., orientation)).radius(5);
    let four = |gap: f64| [origin(), port(90., 50., 1., 180.), port(0., -gap, 1., 0.), port(90., 50. - gap, 1., 180.)];
    let wavy = CrossSection::from(Section::new(|t: f64| 1.0 + t));
    let errors = [
        to(50., 5., 180.).build().unwrap_err(),
        to(8., 50., 180.).build().unwrap_err(),
        to(50., 3., 270.).build().unwrap_err(),
        to(20., 4., 0.).build().unwrap_err(),
        to(10., 0., 90.).build().unwrap_err(),
        to(1., 1., 270.).allow_detour(true).build().unwrap_err(),
        to(50., 50., 45.).build().unwrap_err(),
        RouteManhattanParams::new(origin(), port(80., 60., 5., 180.)).build().unwrap_err(),
        to(80., 60., 180.).width(11).build().unwrap_err(),
        to(80., 60., 180.).width(&wavy).build().unwrap_err(),
        RouteManhattanAutoParams::new([origin()]).build().unwrap_err(),
        RouteManhattanAutoParams::new(four(0.5)).radius(5).build().unwrap_err(),
        RouteBend::Gradual.bend(5.0, 20.0).unwrap_err(),
    ];
    expect![[r#"
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 5) facing 180°: two bends need 10.2 µm to the side, but port2 lies 5 µm to the side; `allow_detour` draws a route of 4 bends that reaches 10.2 µm beyond its ports
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (8, 50) facing 180°: two bends need 10.2 µm ahead, but port2 lies 8 µm ahead; `allow_detour` draws a route of 4 bends that reaches 5.1 µm beyond its ports
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 3) facing 270°: a bend needs 5.1 µm ahead and to the side, but port2 lies 50 µm ahead and 3 µm to the side; `allow_detour` draws a route of 3 bends that reaches 10.2 µm beyond its ports
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (20, 4) facing 0°: a turn back needs 10.2 µm to the side, but port2 lies 4 µm to the side; `allow_detour` draws a route of 4 bends that reaches 10.2 µm beyond its ports
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (10, 0) facing 90°: the route with the fewest corners runs over itself or over a port; `allow_detour` draws a route of 5 bends that reaches 10.2 µm beyond its ports
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (1, 1) facing 270°: there is no room: the wire would run over itself; `allow_crossings` draws it all the same
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (50, 50) facing 45°: the ports are turned by 45° against each other, but must be turned by a multiple of 90°
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (80, 60) facing 180°: port1 is 1 µm wide and port2 5 µm; give a `width`, or a pair of widths for a taper
        route_manhattan: no route from port1 "in" at (0, 0) facing 0° to port2 at (80, 60) facing 180°: the radius is 5 µm, but must be at least 5.5 µm: 0.5 µm are missing
        route_manhattan: the cross-section has functions or lists, which cannot be compared as parameters; `route_custom` draws it
        route_manhattan_auto: ports are joined in pairs, but 1 port is given
        route_manhattan_auto: no route from port1 at (0, -0.5) facing 0° to port2 at (90, 49.5) facing 180°: it overlaps the route from a port "in" at (0, 0) facing 0° to a port at (90, 50) facing 180° by 1 µm
        gradual bend: angle is 20°, but it must be more than 30°, the turn of its two ends
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_serpentines() {
    let line = |length: f64| RouteSerpentineParams::new(origin(), port(100., 0., 1., 180.), length).radius(5);
    let errors = [
        line(90.).build().unwrap_err(),
        line(100.5).bend(RouteBend::Gradual).build().unwrap_err(),
        line(1000.).max_height(20).build().unwrap_err(),
        line(1000.).radius(0.3).build().unwrap_err(),
        delay_line(200, 30, 1, RouteBend::Circular, 10, 0).unwrap_err(),
        delay_line(1000, 200, 1e-9, RouteBend::Gradual, 1e-9, 0).unwrap_err(),
        RouteSerpentineParams::new(origin(), port(100., 0., 2., 180.), 300).build().unwrap_err(),
    ];
    expect![[r#"
        route_serpentine: no route from port1 "in" at (0, 0) facing 0° to port2 at (100, 0) facing 180°: the length is 90 µm, but must be at least 100 µm: 10 µm are missing
        route_serpentine: no route from port1 "in" at (0, 0) facing 0° to port2 at (100, 0) facing 180°: the length, which is more than that of the direct route, is 100.5 µm, but must be at least 102.25317 µm: 1.75317 µm are missing
        route_serpentine: no route from port1 "in" at (0, 0) facing 0° to port2 at (100, 0) facing 180°: `max_height` is 20 µm, but must be at least 94.292087 µm: 74.292087 µm are missing
        route_serpentine: no route from port1 "in" at (0, 0) facing 0° to port2 at (100, 0) facing 180°: the radius is 0.3 µm, but must be at least 0.5 µm: 0.2 µm are missing
        delay_line: no route from port1 at (0, 0) facing 0° to port2 at (30, 0) facing 180°: the longest straight piece is 30 µm, but must be at least 40 µm: 10 µm are missing
        delay_line: no route from port1 at (0, 0) facing 0° to port2 at (200, 0) facing 180°: bumps for a length of 1000 µm would run over the route on both sides
        route_serpentine: no route from port1 "in" at (0, 0) facing 0° to port2 at (100, 0) facing 180°: port1 is 1 µm wide and port2 2 µm; give a `width`, or a pair of widths for a taper
    "#]].assert_eq(&listed(errors));
}

#[test]
fn messages_of_parameters_by_name() {
    let errors = [r#"{"corner_fun": "spline"}"#, r#"{"corner_fun": "arc", "p": 1}"#, r#""arc""#]
        .map(|options| parameters("smooth_options", options));
    let widths = [
        r#""wide""#,
        "[1, 2, 3]",
        r#"{"sections": [{"offset": 1}]}"#,
        r#"{"sections": [{"width": 1, "depth": 2}]}"#,
        r#"{"sections": [{"width": {"cosine": [1, 2]}}]}"#,
    ]
    .map(|width| parameters("width", width));
    expect![[r#"
        route_smooth: smooth_options.corner_fun is "spline", but it must be arc or euler
        route_smooth: smooth_options is {corner_fun: "arc", p: 1}, but it must have only known keys, not "p"; known are corner_fun, num_pts
        route_smooth: smooth_options is "arc", but it must be {"corner_fun": "arc" or "euler", …}
        route_smooth: width is "wide", but it must be a number, a pair of numbers, or {"sections": […]}
        route_smooth: width is [1, 2, 3], but it must be a number, a pair of numbers, or {"sections": […]}
        route_smooth: width.sections[0] is {offset: 1}, but it must have a width
        route_smooth: width.sections[0] is {depth: 2, width: 1}, but it must be a section, without "depth"
        route_smooth: width.sections[0].width is {cosine: [1, 2]}, but it must be a number, a pair of numbers, or {"sine": [from, to]}
    "#]].assert_eq(&listed(errors.into_iter().chain(widths)));
}

/// The error of a smooth route with a parameter from JSON.
fn parameters(name: &str, json: &str) -> Error {
    let case = serde_json::json!({ "id": "", "fn": "route_smooth", "params": {
        "port1": { "midpoint": [0, 0], "width": 1, "orientation": 0 },
        "port2": { "midpoint": [50, 50], "width": 1, "orientation": 270 },
        name: serde_json::from_str::<serde_json::Value>(json).unwrap(),
    }, "expect": {} });
    let case: testkit::golden::Case = serde_json::from_value(case).unwrap();
    registry::find("route_smooth").unwrap().build(&case.values()).unwrap_err()
}
