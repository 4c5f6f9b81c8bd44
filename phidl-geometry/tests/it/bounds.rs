//! Every shape stays within the box that its parameters promise: formulas written down here from the descriptions, not
//! from the code, and tried over the whole parameter domain.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use phidl_core::param::Param;
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::{GeneratorInfo, ParamValues};
use phidl_geometry as pg;
use proptest::prelude::*;
use testkit::domain::{params, search};

/// How far a drawing may leave its box, in parts of the box and its distance from the origin.
const NOISE: f64 = 1e-9;

/// What is known of the box of a drawing.
enum Formula {
    /// It is this one.
    Is(Rect),
    /// It is somewhere in this one.
    Within(Rect),
    /// Nothing is drawn.
    Empty,
}

use Formula::{Empty, Is, Within};

/// All parameters of a drawing.
struct Given(ParamValues);

impl Given {
    fn value(&self, name: &str) -> &Value {
        let found = self.0.iter().find(|(known, _)| *known == name);
        &found.unwrap_or_else(|| panic!("no parameter {name}")).1
    }

    fn number(&self, name: &str) -> f64 {
        self.maybe(name).unwrap_or_else(|| panic!("{name} is no number"))
    }

    fn maybe(&self, name: &str) -> Option<f64> {
        self.value(name).as_f64()
    }

    fn numbers(&self, name: &str) -> Vec<f64> {
        self.value(name).as_list().expect("a list").iter().filter_map(Value::as_f64).collect()
    }

    /// A size or a point.
    fn pair(&self, name: &str) -> (f64, f64) {
        let both = self.numbers(name);
        (both[0], both[1])
    }

    fn word(&self, name: &str) -> &str {
        self.value(name).as_str().unwrap_or_default()
    }

    fn is(&self, name: &str) -> bool {
        *self.value(name) == Value::Bool(true)
    }

    /// Whether no layer is left out.
    fn draws_all(&self) -> bool {
        !self.0.iter().any(|(name, value)| name.contains("layer") && *value == Value::Null)
    }

    fn port(&self, name: &str) -> Option<Port> {
        Port::from_value(self.value(name)).ok()
    }
}

/// The box around some points.
fn around<const N: usize>(points: [(f64, f64); N]) -> Rect {
    Rect::around(points.map(Point::from)).expect("some points")
}

/// The box of this half width and half height around the origin.
fn centered(x: f64, y: f64) -> Rect {
    around([(-x, -y), (x, y)])
}

/// The box of everything that is at most so far from a point.
fn disc(center: Point, radius: f64) -> Rect {
    Rect::new(center, center).grown(radius)
}

/// The largest of some numbers.
fn most(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(0.0, f64::max)
}

/// Width of the longest line of DEPLOF letters and the number of lines: no letter takes more than 1.1 sizes.
fn lettering(text: &str, size: f64) -> (f64, f64) {
    let longest = text.split('\n').map(|line| line.chars().count()).max().unwrap_or(0);
    (1.1 * size.abs() * longest as f64, text.split('\n').count() as f64)
}

