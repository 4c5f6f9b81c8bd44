//! Every number and every list of every registered generator at extreme values, under a limit of memory and processor
//! time: the cell is drawn or refused, and no case aborts, hangs or takes the memory of the machine.
//!
//! Each generator is walked in a process of its own, so that a case which breaks a limit is named. The limits are those
//! of the system (`ulimit`), which count processor time and not the time on the clock: a busy machine changes nothing.

#![allow(clippy::print_stdout, reason = "the parent process reads which case was last")]

use std::collections::BTreeMap;
use std::process::Command;

use phidl::param::{ParamType, Value};
use phidl::prelude::*;
use phidl::registry;
use phidl::runtime::GeneratorInfo;

const NUMBERS: [f64; 9] = [0.0, -0.0, 1e-300, -1e-300, 1e-9, 1e9, 1e300, f64::INFINITY, f64::NAN];
/// Items of a long list.
const LONG: usize = 1_000_000;
/// Items of a long list of cells: fewer, since each of them is drawn, and the test is not optimized.
const LONG_OF_CELLS: usize = 1000;
/// For all cases of one generator, in kibibytes and seconds of processor time.
const LIMITS: &str = "ulimit -v 6000000; ulimit -t 300";
/// The generator that a child process walks.
const GENERATOR: &str = "PHIDL_WALKED_GENERATOR";

fn main() {
    match std::env::var(GENERATOR) {
        Ok(name) => walk(registry::find(&name).expect("the parent process names a generator")),
        Err(_) if is_filtered_out() => {}
        Err(_) => walk_all(),
    }
}

/// Whether `cargo test NAME` asks for other tests.
fn is_filtered_out() -> bool {
    let filter = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    filter.is_some_and(|filter| !"parameter_walk".contains(&filter))
}

/// Walks every generator, each in a child process.
fn walk_all() {
    let this = std::env::current_exe().expect("the path of this program");
    let mut failed = Vec::new();
    for info in registry::all() {
        let output = Command::new("sh")
            .args(["-c", &format!("{LIMITS}; exec \"$0\"")])
            .arg(&this)
            .env(GENERATOR, format!("{}::{}", info.module, info.name))
            .output()
            .expect("a shell");
        if !output.status.success() {
            let (out, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            let last = out.lines().last().unwrap_or_default();
            failed.push(format!("{}, {last}: {}\n{error}", info.name, output.status));
        }
    }
    assert!(failed.is_empty(), "{} generators break a limit:\n{}", failed.len(), failed.join("\n"));
}

/// Every case of one generator.
fn walk(info: &'static GeneratorInfo) {
    let example = info.example().expect("every generator has an example").by_name();
    for param in info.params() {
        for (label, value) in variants(&example[param.name], &param.kind) {
            println!("{} = {label}", param.name);
            let mut params = example.clone();
            params.insert(param.name.to_owned(), value);
            attempt(info, &params);
        }
    }
}

/// Draws the cell. A cell has finite coordinates, and a refusal names a device and a rule.
fn attempt(info: &'static GeneratorInfo, params: &BTreeMap<String, Value>) {
    match phidl::cache::bypass(|| info.build(params)) {
        Ok(device) => {
            let finite = device.bbox().is_none_or(|b| b.min.is_finite() && b.max.is_finite());
            assert!(finite, "{} reaches to infinity", info.name);
            assert!(device.info().values().all(Value::is_finite), "{} records {:?}", info.name, device.info());
        }
        Err(error) => assert!(error.to_string().contains(": "), "{error}"),
    }
}

/// The value with each of its numbers and lists replaced, and what was replaced.
fn variants(value: &Value, kind: &ParamType) -> Vec<(String, Value)> {
    match value {
        Value::Float(_) | Value::Int(_) => NUMBERS.iter().map(|n| (n.to_string(), number(*n))).collect(),
        Value::List(items) => {
            let item = items.first().cloned().unwrap_or_else(|| number(1.0));
            let long = if matches!(item, Value::Device(_) | Value::Map(_)) { LONG_OF_CELLS } else { LONG };
            let mut all = vec![
                ("an empty list".to_owned(), Value::List(Vec::new())),
                (format!("{long} items"), Value::List(vec![item; long])),
            ];
            for i in 0..items.len().min(2) {
                for (label, changed) in variants(&items[i], kind) {
                    let mut list = items.clone();
                    list[i] = changed;
                    all.push((format!("[{i}] {label}"), Value::List(list)));
                }
            }
            all
        }
        Value::Map(map) => {
            let entries = map.iter().flat_map(|(key, entry)| {
                variants(entry, kind).into_iter().map(move |(label, changed)| {
                    let mut map = map.clone();
                    map.insert(key.clone(), changed);
                    (format!(".{key} {label}"), Value::Map(map))
                })
            });
            entries.collect()
        }
        Value::Null => template(kind).map(|value| variants(&value, kind)).unwrap_or_default(),
        Value::Bool(_) | Value::Text(_) | Value::Device(_) => Vec::new(),
    }
}

/// A value for an optional parameter that has none.
fn template(kind: &ParamType) -> Option<Value> {
    match kind {
        ParamType::Optional(inner) => template(inner),
        ParamType::Number | ParamType::Integer => Some(number(1.0)),
        ParamType::Point | ParamType::Size | ParamType::Other(_) => Some(vec![1.0, 1.0].into()),
        ParamType::List(inner) => template(inner).map(|item| Value::List(vec![item])),
        _ => None,
    }
}

/// Whole numbers are integers, so that counts take them.
fn number(n: f64) -> Value {
    #[expect(clippy::cast_possible_truncation, reason = "whole and small enough")]
    if n.fract() == 0.0 && n.abs() < 1e15 { Value::Int(n as i64) } else { Value::Float(n) }
}
