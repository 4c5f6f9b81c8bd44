//! Reference results of paths. What may differ is in testkit's table of differences; everything else must match.

use std::f64::consts::PI;

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Overlaps, Path, Section, Spiral};
use serde_json::{Value as Json, json};
use sha1::{Digest as _, Sha1};
use testkit::golden::{Case, Kind, Refusal, assert_refused, compare_device, differences, load};

use crate::simplified;

/// Points agree to this (µm).
const TOLERANCE: f64 = 1e-6;

#[test]
fn every_reference_case_is_reproduced() {
    let cases = load(Kind::Path);
    let failures: Vec<String> =
        cases.iter().filter_map(|case| check(case).err().map(|failure| format!("{}: {failure}", case.id))).collect();
    assert!(failures.is_empty(), "{} of {} cases differ:\n{}", failures.len(), cases.len(), failures.join("\n"));
}

/// An exception may be made only if it stands in the list of deliberate differences.
fn must_be_listed(function: &str, condition: &str) {
    let listed = differences().iter().any(|d| d.is_about(function) && d.condition.contains(condition));
    assert!(listed, "the table of differences has no entry for {function} with {condition}");
}

fn part<'a>(case: &'a Case, key: &str) -> &'a Json {
    case.rest.get(key).unwrap_or(&Json::Null)
}

fn list<'a>(case: &'a Case, key: &str) -> &'a [Json] {
    part(case, key).as_array().map_or(&[], Vec::as_slice)
}

fn check(case: &Case) -> Result<(), String> {
    let built = build(case);
    let segments = list(case, "segments");
    if segments.iter().any(is_effective_beyond_a_half_turn) {
        must_be_listed("path.euler", "use_eff beyond 190");
        return assert_refused(case, Refusal::Geometry, &built);
    }
    let poorly_sampled = segments.iter().chain(&bends(case)).any(is_poorly_sampled);
    let drawn = built.and_then(|path| Ok((draw(case, &path)?, path)));
    if let (Some(class), false) = (case.refusal(), poorly_sampled) {
        return assert_refused(case, class, &drawn);
    }
    if let Some(error) = case.expect["error"].as_str() {
        let refused = drawn.is_err() || poorly_sampled;
        return if refused { Ok(()) } else { Err(format!("drawn, where the reference has {error}")) };
    }
    if segments.iter().any(is_spiral_without_center) {
        must_be_listed("path.spiral", "fewer than 2 points");
        return match &drawn {
            Ok((_, path)) => check_angles(path, &case.expect),
            Err(_) => assert_refused(case, Refusal::Geometry, &drawn),
        };
    }
    let (device, path) = drawn.map_err(|e| e.report())?;
    // The single point that the reference has instead of a bend turns what follows: a smoothed path ends elsewhere.
    if !(poorly_sampled && case.rest.contains_key("smooth")) {
        check_angles(&path, &case.expect)?;
    }
    if poorly_sampled {
        must_be_listed("path.arc", "fewer than 2 points");
        must_be_listed("path.euler", "fewer than 3 points");
        return Ok(());
    }
    if let Some(error) = segments.iter().filter_map(cut_off_error).reduce(f64::max) {
        must_be_listed("path.euler", "more than 180");
        return check_points(path.points(), &case.expect["points"], error);
    }
    if bends(case).iter().any(count_hangs_on_the_last_bit)
        && path.points().len() != points(&case.expect["points"]).len()
    {
        must_be_listed("path.smooth", "last bit of an angle");
        return check_length(&path, &case.expect, 1e-4 * path.length());
    }
    check_path(case, &path)?;
    let Some(device) = device else { return Ok(()) };
    let expected = &case.expect["device"];
    match (compare_device(&device, expected), part(case, "extrude")["simplify"].as_f64()) {
        (Err(_), Some(tolerance)) => {
            must_be_listed("path.extrude", "equally far");
            check_simplified(case, &path, tolerance)
        }
        (compared, _) => compared,
    }
}

/// Checks that the reference's points, and ours, are a result of the simplification of our edges.
fn check_simplified(case: &Case, path: &Path, tolerance: f64) -> Result<(), String> {
    let all = extrusion(case, path, None).map_err(|e| e.report())?;
    let few = extrusion(case, path, Some(tolerance)).map_err(|e| e.report())?;
    for (all, few) in all.polygons().zip(few.polygons()) {
        simplified::check(all.points, few.points, tolerance)?;
        let theirs = &case.expect["device"]["layers"][all.layer.to_string()]["points"];
        for theirs in theirs.as_array().into_iter().flatten() {
            simplified::check(all.points, &points(theirs), tolerance)?;
        }
    }
    Ok(())
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap_or_else(|| panic!("{json} is no number"))
}

