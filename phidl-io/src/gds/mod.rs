//! GDSII, both ways: [`write()`], [`to_bytes`], [`read()`], [`read_bytes`].
//!
//! # What gds21 does here, and what it does not
//! The gds21 crate (3.0.0-pre.2; there is no 2.x on crates.io, and 0.2 copies whole files) encodes the
//! library's head, cells, labels and arrays, decodes labels, arrays, boxes and paths, and has the names of records and the
//! real numbers. Only this folder names it, and no type of it leaves. The two kinds of element that a mask has millions
//! of, polygons and single references, go straight from the cell to the bytes and back: gds21's model allocates several
//! times for each of them and writes number by number through a `dyn Write`, which takes two to three times as long as
//! gdstk. The rest of gds21's gaps is closed around it:
//!
//! | gds21 | here |
//! |---|---|
//! | dates are "now" unless set | [`GdsOptions::date`], a constant by default; no default of gds21 is ever used |
//! | an outline of more than 8,191 points fails at the end, without a name | outlines are cut before ([`GdsOptions::max_points`]) |
//! | layers, attributes are signed | 16 bits unsigned, as KLayout and gdstk have them |
//! | an empty text makes the reader panic | texts are looked at before gds21 sees them |
//! | a text that is not UTF-8 ends the reading | read as Latin-1, and listed as a problem |
//! | `REFLIBS`, `FONTS`, `GENERATIONS`, unknown records end the reading | left out; unknown ones are listed as problems |
//! | errors often have no position | the element is found, and the error has its byte and cell |
//! | `user_unit` divides the wrong way round | not used |
//!
//! Rounding to the grid is [`Grid`]'s, and happens here once. Text is ASCII in both directions where it can be chosen.

mod boundary;
mod cells;
mod elements;
mod export;
mod frame;
mod import;
mod lattice;
mod library;
mod limits;
mod names;
mod options;
mod outline;
mod path;
mod problem;
mod record;
mod rest;
mod scan;
mod single;
mod split;

use phidl_core::geom::Point;
use phidl_core::num::grid::{Grid, GridError};

pub(crate) use cells::CellTable;
pub use export::{GdsReport, to_bytes, write};
pub use import::{Import, ReadOptions, read, read_bytes};
pub use options::{GdsDate, GdsLimits, GdsOptions};
pub use problem::{Problem, ProblemKind};

/// A point in steps of the grid, in the 32 bits that the format has.
fn corner(grid: &Grid, point: Point) -> Result<[i32; 2], GridError> {
    let steps = |um| {
        let steps = grid.steps(um)?;
        Ok(i32::try_from(steps).expect("invariant: the grid of a file reaches 32 bits"))
    };
    Ok([steps(point.x)?, steps(point.y)?])
}
