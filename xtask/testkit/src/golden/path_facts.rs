//! Facts about cases of paths: what the reference cannot sample, and where it computes with noise.

use std::f64::consts::PI;

use phidl_core::geom::Point;
use serde_json::{Value as Json, json};

use super::Case;

/// Whether an arc or an Euler bend of this name has too few points for its ends.
pub(super) fn is_poorly_sampled(case: &Case, name: &str) -> bool {
    list(case, "segments").iter().chain(&bends(case)).any(|segment| segment["fn"] == name && has_few_points(segment))
}

/// Whether a spiral has too few points in its center.
pub(super) fn has_spiral_without_center(case: &Case) -> bool {
    list(case, "segments").iter().any(is_spiral_without_center)
}

/// How far an Euler bend of the reference is off at the most (µm), if one is.
pub(super) fn cut_off_error(case: &Case) -> Option<f64> {
    list(case, "segments").iter().filter_map(error_of_segment).reduce(f64::max)
}

/// Whether an Euler bend by effective radius turns too far for one.
pub(super) fn has_bend_beyond_a_half_turn(case: &Case) -> bool {
    list(case, "segments").iter().any(is_effective_beyond_a_half_turn)
}

/// Whether the number of points of a bend of a smoothed path depends on the last bit of an angle.
pub(super) fn has_uncertain_count(case: &Case) -> bool {
    bends(case).iter().any(count_hangs_on_the_last_bit)
}

/// Whether the extrusion is simplified.
pub(super) fn is_simplified(case: &Case) -> bool {
    case.rest.get("extrude").is_some_and(|extrude| extrude["simplify"].is_number())
}

fn list<'a>(case: &'a Case, key: &str) -> &'a [Json] {
    case.rest.get(key).and_then(Json::as_array).map_or(&[], Vec::as_slice)
}

fn number_or(json: &Json, default: f64) -> f64 {
    json.as_f64().unwrap_or(default)
}

fn points(json: &Json) -> Vec<Point> {
    let point = |json: &Json| Point::new(number_or(&json[0], f64::NAN), number_or(&json[1], f64::NAN));
    json.as_array().into_iter().flatten().map(point).collect()
}

/// Points by `num_pts`, and the angle, of an arc or an Euler bend.
fn count(segment: &Json) -> Option<(f64, &Json)> {
    let p = &segment["params"];
    let bend = matches!(segment["fn"].as_str(), Some("arc" | "euler"));
    bend.then(|| ((number_or(&p["num_pts"], 720.0) * number_or(&p["angle"], 90.0) / 360.0).abs().floor(), p))
}

/// Whether an arc or an Euler bend has too few points for its ends.
fn has_few_points(segment: &Json) -> bool {
    let Some((n, p)) = count(segment) else { return false };
    let share = number_or(&p["p"], 1.0);
    if segment["fn"] == "arc" || share == 0.0 {
        return n < 2.0;
    }
    let on_clothoid = (n * 2.0 * share / (1.0 + share)).round();
    n < 3.0 || on_clothoid < 2.0 || (share < 1.0 && n - on_clothoid < 2.0)
}

/// The bends at the corners of a smoothed path, as segments.
fn bends(case: &Case) -> Vec<Json> {
    let Some(smooth) = case.rest.get("smooth") else { return Vec::new() };
    let line = points(&smooth["points"]);
    let directions: Vec<f64> = line.windows(2).map(|leg| (leg[1] - leg[0]).direction()).collect();
    let bend = |pair: &[f64]| {
        let mut params = smooth.clone();
        params["angle"] = phidl_core::num::angle::between(pair[0], pair[1]).into();
        json!({ "fn": smooth["corner_fun"].as_str().unwrap_or("euler"), "params": params })
    };
    directions.windows(2).map(bend).collect()
}

/// Whether the arcs in the middle of a spiral get fewer than two points (docs/reference/paths.md, spiral).
fn is_spiral_without_center(segment: &Json) -> bool {
    let p = &segment["params"];
    let (gap, inner) = (number_or(&p["gap"], 1.0), number_or(&p["inner_gap"], 2.0));
    let turns = number_or(&p["num_turns"], 5.0);
    let (a, b) = ((inner - gap) / 2.0, gap / PI);
    let arm = |end: f64| ((a + end * b).powi(2) + b * b).powf(1.5) / (3.0 * (a * b + end * b * b));
    let (whole, part) = (turns.floor(), turns - turns.floor());
    let other = whole - 1.0 + 2.0 * part;
    let ends = if part < 0.5 { [other, whole] } else { [whole, other.max(whole)] };
    let radius = inner * (1.0 + (b / (a + b * PI / 2.0)).powi(2)).sqrt() / 4.0;
    let center = radius * 2.0 * (inner / (4.0 * radius)).asin();
    let degrees = 2.0 * (inner / (4.0 * radius)).asin() * (180.0 / PI);
    let whole_spiral: f64 = ends.iter().map(|half_turns| arm(PI * half_turns + PI / 2.0)).sum::<f64>() + 2.0 * center;
    let share = (number_or(&p["num_pts"], 10_000.0) / whole_spiral * center).floor();
    // Converting the share to a number of points for the full turn, and to the share again, may lose one.
    segment["fn"] == "spiral" && share.min((360.0 * share / degrees * degrees / 360.0).floor()) < 2.0
}

/// How far the end of an Euler bend is off in the reference, at most (µm), if it is.
fn error_of_segment(segment: &Json) -> Option<f64> {
    let p = &segment["params"];
    let turn = number_or(&p["p"], 1.0) * number_or(&p["angle"], 90.0).abs();
    let part_of_radius = if turn <= 360.0 { 1e-6 } else { 0.1 };
    (segment["fn"] == "euler" && turn > 180.0).then(|| 1e-6 + part_of_radius * number_or(&p["radius"], 3.0))
}

fn is_effective_beyond_a_half_turn(segment: &Json) -> bool {
    let p = &segment["params"];
    let own_radius = number_or(&p["p"], 1.0) == 0.0;
    segment["fn"] == "euler" && p["use_eff"] == true && !own_radius && number_or(&p["angle"], 90.0).abs() > 190.0
}

/// Whether the number of points of a bend is truncated from one that is whole but for noise.
fn count_hangs_on_the_last_bit(bend: &Json) -> bool {
    let p = &bend["params"];
    let count = number_or(&p["num_pts"], 720.0) * number_or(&p["angle"], f64::NAN) / 360.0;
    (count - count.round()).abs() < 1e-9
}

/// Whether the direction of an end comes from an arctangent.
pub(super) fn has_arctangents(case: &Case) -> bool {
    case.rest.contains_key("smooth")
        || list(case, "segments").iter().any(|segment| segment["fn"].is_null() || segment["fn"] == "spiral")
        || list(case, "ops").iter().any(|op| op["op"] == "mirror")
}
