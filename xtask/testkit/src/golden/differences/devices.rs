//! Test structures, nanowires and photonic devices.

use crate::golden::Case;
use crate::golden::difference::Instead::{Drawn, LayerOf, Nearby, OtherLayers, Refused, RefusedOrSame, Test, Within};
use crate::golden::difference::{Difference, Refusal};
use crate::golden::facts::{draws_no_shape, turn_is_longer_than_length};

/// Beyond this ratio of widths PHIDL's minimum search loses the curve of an optimal step.
const LOST: f64 = 30.0;

fn is_lost(case: &Case, a: &str, b: &str) -> bool {
    case.exceeds(a, LOST, b) || case.exceeds(b, LOST, a)
}

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["test_res"],
        condition: "gnd_layer is several layers or none",
        applies: |case| (case.is_several("gnd_layer") || !case.gives("gnd_layer")) && case.is_refused(),
        reason: "PHIDL fails without gnd_layer and with a set of layers, which other shapes accept",
        instead: "drawn; the other layers are as they are with one",
        compare: Drawn,
        further: false,
    },
    Difference {
        functions: &["test_comb", "test_ic", "test_res", "test_via"],
        condition: "a layer is null",
        applies: |case| case.params.iter().any(|(name, value)| name.ends_with("layer") && value.is_null()),
        reason: "PHIDL reads positions back from the drawing, so that a layer that is not drawn moves, or breaks, the rest",
        instead: "the other layers are as they are when no layer is left out",
        compare: OtherLayers,
        further: false,
    },
    Difference {
        functions: &["test_res"],
        condition: "num_squares does not suffice for one row of the wire",
        applies: |case| case.number("num_squares") < 100.0,
        reason: "PHIDL draws two squares without a wire between them, the same for all small numbers",
        instead: "refused",
        compare: RefusedOrSame(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["test_ic"],
        condition: "the lists of widths differ in length",
        applies: |case| case.differ_in_length("wire_widths", "wire_widths_wide"),
        reason: "PHIDL makes the common pad for wires that are not drawn",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["test_ic"],
        condition: "a wire is narrower at its pads than in the middle",
        applies: |case| case.exceeds("wire_widths", 1.0, "wire_widths_wide"),
        reason: "PHIDL draws the leads of such wires off-center",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["test_ic"],
        condition: "a wire is more than about 30 times wider at its pads",
        applies: |case| case.exceeds("wire_widths_wide", LOST, "wire_widths"),
        reason: "PHIDL's minimum search for optimal_step, of which the constriction consists, loses the curve",
        instead: "the exact end of the edge, in the tests of optimal_step",
        compare: Test("phidl-geometry, nanowire::step"),
        further: false,
    },
    Difference {
        functions: &["grating"],
        condition: "partial_etch",
        applies: |case| case.parameter("partial_etch").is_some_and(|value| value == true),
        reason: "PHIDL centers the slab on the first bar instead of on all bars, and makes its port as wide as bars are long",
        instead: "the etched bars, point by point; the slab and the port in the tests of the shape",
        compare: LayerOf("layer_etch"),
        further: false,
    },
    Difference {
        functions: &["optimal_step"],
        condition: "widths more than about 30 times apart",
        applies: |case| is_lost(case, "start_width", "end_width"),
        reason: "PHIDL's minimum search loses the curve; from 1 to 1000 it ends at x = 693 instead of 4551",
        instead: "the exact end of the edge, in the tests of the shape",
        compare: Test("phidl-geometry, nanowire::step"),
        further: false,
    },
    Difference {
        functions: &["snspd_expanded"],
        condition: "a connector more than about 30 times wider or narrower than the wire",
        applies: |case| is_lost(case, "connector_width", "wire_width"),
        reason: "PHIDL's minimum search for optimal_step, of which the ends consist, loses the curve",
        instead: "the exact end of the edge, in the tests of optimal_step",
        compare: Test("phidl-geometry, nanowire::step"),
        further: false,
    },
    Difference {
        functions: &["optimal_step"],
        condition: "widths that differ by no more than what width_tol cuts off of them, and are not equal",
        applies: |case| {
            let [start, end, part] = ["start_width", "end_width", "width_tol"].map(|name| case.number(name));
            start != end && start.min(end) * (1.0 + part) >= start.max(end) * (1.0 - part)
        },
        reason: "PHIDL draws an invalid outline with a negative number of squares",
        instead: "an error that names both widths",
        compare: RefusedOrSame(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["racetrack_gradual"],
        condition: "R or N is not the default",
        applies: |case| case.number("R") != 5.0 || case.number("N") != 3.0,
        reason: "PHIDL ignores both and always draws R = 5 and N = 3",
        instead: "the curve of the formulas, in the tests of the shape",
        compare: Test("phidl-geometry, photonic::racetrack"),
        further: false,
    },
    Difference {
        functions: &["racetrack_gradual"],
        condition: "layer is not a single number",
        applies: |case| (case.is_several("layer") || case.is_null("layer")) && case.is_refused(),
        reason: "PHIDL keeps the layer unparsed, and whatever reads the drawing fails",
        instead: "drawn as on a single number",
        compare: Drawn,
        further: false,
    },
    Difference {
        functions: &["optimal_hairpin", "snspd", "snspd_expanded"],
        condition: "no layer",
        applies: |case| case.is_null("layer"),
        reason: "the reference result has no outline, so that a turn which overlaps itself (the next entry) cannot be seen",
        instead: "an error that names the length needed, or ports and info",
        compare: RefusedOrSame(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["optimal_step"],
        condition: "an anticrowding_factor that stretches the curve more than ten times",
        applies: |case| case.number("anticrowding_factor") > 10.0,
        reason: "PHIDL's minimum search ends with a tolerance, which the factor stretches beyond 1e-6 µm",
        instead: "area, box, port widths and info to one part in 10⁴",
        compare: Within(1e-4),
        further: false,
    },
    Difference {
        functions: &["optimal_hairpin", "snspd", "snspd_expanded"],
        condition: "a length, or half a width, that does not hold the turn",
        applies: turn_is_longer_than_length,
        reason: "PHIDL draws outlines that overlap themselves",
        instead: "an error that names the length needed",
        compare: RefusedOrSame(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["ytron_round"],
        condition: "a tip that cuts the source in two, or an inner edge that crosses the outer one of its arm",
        applies: draws_no_shape,
        reason: "PHIDL's outline crosses itself",
        instead: "refused",
        compare: RefusedOrSame(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["snspd_candelabra"],
        condition: "a pitch that is not greater than the width",
        applies: |case| case.number("wire_pitch") <= case.number("wire_width"),
        reason: "PHIDL draws wires that overlap",
        instead: "an error that names pitch and width",
        compare: Refused(Refusal::Geometry),
        further: true,
    },
    Difference {
        functions: &["snspd_candelabra"],
        condition: "axes that leave no room for a full row",
        applies: |case| case.number("haxis") < 30.0,
        reason: "PHIDL draws a disconnected shape",
        instead: "an error that names the room needed",
        compare: RefusedOrSame(Refusal::Geometry),
        further: false,
    },
];

/// Differences that only the float noise of the reference decides; tried last.
pub(super) const NOISE: &[Difference] = &[
    Difference {
        functions: &["test_via"],
        condition: "a link ends exactly on the upper or lower edge of the pads",
        applies: |_| true,
        reason: "the noise of a rotation by 90° decides in PHIDL whether the chain turns; ours is exact, and a link on \
                 the edge is inside",
        instead: "PHIDL's chain is that of a pad or via a hair larger or smaller",
        compare: Nearby(&["pad_size.1", "via_width", "via_spacing"]),
        further: false,
    },
    Difference {
        functions: &["snspd", "snspd_expanded"],
        condition: "a height that is a whole number of pitches but for the noise of the division",
        applies: |_| true,
        reason: "ceil(4.2 / 0.6) is 8 in floating point, so PHIDL draws two rows too many",
        instead: "PHIDL's wire is that of a height a hair larger or smaller",
        compare: Nearby(&["size.1"]),
        further: false,
    },
];