/// The box of a shape with these parameters; none if there is no formula for it here.
fn formula(name: &str, p: &Given, drawn: &Device) -> Option<Formula> {
    Some(match name {
        "connector" => Empty,
        "rectangle" | "straight" => Is(around([(0.0, 0.0), p.pair("size")])),
        "bbox" => bbox(p),
        "compass" | "compass_multi" => Is(centered(p.pair("size").0 / 2.0, p.pair("size").1 / 2.0)),
        "cross" => {
            let reach = p.number("length").abs().max(p.number("width").abs()) / 2.0;
            Is(centered(reach, reach))
        }
        "circle" => Within(disc(Point::ORIGIN, p.number("radius").abs())),
        "ellipse" => Within(centered(p.pair("radii").0, p.pair("radii").1)),
        "ring" | "arc" => Within(disc(Point::ORIGIN, p.number("radius") + p.number("width") / 2.0)),
        "turn" => turn(p),
        "L" | "C" => letter(p, name == "C"),
        "flagpole" | "tee" => pad_with_stub(p, name == "tee"),
        "taper" | "ramp" => taper(p),
        "hecken_taper" => {
            let widest = most(&drawn.ports().map(Port::width).collect::<Vec<_>>());
            Within(around([(0.0, -widest / 2.0), (p.number("length"), widest / 2.0)]))
        }
        "meander_taper" => meander_taper(p),
        "polygon_ports" => {
            let (x, y) = (p.numbers("xpts"), p.numbers("ypts"));
            Rect::around(x.into_iter().zip(y).map(Point::from)).map_or(Empty, Is)
        }
        "litho_steps" => litho_steps(p),
        "litho_star" => Within(disc(Point::ORIGIN, p.number("line_width").hypot(p.number("diameter")) / 2.0)),
        "litho_calipers" => litho_calipers(p),
        "litho_ruler" => litho_ruler(p),
        "basic_die" => basic_die(p),
        "text" => text(p),
        "preview_layerset" => preview_layerset(p),
        "grating" => grating(p),
        "racetrack_gradual" => {
            let half = p.number("width") / 2.0;
            Within(around([(-half, -half), (p.number("R") + half, p.number("R") + half)]))
        }
        "optimal_hairpin" => {
            let start = drawn.port("1").expect("a port").midpoint().x;
            let high = (p.number("pitch") + p.number("width")) / 2.0;
            Is(around([(start, -high), (start + p.number("length"), high)]))
        }
        "optimal_step" => {
            let [start, end] = ["1", "2"].map(|port| drawn.port(port).expect("a port").midpoint().x);
            let wide = p.number("start_width").max(p.number("end_width"));
            let low = if p.is("symmetric") { -wide / 2.0 } else { 0.0 };
            Is(around([(start, low), (end, low + wide)]))
        }
        "optimal_90deg" => {
            // asinh(10^a) is where the leads end.
            let lead = (10_f64.powf(p.number("length_adjust"))).asinh() / FRAC_PI_2;
            let far = 2.0 * p.number("width") * (1.0 + lead);
            Is(around([(0.0, 0.0), (far, far)]))
        }
        "snspd" | "snspd_expanded" => meander(p, drawn, name == "snspd_expanded"),
        "snspd_candelabra" => candelabra(p),
        "ytron_round" => ytron(p),
        "test_via" => test_via(p),
        "test_comb" => test_comb(p),
        "test_ic" => test_ic(p),
        "test_res" => {
            // Too few squares for a meander over the whole height are more in the drawing.
            let squares = drawn.info()["num_squares"].as_f64().expect("a number");
            let ((x, y), length) = (p.pair("pad_size"), p.number("width") * squares);
            Within(around([(-x - p.number("width"), 0.0), (length + p.number("width") + x, y)]))
        }
        _ => return None,
    })
}

fn bbox(p: &Given) -> Formula {
    let corners: Vec<Point> = p.value("bbox").as_list().expect("two corners").iter().map(point).collect();
    Is(Rect::around(corners).expect("two corners"))
}

fn point(value: &Value) -> Point {
    let coordinates: Vec<f64> = value.as_list().expect("a point").iter().filter_map(Value::as_f64).collect();
    Point::new(coordinates[0], coordinates[1])
}

/// Nothing on a circle that goes through a point is farther from it than the diameter.
fn turn(p: &Given) -> Formula {
    let port = p.port("port").expect("a port");
    Within(disc(port.midpoint(), 2.0 * p.number("radius") + port.width()))
}

fn letter(p: &Given, closed: bool) -> Formula {
    let (h, (x, y)) = (p.number("width") / 2.0, p.pair("size"));
    let top = if closed { [y - h, y + h] } else { [y, y] };
    Is(around([(-h, -h), (h, h), (x, h), (x, top[0]), (-h, top[1])]))
}

