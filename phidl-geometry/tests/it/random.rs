//! Random parameters of the shapes that need no other device, and laws over them.
//!
//! The registry states the bounds of each parameter, but many shapes also relate parameters to each other: a ring must
//! not be wider than its diameter. Three of four random sets are therefore adjusted to the relations in the documentation
//! of the shape (`related`), so that most of them are drawn; the fourth stays as it is, so that refusals are tried too. A
//! law fails if fewer than [`LEAST_ACCEPTED`] of the sets are drawn: otherwise a shape that refuses everything would obey
//! every law.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::GeneratorInfo;
use proptest::prelude::*;
use testkit::domain::{params, search};

/// Smallest share of random parameter sets that a shape must accept.
const LEAST_ACCEPTED: f64 = 0.5;

/// Parameters by name.
pub(crate) type Params = BTreeMap<String, Value>;

/// The shapes that can be drawn without other devices.
pub(crate) fn shapes() -> impl Iterator<Item = &'static GeneratorInfo> {
    registry::all().filter(|entry| entry.module.starts_with("phidl_geometry") && params(entry).is_some())
}

/// Draws a shape with random parameters and asserts a law for every drawing.
pub(crate) fn for_every_drawing(
    entry: &'static GeneratorInfo,
    cases: u32,
    law: impl Fn(&Params, &Device) -> Result<(), TestCaseError>,
) {
    let (tried, accepted) = (Cell::new(0_u32), Cell::new(0_u32));
    let refusal = RefCell::new(String::new());
    let values = (params(entry).expect("a shape without devices among its parameters"), 0..4_u8);
    let values = values.prop_map(|(params, turn)| if turn == 0 { params } else { related(entry, params) });
    let outcome = search(cases).run(&values, |params| {
        tried.set(tried.get() + 1);
        match entry.build(&params) {
            Ok(device) => {
                accepted.set(accepted.get() + 1);
                law(&params, &device)
            }
            Err(error) => {
                refusal.replace(error.report());
                Ok(())
            }
        }
    });
    if let Err(failure) = outcome {
        panic!("{}: {failure}", entry.name);
    }
    let share = f64::from(accepted.get()) / f64::from(tried.get());
    let refusal = refusal.into_inner();
    assert!(share >= LEAST_ACCEPTED, "{}: only {share} of all sets are drawn; the last refusal: {refusal}", entry.name);
}

/// A parameter, or its default.
fn number(entry: &GeneratorInfo, params: &Params, name: &str) -> f64 {
    params.get(name).and_then(Value::as_f64).or_else(|| default(entry, name).as_f64()).unwrap_or(1.0)
}

fn default(entry: &GeneratorInfo, name: &str) -> Value {
    let param = entry.params().into_iter().find(|param| param.name == name);
    param.and_then(|param| param.default).unwrap_or(Value::Null)
}

fn numbers(entry: &GeneratorInfo, params: &Params, name: &str) -> Vec<f64> {
    let value = params.get(name).cloned().unwrap_or_else(|| default(entry, name));
    value.as_list().unwrap_or_default().iter().filter_map(Value::as_f64).collect()
}

/// The parameters, changed as little as the relations of the shape ask for.
fn related(entry: &GeneratorInfo, mut params: Params) -> Params {
    let p = params.clone();
    let get = |name: &str| number(entry, &p, name);
    let list = |name: &str| numbers(entry, &p, name);
    let mut set = |name: &str, value: Value| drop(params.insert(name.to_owned(), value));
    match entry.name {
        "ring" | "arc" => set("width", get("width").min(2.0 * get("radius")).into()),
        "turn" => set("radius", get("radius").max(10.0).into()),
        "L" | "C" => {
            let size = list("size");
            let low = get("width") * 1.01;
            set("size", [size[0].abs().max(low), size[1].abs().max(low)].into());
        }
        "flagpole" | "tee" => {
            let (size, stub) = (list("size"), list("stub_size"));
            set("stub_size", [stub[0].min(size[0]), stub[1]].into());
        }
        "hecken_taper" => {
            // Impedances of random numbers rarely have a strip; widths always have an impedance.
            for name in ["width1", "width2"] {
                set(
                    name,
                    get(name).clamp(1e-3 * get("dielectric_thickness"), 1e3 * get("dielectric_thickness")).into(),
                );
            }
            set("Z1", Value::Null);
            set("Z2", Value::Null);
        }
        "meander_taper" => meander_taper(&list("x_taper"), &list("w_taper"), &mut set, &get),
        "polygon_ports" => polygon(&list("xpts"), &list("ypts"), &mut set),
        "litho_steps" if list("line_widths").is_empty() => set("line_widths", [1.0].into()),
        "litho_ruler" => {
            set("height", if get("height") == 0.0 { 2.0 } else { get("height") }.into());
            let scale: Vec<f64> = list("scale").into_iter().filter(|scale| *scale != 0.0).collect();
            set("scale", if scale.is_empty() { vec![3.0, 1.0] } else { scale }.into());
        }
        "basic_die" => {
            set("street_length", get("street_length").max(get("street_width")).into());
            set("text_size", if get("text_size") == 0.0 { 100.0 } else { get("text_size") }.into());
        }
        "text" => {
            set("size", if get("size") == 0.0 { 10.0 } else { get("size") }.into());
            set("font", "DEPLOF".into());
        }
        "grating" if get("fill_factor") >= 1.0 => set("fill_factor", 0.5.into()),
        "racetrack_gradual" => {
            let (r, n) = (get("R"), get("N"));
            // The tightest radius of the superellipse.
            let tightest = 2.0_f64.powf(0.5 - 1.0 / n) * r / (n - 1.0);
            set("width", get("width").min(1.9 * tightest).into());
        }
        "optimal_hairpin" => {
            let width = get("width");
            let pitch = get("pitch").clamp(1.1 * width, 20.0 * width);
            set("pitch", pitch.into());
            set("num_pts", get("num_pts").min(200.0).round().into());
            set("length", get("length").max(3.0 * pitch + 1.1 * get("turn_ratio") * width).into());
        }
        "optimal_step" => {
            set("width_tol", get("width_tol").min(0.01).into());
            let (start, end) = (get("start_width"), get("end_width"));
            set("end_width", if (start / end - 1.0).abs() < 0.1 { start } else { end }.into());
        }
        "snspd" | "snspd_expanded" => snspd(entry.name == "snspd_expanded", &mut set, &get),
        "snspd_candelabra" => {
            let width = get("wire_width");
            set("wire_pitch", get("wire_pitch").clamp(1.05 * width, 3.0 * width).into());
            set("haxis", get("haxis").clamp(60.0 * width, 200.0 * width).into());
            set("vaxis", get("vaxis").clamp(30.0 * width, 100.0 * width).into());
        }
        "ytron_round" => {
            let depth = get("rho") * get("theta").to_radians().sin();
            set("source_length", get("source_length").max(1.1 * depth).into());
            set("theta", get("theta").min(30.0).into());
        }
        "test_comb" => {
            let pad = list("pad_size");
            let smaller = pad[0].min(pad[1]).max(1.0);
            set("pad_size", [pad[0].max(smaller), pad[1].max(smaller)].into());
            set("wire_width", get("wire_width").clamp(smaller / 500.0, smaller / 20.0).into());
            set("wire_gap", get("wire_gap").min(smaller / 20.0).into());
        }
        "test_ic" => test_ic(&list("wire_widths"), &list("wire_widths_wide"), &mut set),
        "test_res" => {
            let width = get("width").clamp(list("pad_size")[1] / 100.0, list("pad_size")[1]);
            set("width", width.into());
            set("num_squares", get("num_squares").max(10.0).into());
        }
        _ => {}
    }
    params
}

