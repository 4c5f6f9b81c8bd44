//! A file into a [`Layout`].
//!
//! Records are read in their order; offsets of tables are only checked. What is referred to by number (cells, texts,
//! properties) is looked up when the whole file has been read, so names may stand before or after their use.

mod block;
mod elements;
mod file;
mod modal;
mod names;
mod placed;
mod property;
mod resolve;
mod shapes;
mod strict;

use super::cursor::Fault;
use crate::error::{IoError, Result};
use crate::model::Layout;

/// How an OASIS file is decoded, and how much it may ask for.
#[derive(Debug, Clone, PartialEq)]
pub struct DecodeOptions {
    /// The most bytes that all compressed blocks together may hold, inflated; 16 GiB by default.
    pub max_bytes: u64,
    /// The most elements that the repetitions of shapes and texts may stand for. A polygon of more than four corners
    /// counts once for every four of them, and a text or property once more for every 64 bytes. 2²⁶ by default, which is
    /// 2 GiB of squares: a rectangle of fifteen bytes may claim 2⁶⁴ copies.
    pub max_elements: u64,
    /// How far the polygon of a circle may be from it (µm); half a grid step by default.
    pub circle_tolerance: Option<f64>,
    /// What a wrong checksum means.
    pub checksum: Checksum,
}

impl Default for DecodeOptions {
    fn default() -> Self {
        Self { max_bytes: 16 << 30, max_elements: 1 << 26, circle_tolerance: None, checksum: Checksum::Report }
    }
}

/// What a wrong checksum means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Checksum {
    /// A problem in the list.
    #[default]
    Report,
    /// An error.
    Refuse,
    /// Nothing: it is not computed.
    Skip,
}

/// Decodes the bytes of an OASIS file. `file` is what errors call it.
///
/// Rectangles, trapezoids and circles become polygons. What a layout has no counterpart for is left out and listed.
///
/// # Errors
/// [`IoError::Malformed`] with byte and cell; [`IoError::DuplicateCell`].
pub fn decode(bytes: &[u8], file: &str, options: &DecodeOptions) -> Result<Layout> {
    let mut parser = file::Parser::new(options);
    match parser.file(bytes).and_then(|end| end.check(bytes, &mut parser)) {
        Ok(()) => {}
        Err(fault) => {
            let cell = parser.cell_name();
            return Err(malformed(&fault, file, cell.as_deref()));
        }
    }
    resolve::resolve(parser, file)
}

fn malformed(fault: &Fault, file: &str, cell: Option<&str>) -> IoError {
    let position = fault.position();
    let problem = match position.inflated {
        None => fault.problem().into(),
        Some(inflated) => format!("{} (byte {inflated} of the compressed block, inflated)", fault.problem()).into(),
    };
    IoError::Malformed { file: file.into(), offset: position.file, cell: cell.map(Into::into), problem }
}