fn pad_with_stub(p: &Given, tee: bool) -> Formula {
    let ((f, g), (s, t)) = (p.pair("size"), p.pair("stub_size"));
    if tee {
        return Is(around([(-f / 2.0, g), (f / 2.0, 0.0), (-s / 2.0, 0.0), (s / 2.0, -t)]));
    }
    let right = if matches!(p.word("shape"), "p" | "b") { 1.0 } else { -1.0 };
    let up = if matches!(p.word("shape"), "p" | "q") { 1.0 } else { -1.0 };
    Is(around([(0.0, 0.0), (right * f, up * g), (right * s, -up * t)]))
}

/// A ramp stands on the x axis, a taper around it, and perhaps on a port.
fn taper(p: &Given) -> Formula {
    let port = p.0.iter().any(|(name, _)| *name == "port").then(|| p.port("port")).flatten();
    let start = p.maybe("width1").or(port.as_ref().map(Port::width)).unwrap_or(5.0);
    let (length, widest) = (p.number("length"), start.max(p.maybe("width2").unwrap_or(start)));
    match port {
        Some(port) => Within(disc(port.midpoint(), length.hypot(widest / 2.0))),
        None if p.0.iter().any(|(name, _)| *name == "port") => {
            Is(around([(0.0, -widest / 2.0), (length, widest / 2.0)]))
        }
        None => Is(around([(0.0, 0.0), (length, widest)])),
    }
}

/// Nothing is farther away than the line is long. The last turn goes all the way round, and with straight sections the
/// last row is drawn in full.
fn meander_taper(p: &Given) -> Formula {
    let x = p.numbers("x_taper");
    let length = x.last().unwrap_or(&0.0) - x.first().unwrap_or(&0.0);
    let last_row = if p.is("straight_sections") { p.number("meander_length") } else { 0.0 };
    let widest = most(&p.numbers("w_taper"));
    let last_turn = PI * (p.number("spacing_factor") * widest).max(p.number("min_spacing"));
    Within(disc(Point::ORIGIN, length + last_turn + last_row + widest))
}

/// The name of the widest line stands upright on the left.
fn litho_steps(p: &Given) -> Formula {
    let (widths, spacing, half) = (p.numbers("line_widths"), p.number("line_spacing"), p.number("height") / 2.0);
    let right = widths.iter().map(|width| width + spacing).sum::<f64>() + spacing;
    let Some(last) = widths.last() else { return Empty };
    let up = (lettering(&format!("{last:?}"), half).0 / 2.0).max(half);
    Within(around([(-1.3 * half, -up), (right, up)]))
}

fn litho_calipers(p: &Given) -> Formula {
    let ((x, y), spacing, notches) = (p.pair("notch_size"), p.number("notch_spacing"), p.number("num_notches"));
    let (last, reach) = (2.0 * notches * (x + spacing), p.number("offset_per_notch") * notches);
    let lower = -p.number("row_spacing");
    Is(around([
        (0.0, 0.0),
        (last + x, y),
        (notches * (x + spacing), 2.0 * y),
        (notches * (x + spacing) + x, lower - 2.0 * y),
        (reach, lower),
        (last - reach, lower - y),
        (reach + x, lower),
        (last - reach + x, lower),
    ]))
}

fn litho_ruler(p: &Given) -> Formula {
    let marks = p.number("num_marks");
    let heights: Vec<f64> = p.numbers("scale").into_iter().map(|scale| scale * p.number("height")).collect();
    if marks == 0.0 || p.value("layer") == &Value::Null {
        return Empty;
    }
    let [first, last] = [0.0, marks - 1.0].map(|mark| mark * p.number("spacing"));
    let low = heights.iter().copied().fold(0.0, f64::min);
    Within(around([
        (first, low),
        (first + p.number("width"), most(&heights)),
        (last, 0.0),
        (last + p.number("width"), 0.0),
    ]))
}

