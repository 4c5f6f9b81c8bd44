//! Reference results of paths. What may differ is in testkit's table of differences; everything else must match.

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Overlaps, Path, Section, Spiral};
use serde_json::Value as Json;
use sha1::{Digest as _, Sha1};
use testkit::golden::{Case, Difference, Instead, Kind, Refusal, assert_refused, compare_device, differences, load};

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

/// The deliberate difference of a function with this condition, if it applies to a case.
fn applies(case: &Case, function: &str, condition: &str) -> Option<&'static Difference> {
    let listed = differences().into_iter().find(|d| d.is_about(function) && d.condition.contains(condition));
    let difference = listed.unwrap_or_else(|| panic!("the table of differences has no {function} with {condition}"));
    (difference.applies)(case).then_some(difference)
}

/// An exception whose condition needs our own drawing may be made only if it is in the table.
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
    if applies(case, "path.euler", "use_eff beyond 190").is_some() {
        return assert_refused(case, Refusal::Geometry, &built);
    }
    let poorly_sampled = applies(case, "path.arc", "fewer than 2 points").is_some()
        || applies(case, "path.euler", "fewer than 3 points").is_some();
    let drawn = built.and_then(|path| Ok((draw(case, &path)?, path)));
    if let (Some(class), false) = (case.refusal(), poorly_sampled) {
        return assert_refused(case, class, &drawn);
    }
    if let Some(error) = case.expect["error"].as_str() {
        let refused = drawn.is_err() || poorly_sampled;
        return if refused { Ok(()) } else { Err(format!("drawn, where the reference has {error}")) };
    }
    if applies(case, "path.spiral", "fewer than 2 points").is_some() {
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
        return Ok(());
    }
    if let Some(Instead::PointsTo(error)) = applies(case, "path.euler", "more than 180").map(|d| d.compare) {
        return check_points(path.points(), &case.expect["points"], error(case));
    }
    if applies(case, "path.smooth", "last bit of an angle").is_some()
        && path.points().len() != points(&case.expect["points"]).len()
    {
        return check_length(&path, &case.expect, 1e-4 * path.length());
    }
    check_path(case, &path)?;
    let Some(device) = device else { return Ok(()) };
    let expected = &case.expect["device"];
    let ties = applies(case, "path.extrude", "equally far").and(part(case, "extrude")["simplify"].as_f64());
    match (compare_device(&device, expected), ties) {
        (Err(_), Some(tolerance)) => check_simplified(case, &path, tolerance),
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
    if ours != theirs && applies(case, "path.hash_geometry", "arctangent").is_some() {
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
