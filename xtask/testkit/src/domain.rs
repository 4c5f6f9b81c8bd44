//! Random parameters of a registered generator, taken from what the registry says of them.

use std::collections::BTreeMap;

use phidl_core::param::{Bounds, ParamType};
use phidl_core::prelude::*;
use phidl_core::runtime::{GeneratorInfo, ParamInfo};
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{Config, TestRunner};

/// A search through a domain with this number of cases, or with that of `PROPTEST_CASES`, for a longer run by hand.
#[must_use]
pub fn search(cases: u32) -> TestRunner {
    let usual = Config::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { usual.cases } else { cases };
    TestRunner::new(Config { cases, failure_persistence: None, ..usual })
}

/// Values for all parameters that can be drawn at random, inside their bounds; the others keep their defaults.
///
/// `None` if a parameter without a default is of a kind that nothing is drawn for: a device, another generator.
pub fn params(entry: &GeneratorInfo) -> Option<BoxedStrategy<BTreeMap<String, Value>>> {
    let nothing = Just(BTreeMap::new()).boxed();
    entry.params().into_iter().try_fold(nothing, |all, param| match value(&param.kind, &param.bounds) {
        Some(values) => Some(with(all, &param, values)),
        None => param.default.is_some().then_some(all),
    })
}

fn with(
    all: BoxedStrategy<BTreeMap<String, Value>>,
    param: &ParamInfo,
    values: BoxedStrategy<Value>,
) -> BoxedStrategy<BTreeMap<String, Value>> {
    let name = param.name.to_owned();
    // A parameter that is left out is as common as one that is given: combinations with defaults are what people draw.
    let given = match param.default {
        Some(_) => prop::option::of(values).boxed(),
        None => values.prop_map(Some).boxed(),
    };
    let insert = move |(mut all, value): (BTreeMap<String, Value>, Option<Value>)| {
        all.extend(value.map(|value| (name.clone(), value)));
        all
    };
    (all, given).prop_map(insert).boxed()
}

fn value(kind: &ParamType, bounds: &Bounds) -> Option<BoxedStrategy<Value>> {
    let list = |strategy: BoxedStrategy<Value>, count| vec(strategy, count).prop_map(Value::List).boxed();
    Some(match kind {
        ParamType::Number => number(bounds).prop_map(Value::Float).boxed(),
        ParamType::Integer => integer(bounds).prop_map(Value::Int).boxed(),
        ParamType::Bool => any::<bool>().prop_map(Value::Bool).boxed(),
        ParamType::Text => "[ -~]{0,8}".prop_map(Value::Text).boxed(),
        ParamType::Point | ParamType::Size => list(number(bounds).prop_map(Value::Float).boxed(), 2..=2),
        ParamType::Layer => (0..60_i64).prop_map(Value::Int).boxed(),
        ParamType::Layers => {
            prop_oneof![(0..60_i64).prop_map(Value::Int), Just(Value::from([7, 3])), Just(Value::Null)].boxed()
        }
        ParamType::Port => port().boxed(),
        ParamType::Choice(words) => select(*words).prop_map(Value::from).boxed(),
        ParamType::List(inner) => list(value(inner, bounds)?, 0..=4),
        ParamType::Map(inner) => btree_map("[A-Z]", value(inner, bounds)?, 0..=3).prop_map(Value::Map).boxed(),
        ParamType::Optional(inner) => prop_oneof![Just(Value::Null), value(inner, bounds)?].boxed(),
        _ => return None,
    })
}

/// Lengths and angles as people draw them, and now and then a very small or a very large one.
fn number(bounds: &Bounds) -> BoxedStrategy<f64> {
    let low = bounds.min.or(bounds.above).unwrap_or(-1e4);
    let high = bounds.max.or(bounds.below).unwrap_or(low.max(0.0) + 1e4);
    let above = bounds.above.is_some();
    let below = bounds.below.is_some();
    let inside = move |v: f64| !(above && v <= low || below && v >= high);
    let usual = (0.0..=1.0_f64).prop_map(move |part| low + (high - low) * part * part * part);
    let small = (-6.0..0.0_f64).prop_map(move |exponent| (low + 10_f64.powf(exponent)).min(high));
    let ends = prop_oneof![Just(low), Just(high)];
    prop_oneof![8 => usual, 2 => small, 1 => ends].prop_filter("inside the bounds", move |v| inside(*v)).boxed()
}

fn integer(bounds: &Bounds) -> BoxedStrategy<i64> {
    let whole = |v: f64| {
        #[expect(clippy::cast_possible_truncation, reason = "bounds of counts are small")]
        let v = v as i64;
        v
    };
    let low = bounds.min.map(whole).or(bounds.above.map(|v| whole(v) + 1)).unwrap_or(0);
    let high = bounds.max.map(whole).or(bounds.below.map(|v| whole(v) - 1)).unwrap_or(low + 30);
    (low..=high.min(low + 60)).boxed()
}

fn port() -> impl Strategy<Value = Value> {
    (-500.0..500.0, -500.0..500.0, 0.0..20.0, 0..8)
        .prop_map(|(x, y, width, turn)| Value::from(&Port::new((x, y), width, 45.0 * f64::from(turn))))
}
