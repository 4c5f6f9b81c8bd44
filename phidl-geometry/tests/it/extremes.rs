//! Senseless parameters end in a cell or in an error, never in a panic and never in an endless search.

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_core::runtime::registry;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// Shapes whose curves are searched for or followed step by step.
const SHAPES: [&str; 13] = [
    "grating",
    "hecken_taper",
    "meander_taper",
    "optimal_90deg",
    "optimal_hairpin",
    "optimal_step",
    "racetrack_gradual",
    "ramp",
    "snspd",
    "snspd_candelabra",
    "snspd_expanded",
    "turn",
    "ytron_round",
];

const NUMBERS: [f64; 12] = [0.0, -1.0, 1e-300, 1e-12, 1e-3, 0.3, 1.0, 4.0, 1e4, 1e9, 1e300, f64::NAN];
/// One number in this many is replaced: of a cell with all of them replaced, the first bound would be the only one tested.
const REPLACED_ONE_IN: usize = 5;
const COUNTS: [i64; 6] = [-1, 0, 1, 2, 7, 1000];

/// The value with every number in it replaced by one of the above, or left as it is.
fn replaced(value: &Value, picks: &mut impl Iterator<Item = usize>) -> Value {
    let mut pick = |from: usize| picks.next().unwrap_or_default() % (REPLACED_ONE_IN * from);
    match value {
        Value::Float(v) => Value::Float(NUMBERS.get(pick(NUMBERS.len())).copied().unwrap_or(*v)),
        Value::Int(v) => Value::Int(COUNTS.get(pick(COUNTS.len())).copied().unwrap_or(*v)),
        Value::Bool(v) => Value::Bool(*v ^ (pick(1) == 0)),
        Value::List(list) => Value::List(list.iter().map(|item| replaced(item, picks)).collect()),
        Value::Map(map) => Value::Map(map.iter().map(|(key, item)| (key.clone(), replaced(item, picks))).collect()),
        other => other.clone(),
    }
}

#[test]
fn senseless_parameters_are_drawn_or_refused() {
    let config = ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() };
    for name in SHAPES {
        let entry = registry::find(name).expect("a registered shape");
        let example = entry.example().expect("an example");
        let picks = prop::collection::vec(0..1000_usize, 24);
        let mut runner = TestRunner::new_with_rng(config.clone(), fixed());
        let result = runner.run(&picks, |picks| {
            let mut picks = picks.into_iter();
            let params: BTreeMap<String, Value> =
                example.iter().map(|(name, value)| ((*name).to_owned(), replaced(value, &mut picks))).collect();
            if let Ok(device) = entry.build(&params) {
                prop_assert!(device.bbox().is_none_or(|bbox| bbox.min.is_finite() && bbox.max.is_finite()));
            }
            Ok(())
        });
        assert!(result.is_ok(), "{name}: {result:?}");
    }
}

/// The same parameters in every run.
fn fixed() -> proptest::test_runner::TestRng {
    proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha)
}
