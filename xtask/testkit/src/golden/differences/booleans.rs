//! Set operations and offsets.

use crate::golden::difference::Difference;
use crate::golden::difference::Instead::{CornersToAStep, Drawn};

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["boolean"],
        condition: "num_divisions, where the result or one operand is empty",
        applies: |case| case.numbers("num_divisions").iter().any(|n| *n > 1.0) && case.is_refused(),
        reason: "PHIDL raises an IndexError for an empty result with divisions",
        instead: "drawn: an empty device",
        compare: Drawn,
        further: false,
    },
    Difference {
        functions: &["boolean", "offset", "outline", "invert", "xor_diff", "union"],
        condition: "outlines of the same corners that are at most a grid step apart",
        applies: |_| true,
        reason: "both round corners to the grid, and PHIDL not always to the nearest point: a taper of 18.531 with \
                 widths of 5.175 and 1.181, offset by -0.129, has its corners at y = 2.44385 and 0.47465, which are 2.4438 \
                 and 0.4746 there. On a long slanted edge that is more than half a step along the outline",
        instead: "corner by corner, to a grid step",
        compare: CornersToAStep,
        further: false,
    },
];
