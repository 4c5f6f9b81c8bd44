//! Reference results: every path case of every JSON file in the folder that `PHIDL_GOLDEN` names, or in the project's
//! own copy. What may differ stands in `differences.toml`; everything else must match.

use std::path::{Path as FilePath, PathBuf};

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Path, Section, Spiral};
use serde_json::Value as Json;
use sha1::{Digest as _, Sha1};

use crate::simplified;

const OWN_COPY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../xtask/testkit/golden");
/// Points agree to this (µm).
const TOLERANCE: f64 = 1e-6;

#[test]
fn every_reference_case_is_reproduced() {
    let differences = Differences::load();
    let (mut cases, mut failures) = (0, Vec::new());
    for case in golden_cases() {
        cases += 1;
        if let Err(failure) = check(&case, &differences) {
            failures.push(format!("{}: {failure}", case["id"]));
        }
    }
    assert!(cases > 0, "no path cases were found");
    assert!(failures.is_empty(), "{} of {cases} cases differ:\n{}", failures.len(), failures.join("\n"));
}

fn golden_cases() -> Vec<Json> {
    let folder = std::env::var_os("PHIDL_GOLDEN").map_or_else(|| PathBuf::from(OWN_COPY), PathBuf::from);
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .filter(|file| file.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    files.iter().flat_map(|file| path_cases(file)).collect()
}

fn path_cases(file: &FilePath) -> Vec<Json> {
    let text = std::fs::read_to_string(file).unwrap();
    let Ok(Json::Array(cases)) = serde_json::from_str(&text) else { return Vec::new() };
    cases.into_iter().filter(|case| case.get("segments").or(case.get("smooth")).is_some()).collect()
}

/// The list of deliberate differences. A test may only make an exception that stands in it.
struct Differences(Vec<(String, String)>);

impl Differences {
    fn load() -> Self {
        let text = std::fs::read_to_string(FilePath::new(OWN_COPY).join("differences.toml")).unwrap();
        let table: toml::Table = text.parse().unwrap();
        let text = |entry: &toml::Value, key: &str| entry[key].as_str().unwrap().to_owned();
        let entries = table["difference"].as_array().unwrap();
        Self(entries.iter().map(|entry| (text(entry, "function"), text(entry, "condition"))).collect())
    }

    fn must_hold(&self, function: &str, condition: &str) {
        let listed = self.0.iter().any(|(f, c)| f == function && c.contains(condition));
        assert!(listed, "differences.toml knows nothing of {function} with {condition}");
    }
}

fn check(case: &Json, differences: &Differences) -> Result<(), String> {
    let expect = &case["expect"];
    let built = build(case);
    if case["segments"].as_array().is_some_and(|s| s.iter().any(is_effective_beyond_a_half_turn)) {
        differences.must_hold("euler", "use_eff beyond 190");
        return if built.is_err() { Ok(()) } else { Err("use_eff beyond 190° was drawn".to_owned()) };
    }
    let drawn = built.and_then(|path| Ok((draw(case, &path)?, path)));
    if let Some(error) = expect["error"].as_str() {
        return if drawn.is_err() { Ok(()) } else { Err(format!("drawn, where the reference has {error}")) };
    }
    let (device, path) = drawn.map_err(|e| e.in_full())?;
    check_angles(&path, expect)?;
    let segments = case["segments"].as_array().cloned().unwrap_or_default();
    if segments.iter().any(is_poorly_sampled) {
        differences.must_hold("arc", "fewer than 2 points");
        differences.must_hold("euler", "fewer than 3 points");
        return Ok(());
    }
    if let Some(radius) = segments.iter().filter_map(cut_off_radius).reduce(f64::max) {
        differences.must_hold("euler", "more than 240");
        return check_points("points", path.points(), &expect["points"], 1e-3 * radius);
    }
    check_path(case, &path, differences)?;
    let Some(device) = device else { return Ok(()) };
    let Some(tolerance) = case["extrude"]["simplify"].as_f64() else { return check_device(&device, &expect["device"]) };
    match check_device(&device, &expect["device"]) {
        Ok(()) => Ok(()),
        Err(_) => {
            differences.must_hold("extrude", "equally far");
            check_simplified(case, &path, tolerance)
        }
    }
}

/// Checks that the reference's points, and ours, are a result of the simplification of our edges.
fn check_simplified(case: &Json, path: &Path, tolerance: f64) -> Result<(), String> {
    let all = extrusion(case, path, None).map_err(|e| e.in_full())?;
    let few = extrusion(case, path, Some(tolerance)).map_err(|e| e.in_full())?;
    for (all, few) in all.polygons().zip(few.polygons()) {
        let name = all.layer.to_string();
        simplified::check(all.points, few.points, tolerance)?;
        for theirs in case["expect"]["device"]["layers"][&name]["points"].as_array().into_iter().flatten() {
            simplified::check(all.points, &points(theirs), tolerance)?;
        }
    }
    check_ports(&few, case["expect"]["device"]["ports"].as_object().unwrap())
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

fn build(case: &Json) -> Result<Path> {
    let mut path = match case.get("smooth") {
        Some(smooth) => smoothed(smooth)?,
        None => {
            let pieces = case["segments"].as_array().unwrap().iter().map(piece).collect::<Result<Vec<_>>>()?;
            Path::of(pieces)
        }
    };
    for op in case["ops"].as_array().into_iter().flatten() {
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

fn draw(case: &Json, path: &Path) -> Result<Option<Device>> {
    match case.get("extrude") {
        Some(extrude) => extrusion(case, path, extrude["simplify"].as_f64()).map(Some),
        None => Ok(None),
    }
}

fn extrusion(case: &Json, path: &Path, simplify: Option<f64>) -> Result<Device> {
    let extrude = &case["extrude"];
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
    match simplify {
        Some(tolerance) => extrusion.simplify(tolerance).build(),
        None => extrusion.build(),
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

fn cut_off_radius(segment: &Json) -> Option<f64> {
    let p = &segment["params"];
    let turn = number_or(&p["p"], 1.0) * number_or(&p["angle"], 90.0).abs();
    (segment["fn"] == "euler" && turn > 240.0).then(|| number_or(&p["radius"], 3.0))
}

fn is_effective_beyond_a_half_turn(segment: &Json) -> bool {
    let p = &segment["params"];
    let own_radius = number_or(&p["p"], 1.0) == 0.0;
    segment["fn"] == "euler" && p["use_eff"] == true && !own_radius && number_or(&p["angle"], 90.0).abs() > 190.0
}

fn check_angles(path: &Path, expect: &Json) -> Result<(), String> {
    for (what, ours) in [("start_angle", path.start_angle()), ("end_angle", path.end_angle())] {
        let theirs = number(&expect[what]);
        let off = (ours - theirs).rem_euclid(360.0);
        if off.min(360.0 - off) > 1e-9 {
            return Err(format!("{what} is {ours}, not {theirs}"));
        }
    }
    Ok(())
}

fn check_path(case: &Json, path: &Path, differences: &Differences) -> Result<(), String> {
    let expect = &case["expect"];
    if expect.get("points").is_some() {
        check_points("points", path.points(), &expect["points"], TOLERANCE)?;
    }
    near("length", path.length(), number(&expect["length"]), TOLERANCE)?;
    check_bbox(path, &expect["bbox"])?;
    let theirs = expect["hash_geometry"].as_str().unwrap();
    let ours = path.hash_geometry(1e-4).unwrap();
    if ours != theirs && has_arctangents(case) {
        differences.must_hold("Path.hash_geometry", "arctangent");
        let (start, end) = (number(&expect["start_angle"]), number(&expect["end_angle"]));
        return same("hash with the reference's angles", &defined_hash(path.points(), start, end), theirs);
    }
    same("hash", &ours, theirs)
}

fn has_arctangents(case: &Json) -> bool {
    let list = |key: &str| case[key].as_array().cloned().unwrap_or_default();
    case.get("smooth").is_some()
        || list("segments").iter().any(|segment| segment["fn"].is_null() || segment["fn"] == "spiral")
        || list("ops").iter().any(|op| op["op"] == "mirror")
}

/// The hash as the specification defines it, written down once more.
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

fn check_device(device: &Device, expect: &Json) -> Result<(), String> {
    check_bbox(device, &expect["bbox"]).map_err(|e| format!("device: {e}"))?;
    let layers = expect["layers"].as_object().unwrap();
    same("layers", &device.layers().len().to_string(), &layers.len().to_string())?;
    for (name, layer) in layers {
        let polygons: Vec<&[Point]> =
            device.polygons().filter(|p| p.layer.to_string() == *name).map(|p| p.points).collect();
        same("polygons", &polygons.len().to_string(), &layer["polygons"].to_string())?;
        let vertices: usize = polygons.iter().map(|p| p.len()).sum();
        same("vertices", &vertices.to_string(), &layer["vertices"].to_string())?;
        for (ours, theirs) in polygons.iter().zip(layer["points"].as_array().into_iter().flatten()) {
            check_points(name, ours, theirs, TOLERANCE)?;
        }
    }
    check_ports(device, expect["ports"].as_object().unwrap())?;
    let info = expect["info"].as_object().unwrap();
    if let Some(key) = info.keys().find(|key| !device.info().contains_key(*key)) {
        return Err(format!("info has no {key}"));
    }
    same("device hash", &device.hash_geometry(1e-4).unwrap(), expect["hash_geometry"].as_str().unwrap())
}

fn check_ports(device: &Device, expect: &serde_json::Map<String, Json>) -> Result<(), String> {
    same("ports", &device.ports().len().to_string(), &expect.len().to_string())?;
    for (name, theirs) in expect {
        let ours = device.port(name).map_err(|e| e.to_string())?;
        near("port midpoint", ours.midpoint().distance(point(&theirs["midpoint"])), 0.0, TOLERANCE)?;
        near("port width", ours.width(), number(&theirs["width"]), TOLERANCE)?;
        let off = (ours.orientation() - number(&theirs["orientation"])).rem_euclid(360.0);
        near("port orientation", off.min(360.0 - off), 0.0, TOLERANCE)?;
    }
    Ok(())
}

fn check_points(what: &str, ours: &[Point], theirs: &Json, tolerance: f64) -> Result<(), String> {
    let theirs = points(theirs);
    same(&format!("number of {what}"), &ours.len().to_string(), &theirs.len().to_string())?;
    match ours.iter().zip(&theirs).position(|(p, q)| p.distance(*q) > tolerance) {
        None => Ok(()),
        Some(i) => Err(format!("point {i} of {what} is {}, not {}", ours[i], theirs[i])),
    }
}

fn check_bbox(thing: &impl Bounded, theirs: &Json) -> Result<(), String> {
    let ours = thing.bbox().unwrap();
    let off = ours.min.distance(point(&theirs[0])).max(ours.max.distance(point(&theirs[1])));
    near("distance of the bounding boxes", off, 0.0, TOLERANCE)
}

fn near(what: &str, ours: f64, theirs: f64, tolerance: f64) -> Result<(), String> {
    if (ours - theirs).abs() <= tolerance { Ok(()) } else { Err(format!("{what} is {ours}, not {theirs}")) }
}

fn same(what: &str, ours: &str, theirs: &str) -> Result<(), String> {
    if ours == theirs { Ok(()) } else { Err(format!("{what} is {ours}, not {theirs}")) }
}
