//! GDSII, both ways: [`write()`], [`to_bytes`], [`read()`], [`read_bytes`] for devices; [`read_layout`],
//! [`decode_layout`], [`encode_layout`], [`write_layout`] for a file as it stands.
//!
//! | Module | What it does |
//! |---|---|
//! | `record`, `real` | records and the format's real numbers |
//! | `element` | one file for each kind of element, reader and writer |
//! | `reader`, `writer` | files to the [layout model](crate::model) and back |
//! | `import`, `export` | devices, by way of the model |
//! | `options` | how a file is written |
//! | `gds21` | the bridge to gds21's object model (feature `gds21`) |
//!
//! The codec is our own: masks have millions of polygons and references, and what other tools write is wider than the
//! manual. The crate gds21 was used before; it allocates for each element, takes layers as signed, stops at texts that are
//! empty or not UTF-8 and at records of old tools, and its errors have no position. It checks the codec in our tests.

mod element;
mod export;
#[cfg(feature = "gds21")]
pub mod gds21;
mod import;
mod options;
mod reader;
mod real;
mod record;
mod writer;

#[cfg(feature = "oasis")]
pub(crate) use export::to_layout;
pub(crate) use export::write_in;
pub use export::{GdsReport, to_bytes, write};
pub use import::{Import, ReadOptions, read, read_bytes};
pub use options::GdsOptions;
pub(crate) use reader::parse;
pub use reader::{decode_layout, read_layout};
pub use writer::{encode_layout, write_layout};

pub use crate::model::{Content, Date, FileLimits, MergeCells, Problem, ProblemKind};
