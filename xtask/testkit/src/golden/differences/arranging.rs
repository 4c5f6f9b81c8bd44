//! Packing and filling.

use crate::golden::difference::Difference;
use crate::golden::difference::Instead::Test;

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
];
