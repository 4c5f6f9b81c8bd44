//! Where ours differs from the reference on purpose, as a table that the tests read.
//!
//! The first entry that applies to a case counts. An entry needs a defect of the reference or a proof, never
//! convenience, and a condition as narrow as its reason. `docs/differences.md` is generated from the table.

mod arranging;
mod booleans;
mod devices;
mod paths;
mod routes;
mod shapes;

use serde_json::Value as Json;
use std::collections::BTreeMap;

use super::difference::Instead::{Refused, RefusedOrSame};
use super::difference::{Difference, Refusal};
use super::facts;

/// All deliberate differences, in the order in which they are tried.
#[must_use]
pub fn differences() -> Vec<&'static Difference> {
    [FIRST, shapes::ALL, devices::ALL, arranging::ALL, booleans::ALL, paths::ALL, routes::ALL, LAST, devices::NOISE]
        .into_iter()
        .flatten()
        .collect()
}

const FIRST: &[Difference] = &[
    Difference {
        functions: &["*"],
        condition: "a number outside the bounds of its parameter: no width, a negative length, more than a full turn",
        applies: facts::is_out_of_bounds,
        reason: "PHIDL stores degenerate polygons silently; the bounds are in the documentation of each shape",
        instead: "refused, with the bound",
        compare: Refused(Refusal::Bound),
        further: false,
    },
    Difference {
        functions: &["*"],
        condition: "a name that is none of the choices of its parameter",
        applies: facts::is_no_choice,
        reason: "PHIDL ignores an unknown name silently",
        instead: "refused, with the choices",
        compare: Refused(Refusal::Choice),
        further: false,
    },
];

const LAST: &[Difference] = &[Difference {
    functions: &["*"],
    condition: "numbers that do not go together: PHIDL's outline encloses nothing or crosses itself",
    applies: facts::draws_no_shape,
    reason: "PHIDL stores degenerate polygons silently, and tools disagree on what an outline covers that crosses itself",
    instead: "refused, with the rule, or drawn the same",
    compare: RefusedOrSame(Refusal::Geometry),
    further: true,
}];

/// Parameters by name.
fn params<const N: usize>(given: [(&str, Json); N]) -> BTreeMap<String, Json> {
    given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
