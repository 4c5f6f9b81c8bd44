//! Every shape stays within the box that its parameters promise. The formulas follow from the documentation of the shapes
//! and the published curves, never from a drawing or its info, and are tried over the whole parameter domain.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use num_complex::Complex64;
use phidl_core::param::Param;
use phidl_core::prelude::*;
use phidl_core::runtime::{GeneratorInfo, ParamValues};
use phidl_geometry as pg;
use proptest::prelude::*;

use crate::random::{for_every_drawing, shapes};

/// How far a drawing may leave its box, in parts of the box and its distance from the origin.
const NOISE: f64 = 1e-9;

/// What is known of the box of a drawing.
enum Formula {
    /// It is this one.
    Is(Rect),
    /// It is somewhere in this one.
    Within(Rect),
    /// It contains the first one and lies in the second one.
    Between(Rect, Rect),
    /// Nothing is drawn.
    Empty,
}

use Formula::{Between, Empty, Is, Within};

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

    fn text(&self, name: &str) -> &str {
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
fn formula(name: &str, p: &Given) -> Option<Formula> {
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
        "hecken_taper" => hecken_taper(p),
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
        "optimal_hairpin" => optimal_hairpin(p),
        "optimal_step" => optimal_step(p),
        "optimal_90deg" => {
            // asinh(10^a) is where the leads end.
            let lead = (10_f64.powf(p.number("length_adjust"))).asinh() / FRAC_PI_2;
            let far = 2.0 * p.number("width") * (1.0 + lead);
            Is(around([(0.0, 0.0), (far, far)]))
        }
        "snspd" | "snspd_expanded" => snspd(p, name == "snspd_expanded"),
        "snspd_candelabra" => candelabra(p),
        "ytron_round" => ytron(p),
        "test_via" => test_via(p),
        "test_comb" => test_comb(p),
        "test_ic" => test_ic(p),
        "test_res" => {
            // A row has one square at least, and no more than the whole wire.
            let ((x, y), width) = (p.pair("pad_size"), p.number("width"));
            let row = width * p.number("num_squares").max(1.0);
            Within(around([(-x - width, 0.0), (row + width + x, y)]))
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
    let right = if matches!(p.text("shape"), "p" | "b") { 1.0 } else { -1.0 };
    let up = if matches!(p.text("shape"), "p" | "q") { 1.0 } else { -1.0 };
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
    let (long, _) = lettering(p.text("die_name"), p.number("text_size"));
    let place = p.value("text_location").as_list().map_or(Point::ORIGIN, |_| point(p.value("text_location")));
    let inset = p.number("street_width") + 20.0;
    let reach = |side: f64, at: f64, ink: f64| side / 2.0 + marks.max(inset + ink + at.abs());
    Within(centered(reach(x, place.x, long), reach(y, place.y, 1.5 * p.number("text_size").abs())))
}

fn text(p: &Given) -> Formula {
    let (size, (long, lines)) = (p.number("size"), lettering(p.text("text"), p.number("size")));
    let low = -(1.5 * (lines - 1.0) + 0.3) * size;
    let high = 1.2 * size;
    // A negative size turns the letters about the start of the pen; right and center look at where the ink then is.
    let (left, right) = match p.text("justify") {
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

/// The width of the strip with an impedance, by bisection: the impedance falls with the width.
fn strip_width(line: &pg::Microstrip, impedance: f64, thickness: f64) -> f64 {
    let (mut low, mut high) = ((1e-6 * thickness).ln(), (1e6 * thickness).ln());
    for _ in 0..100 {
        let middle = (low + high) / 2.0;
        *(if line.impedance(middle.exp()) > impedance { &mut low } else { &mut high }) = middle;
    }
    low.exp()
}

/// Impedances, and so widths, change monotonically from one end to the other.
fn hecken_taper(p: &Given) -> Formula {
    let thickness = p.number("dielectric_thickness");
    let line = pg::Microstrip::new(thickness, p.number("eps_r"), p.number("Lk_per_sq")).expect("a line");
    let end = |width: &str, impedance: &str| {
        p.maybe(width).unwrap_or_else(|| strip_width(&line, p.number(impedance), thickness))
    };
    let widest = end("width1", "Z1").max(end("width2", "Z2"));
    let box_of = |widest: f64| around([(0.0, -widest / 2.0), (p.number("length"), widest / 2.0)]);
    // Widths are exact to 1e-12 of themselves; impedances lose a few digits at either end of the range.
    Between(box_of(widest * (1.0 - 1e-8)), box_of(widest * (1.0 + 1e-8)))
}

/// `length` and `pitch + width` large. The inner edge is a streamline of `dz/dt = √(1 − exp(π z / h))` with
/// `h = (pitch + width) / 2`; along it the imaginary part of `atanh √(1 − exp(π z / h))` is constant. From far in the lead
/// at `−(pitch − width) / 2` it meets the axis where `exp(π x / h) = 1 + tan²(π (pitch − width) / (4 h))`.
fn optimal_hairpin(p: &Given) -> Formula {
    let (width, pitch, length) = (p.number("width"), p.number("pitch"), p.number("length"));
    let h = (pitch + width) / 2.0;
    let tip = h / PI * (PI * (pitch - width) / (4.0 * h)).tan().powi(2).ln_1p();
    // The edge is integrated in steps of `width / (2 num_pts)` whose direction is only nearly normalized: for a pitch of many
    // widths it reaches the axis earlier, and the last step may cross the axis.
    let (shortest, longest) = (TIP_REACHED * tip, tip + width * (0.05 + 1.0 / p.number("num_pts")));
    let box_of = |right: f64, left: f64| around([(left, -h), (right, h)]);
    let ends = |tip: f64| (tip + p.number("turn_ratio") * width, tip + p.number("turn_ratio") * width - length);
    let ((near, _), (far, _)) = (ends(shortest), ends(longest));
    Between(box_of(near, far - length), box_of(far, near - length))
}

/// Smallest part of the exact distance of the tip that a hairpin's inner edge reaches, for a pitch of up to 10,000 widths.
const TIP_REACHED: f64 = 0.3;

/// From the start to the end of the published curve, each with half to one and a half of the tolerance: that is how well the
/// search for an end must hit its width.
fn optimal_step(p: &Given) -> Formula {
    let (start, end) = (p.number("start_width"), p.number("end_width"));
    let low = if p.is("symmetric") { -start.max(end) / 2.0 } else { 0.0 };
    let high = low + start.max(end);
    if start == end {
        return Is(around([(0.0, low), (start, high)]));
    }
    let stretch = p.number("anticrowding_factor") / if p.is("symmetric") { 2.0 } else { 1.0 };
    let box_of = |part: f64| {
        let [narrow, wide] = step_ends(start.min(end), start.max(end), part * p.number("width_tol"));
        let [narrow, wide] = [narrow * stretch, wide * stretch];
        if start < end { around([(narrow, low), (wide, high)]) } else { around([(-wide, low), (-narrow, high)]) }
    };
    // With a large tolerance, one and a half of it is no width at all.
    if p.number("width_tol") < 0.1 { Between(box_of(1.5), box_of(0.5)) } else { Within(box_of(0.5)) }
}

/// x on the edge of a step where it is `1 + tolerance` narrow widths, and `1 − tolerance` wide widths high: the conformal map
/// of Clem and Berggren, inverted by bisection.
fn step_ends(narrow: f64, wide: f64, tolerance: f64) -> [f64; 2] {
    let gamma = (wide * wide + narrow * narrow) / (wide * wide - narrow * narrow);
    let at = |eta: f64| {
        let omega = Complex64::from_polar(1.0, eta);
        let lower = ((omega - gamma) / (gamma + 1.0)).sqrt().atan() * narrow;
        let upper = ((gamma - 1.0) / (omega - gamma)).sqrt().atan() * wide;
        Complex64::i() * (4.0 / PI) * (lower + upper)
    };
    [narrow * (1.0 + tolerance), wide * (1.0 - tolerance)].map(|height| {
        // The wide end is at 0, the narrow one at π.
        let (mut wider, mut narrower) = (0.0_f64, PI);
        for _ in 0..200 {
            let middle = (wider + narrower) / 2.0;
            *(if at(middle).im > height { &mut wider } else { &mut narrower }) = middle;
        }
        at(wider.midpoint(narrower)).re
    })
}

/// Length along x of a step with the default tolerance.
fn step_length(a: f64, b: f64, stretch: f64) -> f64 {
    if a == b {
        return a;
    }
    let [start, end] = step_ends(a.min(b), a.max(b), 0.5e-3);
    stretch * (end - start)
}

/// The rows, from the first terminal down; what widens the wire at the terminals starts there.
fn snspd(p: &Given, expanded: bool) -> Formula {
    let (width, pitch) = (p.number("wire_width"), p.number("wire_pitch"));
    let size = p.value("size").as_list().map(|size| [size[0].as_f64(), size[1].as_f64()]).unwrap_or_default();
    // A square of the wire takes its width times its pitch.
    let area = p.maybe("num_squares").map(|squares| squares * width * pitch);
    let (x, y) = match (size, area) {
        ([Some(x), Some(y)], _) => (x, y),
        ([Some(x), None], Some(area)) => (x, area / x),
        ([None, Some(y)], Some(area)) => (area / y, y),
        (_, area) => (area.unwrap_or_default().sqrt(), area.unwrap_or_default().sqrt()),
    };
    // A row is added for what the division leaves, another for where the terminals are.
    let rows = around([(-x / 4.0, width / 2.0), (0.75 * x, -y - pitch - width / 2.0)]);
    if !expanded {
        return Within(rows);
    }
    let connector = p.number("connector_width");
    let step = step_length(width, connector, 2.0) + connector;
    Within(Rect::new(rows.min - Point::new(step, connector), rows.max + Point::new(step, connector)))
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

/// Three pads wide and three high; wires with a large pitch for the pads run out of them by a link at most.
fn test_comb(p: &Given) -> Formula {
    let ((x, y), wire) = (p.pair("pad_size"), p.number("wire_width"));
    let link = 4.0 * wire + 2.0 * p.number("wire_gap");
    Within(around([(-link, -0.9 * y - link), (2.7 * x + 0.4 * y + link, 1.8 * y + link)]))
}

/// The constrictions are as long as their steps, which may be more than the gap of the pads.
fn test_ic(p: &Given) -> Formula {
    let ((x, y), wide) = (p.pair("pad_size"), p.numbers("wire_widths_wide"));
    let narrow = p.numbers("wire_widths");
    let steps = narrow.into_iter().zip(&wide).map(|(narrow, wide)| step_length(narrow / 2.0, wide / 2.0, 1.2));
    let longest = steps.fold(0.0, f64::max);
    let (gap, lead) = (p.number("pad_gap"), most(&wide) / 2.0);
    let high = (gap / 2.0).max(longest);
    let middle = y + gap / 2.0;
    let width = 1.2 * x * wide.len() as f64;
    Within(around([(0.0, 0.0), (width, 2.0 * y + gap), (x / 2.0 - lead, middle - high), (width + lead, middle + high)]))
}

/// Draws a shape with random parameters and looks at its box.
fn try_everywhere(entry: &'static GeneratorInfo) {
    for_every_drawing(entry, 64, |params, device| {
        let given = Given(entry.record(params).expect("parameters that were drawn"));
        let formula = formula(entry.name, &given).expect("every shape has a formula");
        let Some(drawn) = device.bbox() else { return Ok(()) };
        let scale = 1.0 + drawn.min.norm().max(drawn.max.norm());
        let near = |a: Point, b: Point| a.distance(b) <= NOISE * scale;
        let inside = |inner: Rect, outer: Rect| {
            let outer = outer.grown(NOISE * scale);
            outer.contains(inner.min) && outer.contains(inner.max)
        };
        match formula {
            Empty => prop_assert!(false, "{drawn:?}, expected nothing"),
            Is(rect) if given.draws_all() => {
                prop_assert!(near(drawn.min, rect.min) && near(drawn.max, rect.max), "{drawn:?}, not {rect:?}")
            }
            Between(inner, _) if given.draws_all() && !inside(inner, drawn) => {
                prop_assert!(false, "{drawn:?} does not reach {inner:?}");
            }
            Is(rect) | Within(rect) | Between(_, rect) => {
                prop_assert!(inside(drawn, rect), "{drawn:?} leaves {rect:?}");
            }
        }
        Ok(())
    });
}

#[test]
fn every_shape_stays_within_its_bounding_formula() {
    shapes().for_each(try_everywhere);
}