/// Positions that increase, as many widths, and turns that are wide enough.
fn meander_taper(x: &[f64], w: &[f64], set: &mut impl FnMut(&str, Value), get: &impl Fn(&str) -> f64) {
    let points = x.len().max(2);
    let width = |i: usize| w.get(i).copied().unwrap_or(2.0);
    let widest = (0..points).map(width).fold(0.1, f64::max);
    let step = |i: usize| x.get(i).copied().unwrap_or(50.0).abs().max(5.0 * widest);
    let positions: Vec<f64> = (0..points).map(|i| (0..i).map(step).sum()).collect();
    let length = positions[points - 1];
    set("x_taper", positions.into());
    set("w_taper", (0..points).map(width).collect::<Vec<_>>().into());
    set("min_spacing", get("min_spacing").max(1.1 * widest).into());
    set("meander_length", get("meander_length").clamp(length / 200.0, 10.0 * length).into());
}

/// Two lists of one length, whose outline encloses an area.
fn polygon(x: &[f64], y: &[f64], set: &mut impl FnMut(&str, Value)) {
    let points = x.len().min(y.len());
    if points < 3 {
        set("xpts", [0.0, 4.0, 1.0].into());
        set("ypts", [0.0, 1.0, 3.0].into());
    } else {
        set("xpts", x[..points].to_vec().into());
        set("ypts", y[..points].to_vec().into());
    }
}

/// A width that holds two turns and a height that holds some rows.
fn snspd(expanded: bool, set: &mut impl FnMut(&str, Value), get: &impl Fn(&str) -> f64) {
    let width = get("wire_width");
    let pitch = get("wire_pitch").clamp(1.2 * width, 10.0 * width);
    let ratio = get("turn_ratio").min(10.0);
    let turn = 2.0 * (3.0 * pitch + ratio * width);
    let rows = 5.0 + get("num_squares") % 40.0;
    set("wire_pitch", pitch.into());
    set("turn_ratio", ratio.into());
    if expanded {
        set("connector_width", get("connector_width").clamp(2.0 * width, 30.0 * width).into());
    }
    // The three forms of a size, by turns.
    let (x, y) = (2.0 * turn, rows * pitch);
    let squares = x * y / (width * pitch);
    let (size, squares) = match rows % 3.0 {
        rest if rest < 1.0 => (vec![x.into(), y.into()], Value::Null),
        rest if rest < 2.0 => (vec![x.into(), Value::Null], squares.into()),
        _ => (vec![Value::Null, y.into()], squares.into()),
    };
    set("size", Value::List(size));
    set("num_squares", squares);
}

/// Lists of one length, no wire narrower at its pads than in the middle.
fn test_ic(narrow: &[f64], wide: &[f64], set: &mut impl FnMut(&str, Value)) {
    let count = narrow.len().min(wide.len()).max(1);
    let narrow: Vec<f64> = (0..count).map(|i| narrow.get(i).copied().unwrap_or(1.0)).collect();
    let wide = (0..count).map(|i| wide.get(i).copied().unwrap_or(3.0).max(1.1 * narrow[i]));
    let wide: Vec<f64> = wide.collect();
    set("wire_widths", narrow.into());
    set("wire_widths_wide", wide.into());
}
