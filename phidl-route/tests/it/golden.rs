//! Reference results of routes and waypoints. What may differ is in testkit's table of differences; everything else must
//! match.

use phidl_core::num::angle;
use phidl_core::prelude::*;
use phidl_core::runtime::registry;
use phidl_path::Path;
use phidl_route as route;
use serde_json::Value as Json;
use testkit::golden::{Case, Kind, Refusal, assert_refused, compare_device, differences, load};

/// Points agree to this (µm), and lengths.
const TOLERANCE: f64 = 1e-6;

/// An Euler bend that turns by less (degrees) has fewer than three points of 720 in the reference.
const FEW_POINTS: f64 = 1.5;

/// Corners that turn by more (degrees) have a bevel instead of a long tip.
const BEVELED: f64 = 168.5;

#[test]
fn every_reference_case_is_reproduced() {
    let cases = load(Kind::Routing);
    let failures: Vec<String> =
        cases.iter().filter_map(|case| check(case).err().map(|failure| format!("{}: {failure}", case.id))).collect();
    assert!(failures.is_empty(), "{} of {} cases differ:\n{}", failures.len(), cases.len(), failures.join("\n"));
}

fn check(case: &Case) -> std::result::Result<(), String> {
    match case.function.strip_prefix("path_") {
        Some(kind) => check_way(case, kind),
        None => check_route(case),
    }
}

/// An exception may be made only if it stands in the list of deliberate differences.
fn must_be_listed(function: &str, condition: &str) {
    let listed = differences().iter().any(|d| d.is_about(function) && d.condition.contains(condition));
    assert!(listed, "the table of differences has no entry for {function} with {condition}");
}

/// Ours refuses, since the ports or the lengths do not go together.
fn refused<T>(case: &Case, drawn: &Result<T>) -> std::result::Result<(), String> {
    assert_refused(case, Refusal::Geometry, drawn)
}

fn check_way(case: &Case, kind: &str) -> std::result::Result<(), String> {
    let drawn = way(case, kind);
    if case.expect.get("error").is_some() {
        return refused(case, &drawn);
    }
    if kind == "V" && drawn.is_err() {
        must_be_listed("path_V", "parallel");
        return Ok(());
    }
    let ours = drawn.map_err(|error| error.report())?;
    let theirs = points(&case.expect["points"]);
    if kind == "manhattan" && crosses_itself(&theirs) {
        must_be_listed("path_manhattan", "crosses itself");
        return Ok(());
    }
    same(ours.points(), &theirs)
}

fn check_route(case: &Case) -> std::result::Result<(), String> {
    let drawn = registry::find(&case.function).and_then(|entry| entry.build(&case.values()));
    if case.expect.get("error").is_some() {
        return refused(case, &drawn);
    }
    if case.params.get("path_type").is_some_and(|kind| kind == "V") && way(case, "V").is_err() {
        must_be_listed("path_V", "parallel");
        return refused(case, &drawn);
    }
    if case.function == "route_basic" && !is_ahead(case) {
        must_be_listed("route_basic.direction", "not in front");
        return refused(case, &drawn);
    }
    if is_entered_from_behind(case) {
        must_be_listed("route.direction", "from behind");
        return refused(case, &drawn);
    }
    if case.function == "route_sharp" && sharpest_corner(case) > BEVELED {
        must_be_listed("route.folds", "more than 168.5 degrees");
        return refused(case, &drawn);
    }
    if drawn.is_err() && is_folded(&case.expect["layers"]) {
        must_be_listed("route.folds", "an edge folds back");
        return Ok(());
    }
    let drawn = drawn.map_err(|error| format!("ours refuses it: {}", error.report()))?;
    if centerline(&case.expect["layers"]).is_some_and(|line| crosses_itself(&line)) && is_manhattan(case) {
        must_be_listed("path_manhattan", "crosses itself");
        return check_ports(&drawn, &case.expect["ports"]);
    }
    if case.function == "route_smooth" && corners(case).iter().any(|turn| turn.abs() < FEW_POINTS) {
        must_be_listed("path.euler", "fewer than 3 points");
        return Ok(());
    }
    if case.function == "route_smooth" && corners(case).iter().any(count_hangs_on_the_last_bit) {
        return compare_device(&drawn, &case.expect).or_else(|_| {
            must_be_listed("path.smooth", "last bit of an angle");
            check_ports(&drawn, &case.expect["ports"])?;
            check_area(&drawn, &case.expect)
        });
    }
    match case.expect.get("points") {
        Some(outlines) => check_basic(&drawn, &case.expect, outlines),
        None => compare_device(&drawn, &case.expect),
    }
}

