//! Packing, filling, grids, sweeps and copies.

use crate::golden::difference::Difference;
use crate::golden::difference::Instead::{Test, With};

pub(super) const ALL: &[Difference] = &[
    Difference {
        functions: &["packer"],
        condition: "always",
        applies: |_| true,
        reason: "PHIDL confuses units in the margin, does not find boxes that fit at the largest size only, and rounds \
                 down so that neighbors overlap; a packer may arrange differently if it is at least as dense",
        instead: "density, spacing and largest size",
        compare: Test("phidl-geometry, tests/it/packer.rs"),
        further: true,
    },
    Difference {
        functions: &["fill_rectangle"],
        condition: "always",
        applies: |_| true,
        reason: "PHIDL measures the margin between pixels and does not keep it, rounds asymmetrically, and rounds the \
                 number of cells before it divides it",
        instead: "the distance of every cell from every polygon",
        compare: Test("phidl-geometry, tests/it/fill.rs"),
        further: true,
    },
    Difference {
        functions: &["grid"],
        condition: "a position without a cell, or with a cell that draws nothing",
        applies: |case| case.parameter("device_list").is_some_and(|list| list.to_string().contains("null")),
        reason: "PHIDL gives an empty position a box at the origin, which moves the other cells of its row and column",
        instead: "the distances of the other cells",
        compare: Test("phidl-geometry, tests/it/arrange.rs"),
        further: true,
    },
    Difference {
        functions: &["gridsweep"],
        condition: "always",
        applies: |_| true,
        reason: "PHIDL puts labels into the swept cells, so that a cell that is drawn twice has the wrong one, and shows \
                 values that param_override replaces",
        instead: "the cells and the labels of the grid",
        compare: Test("phidl-geometry, tests/it/arrange.rs"),
        further: true,
    },
    Difference {
        functions: &["flatten"],
        condition: "single_layer is given",
        applies: |case| case.gives("single_layer"),
        reason: "PHIDL ignores single_layer",
        instead: "the drawing without single_layer",
        compare: With(|_| [("single_layer".to_owned(), serde_json::Value::Null)].into()),
        further: false,
    },
];
