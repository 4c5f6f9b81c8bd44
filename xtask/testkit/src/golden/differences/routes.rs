//! Routes and waypoints. The tests of phidl-route look up the entry of each exception that they make.

use crate::golden::difference::Instead::{Refused, Test};
use crate::golden::difference::{Difference, Refusal};

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["path_manhattan"],
        condition: "PHIDL's line crosses itself",
        applies: |_| true,
        reason: "a shorter line without a crossing exists",
        instead: "ours crosses itself only where no line of up to six corners beside the ports avoids it",
        compare: Test("phidl-route, tests/it/laws.rs"),
        further: false,
    },
    Difference {
        functions: &["route.direction"],
        condition: "L, V, U, J, C or Z leave or enter a port from behind",
        applies: |_| true,
        reason: "PHIDL's V and L go backwards through ports, and lengths that are too short give routes through the port",
        instead: "refused, with both ports; the waypoints alone (path_…) are PHIDL's",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["route.folds"],
        condition: "an edge folds back: a bend tighter than half the width, a corner that turns by more than 168.5 degrees",
        applies: |_| true,
        reason: "PHIDL's check of bends ignores the width, so that the wire overlaps itself",
        instead: "refused, with both ports and the position of the fold",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["route_manhattan"],
        condition: "bend is euler",
        applies: |_| true,
        reason: "proof: an Euler bend of 90 degrees with the effective radius R has the smallest radius 0.535 R, and a \
                 Manhattan route is nowhere tighter than its radius. route_smooth draws bends by effective radius",
        instead: "the radius is the smallest of the bend; the laws of routes",
        compare: Test("phidl-route, tests/it/laws.rs"),
        further: true,
    },
    Difference {
        functions: &["path_V"],
        condition: "opposite, and so parallel, ports",
        applies: |_| true,
        reason: "PHIDL's corner is 4e17 µm away, without an error",
        instead: "refused",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
    Difference {
        functions: &["route.options"],
        condition: "an option that the path_type does not have",
        applies: |_| true,
        reason: "options that are ignored silently hide typing errors",
        instead: "refused",
        compare: Refused(Refusal::Choice),
        further: true,
    },
    Difference {
        functions: &["route_basic.direction"],
        condition: "port2 is not in front of port1",
        applies: |_| true,
        reason: "the ports do not face each other, and the route would leave port1 backwards, through its device",
        instead: "refused, with both ports and the missing distance",
        compare: Refused(Refusal::Geometry),
        further: false,
    },
];