/// `route_basic` has a description of its own.
fn check_basic(drawn: &Device, expect: &Json, outlines: &Json) -> std::result::Result<(), String> {
    let drawn_outlines: Vec<_> = drawn.polygons().collect();
    if drawn_outlines.len() != 1 {
        return Err(format!("{} polygons instead of one", drawn_outlines.len()));
    }
    if number(&expect["polygons"]) == 1.0 {
        same(drawn_outlines[0].points, &points(&outlines[0]))?;
    }
    let area = drawn_outlines[0].area();
    if (area - number(&expect["area"])).abs() > TOLERANCE * area {
        return Err(format!("area is {area} µm², expected {}", expect["area"]));
    }
    // The reference integrates: its lengths are good to about 1e-3 (route-basic.md).
    let length = drawn.info()["length"].as_f64().unwrap_or_default();
    if (length - number(&expect["length"])).abs() > 1e-3 {
        return Err(format!("length is {length} µm, expected {}", expect["length"]));
    }
    check_ports(drawn, &expect["ports"])
}

fn check_ports(drawn: &Device, expected: &Json) -> std::result::Result<(), String> {
    for (name, expected) in expected.as_object().into_iter().flatten() {
        let port = drawn.port(name).map_err(|error| error.to_string())?;
        let near = port.midpoint().distance(point(&expected["midpoint"])) < TOLERANCE
            && (port.width() - number(&expected["width"])).abs() < TOLERANCE
            && angle::between(port.orientation(), number(&expected["orientation"])) < TOLERANCE;
        if !near {
            return Err(format!("{port}, expected {expected}"));
        }
    }
    Ok(())
}

fn way(case: &Case, kind: &str) -> Result<Path> {
    let (a, b) = (port(&case.params["port1"]), port(&case.params["port2"]));
    let length = |name: &str, default: f64| case.params.get(name).map_or(default, number);
    match kind {
        "straight" => route::path_straight(a, b),
        "L" => route::path_l(a, b),
        "U" => route::path_u(a, b, length("length1", 200.0)),
        "J" => route::path_j(a, b, length("length1", 200.0), length("length2", 200.0)),
        "C" => route::path_c(a, b, length("length1", 100.0), length("left1", 100.0), length("length2", 100.0)),
        "V" => route::path_v(a, b),
        "Z" => route::path_z(a, b, length("length1", 100.0), length("length2", 100.0)),
        "xy" => route::path_xy(a, b, case.params.get("directions").and_then(Json::as_str).unwrap_or("xxyx")),
        "manhattan" => route::path_manhattan(a, b, length("radius", 5.0)),
        other => panic!("unknown waypoints path_{other}"),
    }
}

fn is_ahead(case: &Case) -> bool {
    let (a, b) = (port(&case.params["port1"]), port(&case.params["port2"]));
    (b.midpoint() - a.midpoint()).dot(a.normal()) > 0.0
}

fn is_manhattan(case: &Case) -> bool {
    case.params.get("path_type").is_none_or(|kind| kind == "manhattan") && case.function != "route_xy"
}

/// The middle of the first outline: its points go forwards on one side and back on the other.
fn centerline(layers: &Json) -> Option<Vec<Point>> {
    let outline = points(layers.as_object()?.values().next()?.get("points")?.get(0)?);
    let (right, left) = outline.split_at(outline.len() / 2);
    Some(right.iter().zip(left.iter().rev()).map(|(p, q)| (*p + *q) / 2.0).collect())
}

/// Whether an edge of the first outline runs against its middle.
fn is_folded(layers: &Json) -> bool {
    let outlines = layers.as_object().and_then(|layers| layers.values().next()).and_then(|layer| layer.get("points"));
    let (Some(outline), Some(middle)) = (outlines.and_then(|outlines| outlines.get(0)), centerline(layers)) else {
        return false;
    };
    let outline = points(outline);
    let (right, left) = outline.split_at(outline.len() / 2);
    let left: Vec<Point> = left.iter().rev().copied().collect();
    let runs_back = |edge: &[Point]| {
        let steps = edge.windows(2).zip(middle.windows(2));
        steps.into_iter().any(|(edge, along)| (edge[1] - edge[0]).dot(along[1] - along[0]) < 0.0)
    };
    runs_back(right) || runs_back(&left)
}