fn number_or(json: &Json, default: f64) -> f64 {
    json.as_f64().unwrap_or(default)
}

fn point(json: &Json) -> Point {
    Point::new(number(&json[0]), number(&json[1]))
}

fn points(json: &Json) -> Vec<Point> {
    json.as_array().unwrap().iter().map(point).collect()
}

fn build(case: &Case) -> Result<Path> {
    let mut path = match case.rest.get("smooth") {
        Some(smooth) => smoothed(smooth)?,
        None => Path::of(list(case, "segments").iter().map(piece).collect::<Result<Vec<_>>>()?),
    };
    for op in list(case, "ops") {
        match op["op"].as_str().unwrap() {
            "rotate" => path.rotate_about(number(&op["angle"]), point(&op["center"])),
            "mirror" => path.mirror(point(&op["p1"]), point(&op["p2"])),
            "move" => path.move_by(point(&op["by"])),
            other => panic!("unknown op {other}"),
        };
    }
    Ok(path)
}

fn piece(segment: &Json) -> Result<Path> {
    let Some(name) = segment["fn"].as_str() else { return Path::from_points(points(&segment["points"])) };
    let p = &segment["params"];
    let num_pts = number_or(&p["num_pts"], 720.0);
    match name {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "counts of the reference are small"
        )]
        "straight" => Path::straight_of(number_or(&p["length"], 5.0), number_or(&p["num_pts"], 100.0) as usize),
        "arc" => ArcBend::new().num_pts(num_pts).path(number_or(&p["radius"], 10.0), number_or(&p["angle"], 90.0)),
        "euler" => euler(p).num_pts(num_pts).path(number_or(&p["radius"], 3.0), number_or(&p["angle"], 90.0)),
        "spiral" => {
            let d = Spiral::default();
            Spiral {
                num_turns: number_or(&p["num_turns"], d.num_turns),
                gap: number_or(&p["gap"], d.gap),
                inner_gap: number_or(&p["inner_gap"], d.inner_gap),
                num_pts: number_or(&p["num_pts"], d.num_pts),
            }
            .path()
        }
        other => panic!("unknown segment {other}"),
    }
}

fn euler(p: &Json) -> EulerBend {
    let bend = EulerBend::new().p(number_or(&p["p"], 1.0));
    if p["use_eff"] == true { bend.use_eff() } else { bend }
}

fn smoothed(smooth: &Json) -> Result<Path> {
    let (points, radius) = (points(&smooth["points"]), number_or(&smooth["radius"], 4.0));
    let num_pts = number_or(&smooth["num_pts"], 720.0);
    match smooth["corner_fun"].as_str() {
        Some("arc") => Path::smooth(points, radius, ArcBend::new().num_pts(num_pts)),
        Some("euler") | None => Path::smooth(points, radius, euler(smooth).num_pts(num_pts)),
        Some(other) => panic!("unknown corner_fun {other}"),
    }
}

fn layers(json: &Json) -> Layers {
    #[expect(clippy::cast_possible_truncation, reason = "layers of the reference fit 16 bits")]
    let number = |json: &Json| json.as_u64().unwrap() as u16;
    match json {
        Json::Null => Layers::from(0),
        Json::Array(pair) => Layers::from((number(&pair[0]), number(&pair[1]))),
        single => Layers::from(number(single)),
    }
}

fn draw(case: &Case, path: &Path) -> Result<Option<Device>> {
    match case.rest.get("extrude") {
        Some(extrude) => extrusion(case, path, extrude["simplify"].as_f64()).map(Some),
        None => Ok(None),
    }
}

fn extrusion(case: &Case, path: &Path, simplify: Option<f64>) -> Result<Device> {
    let extrude = part(case, "extrude");
    let cross_section = match extrude.get("sections") {
        Some(sections) => sections.as_array().unwrap().iter().map(section).fold(CrossSection::new(), CrossSection::add),
        None => match &extrude["width"] {
            Json::Array(ends) => {
                CrossSection::of_width((number(&ends[0]), number(&ends[1])), layers(&extrude["layer"]))
            }
            width => CrossSection::of_width(number(width), layers(&extrude["layer"])),
        },
    };
    let extrusion = Extrusion::new(path, &cross_section);
    let extrusion = simplify.map_or(extrusion, |tolerance| extrusion.simplify(tolerance));
    match extrusion.build() {
        Err(error) if error.to_string().contains("overlaps itself on the") => {
            must_be_listed("path.extrude", "bends too tightly");
            extrusion.overlaps(Overlaps::Keep).build()
        }
        drawn => drawn,
    }
}

