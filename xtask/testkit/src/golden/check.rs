//! Running cases: strictly first, and by the difference that applies where ours differs.

use phidl_core::prelude::*;
use serde::Deserialize;
use serde_json::Value as Json;

use super::compare::{Described, Extent, HAIR, compare, contains, layer, outlines_by_layer, step_of};
use super::difference::{Difference, Instead};
use super::differences::differences;
use super::refusal::assert_refused;
use super::{Case, Refusal};

/// Runs all cases, prints a line for each, and panics with all that failed.
///
/// # Panics
/// If a case fails.
pub fn assert_all(cases: &[Case], draw: impl Fn(&Case) -> Result<Device>) {
    let mut failures = Vec::new();
    for case in cases {
        let outcome = check(case, None, &draw).or_else(|why| {
            match differences().into_iter().find(|difference| difference.applies_to(case)) {
                Some(difference) => check(case, Some(difference), &draw),
                None => Err(why),
            }
        });
        #[expect(clippy::print_stdout, reason = "one line a case, shown by the test runner on failure or demand")]
        {
            println!("{:<28} {}", case.id, outcome.as_ref().map_or_else(String::as_str, |()| "ok"));
        }
        failures.extend(outcome.err().map(|why| format!("{}: {why}", case.id)));
    }
    assert!(failures.is_empty(), "{} of {} cases:\n{}", failures.len(), cases.len(), failures.join("\n"));
}

/// Checks that every difference about one of these functions is needed by a case, or is marked as `further`: that the
/// first difference which applies to a case is about a case in which the two do differ.
///
/// # Panics
/// With the differences that are not.
pub fn assert_differences_are_needed(cases: &[Case], functions: &[&str], draw: impl Fn(&Case) -> Result<Device>) {
    let table = differences();
    let mut needed = vec![false; table.len()];
    for case in cases {
        if let Some(i) = table.iter().position(|difference| difference.applies_to(case)) {
            needed[i] = needed[i] || check(case, None, &draw).is_err();
        }
    }
    let about = |d: &Difference| functions.iter().any(|name| d.is_about(name));
    let wrong: Vec<String> = table
        .into_iter()
        .zip(needed)
        .filter(|(difference, needed)| about(difference) && difference.further == *needed)
        .map(|(difference, needed)| {
            format!("{:?} ({}): needed is {needed}", difference.functions, difference.condition)
        })
        .collect();
    assert!(wrong.is_empty(), "`further` is wrong in the table of differences:\n{}", wrong.join("\n"));
}

fn check(case: &Case, difference: Option<&Difference>, draw: impl Fn(&Case) -> Result<Device>) -> Result<(), String> {
    let drawn = draw(case);
    let Some(difference) = difference else { return same_or_refused(case, drawn) };
    let refused = |class: Refusal, drawn: &Result<Device>| assert_refused(case, class, drawn);
    match difference.compare {
        // Paths are compared by the tests of their crate.
        Instead::Test(_) | Instead::PointsTo(_) => Ok(()),
        Instead::Refused(class) => refused(class, &drawn),
        Instead::RefusedOrSame(class) if drawn.is_err() => refused(class, &drawn),
        Instead::RefusedOrSame(_) => same(case, drawn, Extent::of(case)),
        Instead::Drawn => drawn.map_or_else(|error| Err(error.report()), |_| Ok(())),
        Instead::Nearby(names) => same(case, drawn, Extent::of(case)).or_else(|why| {
            let nearby = names.iter().flat_map(|name| nudged(case, name));
            match nearby.map(|case| same(&case, draw(&case), Extent::Points)).any(|outcome| outcome.is_ok()) {
                true => Ok(()),
                false => Err(format!("{why}; nor is it the reference's with a number changed by a hair")),
            }
        }),
        Instead::With(params) => {
            let mut case = case.clone();
            let params = params(&case);
            case.params.extend(params);
            same(&case, draw(&case), Extent::of(&case))
        }
        Instead::OtherLayers => other_layers(case, drawn, draw),
        Instead::LayerOf(parameter) => layer_of(case, drawn, parameter),
        Instead::Within(part) => same(case, drawn, Extent::Within(part)),
        Instead::CornersToAStep => same(case, drawn, Extent::Corners(step_of(case))),
        Instead::Region => same(case, drawn, Extent::Region),
        Instead::Ports => same(case, drawn, Extent::Ports),
    }
}

/// What the reference draws, or a refusal of the class that the case states.
fn same_or_refused(case: &Case, drawn: Result<Device>) -> Result<(), String> {
    match (case.is_refused(), drawn.is_err(), case.refusal()) {
        (true, true, Some(class)) => assert_refused(case, class, &drawn),
        (true, true, None) => Ok(()),
        _ => same(case, drawn, Extent::of(case)),
    }
}

fn same(case: &Case, drawn: Result<Device>, extent: Extent) -> Result<(), String> {
    if case.is_refused() {
        return Err("the reference refuses it, ours draws it".to_owned());
    }
    let device = drawn.map_err(|error| format!("ours refuses it: {}", error.report()))?;
    compare(&device, &case.expect, extent)
}

/// Compares with our own drawing in which the missing layers are drawn on layers that nothing else uses.
fn other_layers(case: &Case, drawn: Result<Device>, draw: impl Fn(&Case) -> Result<Device>) -> Result<(), String> {
    let mut whole = case.clone();
    let missing = case.params.iter().filter(|(name, value)| name.ends_with("layer") && value.is_null());
    for ((name, _), free) in missing.zip(60_000..) {
        whole.params.insert(name.clone(), free.into());
    }
    let drawn = outlines_by_layer(&drawn.map_err(|error| error.report())?);
    let mut whole = outlines_by_layer(&draw(&whole).map_err(|error| error.report())?);
    whole.retain(|name, _| !name.starts_with("6000"));
    if drawn.is_empty() || !drawn.keys().eq(whole.keys()) {
        return Err(format!("layers are {:?}, expected {:?}", drawn.keys(), whole.keys()));
    }
    drawn.iter().try_for_each(|(name, outlines)| contains(outlines, &whole[name]))
}

/// Compares the polygons on one layer, which is a parameter of the case.
fn layer_of(case: &Case, drawn: Result<Device>, parameter: &str) -> Result<(), String> {
    let device = drawn.map_err(|error| error.report())?;
    let expected = Described::deserialize(&case.expect).map_err(|error| format!("the description is off: {error}"))?;
    let number = case.number(parameter);
    let name = format!("{number}/0");
    let Some(expected) = expected.layers.get(&name) else { return Err(format!("the reference has no layer {name}")) };
    layer(outlines_by_layer(&device).get(&name).map_or(&[][..], Vec::as_slice), expected, Extent::All)
}

/// The case with a number a hair smaller, and a hair larger.
fn nudged(case: &Case, name: &str) -> Vec<Case> {
    let Some(value) = case.parameter(name).and_then(|value| value.as_f64()) else { return Vec::new() };
    let (first, rest) = name.split_once('.').map_or((name, None), |(first, rest)| (first, Some(rest)));
    let with = |value: f64| {
        let mut case = case.clone();
        let mut whole = case.parameter(first).unwrap_or(Json::Null);
        match rest.and_then(|rest| rest.parse::<usize>().ok()) {
            Some(index) => whole[index] = value.into(),
            None => whole = value.into(),
        }
        case.params.insert(first.to_owned(), whole);
        case
    };
    [1.0 - HAIR, 1.0 + HAIR].map(|factor| with(value * factor)).to_vec()
}