/// A name that is longer than the die, or at a place of its own, may stick out.
fn basic_die(p: &Given) -> Formula {
    let ((x, y), marks) = (p.pair("size"), p.number("street_width").max(p.number("street_length")));
    let (long, _) = lettering(p.word("die_name"), p.number("text_size"));
    let place = p.value("text_location").as_list().map_or(Point::ORIGIN, |_| point(p.value("text_location")));
    let inset = p.number("street_width") + 20.0;
    let reach = |side: f64, at: f64, ink: f64| side / 2.0 + marks.max(inset + ink + at.abs());
    Within(centered(reach(x, place.x, long), reach(y, place.y, 1.5 * p.number("text_size").abs())))
}

fn text(p: &Given) -> Formula {
    let (size, (long, lines)) = (p.number("size"), lettering(p.word("text"), p.number("size")));
    let low = -(1.5 * (lines - 1.0) + 0.3) * size;
    let high = 1.2 * size;
    // A negative size turns the letters about the start of the pen; right and center look at where the ink then is.
    let (left, right) = match p.word("justify") {
        "left" if size < 0.0 => (-long, 0.0),
        "left" => (0.0, long),
        "right" => (-long, 0.0),
        _ => (-long, long),
    };
    // A quotation mark reaches a tenth of the size beyond its advance.
    let beyond = 0.1 * size.abs();
    Within(around([(left - beyond, low), (right + beyond, high)]))
}

/// Squares in rows, as many in a row as there are rows, with two lines of lettering below each.
fn preview_layerset(p: &Given) -> Formula {
    let Value::Map(layers) = p.value("ls") else { return Empty };
    let percent = p.number("size") / 100.0;
    let steps = ((layers.len() as f64).sqrt().ceil() - 1.0).max(0.0) * (100.0 + p.number("spacing")) * percent;
    let name = layers.keys().map(|name| name.len()).max().unwrap_or(0).max("65535 / 65535".len());
    let ink = 1.1 * 20.0 * percent * name as f64;
    Within(around([(50.0 * percent - ink, 100.0 * percent), (50.0 * percent + ink + steps, -60.0 * percent - steps)]))
}

fn grating(p: &Given) -> Formula {
    let (period, width) = (p.number("period"), p.number("width_grating"));
    let (fill, last) = (p.number("fill_factor"), (p.number("num_periods") - 1.0) * period);
    if p.is("partial_etch") {
        let half = period * (1.0 - fill) / 2.0;
        return Within(around([(-half, -width / 2.0 - 5.0), (last + half, width / 2.0 + 5.0)]));
    }
    let (half, high) = (period * fill / 2.0, width.max(p.number("width")) / 2.0);
    Is(around([(-half, -high), (last + half + p.number("length_taper"), high)]))
}

/// The rows, from the first terminal down; what widens the wire at the terminals starts there.
fn meander(p: &Given, drawn: &Device, expanded: bool) -> Formula {
    let (width, pitch) = (p.number("wire_width"), p.number("wire_pitch"));
    let info = drawn.info().get("size").and_then(Value::as_list).expect("a size");
    let (x, y) = (info[0].as_f64().expect("a width"), info[1].as_f64().expect("a height"));
    // A row is added for what the division leaves, another for where the terminals are.
    let rows = around([(-x / 4.0, width / 2.0), (0.75 * x, -y - pitch - width / 2.0)]);
    if !expanded {
        return Within(rows);
    }
    let connector = p.number("connector_width");
    let ends = drawn.ports().map(|port| disc(port.midpoint(), connector / 2.0));
    Within(ends.fold(rows.grown(connector), Rect::union))
}

/// The turns stand out by the bends and the pin; each equalized row adds what it is shorter than the longest.
fn candelabra(p: &Given) -> Formula {
    let (width, across) = (p.number("wire_width"), p.number("haxis"));
    let aimed = p.number("vaxis") + 30.0 * (width + p.number("wire_pitch"));
    let pins = if p.is("xwing") { 15.0 * FRAC_1_SQRT_2 } else { 8.0 } * width;
    let longer = p.maybe("equalize_path_lengths").unwrap_or(1.0) * across;
    Within(centered(across / 2.0 + 8.0 * width + longer, aimed + pins + across + longer))
}

