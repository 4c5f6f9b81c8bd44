//! Every error sentence of the shape library, to be read by a person: one line for each kind of refusal.

use std::collections::BTreeMap;
use std::fmt::Write;

use expect_test::expect;
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_geometry as pg;
use serde::Deserialize;

/// The report of a generator's refusal of some parameters, which are JSON.
fn refusal(name: &str, params: &str) -> String {
    let json: BTreeMap<String, serde_json::Value> = serde_json::from_str(params).expect("JSON");
    let params = json.into_iter().map(|(name, value)| (name, Value::deserialize(value).expect("a value"))).collect();
    match registry::find(name).expect("a shape").build(&params) {
        Err(error) => error.report(),
        Ok(_) => format!("{name} draws {params:?}"),
    }
}

fn refusals(cases: &[(&str, &str)]) -> String {
    let mut lines = String::new();
    for (name, params) in cases {
        writeln!(lines, "{}", refusal(name, params)).expect("a string takes all");
    }
    lines
}

#[test]
fn refusals_of_single_shapes() {
    let lines = refusals(&[
        ("ring", r#"{"radius": 1, "width": 3}"#),
        ("ring", r#"{"angle_resolution": 1e-7}"#),
        ("arc", r#"{"radius": 1, "width": 3}"#),
        ("arc", r#"{"theta": 0}"#),
        ("turn", r#"{"port": {"midpoint": [0, 0], "width": 30, "orientation": 0}}"#),
        ("circle", r#"{"angle_resolution": 1e-7}"#),
        ("ellipse", r#"{"radii": [0, 3]}"#),
        ("L", r#"{"width": 4, "size": [1, 1]}"#),
        ("L", r#"{"width": 4, "size": [-2, 9]}"#),
        ("C", r#"{"width": 4, "size": [9, 1]}"#),
        ("compass_multi", r#"{"ports": {"n": 1}}"#),
        ("flagpole", r#"{"size": [1, 2]}"#),
        ("tee", r#"{"size": [1, 2], "taper_type": "straight"}"#),
        ("polygon_ports", r#"{"xpts": [0, 4, 1], "ypts": [0, 1]}"#),
        ("polygon_ports", r#"{"xpts": [0, 1, 2], "ypts": [0, 0, 0]}"#),
        ("hecken_taper", r#"{"width2": 3}"#),
        ("hecken_taper", r#"{"Z1": 1e12, "Z2": 50}"#),
        ("meander_taper", r#"{"x_taper": [0, 20], "w_taper": [1]}"#),
        ("meander_taper", r#"{"x_taper": [0], "w_taper": [1]}"#),
        ("meander_taper", r#"{"x_taper": [0, 20, 20], "w_taper": [1, 1, 1]}"#),
        ("meander_taper", r#"{"x_taper": [0, 20], "w_taper": [4, 4], "meander_length": 10, "spacing_factor": 0.4}"#),
        ("meander_taper", r#"{"x_taper": [0, 9, 10, 40], "w_taper": [40, 40, 1, 1], "meander_length": 10}"#),
        ("meander_taper", r#"{"x_taper": [0, 1e9], "w_taper": [1, 1]}"#),
        ("grating", r#"{"fill_factor": 1, "partial_etch": true}"#),
        ("grating", r#"{"num_periods": 2000000}"#),
        ("racetrack_gradual", r#"{"width": 6}"#),
        ("optimal_hairpin", r#"{"pitch": 0.2}"#),
        ("optimal_hairpin", r#"{"length": 0.1}"#),
        ("optimal_hairpin", r#"{"width": 1e-6, "pitch": 100, "length": 1000}"#),
        ("optimal_step", r#"{"start_width": 10, "end_width": 10.0000001}"#),
        ("snspd", r#"{"num_squares": 3}"#),
        ("snspd", r#"{"size": [10, 0.5]}"#),
        ("snspd", r#"{"size": [1, 1.3]}"#),
        ("snspd_candelabra", r#"{"wire_pitch": 0.5}"#),
        ("snspd_candelabra", r#"{"haxis": 10}"#),
        ("snspd_candelabra", r#"{"wire_width": 1, "wire_pitch": 2.91, "haxis": 36.87, "vaxis": 32}"#),
        ("ytron_round", r#"{"source_length": 0.01, "theta": 60}"#),
        ("ytron_round", r#"{"arm_widths": [1, 1], "theta": 80, "rho": 50, "arm_lengths": [120, 120]}"#),
        ("litho_steps", r#"{"line_widths": []}"#),
        ("litho_ruler", r#"{"scale": []}"#),
        ("litho_ruler", r#"{"scale": [3, 0]}"#),
        ("litho_ruler", r#"{"height": 0}"#),
        ("test_comb", r#"{"wire_width": 21}"#),
        ("test_comb", r#"{"pad_size": [800, 20], "wire_gap": 15}"#),
        ("test_comb", r#"{"wire_width": 1e-6, "wire_gap": 1e-6}"#),
        ("test_ic", r#"{"wire_widths": []}"#),
        ("test_ic", r#"{"wire_widths": [1, 2], "wire_widths_wide": [3]}"#),
        ("test_ic", r#"{"wire_widths": [1, 2], "wire_widths_wide": [3, 1.5]}"#),
        ("test_res", r#"{"width": 51}"#),
        ("test_res", r#"{"width": 1e-6}"#),
        ("test_res", r#"{"pad_size": [20, 20], "num_squares": 2, "width": 8}"#),
        ("basic_die", r#"{"street_length": 10}"#),
        ("basic_die", r#"{"text_size": 0}"#),
        ("text", r#"{"text": "ö"}"#),
        ("text", r#"{"size": 0}"#),
        ("text", r#"{"tolerance": 1e-9}"#),
    ]);
    expect![[r#"
        ring: width is 3 µm, but it must be at most twice the radius, 2 µm
        ring: number of points is 33554432, but it must be at most 16777214
        arc: width is 3 µm, but it must be at most twice the radius, 2 µm
        arc: theta is 0°, but it must not be 0
        in turn: arc: width is 30 µm, but it must be at most twice the radius, 20 µm
        circle: number of points is 16777216, but it must be at most 16777215
        ellipse: radii is 0 × 3 µm, but it must not be 0
        L: the greater of size.width and size.height is 1 µm, but it must be at least half the width, 2 µm
        L: size.width is -2 µm, but it must be greater than minus half the width, -2 µm
        C: size.height is 1 µm, but it must be at least the width, 4 µm
        compass_multi: ports is a map with the side "n", but it must have no sides but N, S, E, W
        flagpole: stub_size.width is 2 µm, but it must be at most size.width, 1 µm
        tee: stub_size.width is 2 µm, but it must be at most size.width, 1 µm
        polygon_ports: number of ypts is 2, but it must be 3, the number of xpts
        polygon_ports: area of the outline is 0 µm², but it must not be 0 µm²
        hecken_taper: Z1 is missing, but it must be given, or width1 instead
        in hecken_taper: microstrip: the impedance is 1000000000000 Ω, but it must be from 0.007519374279779468 Ω (250000 µm wide) to 13606928.754827188 Ω (0.00000025 µm wide)
        meander_taper: number of w_taper is 1, but it must be 2, the number of x_taper
        meander_taper: number of x_taper is 1, but it must be at least 2
        meander_taper: x_taper[2] is 20 µm, but it must be greater than the position before it, 20 µm
        meander_taper: radius of a turn is 1.6 µm, but it must be at least half of the width in it, 2 µm
        meander_taper: distance of rows is 6 µm, but it must be at least half of both widths, 8.95918367346938 µm
        meander_taper: number of rows is 1000000, but it must be at most 100000
        grating: fill_factor is 1, but it must be less than 1, since the rest of a period is etched
        grating: num_periods is 2000000, but it must be at most 1000000
        racetrack_gradual: width is 6 µm, but it must be at most twice the tightest radius, 5.612310241546865 µm
        optimal_hairpin: pitch is 0.2 µm, but it must be greater than width, 0.2 µm
        optimal_hairpin: length is 0.1 µm, but it must be at least that of the turn, 1.480136299833977 µm
        optimal_hairpin: num_pts is 50 at a pitch of 100000000 widths, but it must be smaller, since the inner edge would have more than a million points
        optimal_step: width of the curve at its narrow end is 10.009999999999998 µm, but it must be less than that at its wide end, 9.9900000999 µm
        snspd: number of values among size and num_squares is 3, but it must be two, or num_squares alone
        snspd: number of rows (height / wire_pitch) is 1, but it must be at least 3
        in snspd: optimal_hairpin: length is 0.5 µm, but it must be at least that of the turn, 1.482292958819448 µm
        snspd_candelabra: wire_pitch is 0.5 µm, but it must be greater than wire_width, 0.52 µm
        snspd_candelabra: haxis is 10 µm, but it must be greater than two turns and a step of the rows, 11.810154265221978 µm
        snspd_candelabra: longest row is 18.568421284829522 µm, but it must be greater than the shortest one and a step (a larger haxis or vaxis), 22.959999999999994 µm
        ytron_round: source_length is 0.01 µm, but it must be greater than the depth of the tip, 0.8660254037844387 µm
        ytron_round: arm_widths.left is 1 µm, but it must be greater than what the inner edge takes of it, 82.65188264011901 µm
        litho_steps: line_widths is empty, but it must name at least one width
        litho_ruler: scale is empty, but it must name at least one height
        litho_ruler: scale[1] is 0, but it must not be 0
        litho_ruler: height is 0 µm, but it must not be 0
        test_comb: wire_width is 21 µm, but it must be at most a tenth of pad_size.height, 20 µm
        test_comb: wire_gap is 15 µm, but it must leave room for the fingers of the comb
        test_comb: number of passes of the meander is 30000000, but it must be at most 1000000
        test_ic: wire_widths is empty, but it must name at least one width
        test_ic: number of wire_widths_wide is 1, but it must be 2, the number of wire_widths
        test_ic: wire_widths_wide[1] is 1.5 µm, but it must be at least wire_widths[1], 2 µm
        test_res: width is 51 µm, but it must be at most pad_size.height, 50 µm
        test_res: number of rows is 25000000, but it must be at most 1000000
        test_res: num_squares is 2, but it must suffice for a wire between the pads
        basic_die: street_length is 10 µm, but it must be at least street_width, 100 µm
        in basic_die: text: size is 0 µm, but it must not be 0
        text: the character 'ö' (U+00F6) is not in DEPLOF, which has space, "!" to "~", and "µ"
        text: size is 0 µm, but it must not be 0
        text: tolerance is 1e-9 µm, but it must be at least 10⁻⁸ of the size, 1e-7 µm
    "#]].assert_eq(&lines);
}

#[test]
fn refusals_of_shapes_that_take_devices() {
    let lines = refusals(&[
        ("grid", r#"{"device_list": []}"#),
        ("grid", r#"{"device_list": [[{"device": "circle"}, null], [null]]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}, {"device": "circle"}], "shape": [0, 2]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}, {"device": "circle"}], "shape": [1, 1]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}], "shape": [1000000, 1000000]}"#),
        ("gridsweep", r#"{"function": {"device": "circle"}, "param_x": {"radius": [1]}, "param_y": {"radius": [2]}}"#),
        ("gridsweep", r#"{"function": {"device": "circle"}, "param_x": {"radius": []}, "param_y": null}"#),
        (
            "gridsweep",
            r#"{"function": {"device": "circle"}, "param_x": [["radius", [1]], ["radius", [2]]], "param_y": null}"#,
        ),
        ("gridsweep", r#"{"function": {"device": "circle"}, "param_x": 0, "param_y": null}"#),
        ("gridsweep", r#"{"function": {"device": "circle"}, "param_x": 100000, "param_y": 100}"#),
        ("packer", r#"{"D_list": [{"device": "connector"}]}"#),
        ("packer", r#"{"D_list": [{"device": "circle"}], "max_size": [10, 10]}"#),
        ("fill_rectangle", r#"{"D": {"device": "connector"}}"#),
        ("fill_rectangle", r#"{"D": {"device": "circle"}, "fill_densities": [0.5]}"#),
        ("fill_rectangle", r#"{"D": {"device": "circle"}, "fill_inverted": [true]}"#),
        (
            "fill_rectangle",
            r#"{"D": {"device": "circle"}, "fill_layers": [1], "fill_densities": [1], "fill_inverted": [true]}"#,
        ),
        ("fill_rectangle", r#"{"D": {"device": "circle"}, "fill_size": [1e-6, 1e-6]}"#),
        ("fill_rectangle", r#"{"D": {"device": "circle"}, "cell": {"device": "circle"}, "fill_size": [5, 5]}"#),
        ("union", r#"{"D": {"device": "circle"}, "join_first": false}"#),
        ("kl_offset", r#"{"elements": {"device": "circle"}, "merge_after": false}"#),
        ("kl_invert", r#"{"elements": {"device": "circle"}, "tile_size": [0, 1]}"#),
        ("boolean", r#"{"A": {"device": "circle"}, "B": {"device": "circle"}, "operation": "minus"}"#),
        (
            "boolean",
            r#"{"A": {"device": "circle"}, "B": {"device": "circle"}, "operation": "or", "num_divisions": [0, 1]}"#,
        ),
    ]);
    expect![[r#"
        grid: device_list is empty, but it must hold at least one cell
        grid: number of cells in device_list[1] is 1, but it must be 2, as in device_list[0]
        grid: shape is (0, 2), but it must be two numbers from 1 on, one of which may be -1 for as many as are needed
        grid: shape is (1, 1), but it must have from 2 to 1000000 positions
        grid: shape is (1000000, 1000000), but it must have from 1 to 1000000 positions
        gridsweep: param_x is a sweep of "radius", but it must not sweep a parameter of param_y
        gridsweep: param_x["radius"] is empty, but it must have at least one value
        gridsweep: param_x["radius"] is given twice, but it must be given once
        gridsweep: param_x is 0, but it must be at least 1
        gridsweep: number of cells is 10000000, but it must be at most 100000
        packer: D_list[0] is "connector", which is empty, but it must draw something to be packed
        packer: D_list[0] is 20 × 20 µm large, but it must fit into max_size with half of spacing around it
        fill_rectangle: there is nothing to fill: bbox is not given and the device is empty
        fill_rectangle: number of fill_densities is 1, but it must be 3, one for each fill layer
        fill_rectangle: number of fill_inverted is 1, but it must be 3, one for each fill layer
        fill_rectangle: fill_densities[0] is 1, but it must be less than 1, since the layer is inverted
        fill_rectangle: fill_size is 0.000001 × 0.000001 µm, but it must give at most 16777216 cells in the box, (-10, -10) to (10, 10)
        fill_rectangle: cell is 20 × 20 µm large, but it must draw something and fit into fill_size, 5 × 5 µm
        union: join_first is false, but it must be true, because a union joins all shapes at once
        kl_offset: merge_after is false, but it must be true, because results are always merged
        kl_invert: tile_size is 0, but it must be greater than zero and finite
        boolean: operation is "minus", but it must be one of or, A+B, and, A&B, not, A-B, B-A, xor, A^B
        boolean: num_divisions is [0, 1], but it must be at least 1
    "#]].assert_eq(&lines);
}

/// Parameter types that are not only numbers say what they take.
#[test]
fn refusals_of_parameter_values() {
    let lines = refusals(&[
        ("bbox", r#"{"bbox": [[0, 0]]}"#),
        ("basic_die", r#"{"text_location": "middle"}"#),
        ("snspd", r#"{"size": [1]}"#),
        ("snspd_candelabra", r#"{"equalize_path_lengths": "all"}"#),
        ("ytron_round", r#"{"arm_widths": [1, 2, 3]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}, [{"device": "circle"}]]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}], "spacing": [1, 2, 3]}"#),
        ("grid", r#"{"device_list": [{"device": "circle"}], "shape": [1]}"#),
        ("gridsweep", r#"{"function": {"device": "circle"}, "param_x": [1, 2]}"#),
        ("fill_rectangle", r#"{"D": {"device": "circle"}, "avoid_layers": "some"}"#),
        ("kl_offset", r#"{"elements": {"device": "circle"}, "num_cpu": "most"}"#),
        ("boolean", r#"{"A": 3, "B": null, "operation": "or"}"#),
        ("boolean", r#"{"A": null, "B": null, "operation": "or", "num_divisions": [1]}"#),
    ]);
    expect![[r#"
        bbox: bbox is [[0, 0]], but it must be two points
        basic_die: text_location is "middle", but it must be one of N, NE, E, SE, S, SW, W, NW, C
        snspd: size is [1], but it must be a width and a height, null for an open one
        snspd_candelabra: equalize_path_lengths is "all", but it must be true, false or a number from 0 to 1
        ytron_round: arm_widths is [1, 2, 3], but it must be two numbers, left and right
        grid: device_list[0] is {device: "circle"}, but it must be a list of device or none
        grid: spacing is [1, 2, 3], but it must be one number, or one for x and one for y
        grid: shape is [1], but it must be a number of columns and a number of rows
        gridsweep: param_x is 1, but it must be a parameter's name and the list of its values
        fill_rectangle: avoid_layers is "some", but it must be "all" or layers
        kl_offset: num_cpu is "most", but it must be a number of threads or "all"
        boolean: A is 3, but it must be a device, {"device": NAME, "params": {…}}
        boolean: num_divisions is [1], but it must be one or two counts
    "#]]
    .assert_eq(&lines);
}

#[test]
fn refusals_of_microstrips() {
    let mut lines = String::new();
    for (thickness, eps_r, lk) in [(0.0, 2.0, 0.0), (1.0, 0.5, 0.0), (1.0, 2.0, -1e-12)] {
        writeln!(lines, "{}", pg::Microstrip::new(thickness, eps_r, lk).unwrap_err()).unwrap();
    }
    let line = pg::Microstrip::new(0.25, 2.0, 250e-12).unwrap();
    writeln!(lines, "{}", line.width_for(1e9).unwrap_err()).unwrap();
    expect![[r#"
        microstrip: thickness of the dielectric is 0 µm, but it must be greater than 0 µm
        microstrip: eps_r is 0.5, but it must be at least 1
        microstrip: Lk_per_sq is -1e-12 H/sq, but it must be at least 0 H/sq
        microstrip: the impedance is 1000000000 Ω, but it must be from 0.007519374279779468 Ω (250000 µm wide) to 13606928.754827188 Ω (0.00000025 µm wide)
    "#]].assert_eq(&lines);
}
