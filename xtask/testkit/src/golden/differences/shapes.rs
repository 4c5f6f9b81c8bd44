//! Basic and connecting shapes, lithography marks, tapers, text and dies.

use serde_json::json;

use super::params;
use crate::golden::difference::Instead::{Drawn, Ports, Refused, RefusedOrSame, Test, With, Within};
use crate::golden::difference::{Difference, Refusal};
use crate::golden::facts::draws_no_shape;

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["L"],
        condition: "both arms end inside each other, or one behind the other",
        applies: |case| {
            let (width, [x, y]) = (case.number("width"), ["size.0", "size.1"].map(|name| case.number(name)));
            (width > 2.0 * x && y < 0.5 * width) || x <= -0.5 * width || y <= -0.5 * width
        },
        reason: "PHIDL's outline crosses itself",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["C"],
        condition: "arms that overlap, or end behind the upright one",
        applies: |case| {
            let width = case.number("width");
            case.number("size.1") < width || case.number("size.0") <= -0.5 * width
        },
        reason: "PHIDL's outline crosses itself",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["arc"],
        condition: "theta is 0",
        applies: |case| case.number("theta") == 0.0,
        reason: "PHIDL draws a malformed polygon without points",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["ellipse"],
        condition: "a radius is 0",
        applies: |case| case.numbers("radii").contains(&0.0),
        reason: "PHIDL stores a degenerate polygon silently",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["litho_ruler"],
        condition: "height is 0",
        applies: |case| case.number("height") == 0.0,
        reason: "PHIDL stores degenerate polygons silently",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["litho_ruler"],
        condition: "an entry of scale is 0",
        applies: |case| case.numbers("scale").contains(&0.0),
        reason: "PHIDL stores degenerate polygons silently",
        instead: "refused",
        compare: RefusedOrSame(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["polygon_ports"],
        condition: "a list of coordinates is left out",
        applies: |case| !case.gives("xpts") || !case.gives("ypts"),
        reason: "PHIDL's default lists gain a point with every call, so that the drawing depends on earlier calls",
        instead: "the square that the first call draws, in the tests of the shape",
        compare: Test("phidl-geometry, connect::polygon_ports"),
        further: false,
    },
    Difference {
        functions: &["polygon_ports"],
        condition: "the outline encloses no area",
        applies: draws_no_shape,
        reason: "all ports of PHIDL face 0° then",
        instead: "refused",
        compare: RefusedOrSame(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["polygon_ports"],
        condition: "xpts and ypts differ in length",
        applies: |case| case.differ_in_length("xpts", "ypts"),
        reason: "PHIDL drops the surplus of one list or joins it to the first point of the other",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["compass_multi"],
        condition: "ports names a side that a rectangle does not have",
        applies: |case| {
            let sides = case.parameter("ports").and_then(|ports| ports.as_object().cloned());
            sides.is_some_and(|sides| sides.keys().any(|side| !["N", "S", "E", "W"].contains(&side.as_str())))
        },
        reason: "PHIDL ignores such a side silently",
        instead: "refused",
        compare: Refused(Refusal::Choice),
        further: false,
    },
    Difference {
        functions: &["flagpole", "tee"],
        condition: "the pole of a bar with a taper is wider than the bar",
        applies: |case| {
            case.is_one_of("taper_type", &["straight", "fillet"]) && case.exceeds("stub_size.0", 1.0, "size.0")
        },
        reason: "PHIDL's taper of a wider pole overlaps it; a tee consists of two of them",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["flagpole", "tee"],
        condition: "a fillet on several layers or on none",
        applies: |case| {
            let unusual = case.is_several("layer") || case.is_null("layer");
            case.is_one_of("taper_type", &["fillet"]) && unusual && case.is_refused()
        },
        reason: "PHIDL fails with an AttributeError",
        instead: "drawn on each layer as on one",
        compare: Drawn,
        further: false,
    },
    Difference {
        functions: &["basic_die"],
        condition: "text_location is E, W or C, where ours places the name, or an unknown name, which is refused",
        applies: |case| {
            let known = ["NW", "N", "NE", "SW", "S", "SE", "nw", "n", "ne", "sw", "s", "se"];
            !case.is_one_of("text_location", &known) && !case.is_several("text_location")
        },
        reason: "PHIDL ignores an unknown location silently; the name stays at the origin",
        instead: "refused, or the reference's drawing",
        compare: RefusedOrSame(Refusal::Choice),
        further: false,
    },
    Difference {
        functions: &["basic_die"],
        condition: "street_length is less than street_width",
        applies: |case| case.number("street_length") < case.number("street_width"),
        reason: "PHIDL's corner marks cross themselves",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["hecken_taper"],
        condition: "always",
        applies: |case| !case.is_refused(),
        reason: "PHIDL ends the minimum search for the widths early and is off by up to 0.6 %; ours solves for them",
        instead: "areas, box, port widths and info to 2 %; exact widths in the tests of the shape",
        compare: Within(0.02),
        further: true,
    },
    Difference {
        functions: &["meander_taper"],
        condition: "fewer than two positions, or positions that do not rise",
        applies: |case| {
            let positions = case.numbers("x_taper");
            positions.len() < 2 || positions.windows(2).any(|pair| pair[1] <= pair[0])
        },
        reason: "PHIDL interpolates a profile between positions that it does not find, and draws rows of another width",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["meander_taper"],
        condition: "always",
        applies: |_| true,
        reason: "PHIDL draws a straight line instead of the profile inside a row, and the last row past the end",
        instead: "with straight_sections, ours draws what PHIDL does",
        compare: With(|_| params([("straight_sections", json!(true))])),
        further: false,
    },
    Difference {
        functions: &["text"],
        condition: "a character that DEPLOF does not have",
        applies: |case| {
            let text = case.string("text").unwrap_or_default();
            text.chars().any(|c| !matches!(c, ' '..='~' | 'µ' | '\n'))
        },
        reason: "PHIDL leaves out such characters without a space and shifts what follows",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["text"],
        condition: "DEPLOF is written in lower case",
        applies: |case| case.is_one_of("font", &["deplof"]),
        reason: "PHIDL looks it up as a system font and fails",
        instead: "drawn",
        compare: Drawn,
        further: true,
    },
    Difference {
        functions: &["text", "basic_die"],
        condition: "the size of the letters is 0",
        applies: |case| case.number("size") == 0.0 || case.number("text_size") == 0.0,
        reason: "PHIDL draws degenerate polygons, which no file can hold",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["text"],
        condition: "font is the path or name of an outline font",
        applies: |case| !case.is_one_of("font", &["DEPLOF", "deplof"]),
        reason: "PHIDL hints at 32 pixels, uses a relative grid, takes the exclusive-or of contours and does not kern; \
                 ours scales the design of the font, shapes it and takes the font's own line pitch",
        instead: "the design units of the font, in the tests of text",
        compare: Test("phidl-geometry, tests/it/fonts.rs"),
        further: true,
    },
    Difference {
        functions: &["arc", "turn"],
        condition: "the angle is no more than the angle of one step",
        applies: |case| {
            let angle = if case.device == "turn" { case.number("angle") } else { case.number("theta") };
            (angle.abs() / case.number("angle_resolution")).ceil() < 2.0
        },
        reason: "PHIDL mixes up x and y for a single point on a side; ours has at least two",
        instead: "ports and info",
        compare: Ports,
        further: false,
    },
    Difference {
        functions: &["ring", "arc", "turn"],
        condition: "a width of more than two radii",
        applies: |case| case.exceeds("width", 2.0, "radius") || case.exceeds("port.width", 2.0, "radius"),
        reason: "PHIDL's inner edge has a negative radius: it lies on the other side of the center, and the outline \
                 covers it or crosses itself",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["turn"],
        condition: "an angle of 0",
        applies: |case| case.number("angle") == 0.0,
        reason: "PHIDL draws a malformed polygon",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["taper"],
        condition: "a port without width1",
        applies: |case| case.gives("port") && !case.gives("width1") && !case.is_refused(),
        reason: "the documentation of PHIDL says that width1 is the width of the port, and the code takes 5",
        instead: "with a width1 of 5, ours draws what PHIDL does",
        compare: With(|_| params([("width1", json!(5))])),
        further: false,
    },
    Difference {
        functions: &["taper"],
        condition: "width1 is null, without a port",
        applies: |case| !case.gives("port") && !case.gives("width1") && case.is_refused(),
        reason: "PHIDL fails, since null is not replaced by a default",
        instead: "drawn as without width1",
        compare: Drawn,
        further: false,
    },
];