fn ytron(p: &Given) -> Formula {
    let ((left, right), (w0, w1)) = (p.pair("arm_lengths"), p.pair("arm_widths"));
    let (sin, cos) = p.number("theta").to_radians().sin_cos();
    let (tip, source) = (Point::new(cos, sin) * p.number("rho"), p.number("source_length"));
    Within(around([
        (-tip.x - w0, tip.y - source),
        (tip.x + w1, tip.y - source),
        (-tip.x - left * sin - w0, tip.y + left * cos),
        (tip.x + right * sin + w1, tip.y + right * cos),
        (0.0, p.number("rho") - tip.y),
        (0.0, 0.0),
    ]))
}

/// The chain goes on from the first pad in whatever direction, and ends in the second.
fn test_via(p: &Given) -> Formula {
    let ((x, y), wire) = (p.pair("pad_size"), p.number("wire_width"));
    let links = p.number("num_vias") * (p.number("via_spacing") + wire + p.number("via_width"));
    let reach = links + 12.0 * wire + p.number("via_spacing") + p.number("min_pad_spacing");
    Within(around([(0.0, -reach - 5.0), (2.0 * x + reach, y + reach)]).grown(reach))
}

/// Three pads wide and three high; wires that are far apart for the pads run out of them by a link at most.
fn test_comb(p: &Given) -> Formula {
    let ((x, y), wire) = (p.pair("pad_size"), p.number("wire_width"));
    let link = 4.0 * wire + 2.0 * p.number("wire_gap");
    Within(around([(-link, -0.9 * y - link), (2.7 * x + 0.4 * y + link, 1.8 * y + link)]))
}

/// The narrow places are as long as their steps, which may be more than the gap of the pads.
fn test_ic(p: &Given) -> Formula {
    let ((x, y), wide) = (p.pair("pad_size"), p.numbers("wire_widths_wide"));
    let steps = p.numbers("wire_widths").into_iter().zip(&wide).map(|(narrow, wide)| {
        let step = pg::OptimalStepParams::default().start_width(wide / 2.0).end_width(narrow / 2.0).build();
        step.map_or(0.0, |step| step.xsize())
    });
    let longest = steps.fold(0.0, f64::max);
    let (gap, lead) = (p.number("pad_gap"), most(&wide) / 2.0);
    let high = (gap / 2.0).max(longest);
    let middle = y + gap / 2.0;
    let width = 1.2 * x * wide.len() as f64;
    Within(around([(0.0, 0.0), (width, 2.0 * y + gap), (x / 2.0 - lead, middle - high), (width + lead, middle + high)]))
}

/// Draws a shape with random parameters and looks at its box.
fn try_everywhere(entry: &'static GeneratorInfo) {
    let mut runner = search(64);
    let values = params(entry).expect("only shapes with such parameters are taken");
    let outcome = runner.run(&values, |params| {
        let (Ok(device), Ok(record)) = (entry.build(&params), entry.record(&params)) else { return Ok(()) };
        let given = Given(record);
        let formula = formula(entry.name, &given, &device).expect("every shape has a formula");
        let Some(drawn) = device.bbox() else { return Ok(()) };
        let scale = 1.0 + drawn.min.norm().max(drawn.max.norm());
        let near = |a: Point, b: Point| a.distance(b) <= NOISE * scale;
        match formula {
            Empty => prop_assert!(false, "{drawn:?}, expected nothing"),
            Is(rect) if given.draws_all() => {
                prop_assert!(near(drawn.min, rect.min) && near(drawn.max, rect.max), "{drawn:?}, not {rect:?}")
            }
            Is(rect) | Within(rect) => {
                let room = rect.grown(NOISE * scale);
                prop_assert!(room.contains(drawn.min) && room.contains(drawn.max), "{drawn:?} leaves {rect:?}");
            }
        }
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{}: {failure}", entry.name);
    }
}

#[test]
fn every_shape_stays_within_its_bounding_formula() {
    let shapes = registry::all().filter(|entry| entry.module.starts_with("phidl_geometry") && params(entry).is_some());
    shapes.for_each(try_everywhere);
}
