//! Facts about a case that take a computation: of the reference's drawing, and of the domain of the parameters.

use phidl_core::geom::{Point, Rect};
use phidl_core::param::{Bounds, ParamType};
use phidl_core::runtime::{ParamInfo, registry};
use serde_json::Value as Json;

use super::Case;
use super::region::merged_area;

/// Whether the reference drew an outline that encloses nothing or crosses itself, or drew on no layer, where outlines
/// cannot be judged.
#[must_use]
pub(super) fn draws_no_shape(case: &Case) -> bool {
    let unseen = case.params.get("layer").is_some_and(Json::is_null);
    let sound = |outline: &Vec<Point>| !encloses_nothing(outline) && !crosses_itself(outline);
    unseen || !outlines(&case.expect).iter().all(sound)
}

fn outlines(expect: &Json) -> Vec<Vec<Point>> {
    let layers = expect["layers"].as_object().into_iter().flatten();
    let listed = layers.filter_map(|(_, layer)| layer["points"].as_array()).flatten();
    let coordinate = |json: &Json| json.as_f64().unwrap_or_default();
    let point = |json: &Json| Point::new(coordinate(&json[0]), coordinate(&json[1]));
    listed.map(|outline| outline.as_array().into_iter().flatten().map(point).collect()).collect()
}

/// No area to the seventh digit that the files have.
fn encloses_nothing(outline: &[Point]) -> bool {
    let longest = outline.iter().map(|p| p.distance(outline[0])).fold(0.0, f64::max);
    phidl_core::geom::signed_area(outline).abs() <= 1e-7 * longest.max(1e-7)
}

/// Whether it winds around a point twice, or the other direction: then it encloses less than it covers.
fn crosses_itself(outline: &[Point]) -> bool {
    let length: f64 = (0..outline.len()).map(|i| outline[i].distance(outline[(i + 1) % outline.len()])).sum();
    // Points are rounded to 1e-7 µm.
    let doubt = 1e-6 * length.max(1.0);
    (merged_area(&[outline.to_vec()]) - phidl_core::geom::signed_area(outline).abs()).abs() > doubt
}

/// Whether a case gives a number outside the bounds that the registry states.
#[must_use]
pub(super) fn is_out_of_bounds(case: &Case) -> bool {
    any_param(case, |value, param| breaks(value, &param.kind, &param.bounds))
}

/// Whether a case gives a name that is none of the choices of the registry.
#[must_use]
pub(super) fn is_no_choice(case: &Case) -> bool {
    any_param(case, |value, param| is_unknown(value, &param.kind))
}

fn any_param(case: &Case, holds: impl Fn(&Json, &ParamInfo) -> bool) -> bool {
    let Ok(entry) = registry::find(&case.device) else { return false };
    entry.params().iter().any(|param| case.params.get(param.name).is_some_and(|value| holds(value, param)))
}

fn is_unknown(value: &Json, kind: &ParamType) -> bool {
    match (value, kind) {
        (value, ParamType::Optional(inner)) => is_unknown(value, inner),
        (Json::String(name), ParamType::Choice(names)) => !names.contains(&name.as_str()),
        _ => false,
    }
}

fn breaks(value: &Json, kind: &ParamType, bounds: &Bounds) -> bool {
    match (value, kind) {
        (value, ParamType::Optional(inner)) => !value.is_null() && breaks(value, inner, bounds),
        (Json::Array(list), ParamType::List(_) | ParamType::Point | ParamType::Size) => {
            list.iter().any(|item| item.as_f64().is_some_and(|v| is_outside(v, bounds)))
        }
        // Counts are not negative without saying so.
        (Json::Number(v), ParamType::Integer) => v.as_f64().is_some_and(|v| v < 0.0 || is_outside(v, bounds)),
        (Json::Number(v), ParamType::Number) => v.as_f64().is_some_and(|v| is_outside(v, bounds)),
        _ => false,
    }
}

fn is_outside(v: f64, bounds: &Bounds) -> bool {
    bounds.min.is_some_and(|min| v < min)
        || bounds.above.is_some_and(|above| v <= above)
        || bounds.max.is_some_and(|max| v > max)
        || bounds.below.is_some_and(|below| v >= below)
}

/// `optimal_hairpin` and what is made of it: whether a turn of the reference reaches further than its length. Looks for
/// the halves of turns among the reference's outlines, by their height.
pub(super) fn turn_is_longer_than_length(case: &Case) -> bool {
    let (height, length) = match case.device.as_str() {
        "optimal_hairpin" => ((case.number("pitch") + case.number("width")) / 2.0, case.number("length")),
        _ => {
            let width = case.expect["info"]["size"][0].as_f64().unwrap_or(f64::NAN);
            ((case.number("wire_pitch") + case.number("wire_width")) / 2.0, width / 2.0)
        }
    };
    let sizes = outlines(&case.expect).into_iter().filter_map(Rect::around);
    sizes.into_iter().any(|r| (r.size().height - height).abs() < 1e-4 * height && r.size().width > length + 1e-6)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|p| Point::from(*p)).collect()
    }

    #[test]
    fn an_hourglass_crosses_itself_and_an_hourglass_whose_waist_touches_does_not() {
        assert!(crosses_itself(&outline(&[(0., 0.), (2., 2.), (2., 0.), (0., 2.)])));
        assert!(!crosses_itself(&outline(&[(0., 0.), (1., 1.), (2., 0.), (2., 2.), (1., 1.), (0., 2.)])));
        assert!(!crosses_itself(&outline(&[(0., 0.), (2., 0.), (2., 0.), (2., 2.), (0., 2.)])));
    }

    #[test]
    fn a_line_there_and_back_encloses_nothing() {
        assert!(encloses_nothing(&outline(&[(0., 0.), (5., 0.), (9., 0.)])));
        assert!(!encloses_nothing(&outline(&[(0., 0.), (5., 1e-3), (9., 0.)])));
    }
}