/// By how much the way of a route turns at its corners (degrees).
fn corners(case: &Case) -> Vec<f64> {
    let kind = case.params.get("path_type").and_then(Json::as_str).unwrap_or("manhattan");
    let Ok(way) = way(case, kind) else { return Vec::new() };
    let legs = way.points().windows(2).map(|leg| leg[1] - leg[0]).filter(|leg| leg.norm() > 1e-9);
    let directions: Vec<f64> = legs.map(Point::direction).collect();
    let turns = directions.windows(2).map(|pair| angle::between(pair[0], pair[1]));
    turns.filter(|turn| turn.abs() > 1e-6).collect()
}

/// By how much the way of a sharp route turns at the most (degrees).
fn sharpest_corner(case: &Case) -> f64 {
    corners(case).into_iter().fold(0.0, f64::max)
}

/// Whether the number of points of a bend, two for a degree, is cut off from what is whole but for noise.
fn count_hangs_on_the_last_bit(turn: &f64) -> bool {
    (2.0 * turn - (2.0 * turn).round()).abs() < 1e-9
}

/// A point more or less on a bend changes the area of a wire by a thousandth of that of the bend at the most.
fn check_area(drawn: &Device, expect: &Json) -> std::result::Result<(), String> {
    let expected: f64 =
        expect["layers"].as_object().into_iter().flatten().map(|(_, layer)| number(&layer["area"])).sum();
    match (drawn.area() - expected).abs() <= 1e-3 * expected {
        true => Ok(()),
        false => Err(format!("area is {} µm², expected {expected}", drawn.area())),
    }
}

/// Whether the reference's route leaves or enters a port from behind: where its own ports look along those that they
/// should face. (For widths that are given, the reference states the ports' directions and not the route's.)
fn is_entered_from_behind(case: &Case) -> bool {
    if case.function == "route_xy" || case.function == "route_quad" || case.function == "route_basic" {
        return false;
    }
    let kind = case.params.get("path_type").and_then(Json::as_str).unwrap_or("manhattan");
    if kind == "manhattan" || kind == "manual" {
        return false;
    }
    let Ok(way) = way(case, kind) else { return false };
    let (a, b) = (port(&case.params["port1"]), port(&case.params["port2"]));
    let turned = |way: f64, port: f64| angle::between(way, port) > 90.0;
    turned(way.start_angle(), a.orientation()) || turned(way.end_angle(), b.orientation() + 180.0)
}

/// Whether two legs of an axis-parallel line have an inner point of both in common.
fn crosses_itself(points: &[Point]) -> bool {
    let legs: Vec<(Point, Point)> = points.windows(2).map(|leg| (leg[0], leg[1])).collect();
    let side = |a: Point, b: Point, p: Point| (b - a).cross(p - a);
    let cross = |(a, b): (Point, Point), (c, d): (Point, Point)| {
        side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
    };
    legs.iter().enumerate().any(|(i, leg)| legs.iter().skip(i + 2).any(|other| cross(*leg, *other)))
}

fn same(ours: &[Point], theirs: &[Point]) -> std::result::Result<(), String> {
    if ours.len() != theirs.len() {
        return Err(format!("{} points, expected {}", ours.len(), theirs.len()));
    }
    match ours.iter().zip(theirs).find(|(p, q)| p.distance(**q) > TOLERANCE) {
        None => Ok(()),
        Some((p, q)) => Err(format!("{p}, expected {q}")),
    }
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap_or_else(|| panic!("{json} is no number"))
}

fn point(json: &Json) -> Point {
    Point::new(number(&json[0]), number(&json[1]))
}

fn points(json: &Json) -> Vec<Point> {
    json.as_array().expect("a list of points").iter().map(point).collect()
}

fn port(json: &Json) -> Port {
    Port::new(point(&json["midpoint"]), number(&json["width"]), number(&json["orientation"]))
}
