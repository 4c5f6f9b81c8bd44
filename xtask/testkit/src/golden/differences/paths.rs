//! Paths, cross-sections and extrusions. The tests of phidl-path make no exception but those of this table. Where the
//! condition needs our own drawing (`|_| true`), they establish it.

use crate::golden::difference::Instead::{PointsTo, Refused, Test};
use crate::golden::difference::{Difference, Refusal};
use crate::golden::path_facts::{
    cut_off_error, has_arctangents, has_bend_beyond_a_half_turn, has_spiral_without_center, has_uncertain_count,
    is_poorly_sampled, is_simplified,
};

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["path.hash_geometry"],
        condition: "an end's direction comes from an arctangent: point lists, spirals, smoothed paths, mirrored paths",
        applies: has_arctangents,
        reason: "the hash takes all bits of the angles; the arctangent of PHIDL depends on the processor, and noise may \
                 turn 0 degrees into 360",
        instead: "the hash of our points with PHIDL's angles, and the angles to 1e-9 degrees",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.arc"],
        condition: "fewer than 2 points by num_pts",
        applies: |case| is_poorly_sampled(case, "arc"),
        reason: "PHIDL returns no point or a single one",
        instead: "directions of the ends; ours has both ends",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.euler"],
        condition: "fewer than 3 points by num_pts, or fewer than 2 for the clothoid or the arc between",
        applies: |case| is_poorly_sampled(case, "euler"),
        reason: "PHIDL loses a segment, and the path does not start or end where it should",
        instead: "directions of the ends; ours has exact ends",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.euler"],
        condition: "p times the angle is more than 180 degrees",
        applies: |case| cut_off_error(case).is_some(),
        reason: "PHIDL ends the Fresnel series after eight terms",
        instead: "points to 1e-6 of the radius up to 360 degrees, to a tenth of it beyond; no hash",
        compare: PointsTo(|case| cut_off_error(case).unwrap_or_default()),
        further: false,
    },
    Difference {
        functions: &["path.euler"],
        condition: "use_eff beyond 190 degrees",
        applies: has_bend_beyond_a_half_turn,
        reason: "the effective radius is meaningless there; PHIDL mirrors or collapses the curve",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["path.spiral"],
        condition: "fewer than 2 points for the arcs in the middle by num_pts",
        applies: has_spiral_without_center,
        reason: "PHIDL joins the arms past the center, or fails with an IndexError",
        instead: "refused; or, where ours has two points, the directions of the ends",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.extrude"],
        condition: "repeated points, or a corner that turns by more than 168.5 degrees",
        applies: |_| true,
        reason: "PHIDL draws notches, spikes of any length, or infinities",
        instead: "ours has no point beyond ten times the distance of an edge",
        compare: Test("phidl-path, tests/it/laws.rs"),
        further: true,
    },
    Difference {
        functions: &["path.extrude"],
        condition: "a section overlaps itself where the path bends too tightly",
        applies: |_| true,
        reason: "an outline that crosses itself has no agreed area, since tools fill it differently",
        instead: "refused, with the radius and width that would do; with Overlaps::Keep the points are PHIDL's",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["path.transition"],
        condition: "an offset that changes",
        applies: |_| true,
        reason: "PHIDL moves offsets as a raised cosine whatever the widths do, and measures widths square to the moved \
                 middle line, so that strips and gaps of a coplanar line overlap or separate",
        instead: "offsets follow the law of the widths and are measured square to the path; a function as offset gives \
                  PHIDL's points",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.extrude"],
        condition: "simplify, where two points are equally far from a line but for the last bit",
        applies: is_simplified,
        reason: "on an arc that is the rule; which one PHIDL takes depends on the last bits of its sines, and so on the \
                 processor. The algorithm allows both",
        instead: "PHIDL's points and ours are each a result of the algorithm on our edges, with ties up to 1e-9 µm",
        compare: Test("phidl-path, tests/it/simplified.rs"),
        further: false,
    },
    Difference {
        functions: &["path.smooth"],
        condition: "repeated waypoints, or bends that take up a leg to the last bit",
        applies: |_| true,
        reason: "PHIDL refuses them or takes noise for a direction",
        instead: "ours has the directions of the legs",
        compare: Test("phidl-path, tests/it/laws.rs"),
        further: true,
    },
    Difference {
        functions: &["path.smooth"],
        condition: "a bend whose number of points is whole but for the last bit of an angle",
        applies: has_uncertain_count,
        reason: "PHIDL truncates the number, so that a bend of 89.99999999999999 degrees has a point less than one of 90. \
                 The last bit depends on how the corner was computed, and on the processor",
        instead: "length, or area and ports",
        compare: Test("phidl-path, tests/it/golden.rs"),
        further: false,
    },
    Difference {
        functions: &["path.transition"],
        condition: "no name in common",
        applies: |_| true,
        reason: "PHIDL returns a cross-section without sections, which draws nothing and reports nothing",
        instead: "refused",
        compare: Refused(Refusal::Choice),
        further: true,
    },
];