fn section(json: &Json) -> Section {
    let mut section = Section::new(number(&json["width"])).offset(number_or(&json["offset"], 0.0));
    section.layers = layers(&json["layer"]);
    section.start_port = json["ports"][0].as_str().map(str::to_owned);
    section.end_port = json["ports"][1].as_str().map(str::to_owned);
    section.name = json["name"].as_str().map(str::to_owned);
    section
}

/// Points by `num_pts`, and the angle, of an arc or an Euler bend.
fn count(segment: &Json) -> Option<(f64, &Json)> {
    let p = &segment["params"];
    let bend = matches!(segment["fn"].as_str(), Some("arc" | "euler"));
    bend.then(|| ((number_or(&p["num_pts"], 720.0) * number_or(&p["angle"], 90.0) / 360.0).abs().floor(), p))
}

fn is_poorly_sampled(segment: &Json) -> bool {
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
    // The way back from the share to a number of points for the full turn, and to the share again, may lose one.
    segment["fn"] == "spiral" && share.min((360.0 * share / degrees * degrees / 360.0).floor()) < 2.0
}

/// How far the end of an Euler bend is off in the reference, at most (µm), if it is.
fn cut_off_error(segment: &Json) -> Option<f64> {
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

fn check_angles(path: &Path, expect: &Json) -> Result<(), String> {
    for (what, ours) in [("start_angle", path.start_angle()), ("end_angle", path.end_angle())] {
        let theirs = number(&expect[what]);
        if phidl_core::num::angle::between(ours, theirs) > 1e-9 {
            return Err(format!("{what} is {ours}, not {theirs}"));
        }
    }
    Ok(())
}

fn check_path(case: &Case, path: &Path) -> Result<(), String> {
    let expect = &case.expect;
    if expect.get("points").is_some() {
        check_points(path.points(), &expect["points"], TOLERANCE)?;
    }
    check_length(path, expect, TOLERANCE)?;
    let (ours, theirs) = (path.bbox().unwrap(), &expect["bbox"]);
    if ours.min.distance(point(&theirs[0])).max(ours.max.distance(point(&theirs[1]))) > TOLERANCE {
        return Err(format!("box is {ours}, not {theirs}"));
    }
    let (mut ours, theirs) = (path.hash_geometry(1e-4).unwrap(), expect["hash_geometry"].as_str().unwrap());
    if ours != theirs && has_arctangents(case) {
        must_be_listed("path.hash_geometry", "arctangent");
        ours = defined_hash(path.points(), number(&expect["start_angle"]), number(&expect["end_angle"]));
    }
    if ours == theirs { Ok(()) } else { Err(format!("hash is {ours}, not {theirs}")) }
}

fn check_length(path: &Path, expect: &Json, tolerance: f64) -> Result<(), String> {
    let length = number(&expect["length"]);
    match (path.length() - length).abs() <= tolerance {
        true => Ok(()),
        false => Err(format!("length is {}, not {length}", path.length())),
    }
}

/// Whether the number of points of a bend is cut off from what is whole but for noise.
fn count_hangs_on_the_last_bit(bend: &Json) -> bool {
    let p = &bend["params"];
    let count = number_or(&p["num_pts"], 720.0) * number(&p["angle"]) / 360.0;
    (count - count.round()).abs() < 1e-9
}

fn has_arctangents(case: &Case) -> bool {
    case.rest.contains_key("smooth")
        || list(case, "segments").iter().any(|segment| segment["fn"].is_null() || segment["fn"] == "spiral")
        || list(case, "ops").iter().any(|op| op["op"] == "mirror")
}

/// The hash as docs/reference/geometry-hash.md defines it, written down once more.
pub(crate) fn defined_hash(points: &[Point], start_angle: f64, end_angle: f64) -> String {
    let mut bytes = Vec::new();
    for p in points {
        for v in [p.x, p.y] {
            #[expect(clippy::cast_possible_truncation, reason = "cut off by definition")]
            bytes.extend(((v / 1e-4 + 0.170_486_14) as i64).to_le_bytes());
        }
    }
    bytes.extend(start_angle.to_le_bytes());
    bytes.extend(end_angle.to_le_bytes());
    Sha1::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn check_points(ours: &[Point], theirs: &Json, tolerance: f64) -> Result<(), String> {
    let theirs = points(theirs);
    if ours.len() != theirs.len() {
        return Err(format!("{} points, not {}", ours.len(), theirs.len()));
    }
    match ours.iter().zip(&theirs).position(|(p, q)| p.distance(*q) > tolerance) {
        None => Ok(()),
        Some(i) => Err(format!("point {i} is {}, not {}", ours[i], theirs[i])),
    }
}
