//! One front for all layout formats: GDSII and OASIS, each also compressed with gzip.
//!
//! | Function | What it does |
//! |---|---|
//! | [`detect`] | tells the format of some bytes, by their content |
//! | [`read`], [`read_bytes`] | one cell with all that it places |
//! | [`read_library`] | all cells, several top cells |
//! | [`read_layout`], [`decode`] | a file as it stands, as a [`Layout`] |
//! | [`write()`], [`to_bytes`] | devices into a file; the format by the ending of its name |
//! | [`write_layout`], [`encode`] | a layout into a file |
//! | [`inspect()`] | a file in numbers |
//! | [`convert()`] | a file into another one: other format, one cell, some layers, flat, on another grid |
//!
//! Files are read by their content and never by their names: a name is wrong more often than a content.

mod convert;
mod format;
#[cfg(feature = "gzip")]
mod gzip;
mod inspect;
mod layers;
mod reading;
mod writing;

pub use convert::{Conversion, ConvertOptions, convert};
pub use format::{Detected, Format, detect, of_name};
pub use inspect::{CellFigures, Inspection, LayerFigures, inspect, inspect_bytes};
pub use layers::LayerMap;
pub use reading::{Import, Library, ReadOptions, decode, read, read_bytes, read_layout, read_library};
pub use writing::{WriteOptions, WriteReport, encode, to_bytes, write, write_layout};

#[doc(no_inline)]
pub use crate::model::Layout;
